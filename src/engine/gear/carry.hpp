// Interpolates a shape from one discretisation to another of the same parts: to a finer mesh, or to
// a gear with other lengths. Every node keeps its relative position on its rope or panel.
#pragma once

#include <vector>

#include "netting.hpp"

namespace codend {

// Relative positions of the nodes on the parts of the gear.
struct PartMap {
  int nodes = 0, divided_nodes = 0;  // all; nodes of edges, ropes and points
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
  // Throws InputError if the map does not match the gear's parts, or contains invalid indices.
  // points: number of points of its shape, including tied points.
  void check(const Gear& gear, std::size_t points) const;
  // Returns the point index of a drawn node (DrawnPanel numbers).
  int point(int drawn) const { return drawn > 0 ? drawn - 1 : nodes - 1 - drawn; }
};
// Returns the map of a discretisation with `nodes` nodes, including interior nodes of netting.
PartMap part_map(const Gear& gear, const Division& division, int nodes,
                 const std::vector<DrawnPanel>& drawn);

// A position on a panel: fractions across (s, from the left edge) and deep (t, from the upper
// edge).
struct PanelPlace {
  int node, panel;
  double s, t;
};
std::vector<PanelPlace> panel_places(const Gear& gear, const PartMap& map);
// Appends the positions of grid nodes (panels of cells) to `out`.
void add_grid_places(std::vector<PanelPlace>& out, const PartMap& map);
// Position of the k-th knot or interior node of a panel of bars; `node` is a point index.
PanelPlace bar_place(const Gear& gear, const PartMap& map, int panel, std::size_t k);

// A point on the straight line between two points, at fraction `share`.
struct Between {
  int from, to;
  double share;
  Vector operator()(const double* position) const {
    if (share == 1.0) return at(position, to);
    const Vector first = at(position, from);
    return first + (Vector(at(position, to)) - first) * share;
  }
};

// Indices of the two neighbours of a value, and the fraction between them.
struct Beside {
  int low, high;
  double share;
};

// Rows of positions, sorted by group and depth, and within a row by the position across.
struct PlaceRows {
  std::vector<int> group;        // per row
  std::vector<double> t, t_key;  // depth of each row
  std::vector<int> row;          // per position
  std::vector<double> s, s_key;  // fraction across, per position

  void add_row(int of_group, double deep);
  // Adds a position to the last row.
  void add_place(double across);
  // Neighbouring rows of a group at a depth, and neighbouring positions in a row.
  Beside neighbouring_rows(int of_group, double deep) const;
  Beside beside(int of_row, double across) const;
};

// Shape of panels as rows from the left to the right edge: rows of a grid or of knots.
struct PanelRows : PlaceRows {
  std::vector<Between> at;
};
PanelRows panel_rows(const Gear& gear, const PartMap& map);

// Interpolates positions (m, 3 per node) of the nodes of `to` from all points of `from`.
std::vector<double> carry_positions(const Gear& gear, const PartMap& to, const PartMap& from,
                                    const std::vector<double>& position);

}  // namespace codend
