// Motion by the implicit trapezoid rule, solved by substitution.
//
// For y = (x, v) and dy/dt = f = (v, M^-1 F), F the net force, M mass and added mass where F acts:
//
//   y[k+1] = y[k] + h/2 (f(y[k]) + f(y[k+1])),
//
// the right side repeated with its own result until it stands still (Li et al., Modeling of the
// Midwater Trawl Dynamical Behavior Based on R Language, eqs. 11 and 14). The first guess is that
// of the non-self-starting Heun method, y[k-1] + 2 h f(y[k]) (Chapra and Canale, Numerical Methods
// for Engineers, 26.2), and y[k] + h f(y[k]) in the first step.
//
// Substitution converges only where h omega < 2 for every natural frequency omega: the rule is
// implicit, but its steps are as short as an explicit method's.
#pragma once

#include <algorithm>
#include <functional>

#include "accelerate.hpp"
#include "stepper.hpp"

namespace codend {

class SubstitutionStep : public Stepper {
 public:
  // A step is found when a substitution changes no velocity by more than `tolerance` (m/s) and no
  // position by more than `tolerance * h`, in at most `most` of them.
  SubstitutionStep(Assembly& assembly, double tolerance, int most, const Motion& start);

  // Heun's guess needs that the last step was as long; else Euler's is taken.
  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return 2; }
  // The substitutions shrink by h/2 times the largest rate.
  double longest_step(const FastestRates& rates) const override {
    return 2.0 / std::max(rates.oscillation, rates.decay);
  }

 private:
  const std::vector<int>& free_;
  double tolerance_;
  int most_;
  Acceleration acceleration_;
  Values a_, next_a_;
};

struct SubstitutionReport {
  bool converged = true;        // every step did
  int steps = 0;                // done
  long long substitutions = 0;  // of all steps, the one that failed included
  double time = 0.0;            // s, reached
};

// Marches `steps` steps of length `step` (s). A step is found when a substitution changes no
// velocity by more than `tolerance` (m/s) and no position by more than `tolerance * step`; where
// that takes more than `substitutions` of them, or numbers overflow, the march ends before that
// step and says so. This is the paper's scheme as printed: steps of one length, nothing repeated.
// x (m), v (m/s): 3 per node, the start on entry and the last step found on return; held nodes keep
// their velocity. watch: called before every step; returns false to end there. Throws
// std::invalid_argument where a free node has no mass.
SubstitutionReport march_by_substitution(Assembly& assembly, double step, int steps,
                                         double tolerance, int substitutions, double* x, double* v,
                                         const std::function<bool()>& watch = nullptr);

}  // namespace codend
