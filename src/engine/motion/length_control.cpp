#include "length_control.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Time constant of corrections towards the target length, s.
constexpr double catch_up = 5.0;
// The brake reaches full speed if the tension exceeds its limit by this fraction.
constexpr double full_share = 0.1;
// Interval between choices of the speed (s), near or above the tension limit, and otherwise.
constexpr double slipping_step = 0.05, idle_step = 0.5;
// Largest growth of a step before the next choice of the speed.
constexpr double next_growth = 2.0;

}  // namespace

void LengthControl::choose_speed(double time, double tension) {
  const double h = time - since;
  length += h * speed;
  since = time;
  double next = target_speed;
  if (!by_speed) {
    double wanted, rate;
    target.at(time, Side::after, wanted, rate);
    next = rate + (wanted - length) / catch_up;
  }
  next = std::clamp(next, -speed_limit, speed_limit);
  if (std::isfinite(tension_limit)) {
    const double slope = full_share * tension_limit / speed_limit;
    const double over = tension - tension_limit - slope * speed;
    const double slipping = speed + over / (next_growth * h * stiffness / length + slope);
    next = std::clamp(slipping, next, speed_limit);
    near_limit = tension > (1.0 - full_share) * tension_limit;
  }
  if (length <= least_length) next = std::max(next, 0.0);
  if (length >= most_length) next = std::min(next, 0.0);
  speed = next;
}

double LengthControl::longest_step() const { return near_limit ? slipping_step : idle_step; }

}  // namespace codend
