#include "assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace codend {

Assembly::Assembly(const Model& model)
    : model_(model),
      kinds_(model.kinds()),
      free_(model),
      lines_(model.materials, model.bars, model.cells, model.hexagons, model.water, model.slack),
      wake_(model.wake_sheets, model.points()),
      position_(3 * static_cast<std::size_t>(model.points())),
      velocity_(position_.size()),
      load_(position_.size()),
      force_(position_.size()),
      no_tension_(static_cast<std::size_t>(model.constraints()), 0.0),
      moved_(position_.size()),
      scale_(static_cast<std::size_t>(model.points())) {
  if (!model.wake.empty()) wake_.set_share(model.wake);
  if (model.water.waves.present()) waves_.resize(static_cast<std::size_t>(model.points()));
  change_.strain.resize(static_cast<std::size_t>(model.constraints()));
  in_body_.assign(static_cast<std::size_t>(model.nodes), 0);
  for (const ElementKind* kind : kinds_) {
    if (!kind->has_bodies()) continue;
    has_bodies_ = true;
    FreePoints::Share shares[2];
    for (const int point : kind->nodes()) {
      const int n = free_.shares(point, shares);
      for (int s = 0; s < n; ++s)
        in_body_[static_cast<std::size_t>(free_nodes()[shares[s].unknown])] = 1;
    }
  }
}

const BlockLayout& Assembly::blocks() const {
  if (!blocks_) {
    std::vector<ElementPoints> elements{{2, model_.bars.node},
                                        {4, model_.cells.node},
                                        {4, model_.hexagons.node},
                                        {1, model_.contacts.node}};
    for (const ElementKind* kind : kinds_) {
      elements.push_back({kind->nodes_per_element(), kind->nodes()});
    }
    blocks_.emplace(free_, elements);
  }
  return *blocks_;
}

void Assembly::hold(const std::vector<char>& held) {
  held_back_ = still_ = held;
  flow_known_ = false;
  if (!held.empty()) {
    for (const Tie& tie : model_.ties) {
      still_.push_back(held[static_cast<std::size_t>(tie.first)] &&
                       held[static_cast<std::size_t>(tie.second)]);
    }
  }
  lines_.set_still(still_);
}

void Assembly::spread(const double* nodes, std::vector<double>& points) const {
  std::copy(nodes, nodes + 3 * static_cast<std::ptrdiff_t>(model_.nodes), points.begin());
  for (std::size_t t = 0; t < model_.ties.size(); ++t) {
    const Tie& tie = model_.ties[t];
    at(points.data(), model_.nodes + static_cast<int>(t)) =
        (1.0 - tie.share) * at(nodes, tie.first) + tie.share * at(nodes, tie.second);
  }
}

void Assembly::hand_on(double* values, int width) const {
  for (std::size_t t = 0; t < model_.ties.size(); ++t) {
    const Tie& tie = model_.ties[t];
    const double* from = values + width * (model_.nodes + static_cast<std::ptrdiff_t>(t));
    double* first = values + width * static_cast<std::ptrdiff_t>(tie.first);
    double* second = values + width * static_cast<std::ptrdiff_t>(tie.second);
    for (int k = 0; k < width; ++k) {
      first[k] += (1.0 - tie.share) * from[k];
      second[k] += tie.share * from[k];
    }
  }
}

void Assembly::move_to(const double* x, const double* v) {
  const std::ptrdiff_t size = 3 * static_cast<std::ptrdiff_t>(model_.nodes);
  const bool same_flow = flow_known_ && !model_.water.varies_with_height() &&
                         std::equal(v, v + size, velocity_.begin());
  spread(x, position_);
  if (model_.water.waves.running()) {
    for (int p = 0; p < model_.points(); ++p) {
      waves_[static_cast<std::size_t>(p)] = model_.water.waves.at(at(position_.data(), p));
    }
  }
  if (!same_flow) {
    spread(v, velocity_);
    lines_.set_flow(field());
    flow_known_ = true;
  }
  lines_.move_to(position_.data());
  std::copy(model_.load.begin(), model_.load.end(), load_.begin());
  for (const ElementKind* kind : kinds_) kind->add_force(field(), load_.data());
  if (model_.water.accelerates()) add_push_of_water();
  ++force_evaluations_;
}

void Assembly::gather_added_mass() {
  lines_.add_added_mass(masses_.data());
  for (const ElementKind* kind : kinds_) kind->add_added_mass(field(), masses_.data());
}

void Assembly::add_push_of_water() {
  masses_.assign(3 * position_.size(), 0.0);
  gather_added_mass();
  for (int p = 0; p < model_.points(); ++p) {
    const Eigen::Map<const Block> added(&masses_[9 * static_cast<std::size_t>(p)]);
    at(load_.data(), p) += added * field().acceleration(p);
  }
}

Vector Assembly::flow_past_wake_sheets() const {
  Vector flow = Vector::Zero(), current, slope;
  double height = 0.0;
  for (const int p : model_.wake_sheets.node) {
    height += at(position_.data(), p).z();
    flow -= at(velocity_.data(), p);
  }
  const double points = static_cast<double>(model_.wake_sheets.node.size());
  model_.water.velocity(height / points, current, slope);
  return flow / points + current;
}

double Assembly::renew_wake(bool search, double tolerance) {
  const Vector flow = flow_past_wake_sheets();
  // Netting at rest in still water has no wake.
  if (flow.norm() == 0.0) return 0.0;
  flow_known_ = false;
  return wake_.renew(position_.data(), flow, search, tolerance);
}

void Assembly::keep_wake() {
  const Vector flow = flow_past_wake_sheets();
  if (flow.norm() > 0.0) wake_.keep(position_.data(), flow);
}

void Assembly::keep_wake_of(const Assembly& other) {
  flow_known_ = false;
  wake_.keep_to(other.wake_);
}

void Assembly::renew_wake_over(double time) {
  const Vector flow = flow_past_wake_sheets();
  const double speed = flow.norm();
  if (speed == 0.0) return;
  double first = 1e300, last = -1e300;
  for (const int p : model_.wake_sheets.node) {
    const double along = flow.dot(at(position_.data(), p)) / speed;
    first = std::min(first, along);
    last = std::max(last, along);
  }
  const double passing = 0.5 * (last - first) / speed;
  flow_known_ = false;
  wake_.renew(position_.data(), flow, true, wake_tolerance,
              passing > 0.0 ? -std::expm1(-time / passing) : 1.0);
}

void Assembly::residual(double* force, const DualTension* dual) {
  std::copy(load_.begin(), load_.end(), force_.begin());
  add_pull(dual ? dual->tension.data() : lines().tension,
           dual ? dual->tension.data() + lines_.count() : nullptr, force);
}

void Assembly::pull_of(const DualTension& dual, double* force) {
  // Lines::add_force() also adds drag, which is subtracted first.
  std::fill(force_.begin(), force_.end(), 0.0);
  lines_.add_force(no_tension_.data(), force_.data());
  model_.contacts.add_force(field(), no_tension_.data() + lines_.count(), force_.data());
  for (double& f : force_) f = -f;
  add_pull(dual.tension.data(), dual.tension.data() + lines_.count(), force);
}

void Assembly::add_pull(const double* tension, const double* normal_force, double* force) {
  lines_.add_force(tension, force_.data());
  model_.contacts.add_force(field(), normal_force, force_.data());
  hand_on(force_.data(), 3);
  std::copy(force_.begin(), force_.begin() + 3 * static_cast<std::ptrdiff_t>(model_.nodes), force);
  for (std::size_t n = 0; n < held_back_.size(); ++n) {
    if (held_back_[n]) at(force, static_cast<int>(n)).setZero();
  }
}

void Assembly::balance(double share, double* allowed) {
  // Minimum allowance of every node, as a fraction of the largest tension.
  constexpr double least = 1e-3;
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  double far = 0.0;
  for (int n = 0; n < model_.nodes; ++n) {
    far = std::max(far, at(position_.data(), n).lpNorm<Eigen::Infinity>());
  }
  for (int p = 0; p < model_.points(); ++p) {
    scale_[static_cast<std::size_t>(p)] = share * at(load_.data(), p).norm();
  }
  const LineArrays& a = lines();
  model_.each_line([&](const auto& line) {
    const int k = line.index;
    if (lines_.still(k)) return;
    const double pull = a.multiplicity[k] * (share * std::abs(a.tension[k]) +
                                             rounding * far * a.stiffness[k] * a.inverse_rest[k]);
    const double drag = share * Vector(a.drag[0][k], a.drag[1][k], a.drag[2][k]).norm();
    for (std::size_t i = 0; i < std::size(line.shape); ++i) {
      scale_[static_cast<std::size_t>(line.nodes[i])] +=
          line.pull_at(static_cast<int>(i)) * pull + drag;
    }
  });
  hand_on(scale_.data(), 1);
  const double everywhere = share * least * largest_tension();
  for (int n = 0; n < model_.nodes; ++n) {
    allowed[n] = scale_[static_cast<std::size_t>(n)] + everywhere;
  }
}

void Assembly::jacobian(const JacobianRequest& request, double* values,
                        const DualTension* dual) const {
  const BlockPattern& pattern = blocks().pattern;
  const std::vector<BlockPlaces>& places = blocks().places;
  std::fill(values, values + 9 * pattern.column.size(), 0.0);
  lines_.add_jacobian(request, dual ? dual->tension.data() : lines().tension,
                      dual ? dual->modulus.data() : nullptr, places[0].into(values),
                      places[1].into(values), places[2].into(values));
  model_.contacts.add_jacobian(
      field(), request, dual ? dual->tension.data() + lines_.count() : nullptr,
      dual ? dual->modulus.data() + lines_.count() : nullptr, places[3].into(values));
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    kinds_[k]->add_jacobian(field(), request, places[k + 4].into(values));
  }
  if (held_back_.empty()) return;
  for (int i = 0; i < unknowns(); ++i) {
    if (!held_back_[free_nodes()[i]]) continue;
    std::fill(values + 9 * pattern.row_start[i], values + 9 * pattern.row_start[i + 1], 0.0);
  }
}

double Assembly::bar_pull(int bar) const {
  double pull = lines().multiplicity[bar] * lines().tension[bar];
  for (const SlidingRope& rope : model_.sliding) {
    if (std::find(rope.bar.begin(), rope.bar.end(), bar) != rope.bar.end()) {
      pull += rope.tension(field());
    }
  }
  return pull;
}

double Assembly::end_pull(int bar, const Vector& load) const {
  const double pull = bar_pull(bar);
  if (pull <= 0.0) return pull;
  const LineArrays& known = lines();
  const Vector along =
      known.inverse_length[bar] * Vector(known.e[0][bar], known.e[1][bar], known.e[2][bar]);
  const Vector drag(known.drag[0][bar], known.drag[1][bar], known.drag[2][bar]);
  return (pull * along + drag + load).norm();
}

void Assembly::add_diagonal(const double* numbers, double* values) const {
  const std::vector<std::int64_t>& diagonal = blocks().diagonal;
  for (int i = 0; i < unknowns(); ++i) {
    double* block = values + 9 * diagonal[i];
    for (int k = 0; k < 3; ++k) block[4 * k] += numbers[i];
  }
}

void Assembly::add_mass(const double* mass, double factor, double* values) const {
  for (int i = 0; i < unknowns(); ++i) {
    const double* from = mass + 9 * static_cast<std::ptrdiff_t>(free_nodes()[i]);
    double* block = values + 9 * blocks().diagonal[i];
    for (int k = 0; k < 9; ++k) block[k] += factor * from[k];
  }
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    if (kinds_[k]->has_bodies()) {
      kinds_[k]->add_body_mass(field(), factor, blocks().places[k + 4].into(values));
    }
  }
}

double Assembly::heaviest_body() const {
  double most = 0.0;
  for (const ElementKind* kind : kinds_) most = std::max(most, kind->heaviest_body(field()));
  return most;
}

void Assembly::inertia(const double* mass, const double* acceleration, double* force) {
  for (int n = 0; n < model_.nodes; ++n) {
    at(force, n) =
        Eigen::Map<const Block>(mass + 9 * static_cast<std::ptrdiff_t>(n)) * at(acceleration, n);
  }
  if (!has_bodies_) return;
  spread(acceleration, moved_);
  std::fill(force_.begin(), force_.end(), 0.0);
  for (const ElementKind* kind : kinds_) {
    if (kind->has_bodies()) kind->add_body_inertia(field(), moved_.data(), force_.data());
  }
  hand_on(force_.data(), 3);
  for (int n = 0; n < model_.nodes; ++n) at(force, n) += at(force_.data(), n);
}

void Assembly::mass(double* mass) {
  masses_.assign(3 * position_.size(), 0.0);
  for (int p = 0; p < model_.points(); ++p) {
    for (int k = 0; k < 3; ++k) masses_[9 * static_cast<std::size_t>(p) + 4 * k] = model_.mass[p];
  }
  gather_added_mass();
  hand_on(masses_.data(), 9);
  std::copy(masses_.begin(), masses_.begin() + 9 * static_cast<std::ptrdiff_t>(model_.nodes), mass);
}

double Assembly::fall_time(const double* x) const {
  const double radius = largest_distance_from_mean(x, model_.nodes);
  return radius > 0.0 ? std::sqrt(2.0 * radius / gravity) : 1.0;
}

void Assembly::pseudo_damping(double time, double* damping) {
  for (std::size_t p = 0; p < scale_.size(); ++p) scale_[p] = model_.mass[p] / time;
  lines_.add_drag_scale(scale_.data());
  for (const ElementKind* kind : kinds_) kind->add_drag_scale(field(), time, scale_.data());
  model_.contacts.add_drag_scale(field(), scale_.data());
  hand_on(scale_.data(), 1);
  for (int i = 0; i < unknowns(); ++i) damping[i] = scale_[free_nodes()[i]] / time;
}

void Assembly::drag_across(std::vector<double>& drag) const {
  drag.resize(static_cast<std::size_t>(model_.lines()));
  model_.each_line([&](const auto& line) {
    const int point = line.nodes[0];
    Vector current, slope;
    model_.water.velocity(at(position_.data(), point).z(), current, slope);
    const double speed = (current - at(velocity_.data(), point)).norm();
    drag[static_cast<std::size_t>(line.index)] =
        0.6 * model_.water.density * model_.material(line).diameter * line.rest * speed * speed;
  });
}

double Assembly::largest_tension() const {
  const bool has_bars = model_.bars.count() > 0;
  const int lines = has_bars ? model_.bars.count() : lines_.count();
  double largest = 0.0;
  for (int k = 0; k < lines; ++k) {
    const double many = has_bars ? this->lines().multiplicity[k] : 1.0;
    largest = std::max(largest, many * this->lines().tension[k]);
  }
  for (const SlidingRope& rope : model_.sliding) largest = std::max(largest, rope.tension(field()));
  return largest;
}

void Assembly::strain(std::vector<double>& values) const {
  values.assign(lines().strain, lines().strain + lines_.count());
  for (int e = 0; e < model_.contacts.count(); ++e) {
    values.push_back(model_.contacts.penetration(e, field()));
  }
}

std::vector<Vector> Assembly::ground_places() const {
  std::vector<Vector> out;
  for (const int point : model_.contacts.node) out.push_back(at(position_.data(), point));
  const std::vector<Vector> shoes = model_.plates.shoes(field());
  out.insert(out.end(), shoes.begin(), shoes.end());
  return out;
}

const LineChange& Assembly::line_change(const double* dx) {
  spread(dx, moved_);
  change_.rotation = lines_.change(moved_.data(), change_.strain.data());
  change_.plate_turn = model_.plates.turn(moved_.data());
  change_.surfacing = model_.volumes.surfacing(field(), moved_.data());
  const GroundContacts& contacts = model_.contacts;
  for (int e = 0; e < contacts.count(); ++e) {
    change_.strain[static_cast<std::size_t>(lines_.count() + e)] =
        -model_.ground.normal.dot(at(moved_.data(), contacts.node[e]));
  }
  return change_;
}

}  // namespace codend
