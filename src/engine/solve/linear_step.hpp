// Linear equations of one Newton step. Factors are in single precision. If refinement does not
// converge, later factors are in double precision.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "block_lu.hpp"
#include "settle.hpp"

namespace codend {

class LinearStep {
 public:
  // x: positions of all nodes, m, 3 per node, which guide the elimination order. They are read at
  // every analysis, first on demand. Time and factorisations are added to `report`.
  LinearStep(const Assembly& assembly, const SettleControl& control, SettleReport& report,
             const double* x);

  // Solves values * step = right, 3 per free node. Returns false for a singular matrix.
  bool solve(const std::vector<double>& values, const std::vector<double>& right,
             std::vector<double>& step);
  // Solves another right side with the factors of the last successful solve().
  void solve_again(const std::vector<double>& right, std::vector<double>& step);
  // For other factorisations with the same pattern.
  BlockLU& factors();

 private:
  void analyse(Precision precision);

  const Assembly& assembly_;
  const LinearControl& control_;
  const std::function<void()>& pause_;
  const bool timed_;
  SettleReport& report_;
  const double* x_;
  Precision precision_ = Precision::single_precision;
  std::unique_ptr<BlockLU> lu_;
};

}  // namespace codend
