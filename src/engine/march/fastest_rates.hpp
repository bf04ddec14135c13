// How fast a gear can swing and settle at most: what limits explicit steps.
#pragma once

#include "motion.hpp"

namespace codend {

class Assembly;

struct FastestRates {
  double oscillation = 0.0;  // 1/s: of the stretch of lines, all taken as taut
  double decay = 0.0;        // 1/s: of velocities, by drag and damping
};

// Upper bounds, by the sums of M^-1 K and M^-1 D over the rows of their blocks (Gershgorin): exact
// for a uniform chain, too high by up to some 1.5 for netting.
FastestRates fastest_rates(Assembly& assembly, const Motion& motion);

}  // namespace codend
