#include "ground_contact.hpp"

namespace codend {

void GroundContacts::add_element_force(int e, const Field& field, double* force) const {
  Vector f;
  Matrix by_position, by_velocity;
  ground.contact(at(field.position, node[e]), at(field.velocity, node[e]), clearance[e], area[e],
                 f, by_position, by_velocity);
  at(force, 0) += f;
}

void GroundContacts::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) add_element_force(e, field, force + 3 * node[e]);
}

void GroundContacts::add_jacobian(const Field& field, const JacobianRequest& request,
                                  const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    Vector f;
    Matrix by_position, by_velocity;
    ground.contact(at(field.position, node[e]), at(field.velocity, node[e]), clearance[e], area[e],
                   f, by_position, by_velocity);
    sink.add(e, 0, 0, Matrix(-request.stiffness * by_position - request.damping * by_velocity));
  }
}

void GroundContacts::add_drag_scale(const Field& field, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    double press, slope;
    ground.press(ground.penetration(at(field.position, node[e]), clearance[e]), area[e], press,
                 slope);
    const double speed = (at(field.velocity, node[e]) - ground.velocity).norm();
    scale[node[e]] += ground.friction * press / (speed + ground.slip);
  }
}

}  // namespace codend
