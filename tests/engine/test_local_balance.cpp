// Nodes that swing: which they are, and where they come to rest beside nodes that are held.
#include <doctest/doctest.h>

#include <cmath>

#include "filled_model.hpp"
#include "solve/local_balance.hpp"

namespace {

using namespace codend;

// A load that hangs by two bars from two supports in air, beside a taut cable in three parts.
struct Hanging : FilledModel {
  int load, first, second, taut;

  Hanging() {
    const int twine = material(1e6);
    const int left = node({0.0, 0.0, 0.0}, true), right = node({1.2, 0.0, 0.0}, true);
    load = node({0.3, 0.4, 0.2});
    at(model.load.data(), load) = Vector(0.0, 0.0, -3.0);
    first = bar(left, load, 1.0, twine);
    second = bar(load, right, 1.5, twine);
    const int a = node({5.0, 0.0, 0.0}, true), b = node({6.0, 0.0, 0.0}), c = node({7.0, 0.0, 0.0}),
              d = node({8.0, 0.0, 0.0}, true);
    bar(a, b, 1.0, twine);
    taut = bar(b, c, 1.0, twine);
    bar(c, d, 1.0, twine);
    for (const int n : {b, c}) at(model.load.data(), n) = Vector(0.0, 0.0, -3.0);
    model.prepare();
  }
  std::vector<int> swinging(const std::vector<double>& dx, double tension) const {
    const std::vector<double> tensions(static_cast<std::size_t>(model.bars.count()), tension);
    std::vector<int> found;
    LocalBalance(model).swinging(dx.data(), tensions, model.load.data(), {}, found);
    return found;
  }
};

TEST_CASE("a node that swings comes to rest where its bars and its load put it") {
  Hanging gear;
  const std::vector<double> before = gear.x, v(gear.x.size(), 0.0);
  LocalBalance(gear.model).settle({gear.load}, v.data(), gear.x.data());
  // Both bars are taut: the corner of a triangle with sides 1, 1.5 and 1.2, below the others.
  const double along = (1.0 + 1.2 * 1.2 - 1.5 * 1.5) / (2.0 * 1.2);
  const Vector corner(along, 0.0, -std::sqrt(1.0 - along * along));
  // They are stretched by 3 N / 1e6 N, seen at a sharp angle.
  CHECK((at(gear.x.data(), gear.load) - corner).norm() < 1e-5);
  for (int n = 0; n < gear.model.nodes; ++n) {
    if (n != gear.load) CHECK(at(gear.x.data(), n) == at(before.data(), n));
  }
  LocalBalance(gear.model).each_bar({gear.load}, gear.x.data(), [&](std::size_t, double strain) {
    CHECK(strain > 0.0);
    CHECK(strain < 3.1e-6);
  });
}

TEST_CASE("nodes swing that turn by themselves and hang by little") {
  Hanging gear;
  std::vector<double> dx(gear.x.size(), 0.0);
  CHECK(gear.swinging(dx, 3.0).empty());
  at(dx.data(), gear.load) = Vector(0.0, 0.2, 0.0);
  CHECK(gear.swinging(dx, 3.0) == std::vector<int>{gear.load});
  // between taut bars a node has its place by them
  CHECK(gear.swinging(dx, 300.0).empty());
  // with all around it a node does not turn
  for (int n = 0; n < gear.model.nodes; ++n) at(dx.data(), n) = Vector(0.0, 0.2, 0.0);
  CHECK(gear.swinging(dx, 3.0).empty());
}

TEST_CASE("what is carried goes with all around it") {
  Hanging gear;
  std::vector<double> dx(gear.x.size());
  for (int n = 0; n < gear.model.nodes; ++n) at(dx.data(), n) = Vector(0.1, 0.2, 0.3);
  at(dx.data(), gear.load) = Vector(5.0, 0.0, 0.0);
  const int* ends = gear.model.bars.line(gear.taut).nodes;
  at(dx.data(), ends[0]) = at(dx.data(), ends[1]) = Vector(0.0, -9.0, 0.0);
  LocalBalance(gear.model).carry({gear.load, ends[0], ends[1]}, dx.data());
  CHECK((at(dx.data(), gear.load) - Vector(0.1, 0.2, 0.3)).norm() < 1e-12);
  // a row of two comes nearer by half a sweep
  CHECK((at(dx.data(), ends[0]) - Vector(0.1, 0.2, 0.3)).norm() < 9.3 * std::pow(0.5, 10));
}

TEST_CASE("nodes that carry more than bars are left to the steps of all") {
  Hanging gear;
  std::vector<double> dx(gear.x.size(), 0.0);
  at(dx.data(), gear.load) = Vector(0.0, 0.2, 0.0);
  gear.model.lifts.node.push_back(gear.load);
  CHECK(gear.swinging(dx, 3.0).empty());
}

}  // namespace
