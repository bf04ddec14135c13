#include "schemes.hpp"

#include <stdexcept>

#include "explicit_step.hpp"
#include "newton_step.hpp"
#include "substitution.hpp"

namespace codend {
namespace {

constexpr int most_substitutions = 200;

template <NewtonScheme scheme>
std::unique_ptr<Stepper> newton(Assembly& assembly, double tolerance, const Motion&) {
  return std::make_unique<NewtonStep>(assembly, scheme, tolerance);
}

std::unique_ptr<Stepper> by_substitution(Assembly& assembly, double tolerance,
                                         const Motion& start) {
  return std::make_unique<SubstitutionStep>(assembly, tolerance, most_substitutions, start);
}

template <class Step>
std::unique_ptr<Stepper> explicitly(Assembly& assembly, double, const Motion& start) {
  return std::make_unique<Step>(assembly, start);
}

}  // namespace

const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all = {
      {"bdf2", true, newton<NewtonScheme::bdf2>},
      {"trapezoid", true, newton<NewtonScheme::trapezoid>},
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
