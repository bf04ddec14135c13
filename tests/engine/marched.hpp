// Where a motion comes in conditions that a test chooses.
#pragma once

#include <doctest/doctest.h>

#include "march/march.hpp"

namespace codend {

// By a time (s), in steps of one length (s) or adaptive ones that begin so.
inline Motion marched(Assembly& assembly, Stepper& stepper, Conditions& conditions,
                      const Motion& start, double until, double step, bool adaptive = false,
                      MarchReport* report = nullptr) {
  MarchControl control;
  control.adaptive = adaptive;
  control.step = step;
  Past past;
  past.now = start;
  March march(assembly, stepper, conditions, control, past);
  CHECK(march.to(until) == MarchReport::End::reached);
  if (report) *report = march.report();
  return march.now();
}

}  // namespace codend
