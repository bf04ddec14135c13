// Static stability of an equilibrium. Small perturbations of an unstable equilibrium grow, so it
// does not occur in nature. Kinds of elements with an ElementKind::unstable_size() are tested, and
// joints between bars in compression, such as in a pole of several bars without bending stiffness.
// Walls are also tested: netting under inner pressure that may have passed through itself.
//
// Small displacements y from an equilibrium satisfy D y' = -K y. K is the derivative of the net
// forces (-dF/dx), and D is the drag-like damping of pseudo time (Assembly::pseudo_damping()). A
// motion with growth rate r is an eigenvector of (K + D/h)^-1 D/h with eigenvalue 1/(1 - h r). Its
// magnitude exceeds 1 for h r < 2, and is below 1 for decay. The largest is computed at a few h.
//
// D is not the real damping, so the rate is not the real rate. The boundary between growth and
// decay is the same for any damping. The result is static stability, not flutter.
//
// No motion grows faster than s if the symmetric part of K + s D is positive definite, because y'Dy
// then decreases in all motions. One factorisation checks this and avoids searches at shorter h.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "block_lu.hpp"

namespace codend {

// Returns the size (m) of the smallest element that may be unstable at the present state of the
// assembly; 0 without such elements. `walls` includes walls.
double unstable_size(const Assembly& assembly, bool walls = true);

struct GrowingMotion {
  bool found = false;
  int factorisations = 0;
  double rate = 0.0;           // per unit of pseudo time
  std::vector<double> motion;  // 3 per free node; largest displacement of a tested node 1
};

// Returns the fastest growing motion of elements that may be unstable, at the present state of the
// assembly. `lu` must be analysed for the assembly's pattern; its factors change.
// time: unit of pseudo time, s.
GrowingMotion growing_motion(Assembly& assembly, double time, BlockLU& lu);

}  // namespace codend
