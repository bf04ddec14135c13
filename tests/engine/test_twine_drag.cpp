// Drag of one family of twines against that of the lines that it stands for.
#include <doctest/doctest.h>

#include "elements/twine_drag.hpp"
#include "random_model.hpp"

TEST_CASE("drag of twines is that of a bar of the same twine") {
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
