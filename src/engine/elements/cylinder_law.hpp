// Drag of a long cylinder by the angle between its axis and the flow, per unit of
// 1/2 rho d L (d diameter, L length):
//
//   F / (1/2 rho d L) = a(q_n) U_n + b(q_n, q_t) U_t + c |U| U
//
// with U the water's velocity relative to the cylinder, U_t its part along the axis, U_n the rest,
// q_n = |U_n| and q_t = |U_t|. All coefficients refer to d L (not pi d L).
//
// Cross-flow form: a = C_n q_n, b = C_t q_t, c = 0. The form in C_D(alpha), C_L(alpha) with
// C_D = C_n sin^3 + C_f, C_L = C_n sin^2 cos (Hoerner, Fluid-Dynamic Drag, 1965, 3-11) is the same
// with b = 0, c = C_f, because C_n |U_n| U_n projects on drag and lift as C_n sin^3, C_n sin^2 cos.
//
//   constant: C_n, C_t and C_f as given
//   takagi: T. Takagi et al. 2004, Fish. Res. 66:235: C_n(Re), C_t 0.1
//   choo_casarella: Y. Choo & M. J. Casarella 1971, J. Hydronautics 5:126: C_n(Re), C_t(Re)
//   cifuentes_kim: C. Cifuentes & M. H. Kim 2017: C_n(Re Sn^2), C_t 0
#pragma once

#include "../base/laws.hpp"

namespace codend {

struct CylinderLaw {
  CylinderLawKind kind = CylinderLawKind::constant;
  double normal = 1.1;      // C_n, used by `constant`
  double tangential = 0.0;  // C_t, used by `constant`
  double skin = 0.02;       // C_f, used by `constant`
  double solidity = 0.0;    // Sn of the netting, used by `cifuentes_kim`
  // Factors on a, and on b and c: multipliers of the force across the axis, and of that along axis and
  // flow.
  double normal_share = 1.0;
  double tangential_share = 1.0;
};

struct CylinderCoefficients {
  double a = 0.0, a_n = 0.0;             // a and da/dq_n
  double b = 0.0, b_n = 0.0, b_t = 0.0;  // b, db/dq_n, db/dq_t
  double c = 0.0;
};

// q_n, q_t in m/s; d in m; viscosity in m2/s. Defined and finite for every q >= 0.
CylinderCoefficients cylinder_coefficients(const CylinderLaw& law, double q_n, double q_t, double d,
                                           double viscosity);

}  // namespace codend
