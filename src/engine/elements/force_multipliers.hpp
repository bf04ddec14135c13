// Multipliers of components of force, 1 each where nothing else is known: what of a law's coefficients
// is uncertain as a whole. Those that are a plain factor of an array (drag areas, polars, friction)
// need none here.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "netting_screen_law.hpp"

namespace codend {

struct ForceMultipliers {
  // Of the force across lines, one per material of the model or none.
  std::vector<double> normal;
  double blended_normal = 1.0;  // the same of the twines of blended netting
  // Of netting as a screen, blended netting's share of it too.
  double screen_drag = 1.0, screen_lift = 1.0;
  // Its drag coefficient along the flow besides, on the area of twine: what is added, no factor.
  double screen_friction = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("normal", normal, {1, Among::numbers, Per::element});
    visit("blended_normal", blended_normal);
    visit("screen_drag", screen_drag);
    visit("screen_lift", screen_lift);
    visit("screen_friction", screen_friction);
  }
  bool present() const { return !normal.empty(); }
};

}  // namespace codend
