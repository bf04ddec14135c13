// Every time scheme of the table keeps what it says of itself.
#include <doctest/doctest.h>

#include <cmath>

#include "march/march.hpp"
#include "march/schemes.hpp"
#include "moving_models.hpp"

using namespace codend;

TEST_CASE("every scheme has the order of accuracy that it says, on a smooth motion") {
  Model model;
  make_oscillator(model);
  Motion start;
  start.x = Eigen::Map<const Values>(oscillator_start, 9);
  start.v = Values::Zero(9);
  for (const Scheme& scheme : schemes()) {
    CAPTURE(scheme.name);
    int order = 0;
    // After 1 s: 0.1 m cos(10 t).
    auto error = [&](double step) {
      Assembly assembly(model);
      SteadyConditions conditions(model.held, start);
      StepAccuracy accuracy;
      accuracy.found = 1e-13;
      const std::unique_ptr<Stepper> stepper = scheme.make(assembly, accuracy, start, start.x);
      order = stepper->order();
      MarchControl control;
      control.step = step;
      Past past;
      past.now = start;
      March march(assembly, *stepper, conditions, control, past);
      REQUIRE(march.to(1.0) == MarchReport::End::reached);
      const Motion& end = march.now();
      return std::hypot(end.x[3] - 0.1 * std::cos(10.0), 0.1 * (end.v[3] + std::sin(10.0)));
    };
    // h w = 0.01 and 0.005: the next term of the error is smaller by some 1e-2.
    const double slope = std::log2(error(1e-3) / error(5e-4));
    CHECK(slope == doctest::Approx(order).epsilon(0.02));
  }
}

TEST_CASE("an unknown scheme is refused with the names of those that there are") {
  CHECK(scheme_named(schemes().front().name).name == std::string(schemes().front().name));
  CHECK_THROWS_WITH_AS(scheme_named("euler"), doctest::Contains(schemes().front().name),
                       std::invalid_argument);
}
