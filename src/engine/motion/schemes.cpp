#include "schemes.hpp"

#include <stdexcept>

#include "explicit_step.hpp"
#include "newton_step.hpp"
#include "substitution.hpp"

namespace codend {
namespace {

constexpr int most_substitutions = 200;
// Allowed position error per travelled distance, and of one step over the size of the gear, as
// fractions of the accuracy. The latter bounds the cost of impacts, whose errors decrease slowly.
constexpr double rate_share = 0.1, size_share = 1e-5;

std::unique_ptr<Stepper> newton(Assembly& assembly, const StepAccuracy& accuracy, const Motion&,
                                const Values& ordering) {
  return std::make_unique<NewtonStep>(assembly, accuracy, ordering);
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

StepAccuracy relative_accuracy(double accuracy, const Values& shape) {
  const Eigen::Map<const Eigen::Matrix3Xd> place(shape.data(), 3, shape.size() / 3);
  const double size = (place.rowwise().maxCoeff() - place.rowwise().minCoeff()).norm();
  StepAccuracy out;
  out.position = size_share * accuracy * size;
  out.rate = rate_share * accuracy;
  return out;
}

const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all = {
      {"tr_bdf2", true, newton},
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
