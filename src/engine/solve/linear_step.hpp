// The linear equations of one Newton step. Factors are in single precision; where refinement does not make
// up for that they are double from then on.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "block_lu.hpp"
#include "settle.hpp"

namespace codend {

class LinearStep {
 public:
  // coordinates: 3 per free node, m, by which unknowns are eliminated; asked for at every analysis,
  // the first of which is made when it is needed.
  // What it takes of time and factorisations is booked in `report`.
  LinearStep(const Assembly& assembly, const SettleControl& control, SettleReport& report,
             const double* x);

  // values * step = right, 3 per free node; false where the matrix is singular.
  bool solve(const std::vector<double>& values, const std::vector<double>& right,
             std::vector<double>& step);
  // Another right side with the factors of the last solve() that returned true.
  void solve_again(const std::vector<double>& right, std::vector<double>& step);
  // For others who factorise with the same pattern.
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
