// Equilibrium check of every part of a model against its own forces. Next to a tension of 200 kN,
// lines with 10 N would otherwise seem in equilibrium in any shape.
//
// A part is a set of lines. Its scale is the largest tension or drag of a line in the set, for all
// twines of the line together. A part without such forces uses the largest load on its nodes.
// A node of several parts uses the largest of their scales.
#pragma once

#include <vector>

#include "../model/assembly.hpp"

namespace codend {

// The largest residual of all parts.
struct PartResidual {
  // Largest net force beyond rounding, over the scale of its node; 0 without such a force.
  double residual = 0.0;
  int part = -1;          // part that sets the scale; -1: the whole gear
  int node = -1;          // node of this force
  double rounding = 0.0;  // largest rounding force, over the scale of its node
  int rounding_part = -1;
};

class PartBalance {
 public:
  // `part` is the part of every line (0 and up); empty: one part. It must outlive this object.
  PartBalance(const Assembly& assembly, const std::vector<int>& part);

  // `force` are the net forces (N, 3 per node) at the present state of the assembly. `otherwise` is
  // the scale (N) of nodes without a part.
  PartResidual worst(const double* force, double otherwise);

 private:
  int part_of(int line) const { return part_.empty() ? 0 : part_[static_cast<std::size_t>(line)]; }
  void find_scales();
  void hold(int point, int part);

  const Assembly& assembly_;
  const std::vector<int>& part_;
  std::vector<double> part_scale_;  // N
  std::vector<int> node_part_;      // per point, part with the largest scale; -1: none
  std::vector<double> rounding_;    // N, per point
};

}  // namespace codend
