// Response of an equilibrium to small changes of input values, with one factorised matrix.
//
// At an equilibrium F(x, p) = 0, the implicit function theorem gives J dx/dp = dF/dp. Here J is
// -dF/dx, undamped and on the constitutive law. Steps x += J^-1 F(x, p) with a constant J (chord
// method) extend this. The first step is the tangent. For a change of p by a fraction e, each
// further step reduces the error by about e. J does not include wakes, so they are updated at every
// step and converge at the same rate.
//
// In the adjoint direction, a function m(x) changes by dm/dp = y . dF/dp with J^T y = dm/dx. One
// transposed solve serves any number of p.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "../model/assembly.hpp"
#include "block_lu.hpp"

namespace codend {

struct ChordReport {
  bool converged = false;
  int steps = 0;
  double residual = 0.0;     // largest nodal force over largest tension
  double wake_change = 0.0;  // largest last change of flow speed at a point, over the free flow
};

class Tangent {
 public:
  // Factorises J of the assembly at rest at positions x (m, 3 per node).
  Tangent(Assembly& assembly, const double* x);
  Tangent(const Tangent&) = delete;

  // Factorises J of an assembly with the same nodes. Not regular if its pattern differs.
  void renew(Assembly& assembly, const double* x);

  // False for a singular J; the functions below must not be called then.
  bool regular() const { return regular_; }
  // 3 times the number of nodes.
  std::size_t size() const { return size_; }

  // Computes displacements (m) due to net forces (N), both 3 per node. Fixed nodes stay.
  void solve(const double* force, double* displacement) const;
  // Converts a function's derivative by displacements (per m) to its derivative by forces (per N).
  void solve_transposed(const double* per_displacement, double* per_force) const;

  // Takes chord steps of an assembly with the same nodes and pattern, and possibly other values.
  // They start at rest from x (3 per node). The assembly is left at the final x.
  //
  // Steps end when they stop decreasing, reach the rounding of positions, or after `steps`. From
  // `enough` steps on, the tolerance alone ends them. The result has converged if the net force is
  // within `tolerance` of the largest tension, or within a hundred times that at the rounding
  // limit. It has not converged if `steps` end it, or if the wake still changes. The set of wake
  // sheets upstream of each point is constant.
  ChordReport balance(Assembly& other, double tolerance, int steps, double* x,
                      int enough = std::numeric_limits<int>::max()) const;

 private:
  const std::size_t size_;
  const std::vector<int> free_;
  std::size_t entries_ = 0;  // of the pattern
  bool regular_ = false;
  BlockLU lu_;
  mutable std::vector<double> right_, solution_;
};

}  // namespace codend
