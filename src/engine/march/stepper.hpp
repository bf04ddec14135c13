// One step of a time scheme. The march decides how long it is and what to do with it.
#pragma once

#include <limits>

#include "../model/assembly.hpp"
#include "conditions.hpp"
#include "fastest_rates.hpp"

namespace codend {

struct StepOutcome {
  bool found = false;
  double error = 0.0;  // the step's own error of position, m; 0 where a scheme has no estimate
  int iterations = 0;  // Newton iterations, substitutions or stages
  int worst_node = -1; // where the error, or what was not found, is largest
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  // From past.now over h (s); next holds all of the step where one was found. Its vectors are as
  // long as those of past.now on entry.
  virtual StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) = 0;

  // To be called where a motion begins anew, in its conditions; sets what the scheme needs of a.
  virtual void begin(Motion& motion) { motion.a.setZero(motion.x.size()); }

  // Order of accuracy, with which the error of a step is known to grow: h^(order + 1).
  virtual int order() const = 0;
  // The longest step (s) that is surely stable, or found, at such rates.
  virtual double longest_step(const FastestRates&) const {
    return std::numeric_limits<double>::infinity();
  }
};

}  // namespace codend
