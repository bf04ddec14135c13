// What is prescribed for a model with time, as data: motion of held nodes, lengths and sizes that
// change, currents, nodes that are released, ropes that break.
//
// A rope that is lengthened keeps its bars: all of them grow by one factor, with their mass, weight
// and drag. Material passes the nodes at (1 - s) w, w the speed of lengthening and s the share of
// the rope from its controlled end. Left out is what that does to the water's friction along the
// rope (its tangential coefficient, at w beside the speed of the flow) and to momentum (mass per
// length times w^2, 16 N for 4 kg/m at 2 m/s).
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

  bool present() const { return !by_time.empty() || !even.empty(); }
};

// Held nodes that move as one rigid body, which stays upright but for its swing.
struct PrescribedMotion {
  std::vector<int> node;
  std::vector<Vector> place;  // m from the body's origin, at heading 0
  Curve x, y, z;              // m, of the body's origin
  Curve heading;              // rad, clockwise as seen from above
  Swing swing;
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
};

// A rope that breaks at a time, or where a bar's tension exceeds its strength.
struct Rupture {
  std::vector<int> bars;
  int at = 0;                                                 // the bar that goes at the time
  double time = std::numeric_limits<double>::infinity();      // s
  double strength = std::numeric_limits<double>::infinity();  // N
  int broken = -1;                                            // the bar that went
  double broken_at = 0.0;                                     // s
};

// Free nodes that stay where they are until they are released.
struct Release {
  std::vector<int> node;
  std::vector<double> time;  // s
};

// Contacts with the ground that stick (base/ground.hpp), from where they are at the start, or at anchors
// that another march has left, 3 per contact, m.
struct Sticking {
  bool present = false;
  std::vector<double> anchor;
};

struct Schedule {
  PrescribedMotion motion;
  Release release;
  std::vector<GrowingGroup> groups;
  std::vector<Curve> current_x, current_y;  // m/s, per depth of the model's water; none: constant
  std::vector<Rupture> ruptures;
  Sticking sticking;
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
