// Time integration under conditions that a test chooses.
#pragma once

#include <doctest/doctest.h>

#include "motion/time_integration.hpp"

namespace codend {

// Returns the control of adaptive steps that start with a length (s).
inline IntegrationControl adaptive_from(double step) {
  IntegrationControl control;
  control.adaptive = true;
  control.step = step;
  return control;
}

// Returns the past of a motion that starts under these conditions.
inline Past started(Conditions& conditions, const Motion& start) {
  Past past;
  past.now = start;
  conditions.to_time(start.time, Side::after, past.now);
  return past;
}

// Integrates to a time (s) with a constant step (s), or with adaptive steps that start with it.
inline Motion integrated(Assembly& assembly, Stepper& stepper, Conditions& conditions,
                         const Motion& start, double until, double step, bool adaptive = false,
                         IntegrationReport* report = nullptr) {
  IntegrationControl control;
  control.adaptive = adaptive;
  control.step = step;
  Past past;
  past.now = start;
  TimeIntegration integration(assembly, stepper, conditions, control, past);
  CHECK(integration.to(until) == IntegrationReport::End::reached);
  if (report) *report = integration.report();
  return integration.now();
}

}  // namespace codend
