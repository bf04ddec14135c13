// Tensions are the gradient of an energy and conserve momentum.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

// Elements of one kind.
Ingredients in_vacuum(int Ingredients::*kind, int count) {
  Ingredients wanted;
  wanted.*kind = count;
  wanted.axial_stiffness = 1e4;
  // Twists depend on the density of the water, but have no drag.
  if (kind != &Ingredients::twists) wanted.density = 0.0;
  return wanted;
}

double strain_energy(Assembly& assembly, const Specimen& s) {
  std::vector<double> strain;
  assembly.move_to(s.x.data(), s.v.data());
  assembly.strain(strain);
  double total = 0.0;
  assembly.model().each_line([&](const auto& line) {
    const double length = line.rest * (1.0 + strain[static_cast<std::size_t>(line.index)]);
    total += line.multiplicity * twine_energy(assembly.model().material(line), length, line.rest);
  });
  const Field field = assembly.field();
  for (int e = 0; e < assembly.model().openings.count(); ++e) {
    total += assembly.model().openings.element_energy(e, field);
  }
  for (int e = 0; e < assembly.model().twists.count(); ++e) {
    total += assembly.model().twists.element_energy(e, field);
  }
  for (int e = 0; e < assembly.model().bends.count(); ++e) {
    total += assembly.model().bends.element_energy(e, field);
  }
  for (const SlidingRope& rope : assembly.model().sliding) total += rope.energy(field);
  return total;
}

void check(int Ingredients::*kind, int count) {
  Random random(20260411);
  for (int repeat = 0; repeat < 10; ++repeat) {
    Specimen s(random, in_vacuum(kind, count));
    Assembly assembly(s.model);
    std::vector<double> force(s.x.size());
    assembly.move_to(s.x.data(), s.v.data());
    assembly.residual(force.data());
    Vector sum = Vector::Zero(), moment = Vector::Zero();
    double size = 0.0, arm = 0.0;
    for (int n = 0; n < s.model.nodes; ++n) {
      sum += at(force.data(), n);
      moment += at(s.x.data(), n).cross(at(force.data(), n));
      size += at(force.data(), n).norm();
      arm += at(force.data(), n).norm() * at(s.x.data(), n).norm();
    }
    REQUIRE(size > 0.0);
    // About 30 additions at each of a dozen nodes, 1.1e-16 each; tensions that cancel at a node are
    // up to ten times their sum.
    CHECK(sum.norm() < 1e-13 * size);
    CHECK(moment.norm() < 1e-13 * arm);
    const double largest = Eigen::Map<Eigen::VectorXd>(force.data(), static_cast<int>(force.size()))
                               .cwiseAbs()
                               .maxCoeff();
    // Fourth order at h = 1e-3 m. Rounding: 1.5 x 2.2e-16 E / h with E about |F| x 1 m gives 3e-13,
    // ten times that where lines cancel. Truncation: h^4/30 = 3e-14 over a length of 1 m, and
    // (1/0.1)^4 times that for the shortest lines. Angles of nearly closed meshes change over 0.02
    // m, so their step is a fifth.
    const double h = kind == &Ingredients::openings ? 2e-4 : 1e-3;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      const double before = s.x[k];
      auto energy = [&](double step) {
        s.x[k] = before + step;
        return strain_energy(assembly, s);
      };
      const double slope =
          (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h);
      s.x[k] = before;
      CHECK(std::abs(force[k] + slope) < 1e-9 * largest);
    }
  }
}

}  // namespace

TEST_CASE("forces are the gradient of an energy without sum and moment") {
  SUBCASE("bars") { check(&Ingredients::bars, 20); }
  SUBCASE("netting cells") { check(&Ingredients::cells, 20); }
  SUBCASE("hexagonal triangles") { check(&Ingredients::hexagons, 12); }
  SUBCASE("mesh openings") { check(&Ingredients::openings, 12); }
  SUBCASE("twists of netting") { check(&Ingredients::twists, 12); }
  SUBCASE("bends") { check(&Ingredients::bends, 12); }
  SUBCASE("sliding ropes") { check(&Ingredients::sliding, 6); }
}

TEST_CASE("slack line has no tension and stores no energy") {
  TwineMaterial material;
  material.axial_stiffness = 1e6;
  CHECK(twine_tension(material, 0.99, 1.0) == 0.0);
  CHECK(twine_energy(material, 0.99, 1.0) == 0.0);
  CHECK(twine_tension(material, 1.01, 1.0) == doctest::Approx(1e4).epsilon(1e-12));
}
