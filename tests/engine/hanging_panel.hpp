// A small gear of netting and its meshes, for tests.
#pragma once

#include <cmath>

#include "gear/mesh.hpp"

namespace codend {

// A tapered panel hung from a line between two points, with a rope along its right edge and floats
// along its lower edge.
inline Gear hanging_panel(bool bars, MeshOrientation orientation, NettingDrag drag) {
  Gear gear;
  gear.density = 1025;
  gear.speed = 0.5;
  for (const double y : {0.0, 4.0}) {
    GearPoint point;
    point.held = true;
    point.position = {0, y, 0};
    gear.points.push_back(point);
  }
  GearPanel panel;
  panel.mesh_size = 0.1;
  panel.upper = 60;
  panel.lower = 24;
  panel.lost_left = panel.lost_right = 18;
  panel.deep = 30;
  panel.twine_diameter = 0.002;
  panel.mass_per_length = 0.01;
  panel.volume_per_length = 3e-6;
  panel.knot_diameter = 0.004;
  panel.knot_twine = 0.03;
  panel.orientation = orientation;
  panel.straight_bar = orientation == MeshOrientation::hexagonal ? 0.01 : 0;
  panel.shielding = WakeLaw::cheng;
  panel.drag = drag;
  panel.bars = bars;
  gear.panels = {panel};
  GearSeam top;
  top.chains = {Chain{{Link{0, 0, 1}}}};
  top.held_between = {0, 1};
  gear.seams = {top};
  GearRope rope;
  rope.along = {Link{3, 0, 1}};
  rope.length = 3;
  rope.diameter = 0.008;
  rope.mass_per_length = 0.03;
  rope.volume_per_length = 5e-5;
  gear.ropes = {rope};
  GearPiece floats;
  floats.along = {Link{1, 0, 1}};
  floats.number = 7;
  floats.mass = 0.1;
  floats.volume = 1e-3;
  floats.height = 0.1;
  floats.drag_area = 0.01;
  gear.pieces = {floats};
  gear.point_count = 2;
  gear.rope_count = gear.panel_count = 1;
  return gear;
}

// Moves the free nodes of a skeleton to arbitrary positions.
inline void scatter(const Strings& strings, double* x) {
  for (std::size_t k = 0; k < strings.load.size(); ++k) {
    if (!strings.held[k / 3]) x[k] = std::sin(static_cast<double>(k));
  }
}

inline Mesh mesh_of(const Gear& gear, double nodes, const FromShape& from = {}) {
  Fineness fineness;
  fineness.nodes = nodes;
  return build_mesh(gear, fineness, from, scatter);
}

}  // namespace codend
