// Drag of one family of twines, compared with the drag of the lines that it represents.
#include <doctest/doctest.h>

#include <cmath>

#include "elements/twine_drag.hpp"
#include "random_model.hpp"

TEST_CASE("twine drag equals the drag of a bar of the same twine") {
  using namespace codend;
  Random random(20260461);
  for (const CylinderLaw& law : cylinder_laws()) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      TwineMaterial material;
      material.diameter = 0.002;
      material.law = law;
      const Vector e = random.vector(1.0);
      const Vector u(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0);
      const Vector whole = 2.0 * line_drag(material, e, u);  // two ends of a bar of 1 m
      const Vector found = twine_drag(material, 2.0, 1.0, e, u, Water(), SlackDrag::curved).value;
      // the same operations in another order
      CHECK((found - whole).norm() < 1e-13 * whole.norm());
    }
  }
}

TEST_CASE("drag of curled twines is the mean over all directions") {
  using namespace codend;
  TwineMaterial material;
  material.diameter = 0.002;
  material.law = {CylinderLawKind::constant, 1.2, 0.1, 0.02, 0.0};
  const Vector u(0.0, 0.0, 1.3);
  auto drag = [&](const Vector& e, SlackDrag slack) {
    return twine_drag(material, 1.0, 1.0, e, u, Water(), slack).value.z();
  };
  // Directions evenly spaced in height (and any angle about the flow): midpoint rule. Its error at
  // the kink of |cos| is about the square of a step of 1/500.
  const int n = 1000;
  double mean = 0.0;
  for (int k = 0; k < n; ++k) {
    const double c = -1.0 + (2.0 * k + 1.0) / n;
    mean += drag({std::sqrt(1.0 - c * c), 0.0, c}, SlackDrag::straight) / n;
  }
  CHECK(drag(Vector::Zero(), SlackDrag::curved) == doctest::Approx(mean).epsilon(1e-5));
  CHECK(line_drag(material, Vector::Zero(), u).z() == doctest::Approx(mean).epsilon(1e-5));
  // half of the length spans the ends, which are across the flow
  const Vector half(0.5, 0.0, 0.0);
  CHECK(drag(half, SlackDrag::curved) ==
        doctest::Approx(0.5 * drag(2.0 * half, SlackDrag::straight) + 0.5 * mean).epsilon(1e-5));
}
