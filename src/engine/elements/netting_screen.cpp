#include "netting_screen.hpp"

#include <algorithm>
#include <cmath>

#include "../base/solidity.hpp"

namespace codend {
namespace {

void multiply(ScreenCoefficient& k, double by) {
  k.value *= by;
  k.by_cosine *= by;
  k.by_solidity *= by;
  k.by_reynolds *= by;
}

}  // namespace

ScreenFlow screen_flow(const Field& field, const CellShape& shape, const int* node, double height) {
  ScreenFlow out;
  out.u.setZero();
  for (int k = 0; k < 4; ++k) {
    out.x[k] = at(field.position, node[k]);
    Vector u;
    out.own[k] = shape.share[k] * field.relative_velocity(node[k], height, u, out.slope[k]);
    out.u += shape.share[k] * u;
    out.slope[k] *= shape.share[k];
  }
  out.area = 0.5 * (out.x[2] - out.x[0]).cross(out.x[3] - out.x[1]);
  return out;
}

Matrix area_slope(const ScreenFlow& flow, int l) {
  // dS = 1/2 dx_l x (x_l+1 - x_l+3).
  const Vector side = 0.5 * (flow.x[(l + 1) % 4] - flow.x[(l + 3) % 4]);
  Matrix out;
  out << 0.0, side.z(), -side.y(), -side.z(), 0.0, side.x(), side.y(), -side.x(), 0.0;
  return out;
}

ScreenForce screen_force(NettingScreenLaw law, const ScreenFlow& flow, double twine_area,
                         double overlap, double diameter, double multiplicity, const Water& water,
                         ScreenMultipliers multipliers) {
  ScreenForce out;
  const Vector &s = flow.area, &u = flow.u;
  const double area = s.norm(), speed = u.norm();
  if (area == 0.0 || speed == 0.0) return out;
  const double along = s.dot(u), sign = along < 0.0 ? -1.0 : 1.0;
  const double cosine = std::min(1.0, std::abs(along) / (area * speed));
  const double twine = twine_area / (multiplicity * area);
  const auto [solidity, by_closing] = solidity_of(twine, overlap);
  const double re_per_speed = diameter / water.viscosity;
  ScreenCoefficients k = screen_coefficients(law, cosine, solidity, re_per_speed * speed);
  multiply(k.drag, multipliers.drag);
  multiply(k.lift_per_sine, multipliers.lift);
  // F = c (P A |U| U + G |U|^2 sign S) with G = C_L / sin th, P = C_D - G cos th.
  const ScreenCoefficient& g = k.lift_per_sine;
  const double p = k.drag.value - g.value * cosine;
  const Eigen::RowVector3d cosine_by_area =
      (sign / (area * speed) * u - cosine / (area * area) * s).transpose();
  const Eigen::RowVector3d cosine_by_velocity =
      (sign / (area * speed) * s - cosine / (speed * speed) * u).transpose();
  const Eigen::RowVector3d normal = s.transpose() / area, way = u.transpose() / speed;
  const Eigen::RowVector3d g_by_area =
      g.by_cosine * cosine_by_area - g.by_solidity * by_closing / area * normal;
  const Eigen::RowVector3d g_by_velocity =
      g.by_cosine * cosine_by_velocity + g.by_reynolds * re_per_speed * way;
  const Eigen::RowVector3d p_by_area = k.drag.by_cosine * cosine_by_area -
                                       k.drag.by_solidity * by_closing / area * normal -
                                       cosine * g_by_area - g.value * cosine_by_area;
  const Eigen::RowVector3d p_by_velocity = k.drag.by_cosine * cosine_by_velocity +
                                           k.drag.by_reynolds * re_per_speed * way -
                                           cosine * g_by_velocity - g.value * cosine_by_velocity;
  const double c = 0.5 * water.density * multiplicity;
  out.value = c * (p * area * speed * u + g.value * speed * speed * sign * s);
  out.by_area =
      c * (speed * u * (area * p_by_area + p * normal) + speed * speed * sign * s * g_by_area);
  out.by_area.diagonal().array() += c * g.value * speed * speed * sign;
  out.by_velocity =
      c * (area * speed * u * p_by_velocity + p * area * u * way +
           speed * speed * sign * s * g_by_velocity + 2.0 * g.value * speed * sign * s * way);
  out.by_velocity.diagonal().array() += c * p * area * speed;
  return out;
}

ScreenForce NettingScreens::force(int e, const ScreenFlow& flow, const Water& water) const {
  const std::size_t t = static_cast<std::size_t>(e);
  return screen_force(law[t], flow, twine_area[t], overlap[t], diameter[t], multiplicity[t], water,
                      multipliers);
}

Vector NettingScreens::element_force(int e, const Field& field) const {
  return force(e, flow(e, field), *field.water).value;
}

void NettingScreens::prepare() {
  shape_.clear();
  for (std::size_t e = 0; e < law.size(); ++e) shape_.push_back(cell_shape(&twine[8 * e]));
}

void NettingScreens::add_force(const Field& field, double* out) const {
  for (int e = 0; e < count(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const Vector whole = element_force(e, field);
    for (std::size_t k = 0; k < 4; ++k) at(out, node[4 * i + k]) += shape_[i].share[k] * whole;
  }
}

void NettingScreens::add_jacobian(const Field& field, const JacobianRequest& request,
                                  const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    const double* share = shape_[static_cast<std::size_t>(e)].share;
    const ScreenFlow f = flow(e, field);
    const ScreenForce s = force(e, f, *field.water);
    for (int l = 0; l < 4; ++l) {
      Matrix block = -request.stiffness * (s.by_area * area_slope(f, l)) +
                     request.damping * f.own[l] * s.by_velocity;
      block.col(2) -= request.stiffness * (s.by_velocity * f.slope[l]);
      for (int k = 0; k < 4; ++k) sink.add(e, k, l, (share[k] * block).eval());
    }
  }
}

void NettingScreens::add_drag_scale(const Field& field, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ScreenFlow f = flow(e, field);
    // Drag coefficient of about 1.2 on the twine area, as for twines across the flow.
    const double whole = 0.6 * field.water->density * twine_area[i] * f.u.norm();
    for (std::size_t k = 0; k < 4; ++k) scale[node[4 * i + k]] += shape_[i].share[k] * whole;
  }
}

}  // namespace codend
