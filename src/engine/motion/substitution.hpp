// Implicit trapezoidal rule, solved by fixed-point iteration (substitution).
//
// For y = (x, v) and dy/dt = f = (v, M^-1 F), with net force F, mass and added mass M:
//
//   y[k+1] = y[k] + h/2 (f(y[k]) + f(y[k+1]))
//
// The right side is evaluated with its own result until convergence (Li et al., Modeling of the
// Midwater Trawl Dynamical Behavior Based on R Language, eqs. 11 and 14). The initial guess is the
// non-self-starting Heun method, y[k-1] + 2 h f(y[k]) (Chapra and Canale, Numerical Methods for
// Engineers, 26.2). The first step uses y[k] + h f(y[k]).
//
// The iteration converges only if h omega < 2 for every natural frequency omega. Its steps are
// therefore as short as steps of an explicit method.
#pragma once

#include <algorithm>
#include <functional>

#include "accelerate.hpp"
#include "stepper.hpp"

namespace codend {

class SubstitutionStep : public Stepper {
 public:
  // A step has converged when an iteration changes every velocity by at most `tolerance` (m/s) and
  // every position by at most `tolerance * h`. `most` limits the iterations.
  SubstitutionStep(Assembly& assembly, double tolerance, int most, const Motion& start);

  // Heun's guess requires that the last step had the same length; otherwise Euler's guess is used.
  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return 2; }
  // The contraction rate is h/2 times the largest rate.
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
  bool converged = true;  // in every step
  int steps = 0;
  long long substitutions = 0;  // of all steps, with a failed one
  double time = 0.0;            // reached, s
};

// Integrates `steps` steps of length `step` (s), as printed in the paper: constant steps without
// repetition. tolerance, substitutions: `tolerance` and `most` of SubstitutionStep. The integration
// stops before a step that does not converge or overflows, and reports it.
//
// x (m), v (m/s): 3 per node, the start on entry, the last converged step on return. Fixed nodes
// keep their velocity. watch: called before every step; returns false to stop. Throws
// std::invalid_argument if a free node has no mass.
SubstitutionReport integrate_by_substitution(Assembly& assembly, double step, int steps,
                                             double tolerance, int substitutions, double* x,
                                             double* v,
                                             const std::function<bool()>& watch = nullptr);

}  // namespace codend
