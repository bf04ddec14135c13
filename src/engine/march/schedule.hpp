// What is prescribed for a model with time, as data: motion of held nodes, lengths and sizes that
// change, currents, nodes that are released, ropes that break.
//
// A rope that is lengthened keeps its bars: all of them grow by one factor, with their mass, weight
// and drag. Material passes the nodes at (1 - s) w, w the speed of lengthening and s the share of
// the rope from its controlled end. Left out is what that does to the water's friction along the
// rope (its tangential coefficient, at w beside the speed of the flow) and to momentum (mass per
// length times w^2, 16 N for 4 kg/m at 2 m/s).
//
// Each struct names its fields, once, as those of a model do (base/fields.hpp); what they must be
// is check_schedule.hpp's. Visit offers:
//   visit(name, value)             numbers, marks, vectors
//   visit.place(name, place)       places among nodes, points or elements of the model, -1 for none
//   visit.group(name, struct)      the fields of a struct under its name
//   visit.optional(name, struct, given)   the same where it is given, and whether it is
//   visit.items(name, vector)      one group per element
#pragma once

#include <limits>
#include <vector>

#include "../base/geometry.hpp"
#include "curve.hpp"
#include "length_control.hpp"

namespace codend {

// How a body swings about its way: surge (forwards), sway (to starboard), heave (up), m, and roll
// (starboard down), pitch (bow up), yaw (bow to starboard), rad, in this order. Turns are made in the
// order yaw, pitch, roll about a place of the body.
struct Swing {
  Vector centre = Vector::Zero();  // m from the body's origin
  std::vector<Curve> by_time;      // six, or none
  // Answers to the elevation of the model's waves at the body's origin (Waves::respond()), six per
  // wave, m/m and rad/m; or none.
  std::vector<double> even, odd;

  template <class Visit>
  void fields(Visit& visit) {
    visit("centre", centre);
    visit.items("by_time", by_time);
    visit("even", even);
    visit("odd", odd);
  }
  bool present() const { return !by_time.empty() || !even.empty(); }
};

// Held nodes that move as one rigid body, which stays upright but for its swing.
struct PrescribedMotion {
  std::vector<int> node;
  std::vector<Vector> place;  // m from the body's origin, at heading 0
  Curve x, y, z;              // m, of the body's origin
  Curve heading;              // rad, clockwise as seen from above
  Swing swing;

  template <class Visit>
  void fields(Visit& visit) {
    visit.place("node", node);
    visit("place", place);
    visit.group("x", x);
    visit.group("y", y);
    visit.group("z", z);
    visit.group("heading", heading);
    visit.optional("swing", swing);
  }
};

// Elements that grow or shrink together by a factor. All numbers are those at factor 1.
struct GrowingGroup {
  Curve factor;  // where its length is not controlled
  bool controlled = false;
  LengthControl control;
  std::vector<int> bars;
  std::vector<double> rest;  // m
  std::vector<int> points;
  std::vector<double> mass, load;  // kg; N, upwards
  std::vector<int> spheres;
  std::vector<double> drag_area, added_mass;  // m2, m3
  std::vector<int> volumes;                   // of the model's immersed volumes
  std::vector<double> buoyancy;               // N, the group's own in each of them

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("factor", factor);
    visit.optional("control", control, controlled);
    visit.place("bars", bars);
    visit("rest", rest);
    visit.place("points", points);
    visit("mass", mass);
    visit("load", load);
    visit.place("spheres", spheres);
    visit("drag_area", drag_area);
    visit("added_mass", added_mass);
    visit.place("volumes", volumes);
    visit("buoyancy", buoyancy);
  }
};

// A rope that breaks at a time, or where a bar's tension exceeds its strength.
struct Rupture {
  std::vector<int> bars;
  int at = 0;                                                 // the bar that goes at the time
  double time = std::numeric_limits<double>::infinity();      // s
  double strength = std::numeric_limits<double>::infinity();  // N
  int broken = -1;                                            // the bar that went
  double broken_at = 0.0;                                     // s

  template <class Visit>
  void fields(Visit& visit) {
    visit.place("bars", bars);
    visit.place("at", at);
    visit("time", time);
    visit("strength", strength);
    visit.place("broken", broken);
    visit("broken_at", broken_at);
  }
};

// Free nodes that stay where they are until they are released.
struct Release {
  std::vector<int> node;
  std::vector<double> time;  // s

  template <class Visit>
  void fields(Visit& visit) {
    visit.place("node", node);
    visit("time", time);
  }
};

// What lies on the ground sticks (base/ground.hpp), from where it is at the start, or at anchors that
// another march has left, m: 3 for each of Assembly::ground_places(), or of its contacts alone.
struct Sticking {
  bool present = false;
  std::vector<double> anchor;

  template <class Visit>
  void fields(Visit& visit) {
    visit("present", present);
    visit("anchor", anchor);
  }
};

struct Schedule {
  PrescribedMotion motion;
  Release release;
  std::vector<GrowingGroup> growing;
  std::vector<Curve> current_x, current_y;  // m/s, per depth of the model's water; none: constant
  std::vector<Rupture> ruptures;
  Sticking sticking;

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("motion", motion);
    visit.group("release", release);
    visit.items("growing", growing);
    visit.items("current_x", current_x);
    visit.items("current_y", current_y);
    visit.items("ruptures", ruptures);
    visit.group("sticking", sticking);
  }
};

// What a schedule says of one time.
struct ScheduledValues {
  Vector origin = Vector::Zero(),
         velocity = Vector::Zero();           // m, m/s, of the body that moves nodes
  double heading = 0.0, turning = 0.0;        // rad, rad/s
  std::vector<double> factor, rate;           // of the groups; 1/s
  std::vector<Vector> current, current_rate;  // m/s, m/s2, per depth
};
ScheduledValues values_at(const Schedule& schedule, double time, Side side);

}  // namespace codend
