// Drag models of a long cylinder at an angle to the flow, per unit of 1/2 rho d L (d diameter, L
// length):
//
//   F / (1/2 rho d L) = a(q_n) U_n + b(q_n, q_t) U_t + c |U| U
//
// U is the velocity of the water relative to the cylinder, U_t its component along the axis, U_n
// the remainder, q_n = |U_n| and q_t = |U_t|. All coefficients refer to d L (not pi d L).
//
// Cross-flow form: a = C_n q_n, b = C_t q_t, c = 0. The form in C_D(alpha), C_L(alpha) with C_D =
// C_n sin^3 + C_f, C_L = C_n sin^2 cos (Hoerner, Fluid-Dynamic Drag, 1965, 3-11) has b = 0 and c =
// C_f. The two agree, because the projections of C_n |U_n| U_n on drag and lift are C_n sin^3 and
// C_n sin^2 cos.
//
//   constant: C_n, C_t and C_f as given
//   takagi: T. Takagi et al. 2004, Fish. Res. 66:235: C_n(Re), C_t 0.1
//   choo_casarella: Y. Choo & M. J. Casarella 1971, J. Hydronautics 5:126: C_n(Re), C_t(Re)
//   cifuentes_kim: C. Cifuentes & M. H. Kim 2017: C_n(Re Sn^2), C_t 0
#pragma once

#include "../base/drag_models.hpp"

namespace codend {

struct CylinderLaw {
  CylinderLawKind kind = CylinderLawKind::constant;
  double normal = 1.1;      // C_n, used by `constant`
  double tangential = 0.0;  // C_t, used by `constant`
  double skin = 0.02;       // C_f, used by `constant`
  double solidity = 0.0;    // Sn of the netting, used by `cifuentes_kim`
  // Multipliers of a (force normal to the axis), and of b and c (force along the axis and the
  // flow).
  double normal_share = 1.0;
  double tangential_share = 1.0;
};

struct CylinderCoefficients {
  double a = 0.0, a_n = 0.0;             // a and da/dq_n
  double b = 0.0, b_n = 0.0, b_t = 0.0;  // b, db/dq_n, db/dq_t
  double c = 0.0;
};

// q_n, q_t in m/s; d in m; viscosity in m2/s. The result is finite for all q >= 0.
CylinderCoefficients cylinder_coefficients(const CylinderLaw& law, double q_n, double q_t, double d,
                                           double viscosity);

}  // namespace codend
