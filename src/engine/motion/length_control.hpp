// Control of a rope's length at one end. The length follows a target up to a speed limit. The rope
// pays out when its tension exceeds a tension limit.
//
// Above its limit T_l the brake slips, at a speed v for a tension T_l (1 + v/v_l / 10). Here v_l is
// the speed limit. The speed is updated between steps of h, with the rope stiffness EA/L:
//
//   v1 = v0 + (T0 - T_l (1 + v0/v_l / 10)) / (h EA/L + T_l/v_l / 10)
//
// This is stable, because a taut straight rope has the highest stiffness.
#pragma once

#include <limits>

#include "curve.hpp"

namespace codend {

struct LengthControl {
  Curve target;               // m
  bool by_speed = false;      // follows `target_speed` instead of `target`
  double target_speed = 0.0;  // m/s, positive pays out
  double speed_limit = std::numeric_limits<double>::infinity();    // m/s
  double tension_limit = std::numeric_limits<double>::infinity();  // N; pays out above it
  double stiffness = 0.0;                                          // EA, N
  int bar = 0;                // the first point of this bar is the controlled end
  double full_length = 1.0;   // m, at factor 1
  double least_length = 1.0;  // m
  double most_length = std::numeric_limits<double>::infinity();  // m
  // Present state: length (m) at the time `since` (s), and speed from then on (m/s).
  double length = 0.0, since = 0.0, speed = 0.0;
  bool near_limit = false;  // tension is near its limit

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("target", target);
    visit("by_speed", by_speed);
    visit("target_speed", target_speed);
    visit("speed_limit", speed_limit);
    visit("tension_limit", tension_limit);
    visit("stiffness", stiffness);
    visit.place("bar", bar);
    visit("full_length", full_length);
    visit("least_length", least_length);
    visit("most_length", most_length);
    visit("length", length);
    visit("since", since);
    visit("speed", speed);
    visit("near_limit", near_limit);
  }

  double length_at(double time) const { return length + (time - since) * speed; }
  // Sets the speed from a time (s) on, for a tension (N) in the bar.
  void choose_speed(double time, double tension);
  // Longest step (s) before choose_speed() must be called again.
  double longest_step() const;
};

}  // namespace codend
