// A motion from one time to another by steps of a scheme: how long they are, and what becomes of
// steps that are not good enough.
//
// Adaptive, a step whose own error is larger than its scheme may make is repeated shorter, and the
// next is as long as its error allows. Otherwise steps have one length. Where a scheme does not find
// a step it is repeated at half the length. Where that, or the error, would take steps below the
// least, the march ends and says where: no step is taken that is not good enough. An adaptive march
// whose account of energy (march/energy_account.hpp) drifts off repeats its steps shorter too, and
// ends as unbalanced where that does not help.
//
// Errors fall as h^3 where the motion is smooth, but as h where a line snaps taut within the step: how
// much shorter a step is repeated follows from how its error fell the last time.
// Steps end exactly at the requested times. An adaptive step is at most half of the interval between
// two of these times.
#pragma once

#include <functional>
#include <memory>

#include "energy_account.hpp"
#include "stepper.hpp"

namespace codend {

struct MarchControl {
  bool adaptive = false;     // else steps of one length
  double step = 0.1;         // s, the first, or the length of all
  double least_step = 1e-7;  // s
  double most_step = 60.0;   // s
  // Whether energy is accounted for; at the cost of one evaluation of forces per step.
  bool account = false;
  // Imbalance of energy that an adaptive march may reach: this share of the energy put through, and
  // so much beside (J), which is what errors of position make of the loads' potential.
  double energy_share = 0.02, energy_floor = 0.0;
  // Called after every step that is taken; returns false to stop.
  std::function<bool(const Motion& now)> watch;
};

struct MarchReport {
  enum class End { reached, stopped, stuck, unbalanced } end = End::reached;
  long long steps = 0;       // taken
  long long repeated = 0;    // because of their error
  long long not_found = 0;   // because the scheme found none
  long long unbalanced = 0;  // repeated because of their energy
  long long iterations = 0;
  double shortest_step = 0.0, longest_step = 0.0;  // s, of those taken
  int worst_node = -1;                             // where the last step that was not taken failed
};

class March {
 public:
  // All are kept by reference. past: at the start, now alone, or as another march left it together
  // with its step().
  March(Assembly& assembly, Stepper& stepper, Conditions& conditions, const MarchControl& control,
        Past past);

  // Goes on until `time` (s), which must not lie before now.
  MarchReport::End to(double time);
  // The motion breaks here: what was before says nothing of what comes.
  void begin_anew();

  const Motion& now() const { return past_.now; }
  const Past& past() const { return past_; }
  double step() const { return step_; }
  const MarchReport& report() const { return report_; }
  // Since the motion began; zero without an account.
  const EnergyTotals& energy() const { return energy_; }
  // Goes on from the totals of another march.
  void go_on_from(const EnergyTotals& energy) { energy_ = energy; }

 private:
  void limit_step();
  void begin_account();
  bool too_unbalanced(const EnergyTotals& totals) const;

  Assembly& assembly_;
  Stepper& stepper_;
  Conditions& conditions_;
  const MarchControl& control_;
  Past past_;
  Motion next_;
  double step_;
  int since_limited_ = 0;
  std::unique_ptr<EnergyAccount> account_;
  EnergyTotals energy_;
  MarchReport report_;
};

}  // namespace codend
