#include "schedule.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// A winch that is off its length catches up in about this time, s.
constexpr double catch_up = 5.0;
// A winch slips at full speed where the tension is over its limit by this share.
constexpr double full_share = 0.1;
// A winch is asked this often (s), while it slips or may slip soon, and else.
constexpr double slipping_step = 0.05, idle_step = 0.5;
// Steps are no longer (s) while a gear is shot, so that each node begins in its turn.
constexpr double shooting_step = 0.5;
// Steps may grow by this factor before a winch is asked again.
constexpr double next_growth = 2.0;

}  // namespace

Schedule::Schedule(Model& model, Assembly& assembly, Plan plan, const Motion& start)
    : model_(model),
      assembly_(assembly),
      plan_(std::move(plan)),
      start_(start),
      mass_(model.mass),
      load_(model.load),
      shaded_at_(start.time),
      factor_(plan_.parts.size(), 1.0),
      rate_(plan_.parts.size(), 0.0) {
  for (const GrowingPart& part : plan_.parts) {
    for (std::size_t k = 0; k < part.points.size(); ++k) {
      mass_[part.points[k]] -= part.mass[k];
      load_[3 * static_cast<std::size_t>(part.points[k]) + 2] -= part.load[k];
    }
    other_buoyancy_.emplace_back();
    for (std::size_t k = 0; k < part.volumes.size(); ++k) {
      other_buoyancy_.back().push_back(model.volumes.buoyancy[part.volumes[k]] - part.buoyancy[k]);
    }
  }
  for (Parting& parting : plan_.partings) {
    if (parting.parted >= 0) part(parting, parting.parted, parting.parted_at);
  }
  if (!plan_.shooting.node.empty()) {
    kept_.assign(static_cast<std::size_t>(model.nodes), 0);
    all_shot_ = *std::max_element(plan_.shooting.time.begin(), plan_.shooting.time.end());
  }
  answers_ = !plan_.partings.empty() || assembly.shades();
  for (const GrowingPart& part : plan_.parts) answers_ = answers_ || part.has_winch;
}

void Schedule::to_time(double time, Side side, Motion& motion) {
  for (int n = 0; n < model_.nodes; ++n) {
    if (!model_.held[n]) continue;
    at(motion.x.data(), n) =
        at(start_.x.data(), n) + (time - start_.time) * at(start_.v.data(), n);
    at(motion.v.data(), n) = at(start_.v.data(), n);
  }
  const Track& track = plan_.track;
  if (!track.node.empty()) {
    Vector centre, speed;
    double course, turning;
    track.x.at(time, side, centre.x(), speed.x());
    track.y.at(time, side, centre.y(), speed.y());
    track.heave.at(time, side, centre.z(), speed.z());
    track.course.at(time, side, course, turning);
    const Vector aft(std::cos(course), -std::sin(course), 0.0);
    const Vector starboard(std::sin(course), std::cos(course), 0.0);
    for (std::size_t k = 0; k < track.node.size(); ++k) {
      const Vector& p = track.place[k];
      at(motion.x.data(), track.node[k]) =
          centre + p.x() * aft + p.y() * starboard + p.z() * Vector::UnitZ();
      at(motion.v.data(), track.node[k]) = speed + turning * (p.y() * aft - p.x() * starboard);
    }
  }
  for (std::size_t k = 0; k < plan_.current_x.size(); ++k) {
    model_.water.current[k] = {plan_.current_x[k].at(time, side), plan_.current_y[k].at(time, side),
                               0.0};
  }
  grow(time, side);
  shoot(time);
  assembly_.update();
}

void Schedule::shoot(double time) {
  time_ = time;
  if (kept_.empty()) return;
  bool changed = false;
  for (std::size_t k = 0; k < plan_.shooting.node.size(); ++k) {
    const char kept = plan_.shooting.time[k] > time;
    char& was = kept_[static_cast<std::size_t>(plan_.shooting.node[k])];
    changed = changed || was != kept;
    was = kept;
  }
  if (changed) assembly_.keep(kept_);
}

void Schedule::grow(double time, Side side) {
  bool changed = false;
  for (std::size_t p = 0; p < plan_.parts.size(); ++p) {
    GrowingPart& part = plan_.parts[p];
    double factor, rate;
    if (part.has_winch) {
      const Winch& winch = part.winch;
      factor = (winch.length + (time - winch.since) * winch.speed) / winch.full_length;
      rate = winch.speed / winch.full_length;
    } else {
      part.factor.at(time, side, factor, rate);
    }
    if (factor == factor_[p] && rate == rate_[p]) continue;
    changed = changed || factor != factor_[p];
    factor_[p] = factor;
    rate_[p] = rate;
    for (std::size_t k = 0; k < part.bars.size(); ++k) {
      model_.bars.rest[part.bars[k]] = factor * part.rest[k];
      assembly_.update_bar(part.bars[k], rate / factor);
    }
    for (std::size_t k = 0; k < part.spheres.size(); ++k) {
      model_.spheres.drag_area[part.spheres[k]] = factor * part.drag_area[k];
      model_.spheres.added_mass[part.spheres[k]] = factor * part.added_mass[k];
    }
    for (std::size_t k = 0; k < part.volumes.size(); ++k) {
      model_.volumes.buoyancy[part.volumes[k]] =
          other_buoyancy_[p][k] + factor * part.buoyancy[k];
    }
  }
  if (!changed) return;
  auto load = [&](std::vector<double>& values, int point) -> double& {
    return values[3 * static_cast<std::size_t>(point) + 2];
  };
  for (const GrowingPart& part : plan_.parts) {
    for (const int point : part.points) {
      model_.mass[point] = mass_[point];
      load(model_.load, point) = load(load_, point);
    }
  }
  for (std::size_t p = 0; p < plan_.parts.size(); ++p) {
    const GrowingPart& part = plan_.parts[p];
    for (std::size_t k = 0; k < part.points.size(); ++k) {
      model_.mass[part.points[k]] += factor_[p] * part.mass[k];
      load(model_.load, part.points[k]) += factor_[p] * part.load[k];
    }
  }
}

void Schedule::part(Parting& parting, int bar, double time) {
  parting.parted = bar;
  parting.parted_at = time;
  model_.bars.multiplicity[bar] = 0.0;
  assembly_.update_bar(bar, 0.0);
}

void Schedule::turn(Winch& winch, double time) {
  const double h = time - winch.since;
  winch.length += h * winch.speed;
  winch.since = time;
  double speed = winch.speed_wanted;
  if (!winch.steered) {
    double wanted, rate;
    winch.wanted.at(time, Side::after, wanted, rate);
    speed = rate + (wanted - winch.length) / catch_up;
  }
  speed = std::clamp(speed, -winch.speed_limit, winch.speed_limit);
  if (std::isfinite(winch.tension_limit)) {
    const double tension = assembly_.bar_pull(winch.bar);
    const double slope = full_share * winch.tension_limit / winch.speed_limit;
    const double over = tension - winch.tension_limit - slope * winch.speed;
    const double slipping =
        winch.speed + over / (next_growth * h * winch.stiffness / winch.length + slope);
    speed = std::clamp(slipping, speed, winch.speed_limit);
    winch.near_limit = tension > (1.0 - full_share) * winch.tension_limit;
  }
  if (winch.length <= winch.least_length) speed = std::max(speed, 0.0);
  if (winch.length >= winch.most_length) speed = std::min(speed, 0.0);
  winch.speed = speed;
}

double Schedule::longest_step() const {
  double longest = std::numeric_limits<double>::infinity();
  if (time_ < all_shot_) longest = shooting_step;
  for (const GrowingPart& part : plan_.parts) {
    if (!part.has_winch) continue;
    longest = std::min(longest, part.winch.near_limit ? slipping_step : idle_step);
  }
  return longest;
}

bool Schedule::broken_at(const Motion& now) {
  bool broken = false;
  if (!answers_) return broken;
  assembly_.move_to(now.x.data(), now.v.data());
  for (Parting& parting : plan_.partings) {
    if (parting.parted >= 0) continue;
    int bar = now.time >= parting.time * (1.0 - 1e-12) ? parting.at : -1;
    double most = parting.strength;
    for (const int b : parting.bars) {
      const double pull = assembly_.bar_pull(b);
      if (!(pull > most)) continue;
      most = pull;
      bar = b;
    }
    if (bar < 0) continue;
    part(parting, bar, now.time);
    broken = true;
  }
  for (GrowingPart& part : plan_.parts) {
    if (part.has_winch) turn(part.winch, now.time);
  }
  if (assembly_.shades()) assembly_.shade_over(now.time - shaded_at_);
  shaded_at_ = now.time;
  return broken;
}

}  // namespace codend
