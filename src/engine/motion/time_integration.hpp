// Time integration of a motion with a stepper: step lengths and rejected steps.
//
// Adaptive integration repeats a step with a shorter length if its error exceeds the allowance. The
// error also sets the next length. Otherwise all steps have the same length. A step without
// convergence is repeated with half the length. The integration stops and reports the node if a
// step would be shorter than `least_step`. Inaccurate steps are never accepted.
//
// An adaptive integration with an energy balance (motion/energy_account.hpp) also repeats steps with
// excessive imbalance. It stops as `unbalanced` if shorter steps do not help.
//
// Errors decrease with h^3 for smooth motion, but with h if a line becomes taut within the step.
// The length of a repeated step therefore depends on the decrease of the error in the last
// repetition. Steps end exactly at the requested times. The state at another time results from a
// shorter step that starts with the step around this time and has no effect on later steps.
// Polynomials would be cheaper, but do not keep the tensions of stiff lines.
#pragma once

#include <functional>
#include <memory>

#include "energy_account.hpp"
#include "stepper.hpp"

namespace codend {

struct IntegrationControl {
  bool adaptive = false;     // false: constant steps
  double step = 0.0;         // s; first step, or constant step; 0: a share of the fall time
  double least_step = 1e-7;  // s
  double most_step = 60.0;   // s
  // Computes the energy balance; costs one force computation per step.
  bool account = false;
  // Allowed energy imbalance of an adaptive step: a fraction of the energy that is present or put
  // through, plus a constant (J) for the effect of position errors on the potential of loads.
  double energy_share = 0.02, energy_floor = 0.0;
  // Called after every accepted step, before the conditions respond to the motion.
  std::function<void(const Past& step)> passed;
  // Called after every accepted step. Returns false to stop.
  std::function<bool(const Motion& now)> watch;
};

struct IntegrationReport {
  enum class End { reached, stopped, stuck, unbalanced } end = End::reached;
  long long steps = 0;
  long long repeated = 0;    // steps repeated because of their error
  long long not_found = 0;   // steps without convergence
  long long unbalanced = 0;  // steps repeated because of their energy imbalance
  long long iterations = 0;
  double shortest_step = 0.0, longest_step = 0.0;  // s, of accepted steps
  double largest_error = 0.0;                      // m, of positions in an accepted step
  int worst_node = -1;                             // node of the last rejected step
};

class TimeIntegration {
 public:
  // References must outlive this object. past: the start (only `now`), or past() of another
  // integration, continued with its step().
  TimeIntegration(Assembly& assembly, Stepper& stepper, Conditions& conditions,
                  const IntegrationControl& control, Past past);

  // Integrates to `time` (s), which must not be before the present time.
  IntegrationReport::End to(double time);
  // Restarts the scheme after a discontinuity.
  void restart_iteration();

  // Returns the motion at a time (s) within the last step, to the order of the scheme. stepper: a
  // second one of the same scheme. Leaves the conditions at another time.
  Motion at(double time, Stepper& stepper);

  const Motion& now() const { return past_.now; }
  const Past& past() const { return past_; }
  double step() const { return step_; }
  const IntegrationReport& report() const { return report_; }
  // Since the start of the motion; zero without an energy balance.
  const EnergyTotals& energy() const { return energy_; }
  // Returns the totals at a time (s) within the last step.
  EnergyTotals energy_at(double time) const {
    return between(energy_before_, energy_, (time - past_.before.time) / past_.last_step());
  }
  // Continues the totals of another integration.
  void go_on_from(const EnergyTotals& energy) { energy_ = energy; }

 private:
  void limit_step();
  void begin_account();
  bool too_unbalanced(const EnergyTotals& totals) const;

  Assembly& assembly_;
  Stepper& stepper_;
  Conditions& conditions_;
  const IntegrationControl& control_;
  Past past_;
  Motion next_;
  double step_;
  int since_limited_ = 0;
  std::unique_ptr<EnergyAccount> account_;
  EnergyTotals energy_, energy_before_;  // now, and at the start of the last step
  IntegrationReport report_;
};

}  // namespace codend
