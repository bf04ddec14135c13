// Multipliers of force components, 1 by default. They represent the uncertainty of the coefficients
// of a drag model. Coefficients that scale a whole array (drag areas, polars, friction) need no
// multiplier.
#pragma once

#include <vector>

#include "../base/fields.hpp"

namespace codend {

struct ForceMultipliers {
  // Force normal to lines: one multiplier per material of the model, or empty.
  std::vector<double> normal;
  double blended_normal = 1.0;  // force normal to the twines of blended netting
  // Screen drag models, including the screen force of blended netting.
  double screen_drag = 1.0, screen_lift = 1.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("normal", normal, {1, Among::numbers, Per::element});
    visit("blended_normal", blended_normal);
    visit("screen_drag", screen_drag);
    visit("screen_lift", screen_lift);
  }
  bool present() const { return !normal.empty(); }
};

}  // namespace codend
