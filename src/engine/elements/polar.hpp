// Lift and drag coefficients of a plate by its angle of attack, over the full circle. A cubic
// between the knots matches values and slopes, so that forces have continuous derivatives.
#pragma once

#include <vector>

namespace codend {

struct PolarPoint {
  double lift, drag, lift_slope, drag_slope;  // coefficients and their derivatives (1/rad)
};

class Polar {
 public:
  // angle ascends from -pi to pi (rad); values at both ends are equal.
  std::vector<double> angle, lift, drag, lift_slope, drag_slope;

  template <class Visit>
  void fields(Visit& visit) {
    visit("angle", angle);
    visit("lift", lift);
    visit("drag", drag);
    visit("lift_slope", lift_slope);
    visit("drag_slope", drag_slope);
  }

  // angle in [-pi, pi].
  PolarPoint at_angle(double angle) const;
};

}  // namespace codend
