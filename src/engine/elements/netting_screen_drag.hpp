// Screen drag models: drag and lift of a plane piece of netting by the angle theta between its
// normal and the flow. Coefficients refer to 1/2 rho A |U|^2 with A the whole area. Sn is the
// solidity, the projected area of twine and knots over A.
//
//   loland: G. Loland, Current Forces on and Flow through Fish Farms, NTH Trondheim 1991.
//     C_D = 0.04 + (-0.04 + 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3) cos th.
//     C_L = (-0.05 Sn + 2.3 Sn^2 - 1.76 Sn^3) sin 2th.
//   aarsnes: J. V. Aarsnes, H. Rudi & G. Loland, Current forces on cage, net deflection, 1990.
//     C_D = 0.04 + (-0.04 + Sn - 1.24 Sn^2 + 13.7 Sn^3) cos th.
//     C_L = (0.57 Sn - 3.54 Sn^2 + 10.1 Sn^3) sin 2th.
//   kristiansen_faltinsen: T. Kristiansen & O. M. Faltinsen, J. Fluids Struct. 34, 2012.
//     C_c: drag of a circular cylinder at Re = U d / (nu (1 - Sn)), a polynomial in log10 Re.
//     C_D0 = C_c Sn (2 - Sn) / (2 (1 - Sn)^2),  C_D = C_D0 (0.9 cos th + 0.1 cos 3th).
//     C_N45 = C_c Sn / (2 (1 - Sn)^2),  C_T45 = pi C_N45 / (8 + C_N45).
//     C_L45 = (C_D0 / 2 - C_T45) / sqrt 2,  C_L = C_L45 (sin 2th + 0.1 sin 4th).
//
// Arguments are clamped to the range of the model (base/drag_models.hpp), because the formulas fail
// outside. The first two models give C_D >= 0.04 even without twine. Below their smallest solidity
// their coefficients are therefore proportional to Sn.
#pragma once

namespace codend {

struct ScreenMultipliers {
  double drag = 1.0, lift = 1.0;
};

}  // namespace codend
