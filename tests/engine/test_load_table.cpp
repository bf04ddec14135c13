// Lines whose loads are given by strain, against EA and their own integrals.
#include <doctest/doctest.h>

#include <cmath>

#include "model/assembly.hpp"
#include "solve/settle.hpp"

using namespace codend;

TEST_CASE("a table of loads is continuous, and its energy and inverse are its own") {
  TwineMaterial m;
  m.strains = {0.01, 0.03, 0.05};
  m.loads = {1e3, 6e3, 2e4};
  m.axial_stiffness = 1e5;
  double energy = 0.0;
  const double h = 1e-5;
  for (double s = 0.5 * h; s < 0.08; s += h) {
    const TwinePull pull = twine_pull(m, s);
    energy += h * pull.tension;  // midpoints: right but at kinks, h^2 there
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

TEST_CASE("a line of a table settles where the table says") {
  // Loads of every row, between them and beyond, on one line.
  for (const double load : {300.0, 1000.0, 4000.0, 6000.0, 9000.0, 30000.0}) {
    CAPTURE(load);
    Model model;
    model.nodes = 2;
    model.held = {1, 0};
    model.water.density = 0.0;
    model.mass = {0.0, 1.0};
    model.load = {0.0, 0.0, 0.0, 0.0, 0.0, -load};
    TwineMaterial material;
    material.axial_stiffness = 1.0;
    model.materials = {material};
    model.load_table = {{0, 0, 0}, {0.01, 0.03, 0.05}, {1e3, 6e3, 2e4}};
    model.bars.node = {0, 1};
    model.bars.rest = {2.0};
    model.bars.multiplicity = {1.0};
    model.bars.material = {0};
    model.prepare();
    Assembly assembly(model);
    std::vector<double> x = {0.0, 0.0, 0.0, 0.3, 0.2, -1.5};
    const std::vector<double> v(6, 0.0);
    SettleControl control;
    const SettleReport report = settle(assembly, control, v.data(), x.data());
    CHECK(report.converged);
    double strain, slope;
    twine_stretch(model.materials[0], load, strain, slope);
    CHECK(x[5] == doctest::Approx(-2.0 * (1.0 + strain)).epsilon(1e-6));
  }
}
