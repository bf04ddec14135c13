#include "lifting_surface.hpp"

#include <cmath>

namespace codend {

void LiftingSurfaces::lift(LiftDirection direction, const Vector& u, Vector& value,
                           Matrix& by_velocity) {
  value.setZero();
  by_velocity.setZero();
  const Vector z = Vector::UnitZ();
  const double flat = std::hypot(u.x(), u.y());
  if (flat == 0.0) return;  // no horizontal flow: the direction is not defined
  if (direction == LiftDirection::sideways) {
    // |U|^2 (z x U)/|z x U| = |U|^2 s / h
    const Vector s = z.cross(u);
    Matrix cross = Matrix::Zero();
    cross(0, 1) = -1.0;
    cross(1, 0) = 1.0;
    const double speed2 = u.squaredNorm();
    value = (speed2 / flat) * s;
    const Vector horizontal(u.x(), u.y(), 0.0);
    by_velocity = (speed2 / flat) * cross + (2.0 / flat) * (s * u.transpose()) -
                  (speed2 / (flat * flat * flat)) * (s * horizontal.transpose());
    return;
  }
  // |U|^2 (z - u (u.z))/|...| = |U| (|U|^2 z - U U_z) / h with h the horizontal speed
  const double speed = u.norm();
  const Vector p = speed * speed * z - u.z() * u;
  const Matrix p_by_u = 2.0 * z * u.transpose() - u.z() * Matrix::Identity() - u * z.transpose();
  value = (speed / flat) * p;
  const Vector horizontal(u.x(), u.y(), 0.0);
  by_velocity = (speed / flat) * p_by_u + (p / flat) * (u / speed).transpose() -
                (speed / (flat * flat * flat)) * (p * horizontal.transpose());
}

Vector LiftingSurfaces::element_force(int e, const Field& field) const {
  Vector u, du, value;
  Matrix by_velocity;
  field.relative_velocity(node[e], height[e], u, du);
  lift(direction[e], u, value, by_velocity);
  return (0.5 * field.water->density * lift_area[e]) * value;
}

void LiftingSurfaces::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) at(force, node[e]) += element_force(e, field);
}

void LiftingSurfaces::add_jacobian(const Field& field, const JacobianRequest& request,
                                   const BlockSink& sink) const {
  // Without damping and depth-dependent flow the force does not depend on x.
  if (request.damping == 0.0 && !field.water->varies_with_height()) return;
  for (int e = 0; e < count(); ++e) {
    Vector u, du, value;
    Matrix by_velocity;
    const double own = field.relative_velocity(node[e], height[e], u, du);
    lift(direction[e], u, value, by_velocity);
    by_velocity *= 0.5 * field.water->density * lift_area[e];
    Matrix block = (request.damping * own) * by_velocity;
    block.col(2) -= request.stiffness * (by_velocity * du);
    sink.add(e, 0, 0, block);
  }
}

void LiftingSurfaces::add_drag_scale(const Field& field, double, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    Vector u, du;
    field.relative_velocity(node[e], height[e], u, du);
    scale[node[e]] += 0.5 * field.water->density * std::abs(lift_area[e]) * u.norm();
  }
}

}  // namespace codend
