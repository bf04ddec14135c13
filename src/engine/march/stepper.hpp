// One step of a time scheme. The march decides how long it is and what to do with it.
#pragma once

#include <limits>

#include "../model/assembly.hpp"
#include "conditions.hpp"
#include "fastest_rates.hpp"

namespace codend {

// What a step is held to.
struct StepAccuracy {
  // Errors that one step may make: of any node's position, m, and of any line's tension, as a share
  // of the gear's largest. Not judged where infinite.
  double position = std::numeric_limits<double>::infinity();
  double tension = std::numeric_limits<double>::infinity();
  double found = 1e-6;  // within which an implicit step is found, m, or by substitution m/s
};

struct StepOutcome {
  bool found = false;
  // The step's own error over what is allowed; 0 where a scheme has no estimate. Above 1 in a step
  // that was not found: given up because it is too long.
  double error = 0.0;
  int iterations = 0;   // Newton iterations, substitutions or stages
  int worst_node = -1;  // where the error, or what was not found, is largest
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  // From past.now over h (s); next holds all of the step where one was found. Its vectors are as
  // long as those of past.now on entry.
  virtual StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) = 0;

  // To be called where a motion begins anew, in its conditions; sets what the scheme needs of a and b.
  virtual void begin(Motion& motion) {
    motion.a.setZero(motion.x.size());
    motion.b.setZero(motion.x.size());
  }

  // Leaves nothing of the steps before but what `past` says of them: steps that follow are those of a
  // march that is taken up here.
  virtual void forget() {}

  // Of matrices so far.
  virtual long long factorisations() const { return 0; }
  // Count of numbers that the last factorisation stores for L and U.
  virtual long long factor_entries() const { return 0; }

  // Order of accuracy, with which the error of a step is known to grow: h^(order + 1).
  virtual int order() const = 0;
  // The longest step (s) that is surely stable, or found, at such rates.
  virtual double longest_step(const FastestRates&) const {
    return std::numeric_limits<double>::infinity();
  }
};

}  // namespace codend
