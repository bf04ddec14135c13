#include "sphere.hpp"

#include <cmath>

namespace codend {

void Spheres::coefficient(int e, double speed, double viscosity, double& value,
                          double& slope) const {
  if (diameter[e] == 0.0) {
    value = speed;
    slope = 1.0;
    return;
  }
  const double per_speed = diameter[e] / viscosity;
  if (smooth[e]) {
    const double re = per_speed * speed, r = re / 2.63e5;
    const double rise = std::pow(re / 5.0, 1.52), fall = std::pow(r, 8.0);
    const double first = 2.6 * (re / 5.0) / (1.0 + rise);
    const double second = 0.411 * std::pow(r, 0.06) / (1.0 + fall);
    const double third = std::pow(re, 0.8) / 461000.0;
    value = 24.0 / per_speed + speed * (first + second + third);
    // Derivative of speed x term by speed: the term plus Re times its derivative.
    slope = first * (2.0 - 1.52 * rise / (1.0 + rise)) +
            second * (1.06 - 8.0 * fall / (1.0 + fall)) + 1.8 * third;
    return;
  }
  const double root = std::sqrt(per_speed * speed);
  const double one = 1.0 + root;
  value = 24.0 / per_speed + 6.0 * speed / one + 0.4 * speed;
  slope = 6.0 / one - 3.0 * root / (one * one) + 0.4;
}

Vector Spheres::element_force(int e, const Field& field) const {
  Vector u, du;
  field.relative_velocity(node[e], height[e], u, du);
  double c, slope;
  coefficient(e, u.norm(), field.water->viscosity, c, slope);
  return (0.5 * field.water->density * drag_area[e] * c) * u;
}

void Spheres::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    if (!field.is_still(node[e])) at(force, node[e]) += element_force(e, field);
  }
}

void Spheres::add_jacobian(const Field& field, const JacobianRequest& request,
                           const BlockSink& sink) const {
  // Without damping and depth-dependent flow the force does not depend on x.
  if (request.damping == 0.0 && !field.water->varies_with_height()) return;
  for (int e = 0; e < count(); ++e) {
    if (field.is_still(node[e])) continue;
    Vector u, du;
    const double own = field.relative_velocity(node[e], height[e], u, du);
    const double speed = u.norm();
    double c, slope;
    coefficient(e, speed, field.water->viscosity, c, slope);
    Matrix by_velocity = c * Matrix::Identity();
    if (speed > 0.0) by_velocity += (slope / speed) * (u * u.transpose());
    by_velocity *= 0.5 * field.water->density * drag_area[e];
    Matrix block = (request.damping * own) * by_velocity;
    block.col(2) -= request.stiffness * (by_velocity * du);
    sink.add(e, 0, 0, block);
  }
}

void Spheres::add_added_mass(const Field& field, double* mass) const {
  for (int e = 0; e < count(); ++e) {
    Eigen::Map<Block>(mass + 9 * static_cast<std::ptrdiff_t>(node[e])) +=
        field.immersed_share(node[e], height[e]) * field.water->density * added_mass[e] *
        Matrix::Identity();
  }
}

void Spheres::add_drag_scale(const Field& field, double, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    Vector u, du;
    field.relative_velocity(node[e], height[e], u, du);
    double c, slope;
    coefficient(e, u.norm(), field.water->viscosity, c, slope);
    scale[node[e]] += 0.5 * field.water->density * drag_area[e] * c;
  }
}

}  // namespace codend
