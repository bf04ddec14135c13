// Netting as a screen against published coefficients.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

constexpr double pi = 3.14159265358979323846;

// A square cell with sides of 1 m whose normal stands at `angle` to a flow of `speed`
// along x, of netting of this solidity; its drag and lift over 1/2 rho A U^2.
void coefficients(int law, double solidity, double angle, double reynolds, double& drag,
                  double& lift, double friction = 0.0) {
  const double x[] = {
      0.0, 0.0, 0.0, -std::sin(angle), std::cos(angle), 0.0, -std::sin(angle), std::cos(angle), 1.0,
      0.0, 0.0, 1.0};
  const double v[12] = {};
  Water water;
  // Reynolds number by the gaps between the twines, U d / (nu (1 - Sn)).
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

TEST_CASE("screens have the coefficients of their published formulas") {
  // Sn, theta (deg), then C_D and C_L of Aarsnes, of Loland, and of Kristiansen and Faltinsen at
  // Re = 1000: evaluated from the formulas apart from this program, to five decimals.
  const double table[][8] = {
      {0.10, 0, 0.1013, 0, 0.09352, 0, 0.1179, 0},
      {0.10, 30, 0.09309, 0.02745, 0.08635, 0.01406, 0.09189, 0.02342},
      {0.10, 75, 0.05587, 0.01585, 0.05385, 0.00812, 0.01913, 0.01016},
      {0.20, 15, 0.2525, 0.0266, 0.28009, 0.03396, 0.26577, 0.03354},
      {0.20, 45, 0.19556, 0.0532, 0.21576, 0.06792, 0.15993, 0.05718},
      {0.20, 90, 0.04, 0, 0.04, 0, 0, 0},
      {0.25, 60, 0.21328, 0.06847, 0.2275, 0.08985, 0.13682, 0.06069},
      {0.30, 0, 0.5583, 0, 0.55584, 0, 0.52313, 0},
      {0.30, 45, 0.40649, 0.1251, 0.40475, 0.14448, 0.29593, 0.10267},
      {0.35, 15, 0.76009, 0.09944, 0.68468, 0.09439, 0.64582, 0.07802},
      {0.35, 75, 0.23295, 0.09944, 0.21274, 0.09439, 0.11145, 0.05498},
      {0.35, 90, 0.04, 0, 0.04, 0, 0, 0},
  };
  const int laws[] = {1, 0, 2};
  for (const auto& row : table) {
    CAPTURE(row[0]);
    CAPTURE(row[1]);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      double drag, lift;
      coefficients(laws[k], row[0], row[1] * pi / 180.0, 1000.0, drag, lift);
      CHECK(std::abs(drag - row[2 + 2 * k]) < 5.1e-6);
      CHECK(std::abs(lift - row[3 + 2 * k]) < 5.1e-6);
    }
  }
}

TEST_CASE("friction adds its coefficient on the twine along the flow, at any angle") {
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

TEST_CASE("screens hold their arguments at the ends of the formulas' ranges") {
  double drag, lift, end_drag, end_lift;
  for (int law = 0; law < 3; ++law) {
    const ScreenCoefficients at_end =
        screen_coefficients(static_cast<NettingScreenLaw>(law), 0.5, 0.35, 500.0);
    const ScreenCoefficients beyond =
        screen_coefficients(static_cast<NettingScreenLaw>(law), 0.5, 3.0, 500.0);
    CHECK(beyond.drag.value == at_end.drag.value);
    CHECK(beyond.drag.by_solidity == 0.0);
    // Netting without twine has no drag.
    const ScreenCoefficients bare =
        screen_coefficients(static_cast<NettingScreenLaw>(law), 0.5, 0.0, 500.0);
    CHECK(bare.drag.value == 0.0);
    CHECK(bare.lift_per_sine.value == 0.0);
  }
  for (const double re : {1e-3, 10.0}) {
    coefficients(2, 0.2, 0.7, re, drag, lift);
    coefficients(2, 0.2, 0.7, 32.0 - 1e-9, end_drag, end_lift);
    CHECK(drag == doctest::Approx(end_drag).epsilon(1e-9));
    CHECK(lift == doctest::Approx(end_lift).epsilon(1e-9));
  }
  coefficients(2, 0.2, 0.7, 1e6, drag, lift);
  coefficients(2, 0.2, 0.7, 1e4 + 1e-9, end_drag, end_lift);
  CHECK(drag == doctest::Approx(end_drag).epsilon(1e-9));
}
