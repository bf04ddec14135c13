// The paper's time scheme: what the converged trapezoid rule keeps, and where substitution stops.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "march/substitution.hpp"
#include "oscillator.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

struct Swing : Oscillator {
  std::vector<double> v = std::vector<double>(9, 0.0);
  double spring = 100.0;

  double energy() const { return 0.5 * v[3] * v[3] + 0.5 * spring * x[3] * x[3]; }
  SubstitutionReport march(double step, int steps, int substitutions = 5000) {
    Assembly assembly(model);
    return march_by_substitution(assembly, step, steps, 1e-13, substitutions, x.data(), v.data());
  }
};

}  // namespace

TEST_CASE("the converged trapezoid keeps an oscillator's energy and has its known frequency") {
  Swing o;
  const double step = 0.1, start = o.energy();  // omega h = 1
  // The trapezoid rule turns (x, v/omega) by 2 atan(omega h/2) a step, exactly.
  const double turn = 2.0 * std::atan(0.5);
  CHECK(turn / step == doctest::Approx(9.2729522).epsilon(1e-8));
  for (int k = 1; k <= 200; ++k) {
    REQUIRE(o.march(step, 1).converged);
    // A step is found to 1e-13 / (1 - omega h/2), and errors add up over 200 of them.
    CHECK(std::abs(o.x[3] - 0.1 * std::cos(k * turn)) < 1e-10);
    CHECK(std::abs(o.v[3] + std::sin(k * turn)) < 1e-9);
    CHECK(o.energy() == doctest::Approx(start).epsilon(1e-9));
  }
  CHECK(o.x[4] == 0.0);
  CHECK(o.x[5] == 0.0);
}

TEST_CASE("a march in one go goes where single steps go") {
  Swing one, many;
  const SubstitutionReport report = one.march(0.1, 50);
  CHECK(report.converged);
  CHECK(report.steps == 50);
  CHECK(report.time == doctest::Approx(5.0).epsilon(1e-14));
  long long substitutions = 0;
  for (int k = 0; k < 50; ++k) substitutions += many.march(0.1, 1).substitutions;
  CHECK(std::abs(one.x[3] - many.x[3]) < 1e-11);
  // The guess from two steps back is better than Euler's.
  CHECK(report.substitutions < substitutions);
}

TEST_CASE("substitution converges below omega h = 2 and not above") {
  Swing below, above;
  CHECK(below.march(0.19, 20).converged);  // errors shrink by 0.95 a round
  const double x = above.x[3], v = above.v[3];
  const SubstitutionReport report = above.march(0.205, 20);
  CHECK_FALSE(report.converged);
  CHECK(report.steps == 0);
  CHECK(report.time == 0.0);
  CHECK(above.x[3] == x);
  CHECK(above.v[3] == v);
}

TEST_CASE("a march that is given too few substitutions ends with the last step found") {
  Swing o, reference;
  // The first step, from Euler's guess, needs the most; here it is taken alone.
  REQUIRE(o.march(0.02, 1).converged);
  const SubstitutionReport report = o.march(0.02, 5, 3);
  CHECK_FALSE(report.converged);
  CHECK(report.steps == 0);
  CHECK(report.substitutions == 3);
  REQUIRE(reference.march(0.02, 1).converged);
  CHECK(o.x == reference.x);
  CHECK(o.v == reference.v);
}

TEST_CASE("held nodes keep their velocity and pull the rest along") {
  Swing o;
  o.v = {0.3, 0.0, 0.0, 0.3, 0.0, 0.0, 0.3, 0.0, 0.0};
  o.x[3] = 0.0;
  REQUIRE(o.march(0.01, 100).converged);
  for (const int node : {0, 1, 2}) {
    CHECK(o.v[3 * node] == doctest::Approx(0.3).epsilon(1e-11));
    CHECK(o.x[3 * node] == doctest::Approx(1.5 * (node - 1) + 0.3).epsilon(1e-11));
  }
}

TEST_CASE("added mass is a matrix: a line in water is heavier across than along") {
  // One free node on a taut line along x, pushed along and across: accelerations at the start are
  // force / (m + share of the line's added mass that way).
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
    REQUIRE(march_by_substitution(assembly, step, 1, 1e-16, 50, x.data(), v.data()).converged);
    const double mass = 1.0 + (way == 0 ? 0.0 : 1.0);
    // omega h = 1e-5, squared.
    CHECK(v[3 + way] == doctest::Approx(force / mass * step).epsilon(1e-9));
  }
}

TEST_CASE("a free node without mass is refused before anything moves") {
  Swing o;
  o.model.mass[1] = 0.0;
  const std::vector<double> before = o.x;
  CHECK_THROWS_AS(o.march(0.01, 1), std::invalid_argument);
  CHECK(o.x == before);
}
