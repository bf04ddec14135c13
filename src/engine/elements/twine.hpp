// A straight line of twine or rope between two ends that are weighted sums of nodes.
//
// One element stands for `multiplicity` equal lines in parallel. With e = sum_k a_k x_k the vector
// along the line, L = |e|, L0 its unstretched length:
//   tension  T = EA max(0, L/L0 - 1), the gradient of W(L) = EA (L - L0)^2 / (2 L0);
//   drag     of a cylinder of diameter d and length L0 (elements/cylinder_law.hpp) at the relative
//            velocity U = sum_k w_k (u_k - v_k), shared over the nodes by w_k.
// A slack line (L < L0) hangs in a curve, so its drag loses its direction: a share L/L0 of it is
// taken straight, and the rest as the mean of the same law over all directions,
// (3 pi/16) C_n + (1/4) C_t + C_f. At L = L0 both agree, and drag stays smooth in x as L -> 0.
#pragma once

#include <cmath>

#include "../geometry.hpp"
#include "../water.hpp"
#include "cylinder_law.hpp"

namespace codend {

struct TwineMaterial {
  double axial_stiffness = 0.0;    // EA, N
  double diameter = 0.0;           // m
  double volume_per_length = 0.0;  // m2
  double added_mass_normal = 1.0;  // on the displaced mass of water
  double added_mass_tangential = 0.0;
  CylinderLaw law;
};

enum class SlackDrag { curved = 0, straight = 1 };

// Tension of one line, N.
inline double twine_tension(const TwineMaterial& m, double length, double rest) {
  return length > rest ? m.axial_stiffness * (length / rest - 1.0) : 0.0;
}

// Strain energy of one line, J.
inline double twine_energy(const TwineMaterial& m, double length, double rest) {
  return length > rest ? 0.5 * m.axial_stiffness * (length - rest) * (length - rest) / rest : 0.0;
}

// d(T t)/de of one line of vector e whose tension T changes by `modulus` per strain.
inline Matrix line_stiffness(const Vector& e, double rest, double tension, double modulus) {
  const double length = e.norm();
  if (length <= 1e-12 * rest) return (tension / rest) * Matrix::Identity();
  const Vector t = e / length;
  const double across = tension / length;
  return across * Matrix::Identity() + (modulus / rest - across) * (t * t.transpose());
}

struct TwineDrag {
  Vector force = Vector::Zero();    // N, one line
  Matrix by_velocity = Matrix::Zero();  // d force / dU
  Matrix by_vector = Matrix::Zero();    // d force / de
};

// Drag of one line; derivatives only where `with_derivatives`.
inline TwineDrag twine_drag(const TwineMaterial& m, const Water& water, SlackDrag slack,
                            const Vector& e, double rest, const Vector& u, bool with_derivatives) {
  TwineDrag out;
  const double factor = 0.5 * water.density * m.diameter * rest;
  const double speed = u.norm();
  if (factor == 0.0 || speed == 0.0) return out;
  const double length = e.norm();
  const bool has_axis = length > 1e-12 * rest;
  const Vector t = has_axis ? Vector(e / length) : Vector(u / speed);
  const double along = u.dot(t);
  const Vector u_t = along * t;
  const Vector u_n = u - u_t;
  const double q_n = u_n.norm();
  const double q_t = std::abs(along);
  const CylinderCoefficients k =
      cylinder_coefficients(m.law, q_n, q_t, m.diameter, water.viscosity);
  const Vector straight = factor * (k.a * u_n + k.b * u_t + k.c * speed * u);

  const bool curved = slack == SlackDrag::curved && length < rest;
  const double share = curved ? length / rest : 1.0;
  Vector loose = Vector::Zero();
  double g = 0.0, g_slope = 0.0;
  if (curved) {
    const CylinderCoefficients i =
        cylinder_coefficients(m.law, speed, speed, m.diameter, water.viscosity);
    constexpr double mean_sin3 = 3.0 * 3.14159265358979323846 / 16.0;
    g = mean_sin3 * i.a + 0.25 * i.b + i.c * speed;
    g_slope = mean_sin3 * i.a_n + 0.25 * (i.b_n + i.b_t) + i.c;
    loose = factor * g * u;
  }
  out.force = share * straight + (1.0 - share) * loose;
  if (!with_derivatives) return out;

  const Matrix identity = Matrix::Identity();
  const Matrix tt = t * t.transpose();
  Matrix by_normal = k.a * identity;  // d straight / dU_n, without the factor
  if (q_n > 0.0) {
    by_normal += (k.a_n / q_n) * (u_n * u_n.transpose());
    by_normal += (k.b_n / q_n) * (u_t * u_n.transpose());
  }
  Matrix by_tangent = k.b * identity + k.b_t * q_t * tt;
  const Matrix skin = k.c * (speed * identity + u * u.transpose() / speed);
  const Matrix straight_by_u =
      factor * (by_normal * (identity - tt) + by_tangent * tt + skin);
  out.by_velocity = share * straight_by_u;
  if (curved) {
    out.by_velocity += (1.0 - share) * factor *
                       (g * identity + (g_slope / speed) * (u * u.transpose()));
  }
  if (!has_axis) return out;
  const Matrix turn = t * u.transpose() + along * identity;  // dU_t/dt = -dU_n/dt
  const Matrix by_axis = factor * ((by_tangent - by_normal) * turn);
  out.by_vector = (share / length) * (by_axis - (by_axis * t) * t.transpose());
  if (curved) out.by_vector += ((straight - loose) / rest) * t.transpose();
  return out;
}

}  // namespace codend
