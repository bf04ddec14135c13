// Drag laws against published coefficients, and their own derivatives.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

constexpr double pi = 3.14159265358979323846;

// C_D and C_L of a taut line whose axis stands at `alpha` to the flow.
struct Coefficients {
  double drag, lift;
};

Coefficients at_angle(const CylinderLaw& law, double alpha) {
  TwineMaterial material;
  material.diameter = 0.01;
  material.law = law;
  const Water water;
  const double speed = 1.7;
  const Vector axis(std::cos(alpha), std::sin(alpha), 0.0);
  const Vector force = line_drag(material, axis, speed * Vector::UnitX()) /
                       (0.5 * water.density * material.diameter * speed * speed);
  CHECK(force.z() == 0.0);
  // Lift is on the side to which the flow pushes the line: here away from its upper end.
  return {force.x(), -force.y()};
}

CylinderCoefficients at_reynolds(CylinderLawKind kind, double re) {
  CylinderLaw law;
  law.kind = kind;
  law.solidity = 0.15;
  return cylinder_coefficients(law, re, re, 1.0, 1.0);  // m/s, m, m2/s
}

double normal_at(CylinderLawKind kind, double re) { return at_reynolds(kind, re).a / re; }

}  // namespace

TEST_CASE("drag and lift by angle, Hoerner 1965 and Bessonneau and Marichal 1998") {
  // C_D = 1.1 sin^3 + 0.02, C_L = 1.1 sin^2 cos (Hoerner, Fluid-Dynamic Drag, 3-11); C_n 1.2 and
  // C_t 0.1 (Bessonneau and Marichal, Ocean Eng. 25, 1998) projected on drag and lift; to five
  // decimals.
  const double table[][5] = {
      {0, 0.02, 0.0, 0.1, 0.0},
      {5, 0.02073, 0.00832, 0.09966, 0.00043},
      {10, 0.02576, 0.03267, 0.10179, 0.01879},
      {15, 0.03907, 0.07118, 0.11093, 0.0535},
      {20, 0.06401, 0.12092, 0.13099, 0.10171},
      {25, 0.10303, 0.17806, 0.16502, 0.15953},
      {30, 0.1575, 0.23816, 0.21495, 0.22231},
      {35, 0.22757, 0.29644, 0.28141, 0.2849},
      {40, 0.31214, 0.34816, 0.36365, 0.34209},
      {45, 0.40891, 0.38891, 0.45962, 0.38891},
      {50, 0.51449, 0.41492, 0.566, 0.42099},
      {55, 0.62463, 0.42336, 0.67846, 0.4349},
      {60, 0.73447, 0.4125, 0.79192, 0.42835},
      {65, 0.83888, 0.38185, 0.90087, 0.40038},
      {70, 0.93275, 0.33221, 0.99972, 0.35142},
      {75, 1.01134, 0.26563, 1.0832, 0.28331},
      {80, 1.07062, 0.18525, 1.14666, 0.19912},
      {85, 1.10749, 0.09514, 1.18642, 0.10304},
      {90, 1.12, 0.0, 1.2, 0.0},
  };
  constexpr double half_digit = 5.1e-6;
  const CylinderLaw hoerner{CylinderLawKind::constant, 1.1, 0.0, 0.02, 0.0};
  const CylinderLaw bessonneau{CylinderLawKind::constant, 1.2, 0.1, 0.0, 0.0};
  for (const auto& row : table) {
    CAPTURE(row[0]);
    const Coefficients h = at_angle(hoerner, row[0] * pi / 180.0);
    CHECK(std::abs(h.drag - row[1]) < half_digit);
    CHECK(std::abs(h.lift - row[2]) < half_digit);
    const Coefficients b = at_angle(bessonneau, row[0] * pi / 180.0);
    CHECK(std::abs(b.drag - row[3]) < half_digit);
    CHECK(std::abs(b.lift - row[4]) < half_digit);
  }
}

TEST_CASE("coefficients by Reynolds number, Choo and Casarella 1971 and Takagi 2004") {
  // C_n and C_t of Choo and Casarella (J. Hydronautics 5:126), the latter from their force per
  // length pi mu U (0.55 Re^1/2 + 0.084 Re^2/3) referred to 1/2 rho U^2 d; C_n of Takagi et al.
  // (Fish. Res. 66:235); to four decimals. At Re = 1 and 30 the two branches of C_n meet with a
  // jump, see below.
  const double table[][4] = {
      {1, NAN, 3.9835, 5.0119},    {3, 4.631, 2.3611, 3.6047},   {10, 2.5264, 1.3378, 2.5119},
      {30, NAN, 0.8008, 1.8066},   {60, 1.6164, 0.581, 1.4674},  {100, 1.5, 0.4593, 1.2589},
      {200, 1.3828, 0.3346, 1.2},  {300, 1.3309, 0.2784, 1.2},   {500, 1.2789, 0.221, 1.2},
      {1000, 1.2265, 0.1621, 1.2}, {2000, 1.1894, 0.1192, 1.2},  {5000, 1.1566, 0.0797, 1.2},
      {10000, 1.14, 0.0591, 1.2},  {30000, 1.1231, 0.0369, 1.2}, {100000, 1.1126, 0.0223, 1.2},
  };
  for (const auto& row : table) {
    const double re = row[0];
    CAPTURE(re);
    // Half a digit, and Re held above 0.01, which raises it by a share 0.01^2 / (2 Re^2).
    auto is_near = [&](double found, double printed) {
      CHECK(std::abs(found - printed) < 5.1e-5 + 5e-5 * printed / (re * re));
    };
    const CylinderCoefficients choo = at_reynolds(CylinderLawKind::choo_casarella, re);
    if (!std::isnan(row[1])) is_near(choo.a / re, row[1]);
    is_near(choo.b / re, row[2]);
    is_near(normal_at(CylinderLawKind::takagi, re), row[3]);
    CHECK(at_reynolds(CylinderLawKind::takagi, re).b / re == doctest::Approx(0.1));
  }
}

TEST_CASE("where the laws leave the printed ones on purpose") {
  const CylinderLawKind choo = CylinderLawKind::choo_casarella;
  // Branches of Choo and Casarella joined within 10 % of their switch, half of each on it.
  const double s = -0.077215665 + std::log(8.0);
  const double creeping = 8.0 * pi / s * (1.0 - 0.87 / (s * s));
  CHECK(normal_at(choo, 1.0) == doctest::Approx(0.5 * (creeping + 10.0)).epsilon(1e-4));
  const double low = 1.45 + 8.55 * std::pow(30.0, -0.9), middle = 1.1 + 4.0 / std::sqrt(30.0);
  CHECK(normal_at(choo, 30.0) == doctest::Approx(0.5 * (low + middle)).epsilon(1e-5));
  const double drop = -3.41e-6 * (2.33e5 - 5.78e5);
  CHECK(normal_at(choo, 2.33e5) ==
        doctest::Approx(0.5 * (1.1 + 4.0 / std::sqrt(2.33e5) + drop)).epsilon(1e-9));
  const double high = 0.401 * (1.0 - std::exp(-4.92e5 / 5.99e5));
  CHECK(normal_at(choo, 4.92e5) ==
        doctest::Approx(0.5 * (-3.41e-6 * (4.92e5 - 5.78e5) + high)).epsilon(1e-9));
  // Outside the joins the printed branches.
  CHECK(normal_at(choo, 0.5) == doctest::Approx([] {
                                  const double t = -0.077215665 + std::log(16.0);
                                  return 8.0 * pi / (0.5 * t) * (1.0 - 0.87 / (t * t));
                                }())
                                    .epsilon(3e-4));  // Re held above 0.01: (0.01/0.5)^2 / 2 = 2e-4
  CHECK(normal_at(choo, 3e5) == doctest::Approx(-3.41e-6 * (3e5 - 5.78e5)).epsilon(1e-9));
  CHECK(normal_at(choo, 2e6) ==
        doctest::Approx(0.401 * (1.0 - std::exp(-2e6 / 5.99e5))).epsilon(1e-9));

  // Takagi's branches are switched where they cross, near Re 117, not at the printed 200, where
  // the force would jump from C_n 1.02 to 1.2.
  CHECK(normal_at(CylinderLawKind::takagi, 116.0) ==
        doctest::Approx(std::pow(10.0, 0.7) * std::pow(116.0, -0.3)).epsilon(1e-6));
  CHECK(normal_at(CylinderLawKind::takagi, 118.0) == 1.2);
  CHECK(normal_at(CylinderLawKind::takagi, 199.0) == 1.2);

  // The parabola of Cifuentes and Kim as printed up to Re Sn^2 = 100, then constant.
  auto parabola = [](double y) { return -3.2891e-5 * y * y + 0.00068 * y + 1.4253; };
  const CylinderLawKind kim = CylinderLawKind::cifuentes_kim;
  CHECK(normal_at(kim, 2000.0) == doctest::Approx(parabola(45.0)).epsilon(1e-12));
  CHECK(normal_at(kim, 1e6) == doctest::Approx(parabola(100.0)).epsilon(1e-12));
}

TEST_CASE("coefficients have no jumps and the slopes that they say") {
  for (const CylinderLawKind kind :
       {CylinderLawKind::constant, CylinderLawKind::takagi, CylinderLawKind::choo_casarella,
        CylinderLawKind::cifuentes_kim}) {
    CAPTURE(static_cast<int>(kind));
    CylinderLaw law;
    law.kind = kind;
    law.tangential = 0.1;
    law.solidity = 0.15;
    auto coefficients = [&](double n, double t) {
      return cylinder_coefficients(law, n, t, 1.0, 1.0);
    };
    double before = coefficients(1e-3, 1.0).a, jump = 0.0;
    for (double re = 1e-3; re < 1e7; re *= 1.001) {
      const double a = coefficients(re, 1.0).a;
      jump = std::max(jump, std::abs(a - before) / std::abs(a));
      before = a;
    }
    // A step of 0.1 % in Re changes a power of 3 at most, or a join over 20 % of a jump of 40 %.
    CHECK(jump < 6e-3);
    for (double re = 1.3e-3; re < 1e7; re *= 1.37) {
      CAPTURE(re);
      // Second order at h = 1e-5 Re: h^2/6 f''' is 2e-11 times the cube of a sharp join's 1/0.1,
      // and rounding 2e-16 / 1e-5.
      const double h = 1e-5 * re;
      const CylinderCoefficients k = coefficients(re, 2.0 * re);
      const CylinderCoefficients n1 = coefficients(re + h, 2.0 * re);
      const CylinderCoefficients n0 = coefficients(re - h, 2.0 * re);
      const CylinderCoefficients t1 = coefficients(re, 2.0 * re + h);
      const CylinderCoefficients t0 = coefficients(re, 2.0 * re - h);
      const double a = k.a / re, b = k.b / re;
      CHECK(std::abs((n1.a - n0.a) / (2.0 * h) - k.a_n) < 1e-7 * a);
      CHECK(std::abs((n1.b - n0.b) / (2.0 * h) - k.b_n) <= 1e-7 * b);
      CHECK(std::abs((t1.b - t0.b) / (2.0 * h) - k.b_t) <= 1e-7 * b);
      CHECK(t1.a == t0.a);
    }
  }
}

TEST_CASE("a line without length takes the mean drag over all directions") {
  TwineMaterial material;
  material.diameter = 0.01;
  material.law = {CylinderLawKind::constant, 1.2, 0.1, 0.02, 0.0};
  const Vector u(0.0, 0.0, 1.3);
  auto drag = [&](const Vector& e) { return line_drag(material, e, u); };
  // Directions evenly spread in height (and any angle about the flow): midpoint rule, whose error
  // at the kink of |cos| is about the square of a step of 1/500.
  const int n = 1000;
  double mean = 0.0;
  for (int k = 0; k < n; ++k) {
    const double c = -1.0 + (2.0 * k + 1.0) / n;
    mean += drag({std::sqrt(1.0 - c * c), 0.0, c}).z() / n;
  }
  CHECK(drag(Vector::Zero()).z() == doctest::Approx(mean).epsilon(1e-5));
}

TEST_CASE("drag of knots by Reynolds number, White's fit for spheres") {
  // C_D = 24/Re + 6/(1 + sqrt Re) + 0.4 (F. White, Viscous Fluid Flow), to four decimals.
  const double table[][2] = {
      {1, 27.4},      {3, 10.5962},   {10, 4.2415},    {30, 2.1263},    {60, 1.486},
      {100, 1.1855},  {200, 0.9162},  {300, 0.8075},   {500, 0.7048},   {1000, 0.6079},
      {2000, 0.5432}, {5000, 0.4885}, {10000, 0.4618}, {30000, 0.4352}, {100000, 0.4192},
  };
  Spheres knots;
  knots.node = {0};
  knots.drag_area = {0.5};
  knots.diameter = {0.01};
  knots.smooth = {0};
  knots.added_mass = {0.0};
  knots.height = {0.01};
  Water water;
  const double x[3] = {0.0, 0.0, 0.0}, v[3] = {0.0, 0.0, 0.0};
  for (const auto& row : table) {
    const double speed = row[0] * water.viscosity / 0.01;
    water.current = {Vector(0.0, speed, 0.0)};
    const Vector force = knots.element_force(0, {x, v, &water});
    CHECK(std::abs(force.y() / (0.5 * water.density * 0.5 * speed * speed) - row[1]) < 5.1e-5);
  }
}
