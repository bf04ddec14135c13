// A rope whose length is controlled at one end: it follows a target, no faster than a limit, and
// gives way where its tension exceeds another.
//
// At its limit T_l its brake slips at the speed v where the tension is T_l (1 + v/v_l / 10), v_l its
// speed limit; between two steps of h this is solved once, with the rope's own stiffness EA/L, as
//   v1 = v0 + (T0 - T_l (1 + v0/v_l / 10)) / (h EA/L + T_l/v_l / 10),
// which is stable since no rope is stiffer than taut and straight.
#pragma once

#include <limits>

#include "curve.hpp"

namespace codend {

struct LengthControl {
  Curve target;               // m
  bool by_speed = false;      // follows `target_speed` instead of `target`
  double target_speed = 0.0;  // m/s, positive lengthens
  double speed_limit = std::numeric_limits<double>::infinity();    // m/s
  double tension_limit = std::numeric_limits<double>::infinity();  // N; lengthens above it
  double stiffness = 0.0;                                          // EA, N
  int bar = 0;                                                     // at whose first point it pulls
  double full_length = 1.0;                                        // m, where the factor is 1
  double least_length = 1.0;                                       // m
  double most_length = std::numeric_limits<double>::infinity();    // m
  // As it is: length (m) at a time (s), and speed (m/s) since.
  double length = 0.0, since = 0.0, speed = 0.0;
  bool near_limit = false;  // of tension

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
  // Chooses the speed from a time (s) on, at a tension (N) in the bar.
  void choose_speed(double time, double tension);
  // The longest step (s) after which it must choose again.
  double longest_step() const;
};

}  // namespace codend
