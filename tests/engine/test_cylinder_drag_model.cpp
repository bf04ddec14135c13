// Drag models where they deviate from the published coefficients, and their derivatives.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

CylinderCoefficients at_reynolds(CylinderLawKind kind, double re) {
  CylinderLaw law;
  law.kind = kind;
  law.solidity = 0.15;
  return cylinder_coefficients(law, re, re, 1.0, 1.0);  // m/s, m, m2/s
}

double normal_at(CylinderLawKind kind, double re) { return at_reynolds(kind, re).a / re; }

}  // namespace

TEST_CASE("drag models join, switch and limit the published branches") {
  const CylinderLawKind choo = CylinderLawKind::choo_casarella;
  // Branches of Choo and Casarella are joined within 10 % of their switch, half of each at the
  // switch.
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
  // Outside the joins the published branches apply.
  CHECK(normal_at(choo, 0.5) == doctest::Approx([] {
                                  const double t = -0.077215665 + std::log(16.0);
                                  return 8.0 * pi / (0.5 * t) * (1.0 - 0.87 / (t * t));
                                }())
                                    .epsilon(3e-4));  // Re >= 0.01: (0.01/0.5)^2 / 2 = 2e-4
  CHECK(normal_at(choo, 3e5) == doctest::Approx(-3.41e-6 * (3e5 - 5.78e5)).epsilon(1e-9));
  CHECK(normal_at(choo, 2e6) ==
        doctest::Approx(0.401 * (1.0 - std::exp(-2e6 / 5.99e5))).epsilon(1e-9));

  // Takagi's branches switch where they cross, near Re 117. At the printed 200 the force would jump
  // from C_n 1.02 to 1.2.
  CHECK(normal_at(CylinderLawKind::takagi, 116.0) ==
        doctest::Approx(std::pow(10.0, 0.7) * std::pow(116.0, -0.3)).epsilon(1e-6));
  CHECK(normal_at(CylinderLawKind::takagi, 118.0) == 1.2);
  CHECK(normal_at(CylinderLawKind::takagi, 199.0) == 1.2);

  // The parabola of Cifuentes and Kim applies as printed up to Re Sn^2 = 100, then it is constant.
  auto parabola = [](double y) { return -3.2891e-5 * y * y + 0.00068 * y + 1.4253; };
  const CylinderLawKind kim = CylinderLawKind::cifuentes_kim;
  CHECK(normal_at(kim, 2000.0) == doctest::Approx(parabola(45.0)).epsilon(1e-12));
  CHECK(normal_at(kim, 1e6) == doctest::Approx(parabola(100.0)).epsilon(1e-12));
}

TEST_CASE("drag coefficients are continuous and match their derivatives") {
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
    // A step of 0.1 % in Re changes a power of at most 3, or a join over 20 % of a jump of 40 %.
    CHECK(jump < 6e-3);
    for (double re = 1.3e-3; re < 1e7; re *= 1.37) {
      CAPTURE(re);
      // Second order at h = 1e-5 Re: h^2/6 f''' is 2e-11 times the cube of a sharp join's 1/0.1;
      // rounding is 2e-16 / 1e-5.
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
