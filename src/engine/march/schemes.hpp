// The time schemes by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stepper.hpp"

namespace codend {

struct Scheme {
  const char* name;
  bool adaptive;  // knows the error of its steps, so that an accuracy says how long they are
  // start: where the motion begins; ordering: as NewtonStep's.
  std::unique_ptr<Stepper> (*make)(Assembly& assembly, const StepAccuracy& accuracy,
                                   const Motion& start, const Values& ordering);
};

const std::vector<Scheme>& schemes();

// The scheme of that name. Throws std::invalid_argument, which lists the names, where there is none.
const Scheme& scheme_named(const std::string& name);

}  // namespace codend
