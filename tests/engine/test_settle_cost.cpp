// Cost of settle() in counts: iterations, factorisations and allocations, never in seconds.
#include <doctest/doctest.h>

#include <vector>

#include "allocation_count.hpp"
#include "filled_model.hpp"
#include "model/assembly.hpp"
#include "solve/settle.hpp"

namespace {

using namespace codend;

// Square netting of n x n knots 0.5 m apart in a current of 0.5 m/s, fixed at its upper row.
// Each knot of the lowest row has a load of 8.5 N. Initially flat and upright, as between two
// poles.
struct SquareNet : FilledModel {
  explicit SquareNet(int n) {
    model.water = Water();
    model.water.current = {Vector(0.5, 0.0, 0.0)};
    const int twine = material(1.2e4);
    model.materials[0].diameter = 0.004;
    model.materials[0].law = {CylinderLawKind::constant, 1.2, 0.0314, 0.0, 0.0};
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const int knot = node({0.0, 0.5 * column, -0.5 * row}, row == 0);
        model.mass.back() = 0.03;
        model.load.back() = row == n - 1 ? -8.5 : -0.02;
        if (row > 0) bar(knot - n, knot, 0.5, twine);
        if (row > 0 && column > 0) bar(knot - 1, knot, 0.5, twine);
      }
    }
    model.prepare();
  }
};

struct Cost {
  SettleReport report;
  std::vector<long> allocations;  // so far, at every step
};

Cost settle_and_count(int n) {
  SquareNet net(n);
  Assembly assembly(net.model);
  const std::vector<double> v(net.x.size(), 0.0);
  Cost cost;
  cost.allocations.reserve(10000);
  SettleControl control;
  control.watch = [&](const SettleProgress&) {
    cost.allocations.push_back(allocation_count());
    return true;
  };
  cost.report = settle(assembly, control, v.data(), net.x.data());
  return cost;
}

}  // namespace

TEST_CASE("square net settles in few iterations without further allocation") {
  for (const int n : {8, 16, 32}) {
    CAPTURE(n);
    const Cost cost = settle_and_count(n);
    REQUIRE(cost.report.converged);
    // 14, 15 and 18 when this was written, plus a margin of half as many.
    CHECK(cost.report.iterations <= 27);
    CHECK(cost.report.factorisations <= cost.report.iterations);
    REQUIRE(cost.allocations.size() > 4);
    // The first step analyses the matrix and sizes the workspace. So does the first step of the
    // constitutive law itself, for its own workspace; later steps allocate nothing.
    CHECK(cost.allocations.back() - cost.allocations[1] <= 1);
  }
}
