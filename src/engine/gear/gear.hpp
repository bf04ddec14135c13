// A gear in SI units, from which its discretisation is made: points, ropes, panels of netting,
// seams that join their edges, attached pieces, and plates.
//
// Edges are numbered panel by panel: 4 p upper, 4 p + 1 lower, 4 p + 2 left, 4 p + 3 right.
// Locations (`places`) are numbered in this order; -1 means none:
// - all points;
// - for every panel its upper left, upper right, lower left and lower right corner;
// - for every rope its start, middle and end;
// - locations at a fraction of a rope's length.
//
// Parts are numbered ropes first, then panels, pieces and plates.
#pragma once

#include <array>
#include <vector>

#include "../base/error.hpp"
#include "../base/fields.hpp"
#include "../base/geometry.hpp"
#include "../base/waves.hpp"
#include "../elements/lifting_surface.hpp"
#include "../model/wake.hpp"

namespace codend {

// Initial opening of netting as a fraction of its stretched width.
constexpr double nominal_hanging_ratio = 0.3;

enum class MeshOrientation { diamond, square, turned, hexagonal, hexagonal_turned };
constexpr std::array<const char*, 5> names_of(MeshOrientation) {
  return {"diamond", "square", "turned", "hexagonal", "hexagonal_turned"};
}

// A part of an edge, between two fractions of its length; reversed if from > to.
struct Link {
  int edge = 0;
  double from = 0.0, to = 1.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("edge", edge, {1, Among::edges});
    visit("from", from);
    visit("to", to);
  }
};

// Consecutive parts of edges.
struct Chain {
  std::vector<Link> links;

  template <class Visit>
  void fields(Visit& visit) {
    visit.columns("links", links);
  }
};

struct GearPoint {
  bool held = false;                 // fixed at `position`
  Vector position = Vector::Zero();  // m
  bool has_near = false;             // initial position is given
  Vector near = Vector::Zero();      // m
  Vector load = Vector::Zero();      // N
  int at = -1;                       // location identical to this point

  template <class Visit>
  void fields(Visit& visit) {
    visit("held", held);
    visit("position", position);
    visit("has_near", has_near);
    visit("near", near);
    visit("load", load);
    visit("at", at, {1, Among::places, Per::element, true});
  }
};

// A rope between two locations, which may slide through others, or a rope laced along edges.
struct GearRope {
  int from = -1, to = -1;
  std::vector<int> through;    // locations
  std::vector<Link> along;     // empty: the rope has its own nodes
  std::vector<double> shares;  // parts of its length per edge of `along`; empty: even
  double length = 0.0;         // m
  double diameter = 0.0;       // m
  double mass_per_length = 0.0, volume_per_length = 0.0;  // kg/m, m2
  double weight_factor = 1.0;                             // multiplier of its weight in water
  double axial_stiffness = 0.0, bending_stiffness = 0.0;  // N, N m2
  bool strut = false;                                     // carries compression
  int segments = 0;                                       // 0: automatic
  std::vector<double> friction;  // along and across its axis; empty: as the ground

  bool laced() const { return !along.empty(); }
  bool ring() const { return from >= 0 && from == to && through.empty(); }
  template <class Visit>
  void fields(Visit& visit) {
    visit("from", from, {1, Among::places, Per::element, true});
    visit("to", to, {1, Among::places, Per::element, true});
    visit.list("through", through, {1, Among::places});
    visit.columns("along", along);
    visit.list("shares", shares);
    visit("length", length);
    visit("diameter", diameter);
    visit("mass_per_length", mass_per_length);
    visit("volume_per_length", volume_per_length);
    visit("weight_factor", weight_factor);
    visit("axial_stiffness", axial_stiffness);
    visit("bending_stiffness", bending_stiffness);
    visit("strut", strut);
    visit("segments", segments);
    visit.list("friction", friction);
  }
};

struct GearPanel {
  double mesh_size = 0.0;                                 // stretched, m
  double upper = 0.0, lower = 0.0;                        // meshes along its edges
  double deep = 0.0;                                      // meshes
  double lost_left = 0.0, lost_right = 0.0;               // meshes lost along each side
  double mass_per_length = 0.0, volume_per_length = 0.0;  // all parallel twines, kg/m, m2
  double twine_diameter = 0.0, twine_count = 1.0;         // m; number of parallel twines
  double knot_diameter = 0.0, knot_twine = 0.0;           // m; 0: no knots
  double knot_drag = 1.0;                                 // multiplier of the drag of knots
  double straight_bar = 0.0;                              // of hexagonal meshes, m
  MeshOrientation orientation = MeshOrientation::diamond;
  WakeLaw shielding = WakeLaw::none;
  NettingDrag drag = NettingDrag::morison;
  int columns = 0, rows = 0, bar_segments = 0;       // 0: automatic
  bool bars = false;                                 // equivalent bars instead of cells
  bool stiff = false;                                // knots resist opening
  double opening_couple = 0.0, opening_angle = 0.0;  // N m/rad, rad

  template <class Visit>
  void fields(Visit& visit) {
    visit("mesh_size", mesh_size);
    visit("upper", upper);
    visit("lower", lower);
    visit("deep", deep);
    visit("lost_left", lost_left);
    visit("lost_right", lost_right);
    visit("mass_per_length", mass_per_length);
    visit("volume_per_length", volume_per_length);
    visit("twine_diameter", twine_diameter);
    visit("twine_count", twine_count);
    visit("knot_diameter", knot_diameter);
    visit("knot_twine", knot_twine);
    visit("knot_drag", knot_drag);
    visit("straight_bar", straight_bar);
    visit("orientation", orientation);
    visit("shielding", shielding);
    visit("drag", drag);
    visit("columns", columns);
    visit("rows", rows);
    visit("bar_segments", bar_segments);
    visit("bars", bars);
    visit("stiff", stiff);
    visit("opening_couple", opening_couple);
    visit("opening_angle", opening_angle);
  }

  bool square() const { return orientation == MeshOrientation::square; }
  // Positions of the left and right side at a depth of j meshes, in meshes across.
  double left(double j) const { return lost_left * j / deep; }
  double right(double j) const { return upper - lost_right * j / deep; }
  // Length of one mesh, in square netting of one bar, m.
  double unit() const { return mesh_size / (1 + square()); }
  // Total width of the parallel twines, m.
  double width() const { return twine_diameter * twine_count; }
  // Number of bars of one family, equal to the other family and to the number of knots.
  double bar_count() const { return (upper + lower) / 2 * deep * (2 - square()); }
  // Twine length per bar, m; then including the twine in its knots.
  double cell_twine() const { return mesh_size - straight_bar; }
  double cell_twine_with_knots() const { return cell_twine() + knot_twine; }
  // Coefficient of the area lost at crossings without knots: Sn = s - overlap s^2
  // (base/solidity.hpp). Bars of hexagonal meshes meet and do not cross.
  double crossing_overlap() const { return knot_diameter == 0 && straight_bar == 0 ? 0.25 : 0.0; }
  // True for screen drag models.
  bool screen() const { return drag != NettingDrag::morison && drag != NettingDrag::blended; }
};

// Edges joined chain to chain, gathered in a location, or fixed on the line between two points.
struct GearSeam {
  std::vector<Chain> chains;
  int gathered_at = -1;                        // location
  std::array<int, 2> held_between = {-1, -1};  // points, as locations

  template <class Visit>
  void fields(Visit& visit) {
    visit.items("chains", chains);
    visit("gathered_at", gathered_at, {1, Among::places, Per::element, true});
    visit("held_between", held_between, {1, Among::places, Per::element, true});
  }
};

// Bodies at a location, or distributed along a rope or along edges.
struct GearPiece {
  int at = -1;                               // location
  int rope = -1;                             // or along this rope,
  std::vector<Link> along;                   // or along these edges,
  std::array<double, 2> share = {0.0, 1.0};  // between these fractions,
  bool end_to_end = false;                   // one at each end; else distributed evenly
  double number = 1.0;
  double mass = 0.0, volume = 0.0;                              // of one body, kg, m3
  double height = 0.0, drag_area = 0.0, smooth_diameter = 0.0;  // m, m2, m
  double added_mass = 0.0;                                      // kg
  double lift_area = 0.0;  // C_L A, m2; negative: downward or to port
  LiftDirection lift_direction = LiftDirection::up;
  double upward_lift_area = 0.0;  // m2

  template <class Visit>
  void fields(Visit& visit) {
    visit("at", at, {1, Among::places, Per::element, true});
    visit("rope", rope, {1, Among::ropes, Per::element, true});
    visit.columns("along", along);
    visit("share", share);
    visit("end_to_end", end_to_end);
    visit("number", number);
    visit("mass", mass);
    visit("volume", volume);
    visit("height", height);
    visit("drag_area", drag_area);
    visit("smooth_diameter", smooth_diameter);
    visit("added_mass", added_mass);
    visit("lift_area", lift_area);
    visit("lift_direction", lift_direction);
    visit("upward_lift_area", upward_lift_area);
  }
};

// A rigid plate on three points with lift to the side, or upward if its span is level.
struct GearPlate {
  std::array<int, 3> points = {0, 0, 0};  // as locations
  std::array<Vector, 3> attachment;       // of the points, m (axes: lifting_plate.hpp)
  std::array<Vector, 3> upright;          // in the initial shape, relative to their centroid, m
  double side = 1.0;                      // 1: starboard or up; -1: port or down
  bool level = false;
  double area = 0.0, mass = 0.0, volume = 0.0;  // m2, kg, m3
  double room = 0.0;                            // height of the points' centroid above the foot, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("points", points, {1, Among::places});
    visit("attachment", attachment);
    visit("upright", upright);
    visit("side", side);
    visit("level", level);
    visit("area", area);
    visit("mass", mass);
    visit("volume", volume);
    visit("room", room);
  }
};

// Panels that form a bag with a pressure from its contents, which start at the lower edges.
struct GearBag {
  std::vector<int> panels;
  double deep = 0.0;  // total depth, meshes

  template <class Visit>
  void fields(Visit& visit) {
    visit("panels", panels, {1, Among::panels});
    visit("deep", deep);
  }
};

struct SharePlace {
  int rope = 0;
  double share = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("rope", rope, {1, Among::ropes});
    visit("share", share);
  }
};

// Seabed plane for the initial shape: normal . x = height (m).
struct GearGround {
  Vector normal = Vector::UnitZ();
  double height = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("normal", normal);
    visit("height", height);
  }
};

struct Gear {
  int point_count = 0, rope_count = 0, panel_count = 0, share_count = 0;
  std::vector<GearPoint> points;
  std::vector<GearRope> ropes;
  std::vector<GearPanel> panels;
  std::vector<GearSeam> seams;
  std::vector<GearPiece> pieces;
  std::vector<GearPlate> plates;
  std::vector<SharePlace> share_places;
  bool has_bag = false;
  GearBag bag;
  bool has_ground = false;
  GearGround ground;
  double density = 0.0;  // of water, kg/m3
  double speed = 0.0;    // water speed past the gear at the surface, towards x, m/s
  bool free_surface = false;
  int shot_along = -1;  // rope along which the gear is shot; -1: already in the water

  template <class Visit>
  void fields(Visit& visit) {
    visit("point_count", point_count);
    visit("rope_count", rope_count);
    visit("panel_count", panel_count);
    visit("share_count", share_count);
    visit.count(Among::ropes, static_cast<std::size_t>(rope_count));
    visit.count(Among::panels, static_cast<std::size_t>(panel_count));
    visit.count(Among::edges, 4 * static_cast<std::size_t>(panel_count));
    visit.count(Among::places, static_cast<std::size_t>(places()));
    visit.items("points", points);
    visit.items("ropes", ropes);
    visit.columns("panels", panels);
    visit.items("seams", seams);
    visit.items("pieces", pieces);
    visit.items("plates", plates);
    visit.columns("share_places", share_places);
    visit.optional("bag", bag, has_bag);
    visit.optional("ground", ground, has_ground);
    visit("density", density);
    visit("speed", speed);
    visit("free_surface", free_surface);
    visit("shot_along", shot_along, {1, Among::ropes, Per::element, true});
  }

  int places() const { return point_count + 4 * panel_count + 3 * rope_count + share_count; }
  int parts() const {
    return rope_count + panel_count + static_cast<int>(pieces.size() + plates.size()) + has_bag;
  }
  // Throws InputError if the counts differ from the numbers of given parts.
  void check() const;
};

}  // namespace codend
