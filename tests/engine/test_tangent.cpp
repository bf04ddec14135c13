// Response of an equilibrium to small changes, compared with analytical solutions and the matrix
// itself.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "filled_model.hpp"
#include "random_model.hpp"
#include "solve/tangent.hpp"

namespace {

using namespace codend;

// Two bars of 1 m and EA 1e4 N between points 2 m apart, their middle (node 2) pulled down by P N.
// It sags by h with P = 2 EA (L - 1) h / L, L = sqrt(1 + h^2).
struct Truss : FilledModel {
  explicit Truss(double sag, double pull) {
    const int left = node({-1.0, 0.0, 0.0}, true), right = node({1.0, 0.0, 0.0}, true);
    const int middle = node({0.0, 0.0, -sag});
    at(model.load.data(), middle).z() = -pull;
    bar(left, middle, 1.0, material(stiffness));
    bar(middle, right, 1.0, 0);
    model.prepare();
  }

  static constexpr double stiffness = 1e4;
  static double pull_of(double sag) {
    const double length = std::sqrt(1.0 + sag * sag);
    return 2.0 * stiffness * (length - 1.0) * sag / length;
  }
  static double stiffness_at(double sag) {  // dP/dh
    return 2.0 * stiffness * (1.0 - std::pow(1.0 + sag * sag, -1.5));
  }
};

}  // namespace

TEST_CASE("tangent of a truss matches the analytical derivative and transpose") {
  const double sag = 0.2;
  Truss truss(sag, Truss::pull_of(sag));
  Assembly assembly(truss.model);
  const Tangent tangent(assembly, truss.x.data());
  REQUIRE(tangent.regular());
  REQUIRE(tangent.size() == 9);
  std::vector<double> down(9, 0.0), moved(9, 7.0);
  down[8] = -1.0;
  tangent.solve(down.data(), moved.data());
  // L - 1 loses two digits
  CHECK(moved[8] == doctest::Approx(-1.0 / Truss::stiffness_at(sag)).epsilon(1e-13));
  CHECK(moved[0] == 7.0);  // fixed nodes are not changed
  tangent.solve_transposed(down.data(), moved.data());
  CHECK(moved[8] == doctest::Approx(-1.0 / Truss::stiffness_at(sag)).epsilon(1e-13));
}

TEST_CASE("chord steps converge to a near equilibrium and report failure otherwise") {
  const double sag = 0.2, other_sag = 0.201;
  Truss truss(sag, Truss::pull_of(sag)), other(sag, Truss::pull_of(other_sag));
  Assembly assembly(truss.model), changed(other.model);
  const Tangent tangent(assembly, truss.x.data());
  const ChordReport report = tangent.balance(changed, 1e-10, 50, other.x.data());
  CHECK(report.converged);
  CHECK(report.residual <= 1e-10);
  // strains of 0.02 are accurate to 1e-16 over 0.02, and the sag is a third as sensitive
  CHECK(-other.x[8] == doctest::Approx(other_sag).epsilon(1e-13));

  Truss far(sag, Truss::pull_of(0.9));
  Assembly far_off(far.model);
  CHECK_FALSE(tangent.balance(far_off, 1e-10, 50, far.x.data()).converged);

  Truss held(sag, 1.0);
  held.model.held = {1, 1, 1};
  Assembly fixed(held.model);
  CHECK_THROWS_AS(tangent.balance(fixed, 1e-10, 50, held.x.data()), std::invalid_argument);
}

TEST_CASE("slack truss has no regular tangent") {
  Truss truss(0.0, 0.0);
  truss.model.bars.rest = {1.1, 1.1};
  Assembly assembly(truss.model);
  CHECK_FALSE(Tangent(assembly, truss.x.data()).regular());
}

TEST_CASE("tangent and its transpose agree with the assembly's derivative") {
  Random random(20260611);
  for (int repeat = 0; repeat < 20; ++repeat) {
    Ingredients wanted;
    wanted.bars = 30;
    wanted.cells = 4;
    wanted.hexagons = 2;
    wanted.sliding = 1;
    wanted.plates = 1;
    wanted.contacts = 3;
    wanted.wake = repeat % 2 == 1;
    Specimen s(random, wanted);
    std::fill(s.v.begin(), s.v.end(), 0.0);
    Assembly assembly(s.model);
    const Tangent tangent(assembly, s.x.data());
    REQUIRE(tangent.regular());
    std::vector<double> force(s.x.size()), weight(s.x.size());
    for (double& f : force) f = random.between(-1.0, 1.0);
    for (double& w : weight) w = random.between(-1.0, 1.0);
    std::vector<double> moved(s.x.size(), 0.0), back(s.x.size(), 0.0);
    tangent.solve(force.data(), moved.data());
    tangent.solve_transposed(weight.data(), back.data());

    // w . J^-1 f by both solutions
    double forwards = 0.0, backwards = 0.0, scale = 0.0;
    for (const int node : assembly.free_nodes()) {
      forwards += at(weight.data(), node).dot(at(moved.data(), node));
      backwards += at(back.data(), node).dot(at(force.data(), node));
      scale += at(moved.data(), node).norm();
    }
    // conditions up to 1e6, rounding 1e-16
    CHECK(std::abs(forwards - backwards) <= 1e-9 * scale);

    // J dx reproduces the force, to the rounding (about 1e-15) of the sums' largest terms
    std::vector<double> values(9 * assembly.pattern().column.size());
    assembly.move_to(s.x.data(), s.v.data());
    assembly.jacobian({1.0, 0.0}, values.data());
    const BlockPattern& pattern = assembly.pattern();
    for (int row = 0; row < pattern.n; ++row) {
      Vector sum = -at(force.data(), assembly.free_nodes()[static_cast<std::size_t>(row)]);
      double terms = 0.0;
      for (int64_t b = pattern.row_start[row]; b < pattern.row_start[row + 1]; ++b) {
        const int node = pattern.column[static_cast<std::size_t>(b)];
        const Vector term = Eigen::Map<const Block>(&values[9 * static_cast<std::size_t>(b)]) *
                            at(moved.data(), assembly.free_nodes()[static_cast<std::size_t>(node)]);
        sum += term;
        terms = std::max(terms, term.norm());
      }
      CHECK(sum.norm() <= 1e-11 * (1.0 + terms));
    }
  }
}
