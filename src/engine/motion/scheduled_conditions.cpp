#include "scheduled_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "check_schedule.hpp"

namespace codend {
namespace {

// Longest step (s) during releases, so that nodes start one after the other.
constexpr double releasing_step = 0.5;

template <class Values>
auto& upward(Values& values, int point) {
  return values[3 * static_cast<std::size_t>(point) + 2];
}

}  // namespace

ScheduledConditions::ScheduledConditions(Model& model, Assembly& assembly, Schedule schedule,
                                         const Motion& start)
    : model_(model, assembly),
      assembly_(assembly),
      schedule_(std::move(schedule)),
      start_(start),
      mass_(model.mass),
      load_(model.load),
      buoyancy_(model.volumes.buoyancy),
      wake_time_(start.time),
      factor_(schedule_.growing.size(), 1.0),
      rate_(schedule_.growing.size(), 0.0) {
  check_schedule(schedule_, model);
  for (const GrowingGroup& group : schedule_.growing) {
    for (std::size_t k = 0; k < group.points.size(); ++k) {
      mass_[group.points[k]] -= group.mass[k];
      upward(load_, group.points[k]) -= group.load[k];
    }
    for (std::size_t k = 0; k < group.volumes.size(); ++k) {
      buoyancy_[group.volumes[k]] -= group.buoyancy[k];
    }
    answers_ = answers_ || group.controlled;
  }
  for (Rupture& rope : schedule_.ruptures) {
    if (rope.broken >= 0) break_rope(rope, rope.broken, rope.broken_at);
  }
  if (!schedule_.release.node.empty()) {
    held_back_.assign(static_cast<std::size_t>(model.nodes), 0);
    all_released_ = *std::max_element(schedule_.release.time.begin(), schedule_.release.time.end());
  }
  answers_ = answers_ || !schedule_.ruptures.empty() || assembly.has_wake();
  if (schedule_.sticking.present && model.ground.present) stick();
}

// Writes the anchors to the schedule, so that another integration can continue from them.
void ScheduledConditions::stick() {
  std::vector<double>& anchor = schedule_.sticking.anchor;
  assembly_.move_to(start_.x.data(), start_.v.data());
  std::vector<Vector> from = assembly_.ground_places();
  if (from.empty()) return;
  answers_ = sticks_ = true;
  for (std::size_t e = 0; e < anchor.size() / 3; ++e) {
    from[e] = at(anchor.data(), static_cast<int>(e));
  }
  model_.set_anchors(from);
  keep_anchors();
}

void ScheduledConditions::keep_anchors() {
  const std::vector<Vector> anchor = model_.anchors();
  schedule_.sticking.anchor.resize(3 * anchor.size());
  for (std::size_t e = 0; e < anchor.size(); ++e) {
    at(schedule_.sticking.anchor.data(), static_cast<int>(e)) = anchor[e];
  }
}

void ScheduledConditions::to_time(double time, Side side, Motion& motion) {
  for (int n = 0; n < model_.now().nodes; ++n) {
    if (!model_.now().held[n]) continue;
    at(motion.x.data(), n) = at(start_.x.data(), n) + (time - start_.time) * at(start_.v.data(), n);
    at(motion.v.data(), n) = at(start_.v.data(), n);
  }
  const ScheduledValues values = values_at(schedule_, time, side);
  const PrescribedMotion& body = schedule_.motion;
  const double c = std::cos(values.heading), s = std::sin(values.heading);
  const Vector forth(c, -s, 0.0), aside(s, c, 0.0);  // body axes x and y
  for (std::size_t k = 0; k < body.node.size(); ++k) {
    const Vector& p = body.place[k];
    at(motion.x.data(), body.node[k]) =
        values.origin + p.x() * forth + p.y() * aside + p.z() * Vector::UnitZ();
    at(motion.v.data(), body.node[k]) =
        values.velocity + values.turning * (p.y() * forth - p.x() * aside);
  }
  model_.set_wave_time(time);
  if (body.swing.present()) swing_body(time, side, values, motion);
  for (std::size_t k = 0; k < values.current.size(); ++k) {
    model_.set_current(k, values.current[k]);
  }
  const bool steady = std::all_of(values.current_rate.begin(), values.current_rate.end(),
                                  [](const Vector& rate) { return rate.isZero(0.0); });
  model_.set_current_rate(steady ? std::vector<Vector>() : values.current_rate);
  grow(values);
  release(time);
  assembly_.update();
}

void ScheduledConditions::swing_body(double time, Side side, const ScheduledValues& values,
                                     Motion& motion) const {
  const PrescribedMotion& body = schedule_.motion;
  const Swing& swing = body.swing;
  double value[6] = {}, rate[6] = {};
  if (!swing.even.empty()) {
    model_.now().water.waves.respond(values.origin, values.velocity, swing.even, swing.odd, value,
                                     rate);
  }
  for (std::size_t j = 0; j < swing.by_time.size(); ++j) {
    double more, more_rate;
    swing.by_time[j].at(time, side, more, more_rate);
    value[j] += more;
    rate[j] += more_rate;
  }
  // The body's x axis points aft, its y axis to starboard.
  const Vector shift(-value[0], value[1], value[2]), shift_rate(-rate[0], rate[1], rate[2]);
  auto turn = [](double angle, const Vector& axis, Matrix& out, Matrix& slope) {
    out = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    Matrix across;
    across << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
    slope = across * out;
  };
  Matrix roll, pitch, yaw, roll_slope, pitch_slope, yaw_slope;
  turn(-value[3], Vector::UnitX(), roll, roll_slope);
  turn(value[4], Vector::UnitY(), pitch, pitch_slope);
  turn(-value[5], Vector::UnitZ(), yaw, yaw_slope);
  const Matrix turned = yaw * pitch * roll;
  const Matrix turning = -rate[5] * yaw_slope * pitch * roll + rate[4] * yaw * pitch_slope * roll -
                         rate[3] * yaw * pitch * roll_slope;
  const double c = std::cos(values.heading), s = std::sin(values.heading);
  const Vector forth(c, -s, 0.0), aside(s, c, 0.0);
  for (std::size_t k = 0; k < body.node.size(); ++k) {
    const Vector arm = body.place[k] - swing.centre;
    const Vector p = swing.centre + shift + turned * arm, v = shift_rate + turning * arm;
    at(motion.x.data(), body.node[k]) =
        values.origin + p.x() * forth + p.y() * aside + p.z() * Vector::UnitZ();
    at(motion.v.data(), body.node[k]) = values.velocity + v.x() * forth + v.y() * aside +
                                        v.z() * Vector::UnitZ() +
                                        values.turning * (p.y() * forth - p.x() * aside);
  }
}

void ScheduledConditions::release(double time) {
  time_ = time;
  if (held_back_.empty()) return;
  bool changed = false;
  for (std::size_t k = 0; k < schedule_.release.node.size(); ++k) {
    const char held = schedule_.release.time[k] > time;
    char& was = held_back_[static_cast<std::size_t>(schedule_.release.node[k])];
    changed = changed || was != held;
    was = held;
  }
  if (changed) assembly_.hold(held_back_);
}

void ScheduledConditions::grow(const ScheduledValues& values) {
  bool changed = false;
  for (std::size_t g = 0; g < schedule_.growing.size(); ++g) {
    const double factor = values.factor[g], rate = values.rate[g];
    if (factor == factor_[g] && rate == rate_[g]) continue;
    changed = changed || factor != factor_[g];
    factor_[g] = factor;
    rate_[g] = rate;
    const GrowingGroup& group = schedule_.growing[g];
    for (std::size_t k = 0; k < group.bars.size(); ++k) {
      model_.set_rest(group.bars[k], factor * group.rest[k], rate / factor);
    }
    for (std::size_t k = 0; k < group.spheres.size(); ++k) {
      model_.set_sphere(group.spheres[k], factor * group.drag_area[k],
                        factor * group.added_mass[k]);
    }
  }
  if (!changed) return;
  for (const GrowingGroup& group : schedule_.growing) {
    for (const int point : group.points) {
      model_.set_mass(point, mass_[point]);
      model_.set_upward_load(point, upward(load_, point));
    }
    for (const int volume : group.volumes) model_.set_buoyancy(volume, buoyancy_[volume]);
  }
  for (std::size_t g = 0; g < schedule_.growing.size(); ++g) {
    const GrowingGroup& group = schedule_.growing[g];
    for (std::size_t k = 0; k < group.points.size(); ++k) {
      const int point = group.points[k];
      model_.set_mass(point, model_.now().mass[point] + factor_[g] * group.mass[k]);
      model_.set_upward_load(point, upward(model_.now().load, point) + factor_[g] * group.load[k]);
    }
    for (std::size_t k = 0; k < group.volumes.size(); ++k) {
      const int volume = group.volumes[k];
      model_.set_buoyancy(volume,
                          model_.now().volumes.buoyancy[volume] + factor_[g] * group.buoyancy[k]);
    }
  }
}

void ScheduledConditions::break_rope(Rupture& rope, int bar, double time) {
  rope.broken = bar;
  rope.broken_at = time;
  model_.break_bar(bar);
}

Schedule ScheduledConditions::schedule_at(double time) const {
  Schedule out = schedule_;
  for (GrowingGroup& group : out.growing) {
    group.control.length = group.control.length_at(time);
    group.control.since = time;
  }
  return out;
}

double ScheduledConditions::longest_step() const {
  double longest = std::numeric_limits<double>::infinity();
  if (time_ < all_released_) longest = releasing_step;
  for (const GrowingGroup& group : schedule_.growing) {
    if (group.controlled) longest = std::min(longest, group.control.longest_step());
  }
  return longest;
}

Vector ScheduledConditions::end_load(const GrowingGroup& group) const {
  const Model& model = model_.now();
  const std::size_t g = static_cast<std::size_t>(&group - schedule_.growing.data());
  const int end = model.bars.node[2 * static_cast<std::size_t>(group.control.bar)];
  Vector load = Vector::Zero();
  for (std::size_t k = 0; k < group.points.size(); ++k) {
    if (group.points[k] == end) load.z() += factor_[g] * group.load[k];
  }
  for (std::size_t k = 0; k < group.volumes.size(); ++k) {
    const int volume = group.volumes[k];
    if (model.volumes.node[volume] != end) continue;
    load += factor_[g] * group.buoyancy[k] / model.volumes.buoyancy[volume] *
            model.volumes.element_force(volume, assembly_.field());
  }
  return load;
}

bool ScheduledConditions::broken_at(const Motion& now) {
  bool broken = false;
  if (!answers_) return broken;
  assembly_.move_to(now.x.data(), now.v.data());
  for (Rupture& rope : schedule_.ruptures) {
    if (rope.broken >= 0) continue;
    int bar = now.time >= rope.time * (1.0 - 1e-12) ? rope.at : -1;
    double most = rope.strength;
    for (const int b : rope.bars) {
      const double pull = assembly_.bar_pull(b);
      if (!(pull > most)) continue;
      most = pull;
      bar = b;
    }
    if (bar < 0) continue;
    break_rope(rope, bar, now.time);
    broken = true;
  }
  for (GrowingGroup& group : schedule_.growing) {
    if (!group.controlled) continue;
    group.control.choose_speed(now.time, assembly_.end_pull(group.control.bar, end_load(group)));
  }
  if (sticks_) {
    model_.draw_anchors();
    keep_anchors();
  }
  if (assembly_.has_wake()) assembly_.renew_wake_over(now.time - wake_time_);
  wake_time_ = now.time;
  return broken;
}

}  // namespace codend
