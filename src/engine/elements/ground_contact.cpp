#include "ground_contact.hpp"

#include <algorithm>

namespace codend {

void GroundContacts::prepare() {
  line_.assign(node.size(), -1);
  for (std::size_t k = 0; k < lines.node.size(); ++k) {
    const auto found = std::find(node.begin(), node.end(), lines.node[k]);
    if (found != node.end())
      line_[static_cast<std::size_t>(found - node.begin())] = static_cast<int>(k);
  }
}

Vector GroundContacts::per_press(int e, const Field& field, Matrix* by_position,
                                 Matrix* by_velocity) const {
  const Ground& ground = *field.ground;
  Rubbing rub = ground.rubbing();
  if (line_[e] >= 0) {
    const std::size_t k = static_cast<std::size_t>(line_[e]);
    rub.along = lines.along[k];
    rub.across = lines.across[k];
    rub.way =
        at(field.position, lines.between[2 * k + 1]) - at(field.position, lines.between[2 * k]);
  }
  const Vector v = at(field.velocity, node[e]);
  if (anchor.empty()) return ground.per_press(v, rub, nullptr, by_position, by_velocity);
  const Vector away = at(field.position, node[e]) - anchor[e];
  return ground.per_press(v, rub, &away, by_position, by_velocity);
}

void GroundContacts::draw_anchors(const Field& field) {
  const Ground& ground = *field.ground;
  for (int e = 0; e < count(); ++e) {
    anchor[e] = ground.draw(anchor[e], at(field.position, node[e]), at(field.velocity, node[e]),
                            penetration(e, field) > 0.0);
  }
}

Vector GroundContacts::element_force(int e, const Field& field) const {
  double slope;
  const double press = law(e, field, slope);
  if (press == 0.0) return Vector::Zero();
  return press * per_press(e, field);
}

void GroundContacts::add_force(const Field& field, const double* press, double* force) const {
  for (int e = 0; e < count(); ++e) {
    if (!press) {
      at(force, node[e]) += element_force(e, field);
      continue;
    }
    if (press[e] != 0.0) at(force, node[e]) += press[e] * per_press(e, field);
  }
}

void GroundContacts::add_jacobian(const Field& field, const JacobianRequest& request,
                                  const double* press, const double* modulus,
                                  const BlockSink& sink) const {
  if (count() == 0) return;
  const Ground& ground = *field.ground;
  for (int e = 0; e < count(); ++e) {
    double slope;
    double normal_force = law(e, field, slope);
    if (press) {
      normal_force = press[e];
      slope = modulus[e];
    }
    if (slope == 0.0 && normal_force == 0.0) continue;
    Matrix by_position, by_velocity;
    const Vector direction = per_press(e, field, &by_position, &by_velocity);
    sink.add(
        e, 0, 0,
        Matrix((request.stiffness * slope) * direction * ground.normal.transpose() -
               normal_force * (request.stiffness * by_position + request.damping * by_velocity)));
  }
}

void GroundContacts::add_drag_scale(const Field& field, double* scale) const {
  if (count() == 0) return;
  const Ground& ground = *field.ground;
  for (int e = 0; e < count(); ++e) {
    double slope;
    const double speed = (at(field.velocity, node[e]) - ground.velocity).norm();
    scale[node[e]] += ground.friction * law(e, field, slope) / (speed + ground.slip);
  }
}

}  // namespace codend
