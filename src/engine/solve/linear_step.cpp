#include "linear_step.hpp"

#include <algorithm>

#include "second_thread.hpp"
#include "stopwatch.hpp"

namespace codend {

LinearStep::LinearStep(const Assembly& assembly, const SettleControl& control, SettleReport& report,
                       const double* x)
    : assembly_(assembly),
      control_(control.linear),
      pause_(control.pause),
      timed_(control.timed),
      report_(report),
      x_(x) {}

BlockLU& LinearStep::factors() {
  if (!lu_) analyse(Precision::single_precision);
  return *lu_;
}

void LinearStep::analyse(Precision precision) {
  Stopwatch watch(report_.seconds_analysis, timed_);
  const std::vector<int>& free = assembly_.free_nodes();
  std::vector<double> coordinates(3 * free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(coordinates.data(), static_cast<int>(i)) = at(x_, free[i]);
  }
  precision_ = precision;
  lu_.reset();  // frees memory for the new factors
  lu_ = std::make_unique<BlockLU>(precision, usable_threads(), pause_);
  lu_->analyse(assembly_.pattern(), coordinates.data());
  const long long entries = lu_->figures().factor_entries;
  report_.factor_entries = std::max(report_.factor_entries, entries);
}

bool LinearStep::solve(const std::vector<double>& values, const std::vector<double>& right,
                       std::vector<double>& step) {
  if (!lu_) analyse(Precision::single_precision);
  if (precision_ == Precision::single_precision) {
    {
      Stopwatch watch(report_.seconds_linear, timed_);
      ++report_.factorisations;
      if (lu_->factorise(values.data()) &&
          lu_->solve_refined(assembly_.pattern(), values.data(), right.data(), control_.tolerance,
                             step.data()) < control_.limit) {
        return true;
      }
    }
    analyse(Precision::double_precision);
  }
  Stopwatch watch(report_.seconds_linear, timed_);
  ++report_.factorisations;
  if (!lu_->factorise(values.data())) return false;
  lu_->solve(right.data(), step.data());
  return true;
}

void LinearStep::solve_again(const std::vector<double>& right, std::vector<double>& step) {
  Stopwatch watch(report_.seconds_linear, timed_);
  lu_->solve(right.data(), step.data());
}

}  // namespace codend
