// Time schemes against closed forms, and the march's own promises.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "march/explicit_step.hpp"
#include "march/march.hpp"
#include "march/newton_step.hpp"
#include "march/substitution.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

// 1 kg between two bars that are both taut within 0.5 m of the middle: 100 N/m along x, 10 rad/s.
struct Oscillator {
  Model model;
  Motion start;
  Oscillator() {
    model.nodes = 3;
    model.held = {1, 0, 1};
    model.water.density = 0.0;
    model.load.assign(9, 0.0);
    model.mass = {0.0, 1.0, 0.0};
    TwineMaterial material;
    material.axial_stiffness = 50.0;
    model.materials = {material};
    model.bars.node = {0, 1, 1, 2};
    model.bars.rest = {1.0, 1.0};
    model.bars.multiplicity = {1.0, 1.0};
    model.bars.material = {0, 0};
    model.connect();
    start.x = Values::Zero(9);
    start.x << -1.5, 0.0, 0.0, 0.1, 0.0, 0.0, 1.5, 0.0, 0.0;
    start.v = Values::Zero(9);
  }
  Oscillator(const Oscillator&) = delete;
};

enum class Name { backward_euler, bdf2, trapezoid, substitution, symplectic_euler, rk4 };
constexpr Name names[] = {Name::backward_euler, Name::bdf2, Name::trapezoid, Name::substitution,
                          Name::symplectic_euler, Name::rk4};

std::unique_ptr<Stepper> stepper(Name name, Assembly& assembly, const Motion& start) {
  switch (name) {
    case Name::backward_euler:
      return std::make_unique<NewtonStep>(assembly, NewtonScheme::backward_euler, 1e-12);
    case Name::bdf2:
      return std::make_unique<NewtonStep>(assembly, NewtonScheme::bdf2, 1e-12);
    case Name::trapezoid:
      return std::make_unique<NewtonStep>(assembly, NewtonScheme::trapezoid, 1e-12);
    case Name::substitution:
      return std::make_unique<SubstitutionStep>(assembly, 1e-13, 1000, start);
    case Name::symplectic_euler:
      return std::make_unique<SymplecticEulerStep>(assembly, start);
    default:
      return std::make_unique<RungeKuttaStep>(assembly, start);
  }
}

Motion march(const Model& model, const Motion& start, Name name, double until,
             const MarchControl& control, MarchReport* report = nullptr) {
  Assembly assembly(model);
  SteadyConditions conditions(model.held, start);
  const std::unique_ptr<Stepper> scheme = stepper(name, assembly, start);
  Past past;
  past.now = start;
  March march(assembly, *scheme, conditions, control, past);
  CHECK(march.to(until) == MarchReport::End::reached);
  if (report) *report = march.report();
  return march.now();
}

}  // namespace

TEST_CASE("every scheme has its order on a smooth motion") {
  const Oscillator o;
  const double order[] = {1.0, 2.0, 2.0, 2.0, 1.0, 4.0};
  for (const Name name : names) {
    CAPTURE(static_cast<int>(name));
    auto error = [&](double step) {
      MarchControl control;
      control.step = step;
      const Motion end = march(o.model, o.start, name, 1.0, control);
      CHECK(end.time == doctest::Approx(1.0).epsilon(1e-12));
      const double x = end.x[3] - 0.1 * std::cos(10.0), v = end.v[3] + std::sin(10.0);
      return std::hypot(x, 0.1 * v);
    };
    // h w = 0.01 and 0.005: the next term of the error is smaller by some 1e-2.
    const double slope = std::log2(error(1e-3) / error(5e-4));
    CHECK(slope == doctest::Approx(order[static_cast<int>(name)]).epsilon(0.02));
  }
}
