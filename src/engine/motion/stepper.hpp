// One step of a time integration scheme. `TimeIntegration` chooses its length and accepts or rejects it.
#pragma once

#include <limits>

#include "../model/assembly.hpp"
#include "conditions.hpp"
#include "fastest_rates.hpp"

namespace codend {

struct StepAccuracy {
  // Allowed errors of one step. Infinite values disable the check.
  // - position of a node: `position` (m), or if larger `rate` times the distance that the fastest
  //   node travels in the step, relative to the mean of all nodes;
  // - tension of a line, as a fraction of the gear's largest.
  double position = std::numeric_limits<double>::infinity();
  double tension = std::numeric_limits<double>::infinity();
  // Convergence tolerance of an implicit step (m), unless an allowed error demands a smaller one; of
  // a substitution (m/s).
  double found = std::numeric_limits<double>::infinity();
  double rate = 0.0;
};

// Returns the allowed errors for a relative accuracy of a motion. shape: positions (m, 3 per node).
StepAccuracy relative_accuracy(double accuracy, const Values& shape);

struct StepOutcome {
  bool found = false;
  // Error of the step over the allowance, and position error (m); 0 without an estimate.
  double error = 0.0, place_error = 0.0;
  int iterations = 0;   // Newton iterations, substitutions or stages
  int worst_node = -1;  // node with the largest error or residual
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  // Computes a step of h (s) from past.now. On entry, the vectors of `next` have the lengths of
  // past.now; after convergence, `next` is the end of the step.
  virtual StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) = 0;

  // Called at the start and after discontinuities; sets the initial a of the scheme.
  virtual void begin(Motion& motion) { motion.a.setZero(motion.x.size()); }

  // Discards earlier steps except `past`, so that a continued integration gives identical steps.
  virtual void forget() {}

  virtual long long factorisations() const { return 0; }
  // Stored entries of L and U in the last factorisation.
  virtual long long factor_entries() const { return 0; }

  // Order of accuracy: the error of a step scales with h^(order + 1).
  virtual int order() const = 0;
  // Longest step (s) with guaranteed stability or convergence at these rates.
  virtual double longest_step(const FastestRates&) const {
    return std::numeric_limits<double>::infinity();
  }
};

}  // namespace codend
