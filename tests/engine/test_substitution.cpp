// The paper's time scheme: invariants of the converged trapezoidal rule, and the limit of
// substitution.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "motion/substitution.hpp"
#include "oscillator.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

struct Swing : Oscillator {
  std::vector<double> v = std::vector<double>(9, 0.0);
  double spring = 100.0;

  double energy() const { return 0.5 * v[3] * v[3] + 0.5 * spring * x[3] * x[3]; }
  SubstitutionReport integration(double step, int steps, int substitutions = 5000) {
    Assembly assembly(model);
    return integrate_by_substitution(assembly, step, steps, 1e-13, substitutions, x.data(),
                                     v.data());
  }
};

}  // namespace

TEST_CASE("converged trapezoidal rule conserves energy and has its known frequency") {
  Swing o;
  const double step = 0.1, start = o.energy();  // omega h = 1
  // The trapezoidal rule rotates (x, v/omega) by 2 atan(omega h/2) a step, exactly.
  const double turn = 2.0 * std::atan(0.5);
  CHECK(turn / step == doctest::Approx(9.2729522).epsilon(1e-8));
  for (int k = 1; k <= 200; ++k) {
    REQUIRE(o.integration(step, 1).converged);
    // A step is solved to 1e-13 / (1 - omega h/2), and errors accumulate over 200 steps.
    CHECK(std::abs(o.x[3] - 0.1 * std::cos(k * turn)) < 1e-10);
    CHECK(std::abs(o.v[3] + std::sin(k * turn)) < 1e-9);
    CHECK(o.energy() == doctest::Approx(start).epsilon(1e-9));
  }
  CHECK(o.x[4] == 0.0);
  CHECK(o.x[5] == 0.0);
}

TEST_CASE("one call of 50 steps agrees with 50 single steps") {
  Swing one, many;
  const SubstitutionReport report = one.integration(0.1, 50);
  CHECK(report.converged);
  CHECK(report.steps == 50);
  CHECK(report.time == doctest::Approx(5.0).epsilon(1e-14));
  long long substitutions = 0;
  for (int k = 0; k < 50; ++k) substitutions += many.integration(0.1, 1).substitutions;
  CHECK(std::abs(one.x[3] - many.x[3]) < 1e-11);
  // The initial guess from two previous steps is better than Euler's.
  CHECK(report.substitutions < substitutions);
}

TEST_CASE("substitution converges only below omega h = 2") {
  Swing below, above;
  CHECK(below.integration(0.19, 20).converged);  // errors shrink by 0.95 a round
  const double x = above.x[3], v = above.v[3];
  const SubstitutionReport report = above.integration(0.205, 20);
  CHECK_FALSE(report.converged);
  CHECK(report.steps == 0);
  CHECK(report.time == 0.0);
  CHECK(above.x[3] == x);
  CHECK(above.v[3] == v);
}

TEST_CASE("integration with too few substitutions ends at the last solved step") {
  Swing o, reference;
  // The first step starts from Euler's guess and needs the most substitutions; here it runs
  // separately.
  REQUIRE(o.integration(0.02, 1).converged);
  const SubstitutionReport report = o.integration(0.02, 5, 3);
  CHECK_FALSE(report.converged);
  CHECK(report.steps == 0);
  CHECK(report.substitutions == 3);
  REQUIRE(reference.integration(0.02, 1).converged);
  CHECK(o.x == reference.x);
  CHECK(o.v == reference.v);
}

TEST_CASE("fixed nodes keep their velocity and move the other nodes") {
  Swing o;
  o.v = {0.3, 0.0, 0.0, 0.3, 0.0, 0.0, 0.3, 0.0, 0.0};
  o.x[3] = 0.0;
  REQUIRE(o.integration(0.01, 100).converged);
  for (const int node : {0, 1, 2}) {
    CHECK(o.v[3 * node] == doctest::Approx(0.3).epsilon(1e-11));
    CHECK(o.x[3 * node] == doctest::Approx(1.5 * (node - 1) + 0.3).epsilon(1e-11));
  }
}

TEST_CASE("added mass of a line is larger across than along") {
  // One free node on a taut line along x, pushed along and across. Initial acceleration: force / (m
  // + the line's added mass in that direction).
  Swing o;
  o.model.water.density = 1000.0;
  o.model.materials[0].volume_per_length = 1e-3;  // 1 kg of water per metre, half of it per end
  o.x[3] = 0.0;
  const double force = 10.0;
  for (const int way : {0, 1}) {
    CAPTURE(way);
    o.model.load.assign(9, 0.0);
    o.model.load[3 + way] = force;
    std::vector<double> x = o.x, v = o.v;
    Assembly assembly(o.model);
    const double step = 1e-6;
    REQUIRE(integrate_by_substitution(assembly, step, 1, 1e-16, 50, x.data(), v.data()).converged);
    const double mass = 1.0 + (way == 0 ? 0.0 : 1.0);
    // omega h = 1e-5, squared.
    CHECK(v[3 + way] == doctest::Approx(force / mass * step).epsilon(1e-9));
  }
}

TEST_CASE("free node without mass throws an error before any motion") {
  Swing o;
  o.model.mass[1] = 0.0;
  const std::vector<double> before = o.x;
  CHECK_THROWS_AS(o.integration(0.01, 1), std::invalid_argument);
  CHECK(o.x == before);
}
