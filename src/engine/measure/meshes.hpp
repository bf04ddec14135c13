// Opening of netting meshes in a shape, and the area that the twine hides from the flow.
//
// With x_i and x_j the derivatives of position by meshes across and by meshes down a panel, a
// diamond mesh has the bars (x_j + x_i) / 2 and (x_j - x_i) / 2. A square mesh has the bars x_i and
// x_j.
#pragma once

#include <vector>

#include "../gear/carry.hpp"
#include "dual.hpp"

namespace codend {

// Panels as rows of positions, with constants of their meshes. Positions and rows are consecutive.
struct MeshFrame {
  std::vector<double> width, unit;  // per panel: total twine width, length of a mesh, m
  std::vector<char> square, turned;
  std::vector<int> row_panel;  // per row
  std::vector<double> row_t;
  // Per position: row and fraction across; the two points between which it lies and the fraction.
  std::vector<int> row;
  std::vector<double> s;
  std::vector<int> from, to;
  std::vector<double> share;
  // Neighbours in the rows above and below at the same fraction across: two positions and a
  // fraction.
  std::vector<int> above, above_next, below, below_next;
  std::vector<double> above_share, below_share;
  std::vector<double> per_mesh, per_row, slant;  // 1/meshes across, down; slope of columns
  // Number of meshes represented by a position, and their extent to all sides (meshes).
  std::vector<double> meshes, port, starboard, fore, aft;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("width", width);
    visit.list("unit", unit);
    visit.list("square", square);
    visit.list("turned", turned);
    visit.list("row_panel", row_panel, {1, Among::panels});
    visit.list("row_t", row_t);
    visit("row", row);
    visit.count(Among::elements, row.size());
    visit("s", s);
    visit("from", from, {1, Among::points});
    visit("to", to, {1, Among::points});
    visit("share", share);
    visit("above", above, {1, Among::elements});
    visit("above_next", above_next, {1, Among::elements});
    visit("below", below, {1, Among::elements});
    visit("below_next", below_next, {1, Among::elements});
    visit("above_share", above_share);
    visit("below_share", below_share);
    visit("per_mesh", per_mesh);
    visit("per_row", per_row);
    visit("slant", slant);
    visit("meshes", meshes);
    visit("port", port);
    visit("starboard", starboard);
    visit("fore", fore);
    visit("aft", aft);
  }

  int count() const { return static_cast<int>(row.size()); }
  int panel(int place) const { return row_panel[row[place]]; }
  // Positions (m) for points of the discretisation at x, 3 each.
  template <class T>
  std::vector<Three<T>> places(const std::vector<T>& x) const;
};
MeshFrame mesh_frame(const Gear& gear, const PartMap& map);

// Meshes at a position: position and one bar of each family (m); mesh opening across the panel (for
// square meshes the distance of bars, m) and mesh depth (m); angle between bars (rad). The angle is
// 0 for meshes closed across the panel, NaN if a bar has no length.
template <class T>
struct MeshPlace {
  Three<T> at, u, v;
  T opening{}, depth{}, angle{};
};
template <class T>
std::vector<MeshPlace<T>> mesh_places(const MeshFrame& frame, const std::vector<T>& x);

// Area (m2) normal to the flow that twine hides; overlapping twine counts once. across, up: unit
// vectors.
//
// A piece of netting with the projected area A transmits the fraction (1 - a_u / A) (1 - a_v / A),
// at least 0.01. Here a_u and a_v are the projected areas of its two families of bars. Pieces one
// behind the other transmit the product of their fractions, because twines of different pieces have
// random relative positions. The sum uses a grid normal to the flow; the cell area is the mean
// projected area of a position. Each position is divided into about 16 parts. The derivative
// neglects that parts move between cells.
template <class T>
T twine_shadow(const MeshFrame& frame, const std::vector<MeshPlace<T>>& found,
               const Three<double>& across, const Three<double>& up);

}  // namespace codend
