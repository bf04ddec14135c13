// Highest oscillation and decay rates of a gear, which limit explicit steps.
#pragma once

#include "motion.hpp"

namespace codend {

class Assembly;

struct FastestRates {
  double oscillation = 0.0;  // 1/s, of line stretch, with all lines taut
  double decay = 0.0;        // 1/s, of velocities, from drag and damping
};

// Returns upper bounds: the largest row sums of the blocks of M^-1 K and M^-1 D (Gershgorin). They
// are exact for a uniform chain, and up to about 1.5 times too high for netting.
FastestRates fastest_rates(Assembly& assembly, const Motion& motion);

}  // namespace codend
