#include "cylinder_drag_model.hpp"

#include <algorithm>
#include <cmath>

#include "../base/pi.hpp"

namespace codend {
namespace {

// A value and its derivative by q_n.
struct Slope {
  double value, slope;
};

Slope operator+(Slope x, Slope y) { return {x.value + y.value, x.slope + y.slope}; }
Slope operator*(double k, Slope x) { return {k * x.value, k * x.slope}; }
Slope operator*(Slope x, Slope y) {
  return {x.value * y.value, x.slope * y.value + x.value * y.slope};
}
Slope inverse(Slope x) { return {1.0 / x.value, -x.slope / (x.value * x.value)}; }
Slope power(Slope x, double k) {
  const double p = std::pow(x.value, k);
  return {p, k * p / x.value * x.slope};
}
Slope logarithm(Slope x) { return {std::log(x.value), x.slope / x.value}; }
Slope exponential(Slope x) {
  const double e = std::exp(x.value);
  return {e, e * x.slope};
}

// Reynolds number, smoothly bounded below at 0.01, because powers are not differentiable at zero.
Slope reynolds(double q, double d, double viscosity) {
  constexpr double floor = 0.01;
  const double re = q * d / viscosity;
  const double held = std::sqrt(re * re + floor * floor);
  return {held, re / held * d / viscosity};
}

// Blends two branches of a published drag model within +-10 % of their switch, where their values
// differ. A jump in force would prevent an equilibrium near the switch.
Slope join(Slope re, double at, Slope below, Slope above) {
  const double half = 0.1;
  const double s = (std::log(re.value / at) + half) / (2.0 * half);
  if (s <= 0.0) return below;
  if (s >= 1.0) return above;
  const Slope w{s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) / (2.0 * half) * re.slope / re.value};
  return (Slope{1.0, 0.0} + -1.0 * w) * below + w * above;
}

Slope takagi_normal(Slope re) {
  // The branches cross at Re = 117; the printed switch at Re = 200 would jump by 15 %.
  const Slope low = std::pow(10.0, 0.7) * power(re, -0.3);
  return low.value > 1.2 ? low : Slope{1.2, 0.0};
}

Slope choo_casarella_normal(Slope re) {
  const double x = re.value;
  auto creeping = [&] {
    const Slope s = Slope{-0.077215665, 0.0} + logarithm(8.0 * inverse(re));
    return 8.0 * pi * inverse(s * re) * (Slope{1.0, 0.0} + -0.87 * power(s, -2.0));
  };
  auto low = [&] { return Slope{1.45, 0.0} + 8.55 * power(re, -0.9); };
  auto middle = [&] { return Slope{1.1, 0.0} + 4.0 * power(re, -0.5); };
  auto drop = [&] { return -3.41e-6 * (re + Slope{-5.78e5, 0.0}); };
  auto high = [&] { return 0.401 * (Slope{1.0, 0.0} + -1.0 * exponential((-1.0 / 5.99e5) * re)); };
  if (x < 5.0) return join(re, 1.0, creeping(), low());
  if (x < 1e3) return join(re, 30.0, low(), middle());
  if (x < 3.4e5) return join(re, 2.33e5, middle(), drop());
  return join(re, 4.92e5, drop(), high());
}

}  // namespace

CylinderCoefficients cylinder_coefficients(const CylinderLaw& law, double q_n, double q_t, double d,
                                           double viscosity) {
  CylinderCoefficients k;
  k.c = law.skin;
  auto set_normal = [&](Slope c_n) {
    k.a = c_n.value * q_n;
    k.a_n = c_n.value + c_n.slope * q_n;
  };
  auto set_tangential = [&](double c_t) {
    k.b = c_t * q_t;
    k.b_t = c_t;
  };
  switch (law.kind) {
    case CylinderLawKind::constant:
      set_normal(Slope{law.normal, 0.0});
      set_tangential(law.tangential);
      break;
    case CylinderLawKind::takagi:
      set_normal(takagi_normal(reynolds(q_n, d, viscosity)));
      set_tangential(0.1);
      break;
    case CylinderLawKind::choo_casarella: {
      const Slope re = reynolds(q_n, d, viscosity);
      set_normal(choo_casarella_normal(re));
      // The source prints a force per length, pi mu U_t (0.55 Re^1/2 + 0.084 Re^2/3).
      const Slope b =
          (2.0 * pi * viscosity / d) * (0.55 * power(re, 0.5) + 0.084 * power(re, 2.0 / 3.0));
      k.b = b.value;
      k.b_n = b.slope;
      break;
    }
    case CylinderLawKind::cifuentes_kim: {
      // The parabola becomes negative at Re Sn^2 = 219; it is constant above 100.
      const double sn2 = law.solidity * law.solidity;
      Slope x{q_n * d / viscosity * sn2, d / viscosity * sn2};
      if (x.value > 100.0) x = Slope{100.0, 0.0};
      set_normal(Slope{1.4253, 0.0} + 0.00068 * x + -3.2891e-5 * (x * x));
      break;
    }
  }
  k.a *= law.normal_share;
  k.a_n *= law.normal_share;
  k.b *= law.tangential_share;
  k.b_n *= law.tangential_share;
  k.b_t *= law.tangential_share;
  k.c *= law.tangential_share;
  return k;
}

}  // namespace codend
