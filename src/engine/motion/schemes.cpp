#include "schemes.hpp"

#include <stdexcept>

#include "explicit_step.hpp"
#include "newton_step.hpp"
#include "substitution.hpp"

namespace codend {
namespace {

constexpr int most_substitutions = 200;

template <NewtonScheme scheme>
std::unique_ptr<Stepper> newton(Assembly& assembly, const StepAccuracy& accuracy, const Motion&,
                                const Values& ordering) {
  return std::make_unique<NewtonStep>(assembly, scheme, accuracy, ordering);
}

std::unique_ptr<Stepper> by_substitution(Assembly& assembly, const StepAccuracy& accuracy,
                                         const Motion& start, const Values&) {
  return std::make_unique<SubstitutionStep>(assembly, accuracy.found, most_substitutions, start);
}

template <class Step>
std::unique_ptr<Stepper> explicitly(Assembly& assembly, const StepAccuracy&, const Motion& start,
                                    const Values&) {
  return std::make_unique<Step>(assembly, start);
}

}  // namespace

const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all = {
      {"bdf2", true, newton<NewtonScheme::bdf2>},
      {"generalised_alpha", true, newton<NewtonScheme::generalised_alpha>},
      {"backward_euler", true, newton<NewtonScheme::backward_euler>},
      {"substitution", false, by_substitution},
      {"symplectic_euler", false, explicitly<SymplecticEulerStep>},
      {"rk4", false, explicitly<RungeKuttaStep>},
  };
  return all;
}

const Scheme& scheme_named(const std::string& name) {
  std::string known;
  for (const Scheme& scheme : schemes()) {
    if (name == scheme.name) return scheme;
    known += (known.empty() ? "" : ", ") + std::string(scheme.name);
  }
  throw std::invalid_argument("the time scheme is `" + name + "`; it must be one of " + known);
}

}  // namespace codend
