// Solidity Sn of netting: the fraction of its area that twine and knots cover.
//
// Let s be the sum of the projected areas of twine and knots, divided by the area of the netting.
// In knotless netting, s counts every crossing of two twines twice. With bar length a, twine
// diameter d and angle b between the families, the twine gives
//
//   s = 2 d / (a sin b),
//
// and the crossings give s^2 / 4. Hence Sn = s - s^2 / 4 at every opening (2 d/a - (d/a)^2 for
// square meshes), and Sn = 1 for s >= 2.
#pragma once

namespace codend {

struct Solidity {
  double value;
  double by_closing;  // - A dSn/dA, with A the area of the netting
};

// Computes Sn = s - overlap s^2 for s = twine. overlap: 1/4 for knotless netting, 0 for knots.
inline Solidity solidity_of(double twine, double overlap) {
  if (2.0 * overlap * twine > 1.0) return {0.25 / overlap, 0.0};
  return {twine * (1.0 - overlap * twine), twine * (1.0 - 2.0 * overlap * twine)};
}

}  // namespace codend
