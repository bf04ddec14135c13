#include "twine_drag.hpp"

#include <cmath>

#include "../base/pi.hpp"

namespace codend {

TwineDrag twine_drag(const TwineMaterial& material, double metres, double rest, const Vector& e,
                     const Vector& u, const Water& water, SlackDrag slack) {
  // Means over all directions of sin^3 and |cos|^3, as in line_kernels.inl.
  constexpr double mean_normal = 3.0 * pi / 16.0, mean_tangential = 0.25;
  const double weight = 0.5 * water.density * material.diameter * metres;
  const double length = e.norm(), speed = u.norm();
  const double inverse_length = length > 1e-12 * rest ? 1.0 / length : 1.0 / rest;
  const Vector t = inverse_length * e;
  const double along = u.dot(t);
  const Vector across = u - along * t;
  const double q_n = across.norm(), q_t = std::abs(along);
  auto at_speeds = [&](double normal, double tangential) {
    return cylinder_coefficients(material.law, normal, tangential, material.diameter,
                                 water.viscosity);
  };
  const CylinderCoefficients k = at_speeds(q_n, q_t), curled = at_speeds(speed, speed);
  const double loose =
      weight * (mean_normal * curled.a + mean_tangential * curled.b + curled.c * speed);
  const double loose_slope =
      weight * (mean_normal * curled.a_n + mean_tangential * (curled.b_n + curled.b_t) + curled.c);
  const bool bends = slack == SlackDrag::curved && length < rest;
  const double share = bends ? length / rest : 1.0;
  const double by_u = k.a + k.c * speed, by_t = (k.b - k.a) * along;
  TwineDrag out;
  out.value = (share * weight * by_u + (1.0 - share) * loose) * u + share * weight * by_t * t;

  const double inverse_q_n = q_n > 0.0 ? 1.0 / q_n : 0.0;
  const double fall = along * inverse_q_n;
  const double t_slope = (k.b - k.a) + along * fall * (k.a_n - k.b_n) + k.b_t * q_t;
  const double turning = share * weight * inverse_length;
  Vector along_t = -turning * by_t * t;
  if (bends) along_t += ((weight * by_u - loose) * u + weight * by_t * t) / rest;
  out.by_vector = turning * by_t * Matrix::Identity() + along_t * t.transpose() +
                  turning * (-k.a_n * fall * u + t_slope * t) * across.transpose();

  const double straight = share * weight;
  const double inverse_speed = speed > 0.0 ? 1.0 / speed : 0.0;
  out.by_velocity =
      (straight * by_u + (1.0 - share) * loose) * Matrix::Identity() +
      inverse_speed * (straight * k.c + (1.0 - share) * loose_slope) * u * u.transpose() +
      straight * (k.b + k.b_t * q_t - k.a) * t * t.transpose() +
      straight * inverse_q_n * (k.a_n * across + k.b_n * along * t) * across.transpose();
  return out;
}

}  // namespace codend
