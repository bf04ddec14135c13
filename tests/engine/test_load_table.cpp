// Lines with a load table by strain: compared with EA and integrals of the table.
#include <doctest/doctest.h>

#include <cmath>

#include "model/assembly.hpp"
#include "solve/settle.hpp"

using namespace codend;

TEST_CASE("load table is continuous and its energy and inverse agree with it") {
  TwineMaterial m;
  m.strains = {0.01, 0.03, 0.05};
  m.loads = {1e3, 6e3, 2e4};
  m.axial_stiffness = 1e5;
  double energy = 0.0;
  const double h = 1e-5;
  for (double s = 0.5 * h; s < 0.08; s += h) {
    const TwinePull pull = twine_pull(m, s);
    energy += h * pull.tension;  // midpoints: exact except at kinks, h^2 there
    CHECK(twine_pull(m, s + 0.5 * h).energy == doctest::Approx(energy).epsilon(1e-5));
    double strain, slope;
    twine_stretch(m, pull.tension, strain, slope);
    CHECK(strain == doctest::Approx(s).epsilon(1e-12));
    CHECK(slope == doctest::Approx(1.0 / pull.modulus).epsilon(1e-12));
  }
  for (const double s : m.strains) {
    CHECK(twine_pull(m, s - 1e-12).tension == doctest::Approx(twine_pull(m, s + 1e-12).tension));
  }
}
