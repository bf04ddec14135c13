// What a crew and the sea do to a gear with time: the vessel's track and heave, warps paid out and
// hauled, currents that change, ropes that part.
//
// Motion is computed over the ground, where a turn brings in no forces of its own: towing points
// move, and water stands still but for its current.
//
// A warp that is paid out keeps its bars: all of them grow by one factor, with their mass, weight
// and drag. Material passes the nodes at (1 - s) w, w the speed of paying out and s the share of
// the warp from the vessel. Left out is what that does to the water's friction along the warp (its
// tangential coefficient, at w beside the towing speed) and to momentum (mass per length times
// w^2, 16 N for 4 kg/m at 2 m/s).
#pragma once

#include <limits>
#include <vector>

#include "../model/assembly.hpp"
#include "conditions.hpp"

namespace codend {

// Held nodes that move with a vessel.
struct Track {
  std::vector<int> node;
  std::vector<Vector> place;       // m from the vessel's origin, on course 0: aft, starboard, up
  Curve x, y, heave;               // m, of the vessel's origin over the ground
  Curve course;                    // rad, to starboard of the start, which heads towards -x
};

// A winch that answers to its warp: it is steered, or gives way at a tension. At its limit T_l its
// brake slips at the speed v where the tension is T_l (1 + v/v_l / 10), v_l its speed limit;
// between two steps of h this is solved once, with the warp's own stiffness EA/L, as
//   v1 = v0 + (T0 - T_l (1 + v0/v_l / 10)) / (h EA/L + T_l/v_l / 10),
// which is stable since no warp is stiffer than taut and straight.
struct Winch {
  Curve wanted;                    // m
  bool steered = false;            // at `speed_wanted` instead of by `wanted`
  double speed_wanted = 0.0;       // m/s, positive pays out
  double speed_limit = std::numeric_limits<double>::infinity();    // m/s
  double tension_limit = std::numeric_limits<double>::infinity();  // N; pays out above it
  double stiffness = 0.0;          // EA, N
  int bar = 0;                     // where the winch pulls
  double full_length = 0.0;        // m, where the factor is 1
  double least_length = 1.0;       // m
  double most_length = std::numeric_limits<double>::infinity();    // m
  // As it is: length (m) at a time (s), and speed (m/s) since.
  double length = 0.0, since = 0.0, speed = 0.0;
  bool near_limit = false;         // of tension
};

// A part of the gear that grows or shrinks as a whole by a factor: a warp, the catch. All numbers
// are those at factor 1.
struct GrowingPart {
  Curve factor;                    // where there is no winch
  bool has_winch = false;
  Winch winch;
  std::vector<int> bars;
  std::vector<double> rest;        // m
  std::vector<int> points;
  std::vector<double> mass, load;  // kg; N, upwards
  std::vector<int> spheres;
  std::vector<double> drag_area, added_mass;
  std::vector<int> volumes;        // of the model's immersed volumes
  std::vector<double> buoyancy;    // N, the part's own in each of them
};

// A rope that parts at a time, or where a bar's tension exceeds its strength.
struct Parting {
  std::vector<int> bars;
  int at = 0;                      // the bar that goes at the time
  double time = std::numeric_limits<double>::infinity();      // s
  double strength = std::numeric_limits<double>::infinity();  // N
  int parted = -1;                 // the bar that went
  double parted_at = 0.0;          // s
};

// Nodes that stay where they lie until they are shot.
struct Shooting {
  std::vector<int> node;
  std::vector<double> time;        // s
};

struct Plan {
  Track track;
  Shooting shooting;
  std::vector<GrowingPart> parts;
  std::vector<Curve> current_x, current_y;  // m/s over the ground, per depth of the model's water
  std::vector<Parting> partings;
};

class Schedule : public Conditions {
 public:
  // The model is changed as time goes, the assembly over it told. start: where held nodes are that
  // no track moves.
  Schedule(Model& model, Assembly& assembly, Plan plan, const Motion& start);

  void to_time(double time, Side side, Motion& motion) override;
  // A rope that parts takes one bar away; its weight stays on the nodes. The water behind netting
  // slows after the netting has moved, so that shading is that of the step before.
  bool broken_at(const Motion& now) override;
  double longest_step() const override;

  Plan& plan() { return plan_; }
  const Plan& plan() const { return plan_; }

 private:
  void grow(double time, Side side);
  void shoot(double time);
  void part(Parting& parting, int bar, double time);
  void turn(Winch& winch, double time);

  Model& model_;
  Assembly& assembly_;
  Plan plan_;
  Motion start_;
  std::vector<double> mass_, load_;       // without growing parts
  bool answers_ = false;                  // there are winches, ropes that may part, or a wake
  double shaded_at_;                      // s
  // Per part, buoyancy of its volumes without its own, N.
  std::vector<std::vector<double>> other_buoyancy_;
  std::vector<double> factor_, rate_;     // of the parts, as the model has them
  std::vector<char> kept_;                // per node: 1 until it is shot
  double all_shot_ = 0.0, time_ = 0.0;    // s
};

}  // namespace codend
