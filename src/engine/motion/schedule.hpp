// Prescribed changes of a model over time, as data. They are motions of fixed nodes, lengths and
// sizes, currents, releases of nodes and ruptures of ropes.
//
// A rope that is paid out keeps its bars. All its bars grow by one factor, with their mass, weight
// and drag. The rope therefore moves past the nodes at (1 - s) w, with w the payout speed and s the
// fraction of the length from the controlled end. The changes of tangential drag
// and of momentum (mass per length times w^2, 16 N for 4 kg/m at 2 m/s) by w are neglected.
//
// Each struct lists its fields once, like a model (base/fields.hpp). check_schedule.hpp defines
// valid values. Visit provides:
//
//   visit(name, value)             numbers, flags, vectors
//   visit.place(name, place)       indices of nodes, points or elements of the model, or -1
//   visit.group(name, struct)      the fields of a struct under its name
//   visit.optional(name, struct, given)   an optional group, and a flag for its presence
//   visit.items(name, vector)      one group per element
#pragma once

#include <limits>
#include <vector>

#include "../base/geometry.hpp"
#include "curve.hpp"
#include "length_control.hpp"

namespace codend {

// Oscillation of a body about its path. The six components are surge (forwards), sway (to
// starboard) and heave (up), m; roll (starboard down), pitch (bow up) and yaw (bow to starboard),
// rad. Rotations are applied in the order yaw, pitch, roll about `centre`.
struct Swing {
  Vector centre = Vector::Zero();  // m from the body's origin
  std::vector<Curve> by_time;      // six or empty
  // Responses to the wave elevation at the body's origin (Waves::respond()), m/m and rad/m.
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

// Fixed nodes that move as one rigid body, upright except for its oscillation.
struct PrescribedMotion {
  std::vector<int> node;
  std::vector<Vector> place;  // m from the body's origin, at heading 0
  Curve x, y, z;              // m, of the body's origin
  Curve heading;              // rad, clockwise from above
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

// Elements that grow or shrink together by a factor. All numbers apply at factor 1.
struct GrowingGroup {
  Curve factor;  // if not `controlled`
  bool controlled = false;
  LengthControl control;
  std::vector<int> bars;
  std::vector<double> rest;  // m
  std::vector<int> points;
  std::vector<double> mass, load;  // kg; N, upwards
  std::vector<int> spheres;
  std::vector<double> drag_area, added_mass;  // m2, m3
  std::vector<int> volumes;                   // indices of immersed volumes
  std::vector<double> buoyancy;               // N, part of the group in each of them

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

// A rope that breaks at a time, or when a bar's tension exceeds its strength.
struct Rupture {
  std::vector<int> bars;
  int at = 0;                                                 // bar that breaks at `time`
  double time = std::numeric_limits<double>::infinity();      // s
  double strength = std::numeric_limits<double>::infinity();  // N
  int broken = -1;                                            // index of the broken bar, or -1
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

// Free nodes that are fixed until their release time.
struct Release {
  std::vector<int> node;
  std::vector<double> time;  // s

  template <class Visit>
  void fields(Visit& visit) {
    visit.place("node", node);
    visit("time", time);
  }
};

// Static friction on the ground (base/ground.hpp). `anchor` continues another integration: 3 for
// each of Assembly::ground_places(), or for its contacts only, m; empty: the initial positions.
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
  std::vector<Curve> current_x, current_y;  // m/s, per depth of the water; empty: constant
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

// Values of a schedule at one time.
struct ScheduledValues {
  Vector origin = Vector::Zero(),
         velocity = Vector::Zero();           // of the moving body, m, m/s
  double heading = 0.0, turning = 0.0;        // rad, rad/s
  std::vector<double> factor, rate;           // of the growing groups; 1/s
  std::vector<Vector> current, current_rate;  // m/s, m/s2, per depth
};
ScheduledValues values_at(const Schedule& schedule, double time, Side side);

}  // namespace codend
