#pragma once

#include <cstdint>
#include <vector>

#include "ordering.hpp"

namespace codend {

// A run of `length` nodes that are adjacent both in a child's boundary (starting at `from`) and in
// its parent's front (starting at `to`, counting pivots, then boundary).
struct Run {
  int from;
  int to;
  int length;
};

// Fronts of a multifrontal factorisation (Duff and Reid 1983) in the order of elimination, each
// after its children. Counts are in nodes.
struct AssemblyTree {
  std::vector<int> order;        // order[p]: node eliminated p-th
  std::vector<int> position;     // inverse of order
  std::vector<int> first_pivot;  // fronts + 1: front f eliminates positions from first_pivot[f]
  std::vector<int> parent;       // -1 at a root
  std::vector<int64_t> first_boundary;  // fronts + 1, into boundary
  std::vector<int> boundary;     // sorted positions that a front updates but does not eliminate
  std::vector<int> first_child;  // fronts + 1, into child
  std::vector<int> child;
  std::vector<int64_t> first_run;  // fronts + 1, into run
  std::vector<Run> run;            // maps a front's boundary into its parent's front

  int fronts() const { return static_cast<int>(parent.size()); }
  int pivots(int front) const { return first_pivot[front + 1] - first_pivot[front]; }
  int boundary_nodes(int front) const {
    return static_cast<int>(first_boundary[front + 1] - first_boundary[front]);
  }
  // Multiplications and additions to factorise a front, with three unknowns per node.
  double flops(int front) const {
    const double k = 3.0 * pivots(front), b = 3.0 * boundary_nodes(front);
    return 2 * (k * k * k / 3 + k * k * b + k * b * b);
  }
};

// Symbolic factorisation. A child is merged into its parent if one larger front is cheaper.
// Children are ordered to minimise the stack of update matrices (Liu 1986).
AssemblyTree assembly_tree(const BlockPattern& pattern, const SeparatorTree& tree);

}  // namespace codend
