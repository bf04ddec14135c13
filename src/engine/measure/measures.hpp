// Measures of a gear: numbers derived from its shape and forces. Each is a function of positions
// and velocities of nodes, tensions of lines and forces on elements. The number type is a template
// parameter: dual numbers (dual.hpp) give exact derivatives along any change of the input.
//
// The caller defines names, units and definitions. Results are in SI units, NaN if the gear lacks
// the measure.
#pragma once

#include <string>
#include <vector>

#include "../model/evaluate.hpp"
#include "filled_bag.hpp"
#include "frame.hpp"
#include "measure_kinds.hpp"

namespace codend {

// Location on a rope. Angle: of a rope's bar below the horizontal (declination) or from the flow in
// plan view (divergence, see flow_axis()), or of a plate.
enum class MeasureAt { none, start, middle, end, max };
constexpr std::array<const char*, 5> names_of(MeasureAt) {
  return {"none", "start", "middle", "end", "max"};
}
enum class MeasureAngle { none, declination, divergence, attack, heel, trim };
constexpr std::array<const char*, 6> names_of(MeasureAngle) {
  return {"none", "declination", "divergence", "attack", "heel", "trim"};
}

// One requested measure. Locations, ropes, panels, parts and plates are numbered as in
// gear/gear.hpp.
struct AskedMeasure {
  MeasureKind kind = MeasureKind::total_drag;
  std::vector<int> places, ropes, panels, parts, plates;  // pairs of locations are consecutive
  MeasureAt at = MeasureAt::none;
  MeasureAngle angle = MeasureAngle::none;
  double of = 1.0;  // reference volume of a fraction, m3

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

// Propulsion. Maximum pull by speed: piecewise linear in increasing speed,
// extrapolated beyond the last. Power, and fuel consumption by load (fraction of the power).
struct Propulsion {
  std::vector<double> speed, pull;        // m/s, N
  double power = 0.0;                     // W
  std::vector<double> load, consumption;  // fraction of the power, kg/J; empty: unknown
  double fuel_density = 1.0;              // kg/m3
  double yield = 0.0;                     // catch rate, kg/s; 0: unknown

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

// Roles of parts in one net of a gear; empty: unknown.
struct NetRoles {
  std::vector<int> mouth;  // ropes around its mouth
  std::vector<int> wings;  // pairs of locations that sweep the ground

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("mouth", mouth, {1, Among::ropes});
    visit.list("wings", wings, {1, Among::places});
  }
};

// All measures requested of a gear.
struct Questions {
  int place_count = 0, rope_count = 0, panel_count = 0, part_count = 0, plate_count = 0;
  double speed = 0.0;  // of the gear over the ground, towards -x, m/s
  std::vector<NetRoles> nets;
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
    visit.items("nets", nets);
    visit.optional("propulsion", propulsion, has_propulsion);
    visit.items("measures", measures);
  }
};

// A shape and its forces, as in Evaluation: positions (m), velocities (m/s) and net forces (N) of
// nodes, 3 each; tensions (N); forces in the order of reported_forces() (N); angles of plates
// (rad).
template <class T>
struct MeasuredShape {
  std::vector<T> position, velocity, force;
  std::vector<T> bar_tension, u_tension, v_tension, straight_tension;
  std::vector<std::vector<T>> forces;
  std::vector<T> attack, heel, trim;
};
MeasuredShape<double> measured_shape(const Evaluation& found, const std::vector<double>& position,
                                     const std::vector<double>& velocity);

// Returns positions of nodes, then of tied points, 3 each, from positions of nodes.
template <class T>
std::vector<T> all_points(const Model& model, const std::vector<T>& position);

// Direction of the flow past a gear: x for a towed gear, else the fastest current of the profile,
// and x in still water.
Three<double> flow_axis(const Model& model, const Questions& questions);

// Returns the requested measures in order. bag: null if there is none. T: double or Dual.
template <class T>
std::vector<T> measure(const MeasureFrame& frame, const Model& model, const Questions& questions,
                       const FilledBag* bag, const MeasuredShape<T>& shape);

// Hydrodynamic force on every part, 3 each, N.
template <class T>
std::vector<T> part_forces(const MeasureFrame& frame, const MeasuredShape<T>& shape);

// Tension at both ends of a bar of a rope, N. A bar's own tension refers to its middle; each end
// adds drag and weight of half the bar, which the model lumps in the node. A bar without tension,
// or in compression, returns its own value.
template <class T>
std::array<T, 2> end_tensions(const MeasureFrame& frame, const Model& model,
                              const MeasuredShape<T>& shape, int bar);

}  // namespace codend
