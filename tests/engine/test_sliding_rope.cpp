// A rope that slides through points: its energy, and zero tension when slack.
#include <doctest/doctest.h>

#include <cmath>

#include "filled_model.hpp"
#include "motion/newton_step.hpp"
#include "motion/time_integration.hpp"

namespace {

using namespace codend;

// A weight that slides on a weightless rope of length `rest` between two fixed points at distance
// `span`.
struct Ellipse : FilledModel {
  double span = 8.0, rest = 10.0, weight = 100.0;
  std::vector<double> v = std::vector<double>(9, 0.0);

  Ellipse() {
    node({0, 0, 0}, true);
    node({2.0, 0.5, -1.0});
    node({span, 0, 0}, true);
    model.load[5] = -weight;
    model.mass[1] = weight / 9.81;
    const int slack = material(0.0);
    model.materials[0].diameter = 0.01;
    SlidingRope rope;
    rope.bar = {bar(0, 1, 0.5 * rest, slack), bar(1, 2, 0.5 * rest, slack)};
    rope.axial_stiffness = 1e5;
    rope.bend = 0.02;
    model.sliding = {rope};
    model.prepare();
  }
};

}  // namespace

TEST_CASE("weight slides along its rope and conserves energy") {
  // It swings on an ellipse; the scheme has an error of second order.
  Ellipse e;
  Assembly assembly(e.model);
  auto total = [&](const Motion& m) {
    assembly.move_to(m.x.data(), m.v.data());
    return 0.5 * e.model.mass[1] * at(m.v.data(), 1).squaredNorm() + e.weight * m.x[5] +
           e.model.sliding[0].energy(assembly.field());
  };
  Past past;
  past.now = e.at_rest();
  // Above the lowest position; the rope is slack by 0.7 m.
  past.now.x.segment<3>(3) << 1.5, 0.0, -2.0;
  SteadyConditions conditions(e.model.held, past.now);
  StepAccuracy accuracy;
  accuracy.found = 1e-10;
  NewtonStep scheme(assembly, accuracy, past.now.x);
  IntegrationControl control;
  control.step = 0.001;
  TimeIntegration integration(assembly, scheme, conditions, control, past);
  const double before = total(past.now);
  REQUIRE(integration.to(2.0) == IntegrationReport::End::reached);
  // A fall of 1 m converts 100 J. When the rope snaps taut, at about 30 rad/s, a step loses
  // (0.03)^2 / 12: 1e-3 allows ten snaps.
  CHECK(std::abs(total(integration.now()) - before) < 1e-3 * e.weight);
}

TEST_CASE("sliding rope has zero tension when slack or parted") {
  Ellipse e;
  Assembly assembly(e.model);
  e.x[3] = 4.0;
  e.x[4] = 0.0;
  e.x[5] = -1.0;
  assembly.move_to(e.x.data(), e.v.data());
  CHECK(e.model.sliding[0].tension(assembly.field()) == 0.0);
  e.x[5] = -4.0;
  assembly.move_to(e.x.data(), e.v.data());
  CHECK(e.model.sliding[0].tension(assembly.field()) > 0.0);
  e.model.bars.multiplicity[1] = 0.0;
  CHECK(e.model.sliding[0].tension(assembly.field()) == 0.0);
}

TEST_CASE("hold() keeps nodes in place with zero net force") {
  Ellipse e;
  Assembly assembly(e.model);
  assembly.hold({0, 1, 0});
  Past past;
  past.now = e.at_rest();
  SteadyConditions conditions(e.model.held, past.now);
  StepAccuracy accuracy;
  accuracy.found = 1e-10;
  NewtonStep scheme(assembly, accuracy, past.now.x);
  IntegrationControl control;
  control.step = 0.1;
  TimeIntegration integration(assembly, scheme, conditions, control, past);
  REQUIRE(integration.to(1.0) == IntegrationReport::End::reached);
  for (int k = 0; k < 9; ++k) CHECK(integration.now().x[k] == e.x[static_cast<std::size_t>(k)]);
  assembly.hold({});
  REQUIRE(integration.to(1.2) == IntegrationReport::End::reached);
  CHECK(integration.now().x[5] < e.x[5]);
}
