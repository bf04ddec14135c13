// Drag of twines in blended netting, compared with the lines that it represents, and of slack
// twines.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

TEST_CASE("blended drag across the netting equals the drag of bars of the same twine") {
  using namespace codend;
  Random random(20260461);
  for (const CylinderLaw& law : cylinder_laws()) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      TwineMaterial material;
      material.diameter = 0.002;
      material.law = law;
      // One bar of 1 m of each family. The flow is within 60 degrees of the normal.
      const Vector e[2] = {random.vector(1.0), random.vector(1.0)};
      const Vector normal = e[0].cross(e[1]).normalized();
      const Vector u = normal + 0.5 * random.vector(1.0);
      Model model;
      model.nodes = 4;
      model.held.assign(4, 1);
      model.load.assign(12, 0.0);
      model.mass.assign(4, 0.0);
      model.water.current = {u};
      model.blended.node = {0, 1, 2, 3};
      model.blended.twine = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
      model.blended.rest = model.blended.multiplicity = model.blended.height = {1.0};
      model.blended.overlap = {0.25};
      model.blended.material = {0};
      model.blended.materials = {material};
      model.prepare();
      Assembly assembly(model);
      std::vector<double> x(12, 0.0);
      const std::vector<double> v(12, 0.0);
      at(x.data(), 1) = e[0];
      at(x.data(), 2) = e[0] + e[1];
      at(x.data(), 3) = e[1];
      const Evaluation found = evaluate(assembly, x.data(), v.data());
      const Vector force = at(found.reported("blended_force").data(), 0);
      const Vector bars = line_drag(material, e[0], u) + line_drag(material, e[1], u);
      // the same operations in another order
      CHECK((force - bars).norm() < 1e-13 * bars.norm());
    }
  }
}

TEST_CASE("drag of curled twines is the mean over all directions") {
  using namespace codend;
  TwineMaterial material;
  material.diameter = 0.002;
  material.law = {CylinderLawKind::constant, 1.2, 0.1, 0.02, 0.0};
  const Vector u(0.0, 0.0, 1.3);
  auto drag = [&](const Vector& e) { return line_drag(material, e, u).z(); };
  // Directions evenly spaced in height (and any angle about the flow): midpoint rule. Its error at
  // the kink of |cos| is about the square of a step of 1/500.
  const int n = 1000;
  double mean = 0.0;
  for (int k = 0; k < n; ++k) {
    const double c = -1.0 + (2.0 * k + 1.0) / n;
    mean += drag({std::sqrt(1.0 - c * c), 0.0, c}) / n;
  }
  CHECK(drag(Vector::Zero()) == doctest::Approx(mean).epsilon(1e-5));
  // half of the length spans the ends, which are across the flow
  const Vector half(0.5, 0.0, 0.0);
  CHECK(drag(half) == doctest::Approx(0.5 * drag(2.0 * half) + 0.5 * mean).epsilon(1e-5));
}
