// Carries a shape from one lattice to another of the same parts: to a finer division, or to a gear with
// other lengths. Every node goes where its place on its rope or panel is on the old shape.
#pragma once

#include <vector>

#include "netting.hpp"

namespace codend {

// Where the nodes of a lattice lie on the parts of its gear.
struct PartMap {
  int nodes = 0, divided_nodes = 0;  // all, and those of edges, ropes and points
  EdgeNodes edges;
  std::vector<Grid> grids;
  std::vector<NodeRun> ropes;
  std::vector<int> points;  // their nodes
  std::vector<DrawnPanel> panels;

  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit("divided_nodes", divided_nodes);
    visit.count(Among::nodes, static_cast<std::size_t>(nodes));
    visit.group("edges", edges);
    visit.items("grids", grids);
    visit.items("ropes", ropes);
    visit.list("points", points, {1, Among::nodes});
    visit.items("panels", panels);
  }
  // Throws InputError where it is not one of a gear with these parts, or refers to what is not there;
  // points: of its shape, with tied ones.
  void check(const Gear& gear, std::size_t points) const;
  // Of a drawn node, as it is numbered there, its number among all points.
  int point(int drawn) const { return drawn > 0 ? drawn - 1 : nodes - 1 - drawn; }
};
// nodes: of the lattice, with those that netting has of its own.
PartMap part_map(const Gear& gear, const Division& division, int nodes,
                 const std::vector<DrawnPanel>& drawn);

// A place on a panel: shares across and deep, from its left and its upper edge.
struct PanelPlace {
  int node, panel;
  double s, t;
};
std::vector<PanelPlace> panel_places(const Gear& gear, const PartMap& map);
// Those of the nodes of grids, the panels of cells, at the end of `out`.
void add_grid_places(std::vector<PanelPlace>& out, const PartMap& map);
// That of the k-th knot or middle of a bar of a panel of bars; its node as a number among all points.
PanelPlace bar_place(const Gear& gear, const PartMap& map, int panel, std::size_t k);

// A place on the straight line between two points.
struct Between {
  int from, to;
  double share;
  Vector operator()(const double* position) const {
    if (share == 1.0) return at(position, to);
    const Vector first = at(position, from);
    return first + (Vector(at(position, to)) - first) * share;
  }
};

// The values (0 to 1) of a group next to one in it, and the share of the way between them.
struct Beside {
  int low, high;
  double share;
};

// Rows of places, row after row: of a group each, by group and how deep they are, their places by how far
// across.
struct PlaceRows {
  std::vector<int> group;        // of every row
  std::vector<double> t, t_key;  // and how deep it is
  std::vector<int> row;          // of every place
  std::vector<double> s, s_key;  // and how far across

  void add_row(int of_group, double deep);
  // To the last row.
  void add_place(double across);
  // The rows of a group next to a depth, and the places of a row next to a share across.
  Beside rows_beside(int of_group, double deep) const;
  Beside beside(int of_row, double across) const;
};

// The shape of panels as such rows, each from the left edge to the right edge: the rows of a grid, or those
// of knots.
struct PanelRows : PlaceRows {
  std::vector<Between> at;
};
PanelRows panel_rows(const Gear& gear, const PartMap& map);

// Positions (m, 3 per node) of the nodes of `to`, from those of all points of `from`.
std::vector<double> carry_positions(const Gear& gear, const PartMap& to, const PartMap& from,
                                    const std::vector<double>& position);

}  // namespace codend
