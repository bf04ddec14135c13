#include <doctest/doctest.h>

#include "solve/layout.hpp"

namespace {

// Returns the height (m) of a float in the middle of a slack line between two points at the
// surface.
double float_height(double lift, double weight, bool surface) {
  codend::StringNet net;
  net.held = {1, 0, 0, 0, 1};
  net.ends = {0, 1, 1, 2, 2, 3, 3, 4};
  net.rest.assign(4, 1.5);
  net.tension.assign(4, 10.0);
  net.load.assign(15, 0.0);
  net.load[5] = net.load[11] = -weight;
  net.load[8] = lift;
  if (surface) net.buoyant = {0, 0, 1, 0, 0};
  std::vector<double> x(15, 0.0);
  x[12] = 4.0;
  codend::lay_out(net, x.data());
  CHECK(x[6] == doctest::Approx(2.0));
  return x[8];
}

}  // namespace

TEST_CASE("water surface stops a float that lifts its line") {
  CHECK(float_height(10.0, 1.0, false) > 0.1);
  CHECK(float_height(10.0, 1.0, true) == doctest::Approx(0.0).epsilon(1e-4));
}

TEST_CASE("float stays below the surface if its load exceeds its buoyancy") {
  const double free = float_height(0.1, 1.0, false);
  CHECK(free < -0.1);
  CHECK(float_height(0.1, 1.0, true) == doctest::Approx(free));
}
