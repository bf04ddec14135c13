#include "settle.hpp"

#include <algorithm>
#include <cmath>

#include "settle_iteration.hpp"

namespace codend {
namespace {

// Outer loop around SettleIteration: initial guesses, wakes and unstable equilibria.
class Settling {
 public:
  Settling(Assembly& assembly, const SettleControl& control, const double* v, double* x,
           SettleReport& report)
      : assembly_(assembly),
        control_(control),
        report_(report),
        x_(x),
        from_settled_(control.start == Start::settled && !control.gradual),
        closing_in_(from_settled_),
        settled_(x, x + 3 * static_cast<std::ptrdiff_t>(assembly.model().nodes)),
        iteration_(assembly, control, v, x, report) {}

  void run() {
    find();
    if (!report_.converged && !unstable_.empty()) keep_unstable();
    if (!report_.converged) iteration_.judge_parts();
  }

 private:
  void find() {
    for (;; ++report_.iterations) {
      iteration_.measure();
      if (report_.iterations == 0) {
        report_.first_residual = report_.residual;
        take_start();
      } else if (closing_in_ && !std::isfinite(report_.residual)) {
        if (!go_back()) return;
      } else if (closing_in_ && iteration_.wanders()) {
        iteration_.relax();
        closing_in_ = false;
      }
      if (control_.watch && !control_.watch({report_.iterations, report_.residual})) {
        report_.stopped = true;
        return;
      }
      follow_wake();
      report_.converged = iteration_.balanced();
      if (report_.converged && wake_is_due()) {
        renew_wake();
        if (wake_rounds_ == control_.wake.renewals && !report_.converged) return;
      }
      if (report_.converged) leave_if_unstable();
      if (report_.converged || report_.iterations >= control_.iterations) return;
      if (!std::isfinite(report_.residual)) return;
      iteration_.step();
    }
  }

  void take_start() {
    // On the gradual path, a settled start is one that has failed.
    const bool near = control_.start == Start::settled
                          ? report_.residual < control_.law.near_residual
                          : control_.start == Start::near;
    if (from_settled_) {
      iteration_.begin_settled();
    } else if (near) {
      iteration_.begin_near();
    }
  }

  // Returns to the last settled shape after divergence. Returns false if this is the start.
  bool go_back() {
    std::copy(settled_.begin(), settled_.end(), x_);
    iteration_.measure();
    if (report_.wake_renewals == 0) return false;
    iteration_.begin();
    closing_in_ = false;
    return true;
  }

  // A settled start that needs no step keeps its stored wake.
  bool wake_is_due() const {
    return assembly_.has_wake() &&
           !(from_settled_ && report_.iterations == 0 && !assembly_.model().wake.empty());
  }

  // Updates the wake before equilibrium, where it costs no extra iterations.
  void follow_wake() {
    if (from_settled_ || !assembly_.has_wake()) return;
    const bool close = iteration_.nearly_balanced();
    const bool far = control_.start == Start::near && !wake_is_searched_ &&
                     far_searches_ < control_.wake.renewals && iteration_.far_on_path();
    if (!close && !far) return;
    const double change = assembly_.renew_wake(far || !wake_is_searched_, control_.wake.tolerance);
    ++report_.wake_renewals;
    if (close)
      wake_is_searched_ = true;
    else
      ++far_searches_;
    if (change > control_.wake.tolerance) iteration_.measure();
  }

  // Updates the wake in equilibrium. If it changes, the shape must converge again.
  void renew_wake() {
    report_.wake_change = assembly_.renew_wake(!wake_is_searched_, control_.wake.tolerance);
    wake_is_searched_ = true;
    ++report_.wake_renewals;
    ++wake_rounds_;
    if (report_.wake_change <= control_.wake.tolerance) return;
    report_.converged = false;
    iteration_.measure();
    iteration_.resume();
    closing_in_ = true;
    settled_.assign(x_, x_ + settled_.size());
  }

  void leave_if_unstable() {
    report_.unstable = false;
    if (!iteration_.may_be_unstable()) return;
    const GrowingMotion growing = iteration_.growing_motion();
    report_.unstable = growing.found;
    if (!growing.found) return;
    const bool wall = iteration_.only_walls_may_be_unstable();
    if (wall) unstable_.assign(x_, x_ + settled_.size());
    if (report_.perturbations == control_.perturbation.most) return;
    iteration_.perturb(growing, report_.perturbations % 2 == 1);
    closing_in_ = false;
    ++report_.perturbations;
    report_.converged = false;
    iteration_.measure();
  }

  // Returns to the last unstable equilibrium of a wall, if no other one was found.
  void keep_unstable() {
    std::copy(unstable_.begin(), unstable_.end(), x_);
    iteration_.measure();
    iteration_.judge_parts();
    report_.converged = report_.unstable = true;
  }

  Assembly& assembly_;
  const SettleControl& control_;
  SettleReport& report_;
  double* x_;
  int far_searches_ = 0;           // for wakes, far from equilibrium
  bool wake_is_searched_ = false;  // near equilibrium or in it
  int wake_rounds_ = 0;            // updates of the wake in equilibrium
  const bool from_settled_;
  // Iterating from the last settled shape under changed loads or wakes.
  bool closing_in_;
  std::vector<double> settled_;
  std::vector<double> unstable_;  // the last unstable equilibrium of a wall
  SettleIteration iteration_;
};

}  // namespace

void SettleCost::add(const SettleCost& other) {
  iterations += other.iterations;
  factorisations += other.factorisations;
  force_evaluations += other.force_evaluations;
  factor_entries = std::max(factor_entries, other.factor_entries);
  seconds_analysis += other.seconds_analysis;
  seconds_forces += other.seconds_forces;
  seconds_jacobian += other.seconds_jacobian;
  seconds_linear += other.seconds_linear;
}

SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x) {
  SettleReport report;
  const long long evaluations = assembly.force_evaluations();
  if (assembly.unknowns() == 0) {
    report.converged = true;
  } else {
    Settling(assembly, control, v, x, report).run();
  }
  report.force_evaluations = assembly.force_evaluations() - evaluations;
  return report;
}

SettleControl attempt(SettleControl control, bool gradual) {
  control.gradual = gradual;
  const int direct = std::min(control.iterations, PathControl::direct_iterations);
  control.iterations = gradual ? control.iterations - direct : direct;
  return control;
}

bool needs_gradual_path(const SettleReport& direct, int iterations) {
  return !direct.converged && !direct.stopped && iterations > PathControl::direct_iterations;
}

SettleReport settle_from(Assembly& assembly, const SettleControl& control, const double* v,
                         double* x) {
  const std::vector<double> start(x, x + 3 * static_cast<std::ptrdiff_t>(assembly.model().nodes));
  const SettleReport first = settle(assembly, attempt(control, false), v, x);
  if (!needs_gradual_path(first, control.iterations)) return first;
  std::copy(start.begin(), start.end(), x);
  SettleReport report = settle(assembly, attempt(control, true), v, x);
  report.add(first);
  return report;
}

}  // namespace codend
