#include "polar.hpp"

#include <algorithm>

namespace codend {
namespace {

// Computes value and derivative of the cubic between two knots at distance `width`, at fraction t.
void hermite(double t, double width, double y0, double y1, double s0, double s1, double& value,
             double& slope) {
  const double t2 = t * t, t3 = t2 * t;
  value = (2.0 * t3 - 3.0 * t2 + 1.0) * y0 + (3.0 * t2 - 2.0 * t3) * y1 +
          width * ((t3 - 2.0 * t2 + t) * s0 + (t3 - t2) * s1);
  slope = 6.0 * (t - t2) * (y1 - y0) / width + (3.0 * t2 - 4.0 * t + 1.0) * s0 +
          (3.0 * t2 - 2.0 * t) * s1;
}

}  // namespace

PolarPoint Polar::at_angle(double a) const {
  const auto above = std::upper_bound(angle.begin() + 1, angle.end() - 1, a);
  const std::size_t k = static_cast<std::size_t>(above - angle.begin()) - 1;
  const double width = angle[k + 1] - angle[k];
  const double t = std::clamp((a - angle[k]) / width, 0.0, 1.0);
  PolarPoint found;
  hermite(t, width, lift[k], lift[k + 1], lift_slope[k], lift_slope[k + 1], found.lift,
          found.lift_slope);
  hermite(t, width, drag[k], drag[k + 1], drag_slope[k], drag_slope[k + 1], found.drag,
          found.drag_slope);
  return found;
}

}  // namespace codend
