// How the meshes of netting stand in a shape, and what its twine hides of the flow.
//
// With x_i and x_j the derivatives of position by meshes across and by meshes down a panel, a mesh of
// diamonds has the bars (x_j + x_i) / 2 and (x_j - x_i) / 2, one of squares the bars x_i and x_j.
#pragma once

#include <vector>

#include "../gear/carry.hpp"
#include "dual.hpp"

namespace codend {

// Panels as rows of places with what of their meshes does not move. Places and rows follow each other.
struct MeshFrame {
  std::vector<double> width, unit;  // per panel: of its twine across the flow, length of a mesh, m
  std::vector<char> square, turned;
  std::vector<int> row_panel;  // per row
  std::vector<double> row_t;
  // Per place: its row and share across; the points between which it lies and the share of the way.
  std::vector<int> row;
  std::vector<double> s;
  std::vector<int> from, to;
  std::vector<double> share;
  // At the same share across in the rows above and below: the places on both sides, the share between.
  std::vector<int> above, above_next, below, below_next;
  std::vector<double> above_share, below_share;
  std::vector<double> per_mesh, per_row, slant;  // 1/meshes across, down; how columns lean
  // Meshes that a place stands for, and how far these reach from it to all sides.
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
  // The places themselves (m) where all points of the lattice are at x, 3 each.
  template <class T>
  std::vector<Three<T>> places(const std::vector<T>& x) const;
};
MeshFrame mesh_frame(const Gear& gear, const PartMap& map);

// The meshes at a place: the place and one bar of each family (m), how wide a mesh stands across its
// panel (of squares the distance of the bars) and its depth (m), and the angle between its bars (rad, 0
// where it is closed across the panel; not a number where a bar has no length).
template <class T>
struct MeshPlace {
  Three<T> at, u, v;
  T opening{}, depth{}, angle{};
};
template <class T>
std::vector<MeshPlace<T>> mesh_places(const MeshFrame& frame, const std::vector<T>& x);

// Area (m2) across the flow that all twine hides; twine behind other twine counts once. across, up: unit
// vectors.
//
// A piece of netting that casts a shadow of the area A lets the share (1 - a_u / A) (1 - a_v / A) of it
// through, a_u and a_v the areas that its two families of bars show, and never less than a hundredth.
// Pieces one behind another let through the product of their shares: seen along the flow, twines of
// different pieces lie anyhow to each other. That is summed up over a grid across the flow whose cells
// are as large as the shadow of a place on the mean; each place is cut into 16 parts or so. Its
// derivative leaves out that parts move from cell to cell.
template <class T>
T twine_shadow(const MeshFrame& frame, const std::vector<MeshPlace<T>>& found,
               const Three<double>& across, const Three<double>& up);

}  // namespace codend
