#include "inner_pressure.hpp"

#include <cmath>

namespace codend {

Vector InnerPressure::mean_velocity(const Field& field) const {
  Vector sum = Vector::Zero();
  double weights = 0.0;
  for (int e = 0; e < count(); ++e) {
    const std::size_t i = 3 * static_cast<std::size_t>(e);
    const double covered = std::abs(weight[i]) + std::abs(weight[i + 1]) + std::abs(weight[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) sum += covered / 3.0 * at(field.velocity, node[i + k]);
    weights += covered;
  }
  return weights > 0.0 ? Vector(sum / weights) : sum;
}

InnerPressure::Push InnerPressure::push(int e, const Field& field, const Vector& mean) const {
  Push out;
  out.u.setZero();
  for (int k = 0; k < 3; ++k) {
    const int point = node[3 * static_cast<std::size_t>(e) + k];
    out.x[k] = at(field.position, point);
    Vector u;
    out.share +=
        field.relative_velocity(point, height[static_cast<std::size_t>(e)], mean, u, out.slope[k]) /
        9.0;
    out.u += u / 3.0;
    out.slope[k] /= 3.0;
  }
  out.area = 0.5 * (out.x[1] - out.x[0]).cross(out.x[2] - out.x[0]);
  out.pressure = 0.5 * drag_coefficient * field.water->density * out.u.squaredNorm();
  return out;
}

Vector InnerPressure::element_force(int e, const Field& field, const Vector& mean) const {
  const Push p = push(e, field, mean);
  const double* w = &weight[3 * static_cast<std::size_t>(e)];
  return (w[0] + w[1] + w[2]) * p.pressure * p.area;
}

void InnerPressure::add_force(const Field& field, double* force) const {
  const Vector mean = mean_velocity(field);
  for (int e = 0; e < count(); ++e) {
    const Push p = push(e, field, mean);
    for (int k = 0; k < 3; ++k) {
      const std::size_t i = 3 * static_cast<std::size_t>(e) + k;
      at(force, node[i]) += weight[i] * p.pressure * p.area;
    }
  }
}

void InnerPressure::add_jacobian(const Field& field, const JacobianRequest& request,
                                 const BlockSink& sink) const {
  const Vector mean = mean_velocity(field);
  for (int e = 0; e < count(); ++e) {
    const Push p = push(e, field, mean);
    const double c = drag_coefficient * field.water->density;
    for (int l = 0; l < 3; ++l) {
      // dS = 1/2 dx_l x (x_l+1 - x_l+2).
      const Vector side = 0.5 * (p.x[(l + 1) % 3] - p.x[(l + 2) % 3]);
      Matrix turn;  // dS/dx_l
      turn << 0.0, side.z(), -side.y(), -side.z(), 0.0, side.x(), side.y(), -side.x(), 0.0;
      Matrix by = -request.stiffness * p.pressure * turn;
      by += (request.damping * c * p.share) * (p.area * p.u.transpose());
      by.col(2) -= (request.stiffness * c * p.u.dot(p.slope[l])) * p.area;
      for (int k = 0; k < 3; ++k) {
        const double w = weight[3 * static_cast<std::size_t>(e) + k];
        if (w != 0.0) sink.add(e, k, l, (w * by).eval());
      }
    }
  }
}

void InnerPressure::add_drag_scale(const Field& field, double, double* scale) const {
  const Vector mean = mean_velocity(field);
  for (int e = 0; e < count(); ++e) {
    const Push p = push(e, field, mean);
    const double speed = p.u.norm();
    for (int k = 0; k < 3; ++k) {
      const std::size_t i = 3 * static_cast<std::size_t>(e) + k;
      scale[node[i]] += std::abs(weight[i]) * p.area.norm() * 0.5 * drag_coefficient *
                        field.water->density * speed;
    }
  }
}

}  // namespace codend
