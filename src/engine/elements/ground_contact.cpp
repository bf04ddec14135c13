#include "ground_contact.hpp"

namespace codend {

Vector GroundContacts::element_force(int e, const Field& field) const {
  double slope;
  Matrix by_velocity;
  return law(e, field, slope) * per_press(e, field, by_velocity);
}

void GroundContacts::add_force(const Field& field, const double* press, double* force) const {
  for (int e = 0; e < count(); ++e) {
    if (!press) {
      at(force, node[e]) += element_force(e, field);
      continue;
    }
    Matrix by_velocity;
    at(force, node[e]) += press[e] * per_press(e, field, by_velocity);
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
    Matrix by_velocity;
    const Vector direction = per_press(e, field, by_velocity);
    sink.add(e, 0, 0,
             Matrix((request.stiffness * slope) * direction * ground.normal.transpose() -
                    (request.damping * normal_force) * by_velocity));
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
