// Solidity Sn of netting: the share of its area that its twine and knots hide.
//
// With s the projected area of twine and knots over the netting's, every crossing of two twines without
// a knot would count twice. With bars a, width d and angle b between the families the twine is
// s = 2 d / (a sin b) and the crossings are s^2 / 4, so that Sn = s - s^2 / 4 at every opening
// (2 d/a - (d/a)^2 in square meshes), 1 from s = 2 on.
#pragma once

namespace codend {

struct Solidity {
  double value;
  double by_closing;  // - A dSn/dA, A the area of the netting
};

// twine: s; overlap: Sn = s - overlap s^2, 1/4, or 0 where crossings are knots.
inline Solidity solidity_of(double twine, double overlap) {
  if (2.0 * overlap * twine > 1.0) return {0.25 / overlap, 0.0};
  return {twine * (1.0 - overlap * twine), twine * (1.0 - 2.0 * overlap * twine)};
}

}  // namespace codend
