// How the equilibrium of a model answers to small changes of its numbers, with the factors of one
// matrix.
//
// At an equilibrium F(x, p) = 0 the implicit function theorem gives J dx/dp = dF/dp with
// J = -dF/dx, on the constitutive law itself and undamped. Steps x += J^-1 F(x, p) with J kept as
// it is (the chord method) go on from there: the first is that tangent, and each further one, for a
// change of p by a share e, leaves about e times the error before it. So do wakes, of which J knows
// nothing: they are renewed at every step.
//
// Backwards, a function m(x) changes by dm/dp = y . dF/dp with J^T y = dm/dx: one transposed solve
// serves any number of p.
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
  double wake_change = 0.0;  // of any point's share of the free flow's speed, in the last step
};

class Tangent {
 public:
  // Factorises J of the assembly at positions x (m, 3 per node), where it is at rest.
  Tangent(Assembly& assembly, const double* x);
  Tangent(const Tangent&) = delete;

  // The same of an assembly of the same nodes, whose numbers may be others; not regular where it has
  // another pattern.
  void renew(Assembly& assembly, const double* x);

  // False where J is singular; nothing below may be called then.
  bool regular() const { return regular_; }
  // 3 times the number of nodes.
  std::size_t size() const { return size_; }

  // Displacement (m) that net forces (N) make, both 3 per node; held nodes stay.
  void solve(const double* force, double* displacement) const;
  // Forces' part (1/N of a unit) in a function by its change per displacement (per m), 3 per node each.
  void solve_transposed(const double* per_displacement, double* per_force) const;

  // Takes chord steps of an assembly of the same nodes and pattern, whose numbers may be others,
  // from x, 3 per node, at rest. They end when they no longer close in: converged where net forces
  // are then within `tolerance` of the largest tension, or a hundred times that where steps are down
  // to the rounding of positions, and not after `steps`, or where steps grow. From `enough` steps on
  // the tolerance alone ends them. The assembly is then at x. Its wake keeps to the sheets upstream that
  // it has.
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
