#include "netting_screen_drag.hpp"

#include <algorithm>
#include <cmath>

#include "../base/pi.hpp"

namespace codend {
namespace {

using Number = ScreenCoefficient;

Number constant(double value) { return {value, 0.0, 0.0, 0.0}; }
Number combine(double value, double of_x, Number x, double of_y, Number y) {
  return {value, of_x * x.by_cosine + of_y * y.by_cosine,
          of_x * x.by_solidity + of_y * y.by_solidity, of_x * x.by_reynolds + of_y * y.by_reynolds};
}
Number operator+(Number x, Number y) { return combine(x.value + y.value, 1.0, x, 1.0, y); }
Number operator-(Number x, Number y) { return combine(x.value - y.value, 1.0, x, -1.0, y); }
Number operator*(Number x, Number y) { return combine(x.value * y.value, y.value, x, x.value, y); }
Number operator*(double k, Number x) { return constant(k) * x; }
Number operator/(Number x, Number y) {
  const double q = x.value / y.value;
  return combine(q, 1.0 / y.value, x, -q / y.value, y);
}
Number log10(Number x) {
  return combine(std::log10(x.value), 1.0 / (x.value * std::log(10.0)), x, 0.0, x);
}
// Clamps x between two bounds.
Number held(Number x, double low, double high) {
  return x.value < low ? constant(low) : x.value > high ? constant(high) : x;
}

// Drag coefficient of a circular cylinder as a polynomial in log10 Re (Kristiansen & Faltinsen).
Number cylinder_drag(Number log_re) {
  const double c[] = {-78.46675, 254.73873, -327.8864, 223.64577,
                      -87.92234, 20.00769,  -2.44894,  0.12479};
  Number sum = constant(c[7]);
  for (int k = 6; k >= 0; --k) sum = sum * log_re + constant(c[k]);
  return sum;
}

}  // namespace

ScreenCoefficients screen_coefficients(NettingScreenLaw law, double cosine, double solidity,
                                       double reynolds) {
  const Number c{cosine, 1.0, 0.0, 0.0};
  const Number given{solidity, 0.0, 1.0, 0.0};
  const LawRange range = range_of(law);
  const Number s = held(given, range.least_solidity, range.most_solidity);
  const Number one = constant(1.0);
  // sin 2th / sin th = 2 cos th, and sin 4th / sin th = 4 cos th cos 2th.
  const Number sine2 = 2.0 * c, sine4 = 4.0 * c * (2.0 * c * c - one);
  ScreenCoefficients out;
  switch (law) {
    case NettingScreenLaw::loland:
      out.drag = constant(0.04) +
                 (constant(-0.04) + s * (constant(0.33) + s * (constant(6.54) - 4.88 * s))) * c;
      out.lift_per_sine = s * (constant(-0.05) + s * (constant(2.3) - 1.76 * s)) * sine2;
      break;
    case NettingScreenLaw::aarsnes:
      out.drag =
          constant(0.04) + (constant(-0.04) + s * (one + s * (constant(-1.24) + 13.7 * s))) * c;
      out.lift_per_sine = s * (constant(0.57) + s * (constant(-3.54) + 10.1 * s)) * sine2;
      break;
    case NettingScreenLaw::kristiansen_faltinsen: {
      const Number re = held(Number{reynolds, 0.0, 0.0, 1.0} / (one - s), range.least_reynolds,
                             range.most_reynolds);
      const Number normal45 = 0.5 * cylinder_drag(log10(re)) * s / ((one - s) * (one - s));
      const Number drag0 = normal45 * (constant(2.0) - s);
      const Number tangential45 = pi * normal45 / (constant(8.0) + normal45);
      const Number lift45 = std::sqrt(0.5) * (0.5 * drag0 - tangential45);
      // cos 3th = 4 cos^3 th - 3 cos th
      out.drag = drag0 * (0.6 * c + 0.4 * c * c * c);
      out.lift_per_sine = lift45 * (sine2 + 0.1 * sine4);
      break;
    }
  }
  if (solidity < range.least_solidity) {
    out.drag = (1.0 / range.least_solidity) * given * out.drag;
    out.lift_per_sine = (1.0 / range.least_solidity) * given * out.lift_per_sine;
  }
  return out;
}

}  // namespace codend
