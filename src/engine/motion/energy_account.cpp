#include "energy_account.hpp"

#include <cmath>

namespace codend {
namespace {

// Elastic energy of a ground contact (J), the integral of Ground::press().
double pressed(const Ground& ground, double penetration, double area) {
  if (penetration <= 0.0) return 0.0;
  const double h = ground.onset, k = ground.stiffness * area;
  if (penetration < h) return k * penetration * penetration * penetration / (6.0 * h);
  const double beyond = penetration - h;
  return k * (h * h / 6.0 + 0.5 * h * beyond + 0.5 * beyond * beyond);
}

// Decrease of a line's strain energy per unit of added rest length, -dW/dL0, N.
double give(const TwineMaterial& material, double length, double rest) {
  if (length <= rest && !material.strut) return 0.0;
  const TwinePull pull = twine_pull(material, length / rest - 1.0);
  return length / rest * pull.tension - pull.energy;
}

constexpr double EnergyTotals::*parts[] = {&EnergyTotals::kinetic,   &EnergyTotals::elastic,
                                           &EnergyTotals::potential, &EnergyTotals::supports,
                                           &EnergyTotals::lengths,   &EnergyTotals::water,
                                           &EnergyTotals::damping};

}  // namespace

EnergyTotals between(const EnergyTotals& begin, const EnergyTotals& end, double share) {
  EnergyTotals out = begin;
  for (double EnergyTotals::*part : parts) out.*part += share * (end.*part - begin.*part);
  out.put_through += share * (end.put_through - begin.put_through);
  return out;
}

EnergyAccount::EnergyAccount(Assembly& assembly)
    : assembly_(assembly), force_(3 * static_cast<std::size_t>(assembly.model().points())) {
  other_.resize(force_.size());
}

void EnergyAccount::measure(const Motion& motion, Moment& moment) {
  const Model& model = assembly_.model();
  moment.time = motion.time;
  moment.x = motion.x;
  moment.v = motion.v;
  moment.load = model.load;
  moment.rest = model.bars.rest;
  moment.give.resize(moment.rest.size());
  moment.mass.resize(9 * static_cast<std::size_t>(model.nodes));
  assembly_.move_to(motion.x.data(), motion.v.data());
  assembly_.residual(force_.data());
  assembly_.mass(moment.mass.data());
  const Field field = assembly_.field();
  const LineArrays& lines = assembly_.lines();
  moment.place.assign(field.position, field.position + force_.size());
  moment.velocity.assign(field.velocity, field.velocity + force_.size());
  moment.elastic = moment.supports = moment.damping = 0.0;
  double all = 0.0, named = 0.0;
  for (int n = 0; n < model.nodes; ++n) {
    const double power = at(force_.data(), n).dot(at(motion.v.data(), n));
    all += power;
    if (model.held[n]) moment.supports -= power;
  }
  for (int p = 0; p < model.points(); ++p) {
    named += at(model.load.data(), p).dot(at(field.velocity, p));
  }
  model.each_line([&](const auto& line) {
    const int k = line.index;
    const double tension = lines.multiplicity[k] * lines.tension[k];
    const double length = line.rest * (1.0 + lines.strain[k]);
    moment.elastic += lines.multiplicity[k] * twine_energy(model.material(line), length, line.rest);
    moment.elastic += line.held_energy(lines);
    named += line.held_power(lines, field.velocity);
    if (k < model.bars.count()) {
      moment.give[static_cast<std::size_t>(k)] =
          lines.multiplicity[k] * give(model.material(line), length, line.rest);
    }
    if (tension == 0.0) return;
    const double stretching = line.stretching(lines, field.velocity);
    named -= tension * stretching;
    const double spring =
        lines.multiplicity[k] * twine_tension(model.material(line), length, line.rest);
    moment.damping -= (tension - spring) * stretching;
  });
  for (const SlidingRope& rope : model.sliding) {
    moment.elastic += rope.energy(field);
    std::fill(other_.begin(), other_.end(), 0.0);
    rope.add_force(field, other_.data());
    for (const int p : rope.nodes()) {
      named += at(other_.data(), p).dot(at(field.velocity, p));
      at(other_.data(), p).setZero();  // a rope may pass a point twice
    }
  }
  const GroundContacts& contacts = model.contacts;
  for (int e = 0; e < contacts.count(); ++e) {
    const double penetration = contacts.penetration(e, field);
    double press, slope;
    model.ground.press(penetration, contacts.area[e], press, slope);
    moment.elastic += pressed(model.ground, penetration, contacts.area[e]);
    named += press * model.ground.normal.dot(at(field.velocity, contacts.node[e]));
  }
  moment.water = all - named;
}

double EnergyAccount::gained_by_bodies() {
  const Model& model = assembly_.model();
  double gained = 0.0;
  for (const ElementKind* kind : model.kinds()) {
    if (!kind->has_bodies()) continue;
    std::vector<double> change(force_.size(), 0.0);
    for (const int p : kind->nodes()) {
      if (p < model.nodes && model.held[p]) continue;
      at(change.data(), p) = at(to_.velocity.data(), p) - at(from_.velocity.data(), p);
    }
    std::fill(other_.begin(), other_.end(), 0.0);
    Field field = assembly_.field();
    for (const Moment* end : {&from_, &to_}) {
      field.position = end->place.data();
      kind->add_body_inertia(field, change.data(), other_.data());
    }
    for (int p = 0; p < model.points(); ++p) {
      if (p < model.nodes && model.held[p]) continue;
      gained += 0.25 *
                at(other_.data(), p).dot(at(from_.velocity.data(), p) + at(to_.velocity.data(), p));
    }
  }
  return gained;
}

void EnergyAccount::begin(const Motion& now) { measure(now, from_); }

double EnergyAccount::present() const {
  double sum = from_.elastic;
  for (const int n : assembly_.free_nodes()) {
    const Vector v = at(from_.v.data(), n);
    sum += 0.5 * v.dot(Eigen::Map<const Block>(&from_.mass[9 * static_cast<std::size_t>(n)]) * v);
  }
  return sum;
}

EnergyTotals EnergyAccount::after(const Motion& next, const EnergyTotals& before) {
  measure(next, to_);
  const Model& model = assembly_.model();
  EnergyTotals step;
  for (const int n : assembly_.free_nodes()) {
    const Vector v0 = at(from_.v.data(), n), v1 = at(to_.v.data(), n);
    const Eigen::Map<const Block> m0(&from_.mass[9 * static_cast<std::size_t>(n)]);
    const Eigen::Map<const Block> m1(&to_.mass[9 * static_cast<std::size_t>(n)]);
    step.kinetic += 0.25 * (v0 + v1).dot((m0 + m1) * (v1 - v0));
  }
  step.kinetic += gained_by_bodies();
  step.elastic = to_.elastic - from_.elastic;
  for (std::size_t b = 0; b < to_.rest.size(); ++b) {
    step.lengths -= 0.5 * (from_.give[b] + to_.give[b]) * (to_.rest[b] - from_.rest[b]);
  }
  auto place = [&](const Moment& moment, int p) -> Vector {
    if (p < model.nodes) return at(moment.x.data(), p);
    const Tie& tie = model.ties[static_cast<std::size_t>(p - model.nodes)];
    return (1.0 - tie.share) * at(moment.x.data(), tie.first) +
           tie.share * at(moment.x.data(), tie.second);
  };
  for (int p = 0; p < model.points(); ++p) {
    const Vector x0 = place(from_, p), x1 = place(to_, p);
    const Vector l0 = at(from_.load.data(), p), l1 = at(to_.load.data(), p);
    step.potential -= 0.5 * (l0 + l1).dot(x1 - x0);
  }
  const double half = 0.5 * (to_.time - from_.time);
  step.supports = half * (from_.supports + to_.supports);
  step.water = half * (from_.water + to_.water);
  step.damping = half * (from_.damping + to_.damping);
  EnergyTotals out = before;
  for (double EnergyTotals::*part : parts) {
    out.*part += step.*part;
    out.put_through += 0.5 * std::abs(step.*part);
  }
  return out;
}

}  // namespace codend
