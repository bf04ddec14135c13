// A rope that slides through points: its energy, and where it does not pull.
#include <doctest/doctest.h>

#include <cmath>

#include "filled_model.hpp"
#include "march/march.hpp"
#include "march/newton_step.hpp"

namespace {

using namespace codend;

// A weight that slides on a weightless rope of length `rest` between two held points `span` apart.
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

TEST_CASE("a weight slides along its rope without losing energy") {
  // Swings on an ellipse, which generalised alpha follows but for its error of second order.
  Ellipse e;
  Assembly assembly(e.model);
  auto total = [&](const Motion& m) {
    assembly.move_to(m.x.data(), m.v.data());
    return 0.5 * e.model.mass[1] * at(m.v.data(), 1).squaredNorm() + e.weight * m.x[5] +
           e.model.sliding[0].energy(assembly.field());
  };
  Past past;
  past.now = e.at_rest();
  // Above the lowest place, a slack rope's 0.7 m off it.
  past.now.x.segment<3>(3) << 1.5, 0.0, -2.0;
  SteadyConditions conditions(e.model.held, past.now);
  StepAccuracy accuracy;
  accuracy.found = 1e-10;
  NewtonStep scheme(assembly, NewtonScheme::generalised_alpha, accuracy, past.now.x);
  MarchControl control;
  control.step = 0.001;
  March march(assembly, scheme, conditions, control, past);
  const double before = total(past.now);
  REQUIRE(march.to(2.0) == MarchReport::End::reached);
  // 100 J are turned over in a fall of 1 m; where it snaps taut, at some 30 rad/s, a step of
  // (0.03)^2 / 12 of that is lost: 1e-3 leaves room for ten snaps.
  CHECK(std::abs(total(march.now()) - before) < 1e-3 * e.weight);
}

TEST_CASE("a sliding rope pulls nothing while slack or parted") {
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

TEST_CASE("nodes that are kept stay and show no net force") {
  Ellipse e;
  Assembly assembly(e.model);
  assembly.hold({0, 1, 0});
  Past past;
  past.now = e.at_rest();
  SteadyConditions conditions(e.model.held, past.now);
  StepAccuracy accuracy;
  accuracy.found = 1e-10;
  NewtonStep scheme(assembly, NewtonScheme::bdf2, accuracy, past.now.x);
  MarchControl control;
  control.step = 0.1;
  March march(assembly, scheme, conditions, control, past);
  REQUIRE(march.to(1.0) == MarchReport::End::reached);
  for (int k = 0; k < 9; ++k) CHECK(march.now().x[k] == e.x[static_cast<std::size_t>(k)]);
  assembly.hold({});
  REQUIRE(march.to(1.2) == MarchReport::End::reached);
  CHECK(march.now().x[5] < e.x[5]);
}
