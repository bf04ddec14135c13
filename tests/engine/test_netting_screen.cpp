// Friction of netting screens.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

// A square cell with sides of 1 m whose normal is at `angle` to a flow of `speed` along x, of
// netting of this solidity. Returns drag and lift over 1/2 rho A U^2.
void coefficients(int law, double solidity, double angle, double reynolds, double& drag,
                  double& lift, double friction = 0.0) {
  const double x[] = {
      0.0, 0.0, 0.0, -std::sin(angle), std::cos(angle), 0.0, -std::sin(angle), std::cos(angle), 1.0,
      0.0, 0.0, 1.0};
  const double v[12] = {};
  Water water;
  // Reynolds number of the gaps between the twines, U d / (nu (1 - Sn)).
  const double diameter = 0.002;
  const double speed = reynolds * (1.0 - solidity) * water.viscosity / diameter;
  water.current = {Vector(speed, 0.0, 0.0)};
  NettingScreens screens;
  screens.node = {0, 1, 2, 3};
  screens.twine = {0.0, 0.0, 9.0, 0.0, 9.0, 9.0, 0.0, 9.0};
  screens.twine_area = {solidity};
  screens.overlap = {0.0};
  screens.diameter = screens.height = {diameter};
  screens.multiplicity = {1.0};
  screens.law = {static_cast<NettingScreenLaw>(law)};
  screens.multipliers.friction = friction;
  screens.prepare();
  const Field field{x, v, &water};
  const Vector force = screens.element_force(0, field);
  const double unit = 0.5 * water.density * speed * speed;
  drag = force.x() / unit;
  lift = std::hypot(force.y(), force.z()) / unit;
}

}  // namespace

TEST_CASE("screen friction adds its coefficient to drag at any angle") {
  for (int law = 0; law < 3; ++law) {
    for (const double angle : {0.0, 1.2, 0.5 * pi}) {
      double drag, lift, rubbed_drag, rubbed_lift;
      coefficients(law, 0.2, angle, 1000.0, drag, lift);
      coefficients(law, 0.2, angle, 1000.0, rubbed_drag, rubbed_lift, 0.3);
      CHECK(rubbed_drag == doctest::Approx(drag + 0.3 * 0.2).epsilon(1e-12));
      CHECK(rubbed_lift == doctest::Approx(lift).epsilon(1e-12));
    }
  }
}
