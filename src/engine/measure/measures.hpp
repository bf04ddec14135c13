// Measures of a gear: numbers that people ask of a shape and of what acts in it. Each is a function of
// positions and velocities of nodes, tensions of lines and forces on elements, computed with numbers of
// any type: with dual numbers (dual.hpp) it has its exact derivative along any change of these.
//
// Names, units and definitions are the asker's. SI units. A measure that a gear does not have is not a
// number.
#pragma once

#include <string>
#include <vector>

#include "../model/evaluate.hpp"
#include "filled_bag.hpp"
#include "frame.hpp"
#include "measure_kinds.hpp"

namespace codend {

// Where on a rope, or which angle: of a rope's bar below the horizontal or out of the x axis, of a plate.
enum class MeasureAt { none, start, middle, end, max };
constexpr std::array<const char*, 5> names_of(MeasureAt) {
  return {"none", "start", "middle", "end", "max"};
}
enum class MeasureAngle { none, declination, divergence, attack, heel, trim };
constexpr std::array<const char*, 6> names_of(MeasureAngle) {
  return {"none", "declination", "divergence", "attack", "heel", "trim"};
}

// One measure. Places, ropes, panels, parts and plates by their numbers (gear/gear.hpp).
struct AskedMeasure {
  MeasureKind kind = MeasureKind::total_drag;
  std::vector<int> places, ropes, panels, parts, plates;  // places of pairs one after the other
  MeasureAt at = MeasureAt::none;
  MeasureAngle angle = MeasureAngle::none;
  double of = 1.0;  // m3, of a share of a volume

  template <class Visit>
  void fields(Visit& visit) {
    visit("kind", kind);
    visit.list("places", places, {1, Among::places});
    visit.list("ropes", ropes, {1, Among::ropes});
    visit.list("panels", panels, {1, Among::panels});
    visit.list("parts", parts, {1, Among::parts});
    visit.list("plates", plates, {1, Among::elements});
    visit("at", at);
    visit("angle", angle);
    visit("of", of);
  }
};

// What pulls the gear: what it can pull by its speed, between points that rise in speed, straight on
// beyond the last; its power, and consumption by the share of it.
struct Propulsion {
  std::vector<double> speed, pull;        // m/s, N
  double power = 0.0;                     // W
  std::vector<double> load, consumption;  // share of the power, kg/J; empty: not known
  double fuel_density = 1.0;              // kg/m3
  double yield = 0.0;                     // kg/s that is gained meanwhile; 0: not known

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("speed", speed);
    visit.list("pull", pull);
    visit("power", power);
    visit.list("load", load);
    visit.list("consumption", consumption);
    visit("fuel_density", fuel_density);
    visit("yield", yield);
  }
};

// All that is asked of a gear.
struct Questions {
  int place_count = 0, rope_count = 0, panel_count = 0, part_count = 0, plate_count = 0;
  double speed = 0.0;      // of the gear over the ground, towards -x, m/s
  std::vector<int> mouth;  // ropes around its mouth; empty: unknown
  std::vector<int> wings;  // places of pairs whose lines pass over the ground; empty: unknown
  bool has_propulsion = false;
  Propulsion propulsion;
  std::vector<AskedMeasure> measures;

  template <class Visit>
  void fields(Visit& visit) {
    visit("place_count", place_count);
    visit("rope_count", rope_count);
    visit("panel_count", panel_count);
    visit("part_count", part_count);
    visit("plate_count", plate_count);
    visit.count(Among::places, static_cast<std::size_t>(place_count));
    visit.count(Among::ropes, static_cast<std::size_t>(rope_count));
    visit.count(Among::panels, static_cast<std::size_t>(panel_count));
    visit.count(Among::parts, static_cast<std::size_t>(part_count));
    visit.count(Among::elements, static_cast<std::size_t>(plate_count));
    visit("speed", speed);
    visit.list("mouth", mouth, {1, Among::ropes});
    visit.list("wings", wings, {1, Among::places});
    visit.optional("propulsion", propulsion, has_propulsion);
    visit.items("measures", measures);
  }
};

// A shape and what acts in it, as an Evaluation has it: positions (m), velocities (m/s) and net forces
// (N) of nodes, 3 each; tensions (N); forces by the table of reported_forces(); angles of plates (rad).
template <class T>
struct MeasuredShape {
  std::vector<T> position, velocity, force;
  std::vector<T> bar_tension, u_tension, v_tension, straight_tension;
  std::vector<std::vector<T>> forces;
  std::vector<T> attack, heel, trim;
};
MeasuredShape<double> measured_shape(const Evaluation& found, const std::vector<double>& position,
                                     const std::vector<double>& velocity);

// Positions of nodes, then of points tied between two of them, 3 each, from those of the nodes.
template <class T>
std::vector<T> all_points(const Model& model, const std::vector<T>& position);

// The flow past a gear: along x where it is towed, else along the fastest current of its profile, and
// along x where the water is still.
Three<double> flow_axis(const Model& model, const Questions& questions);

// The measures that are asked for, in their order. bag: null where there is none. T: double or Dual.
template <class T>
std::vector<T> measure(const MeasureFrame& frame, const Model& model, const Questions& questions,
                       const FilledBag* bag, const MeasuredShape<T>& shape);

// Force of the flow on every part, 3 each, N.
template <class T>
std::vector<T> part_forces(const MeasureFrame& frame, const MeasuredShape<T>& shape);

// Tension at both ends of a bar of a rope (N). A bar's own tension is that of its middle; at an end it
// carries what water and weight pull at the half between, which the lattice gathers in the node. Where
// they push a bar together its own is kept.
template <class T>
std::array<T, 2> end_tensions(const MeasureFrame& frame, const Model& model,
                              const MeasuredShape<T>& shape, int bar);

}  // namespace codend
