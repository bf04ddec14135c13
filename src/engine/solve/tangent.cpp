#include "tangent.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "second_thread.hpp"

namespace codend {
namespace {

// Steps below this fraction of the previous step converge.
constexpr double closing_in = 0.7;
// Rounding of positions (m), as a fraction of the largest position.
constexpr double rounding_share = 1e-14;
// Factor of the tolerance at the rounding limit, where net forces next to stiff lines are larger.
constexpr double rounded_tolerance = 100.0;

}  // namespace

Tangent::Tangent(Assembly& assembly, const double* x)
    : size_(3 * static_cast<std::size_t>(assembly.model().nodes)),
      free_(assembly.free_nodes()),
      lu_(Precision::double_precision, usable_threads()),
      right_(3 * free_.size()),
      solution_(right_.size()) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) = at(x, free_[i]);
  }
  lu_.analyse(assembly.pattern(), right_.data());
  entries_ = assembly.pattern().column.size();
  renew(assembly, x);
}

void Tangent::renew(Assembly& assembly, const double* x) {
  const std::vector<double> rest(size_, 0.0);
  assembly.move_to(x, rest.data());
  std::vector<double> values(9 * assembly.pattern().column.size());
  assembly.jacobian({1.0, 0.0}, values.data());
  regular_ = values.size() == 9 * entries_ && lu_.factorise(values.data());
  lu_.end_second_thread();
}

void Tangent::solve(const double* force, double* displacement) const {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) = at(force, free_[i]);
  }
  lu_.solve(right_.data(), solution_.data());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(displacement, free_[i]) = at(solution_.data(), static_cast<int>(i));
  }
}

void Tangent::solve_transposed(const double* per_displacement, double* per_force) const {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) = at(per_displacement, free_[i]);
  }
  lu_.solve_transposed(right_.data(), solution_.data());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(per_force, free_[i]) = at(solution_.data(), static_cast<int>(i));
  }
}

ChordReport Tangent::balance(Assembly& other, double tolerance, int steps, double* x,
                             int enough) const {
  if (3 * static_cast<std::size_t>(other.model().nodes) != size_ || other.free_nodes() != free_) {
    throw std::invalid_argument("tangent: the assembly has other free nodes");
  }
  const std::vector<double> rest(size_, 0.0);
  std::vector<double> force(size_), step(size_, 0.0);
  ChordReport report;
  double before = 0.0;
  for (;; ++report.steps) {
    other.move_to(x, rest.data());
    if (other.has_wake()) {
      report.wake_change = other.renew_wake(false, 0.0);
      other.move_to(x, rest.data());
    }
    other.residual(force.data());
    double worst = 0.0, far = 0.0, largest = 0.0;
    for (const int node : free_) {
      const double f = at(force.data(), node).norm();
      if (!(f <= worst)) worst = f;
      far = std::max(far, at(x, node).norm());
    }
    report.residual = worst == 0.0 ? 0.0 : worst / other.largest_tension();
    if (!std::isfinite(report.residual)) return report;
    report.converged = report.steps >= enough && report.residual <= tolerance;
    if (report.converged) return report;
    solve(force.data(), step.data());
    for (const int node : free_) largest = std::max(largest, at(step.data(), node).norm());
    const bool smallest = largest <= rounding_share * far;
    const bool closes_in = report.steps == 0 || largest <= closing_in * before;
    if (smallest || !closes_in || report.steps == steps) {
      const double allowed = smallest ? rounded_tolerance * tolerance : tolerance;
      report.converged = report.residual <= allowed && (smallest || !closes_in) &&
                         report.wake_change <= wake_tolerance;
      return report;
    }
    for (std::size_t k = 0; k < size_; ++k) x[k] += step[k];
    before = largest;
  }
}

}  // namespace codend
