#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stepper.hpp"

namespace codend {

struct Scheme {
  const char* name;
  bool adaptive;  // estimates the error of its steps, so that an accuracy sets the step length
  // start: initial state; ordering: see NewtonStep.
  std::unique_ptr<Stepper> (*make)(Assembly& assembly, const StepAccuracy& accuracy,
                                   const Motion& start, const Values& ordering);
};

const std::vector<Scheme>& schemes();

// Returns the scheme with this name. Throws std::invalid_argument with all names if it is unknown.
const Scheme& scheme_named(const std::string& name);

}  // namespace codend
