// Whether an equilibrium is stable: one that a small perturbation grows in is never seen in nature. Tried
// are the kinds of elements that may stand so (ElementKind::unstable_size), joints between bars that
// push, as of a pole that is divided and has no stiffness against bending, and walls: netting that is
// pushed from inside and may have gone through itself.
//
// Small displacements y from an equilibrium follow D y' = -K y with K the derivative of the net
// forces (-dF/dx) and D the drag-like damping of pseudo time (Assembly::pseudo_damping). A motion
// that grows at a rate r is an eigenvector with eigenvalue 1/(1 - h r) of (K + D/h)^-1 D/h, larger than
// 1 in size while h r < 2; a motion that dies has one within 1. The largest is sought at a few
// h. Where D is not the real damping the rate is not the real one either, but a motion that
// neither grows nor dies does so with any: what is told is static stability, not flutter.
//
// The rate of no motion is above s where the symmetric part of K + s D is positive definite: y'Dy falls
// in all of them then. One factorisation tells, and shorter h need no search.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "block_lu.hpp"

namespace codend {

// Size (m) of the least element that may stand in an unstable equilibrium, at the place that the
// assembly was last moved to; 0: there is none. walls: whether walls count.
double unstable_size(const Assembly& assembly, bool walls = true);

struct GrowingMotion {
  bool found = false;
  int factorisations = 0;  // that the search took
  double rate = 0.0;       // 1/s of pseudo time
  std::vector<double>
      motion;  // 3 per free node; its largest at a node of such an element is 1 long
};

// The motion of elements that may be unstable which grows fastest, at the place that the assembly was
// last moved to. Changes the factors of `lu`, which must have been analysed for the assembly's pattern.
GrowingMotion growing_motion(Assembly& assembly, BlockLU& lu);

}  // namespace codend
