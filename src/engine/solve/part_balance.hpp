// Whether every part of a model is in balance, by its own measure: beside a tension of 200 kN lines with
// 10 N would seem so in any shape.
//
// A part is a set of lines. Its scale is the largest force on any of them, pull or drag, all lines of a
// group together; of a part without any, the largest load on its nodes. A node that several parts share
// is held to the largest of their scales.
#pragma once

#include <vector>

#include "../model/assembly.hpp"

namespace codend {

// Where a model is farthest from balance.
struct PartResidual {
  // The largest net force beyond what rounding of the positions makes there, over the scale that its
  // node is held to; 0: there is none.
  double residual = 0.0;
  int part = -1;          // whose scale that is; -1: no part's, all of the gear
  int node = -1;          // where it acts
  double rounding = 0.0;  // the most that rounding makes anywhere, over the scale there
  int rounding_part = -1;
};

class PartBalance {
 public:
  // part: of every line of the assembly's model, 0 and up; empty: all are one. Both must outlive this.
  PartBalance(const Assembly& assembly, const std::vector<int>& part);

  // force: net forces (N, 3 per node) at the place that the assembly was last moved to; otherwise: the
  // scale (N) of nodes that no part touches.
  PartResidual worst(const double* force, double otherwise);

 private:
  int part_of(int line) const { return part_.empty() ? 0 : part_[static_cast<std::size_t>(line)]; }
  void find_scales();
  void hold(int point, int part);

  const Assembly& assembly_;
  const std::vector<int>& part_;
  std::vector<double> part_scale_;  // N
  std::vector<int> node_part_;      // per point, the part with the largest scale; -1: none
  std::vector<double> rounding_;    // N, per point
};

}  // namespace codend
