#include "netting_screen.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

NettingScreens::Flow NettingScreens::flow(int e, const Field& field) const {
  Flow out;
  out.u.setZero();
  for (int k = 0; k < 3; ++k) {
    const int point = node[3 * static_cast<std::size_t>(e) + k];
    out.x[k] = at(field.position, point);
    Vector u;
    field.relative_velocity(point, u, out.slope[k]);
    out.u += u / 3.0;
    out.slope[k] /= 3.0;
  }
  out.area = 0.5 * (out.x[1] - out.x[0]).cross(out.x[2] - out.x[0]);
  return out;
}

void NettingScreens::force(int e, const Flow& flow, const Water& water, Vector& value,
                           Matrix& by_area, Matrix& by_velocity) const {
  value.setZero();
  by_area.setZero();
  by_velocity.setZero();
  const std::size_t t = static_cast<std::size_t>(e);
  const Vector &s = flow.area, &u = flow.u;
  const double area = s.norm(), speed = u.norm();
  if (area == 0.0 || speed == 0.0) return;
  const double along = s.dot(u), sign = along < 0.0 ? -1.0 : 1.0;
  const double cosine = std::min(1.0, std::abs(along) / (area * speed));
  const double solidity = twine_area[t] / (multiplicity[t] * area);
  const double re_per_speed = diameter[t] / water.viscosity;
  const ScreenCoefficients k = screen_coefficients(
      static_cast<NettingScreenLaw>(law[t]), cosine, solidity, re_per_speed * speed);
  // F = c (P A |U| U + G |U|^2 sign S) with G = C_L / sin th, P = C_D - G cos th.
  const ScreenCoefficient& g = k.lift_per_sine;
  const double p = k.drag.value - g.value * cosine;
  const Eigen::RowVector3d cosine_by_area =
      (sign / (area * speed) * u - cosine / (area * area) * s).transpose();
  const Eigen::RowVector3d cosine_by_velocity =
      (sign / (area * speed) * s - cosine / (speed * speed) * u).transpose();
  const Eigen::RowVector3d normal = s.transpose() / area, way = u.transpose() / speed;
  const Eigen::RowVector3d g_by_area =
      g.by_cosine * cosine_by_area - g.by_solidity * solidity / area * normal;
  const Eigen::RowVector3d g_by_velocity =
      g.by_cosine * cosine_by_velocity + g.by_reynolds * re_per_speed * way;
  const Eigen::RowVector3d p_by_area = k.drag.by_cosine * cosine_by_area -
                                       k.drag.by_solidity * solidity / area * normal -
                                       cosine * g_by_area - g.value * cosine_by_area;
  const Eigen::RowVector3d p_by_velocity =
      k.drag.by_cosine * cosine_by_velocity + k.drag.by_reynolds * re_per_speed * way -
      cosine * g_by_velocity - g.value * cosine_by_velocity;
  const double c = 0.5 * water.density * multiplicity[t];
  value = c * (p * area * speed * u + g.value * speed * speed * sign * s);
  by_area = c * (speed * u * (area * p_by_area + p * normal) +
                 speed * speed * sign * s * g_by_area);
  by_area.diagonal().array() += c * g.value * speed * speed * sign;
  by_velocity = c * (area * speed * u * p_by_velocity + p * area * u * way +
                     speed * speed * sign * s * g_by_velocity +
                     2.0 * g.value * speed * sign * s * way);
  by_velocity.diagonal().array() += c * p * area * speed;
}

Vector NettingScreens::element_force(int e, const Field& field) const {
  Vector value;
  Matrix by_area, by_velocity;
  force(e, flow(e, field), *field.water, value, by_area, by_velocity);
  return value;
}

void NettingScreens::add_force(const Field& field, double* out) const {
  for (int e = 0; e < count(); ++e) {
    const Vector third = element_force(e, field) / 3.0;
    for (int k = 0; k < 3; ++k) at(out, node[3 * static_cast<std::size_t>(e) + k]) += third;
  }
}

void NettingScreens::add_jacobian(const Field& field, const JacobianRequest& request,
                                  const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    const Flow f = flow(e, field);
    Vector value;
    Matrix by_area, by_velocity;
    force(e, f, *field.water, value, by_area, by_velocity);
    for (int l = 0; l < 3; ++l) {
      // S changes by 1/2 dx_l x (x_l+1 - x_l+2).
      const Vector side = 0.5 * (f.x[(l + 1) % 3] - f.x[(l + 2) % 3]);
      Matrix turn;  // dS/dx_l
      turn << 0.0, side.z(), -side.y(), -side.z(), 0.0, side.x(), side.y(), -side.x(), 0.0;
      Matrix block = -request.stiffness / 3.0 * (by_area * turn) +
                     request.damping / 9.0 * by_velocity;
      block.col(2) -= request.stiffness / 3.0 * (by_velocity * f.slope[l]);
      for (int k = 0; k < 3; ++k) sink.add(e, k, l, block);
    }
  }
}

void NettingScreens::add_drag_scale(const Field& field, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    const Flow f = flow(e, field);
    // About a coefficient of 1.2 on the twine's area, as of twines across the flow.
    const double whole = 0.6 * field.water->density * twine_area[e] * f.u.norm();
    for (int k = 0; k < 3; ++k) scale[node[3 * static_cast<std::size_t>(e) + k]] += whole / 3.0;
  }
}

}  // namespace codend
