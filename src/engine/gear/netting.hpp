// Netting as elements: cells of a panel's grid, or equivalent bars along its twines. Both have the
// same twine, knots, mass and projected area, and both share the nodes of the panel's edges.
//
// Mesh coordinates of a panel: i meshes across (from the left end of the upper edge), j meshes
// deep. Twine coordinates: u = i + j, v = j - i for diamond and turned meshes, u = i, v = j for
// square meshes. One unit is one bar.
#pragma once

#include <vector>

#include "collection.hpp"
#include "division.hpp"
#include "resolution.hpp"

namespace codend {

// Area of a cell in twine coordinates: the number of bars of each family inside.
double cell_area(const double* u, const double* v);
double triangle_area(const double* u, const double* v, int a, int b, int c);
// The four triangles of a cell's corners.
constexpr int corner_triangles[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

// Drawing data of a panel. Cells: index of the upper left corner in the grid, from 1. Bars: knots
// and interior nodes with mesh coordinates. Their node numbers start from 1; tied points are -1,
// -2, ...
struct DrawnPanel {
  bool bars = false;
  std::vector<int> cell, node;
  std::vector<double> i, j;
  double lambda = 0.0;
  int segments = 0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("bars", bars);
    visit.list("cell", cell);
    visit.list("node", node);
    visit.list("i", i);
    visit.list("j", j);
    visit("lambda", lambda);
    visit("segments", segments);
  }
};

// Adds the netting of all panels: panels of bars, then panels of cells. Cells of hexagonal netting
// are triangles. At the tip of a panel, cells have three corners.
//
// Knots of equivalent bars are lambda bars apart along the twines. Twines end at an edge, and
// points on an edge are tied to the edge's nodes. Knots within a quarter of an equivalent mesh of
// an edge are omitted. If a twine runs nearly along the edge, they are moved to it instead.
// Multiplicities are scaled to the panel's exact twine length. Sheets between the rows of knots are
// added to panels with screen or blended drag, stiff knots or bag contents.
std::vector<DrawnPanel> add_netting(Collection& to, const Gear& gear, const Division& division,
                                    const Grouping& grouping);

// The same for panels of bars or of cells only.
void add_bar_netting(Collection& to, const Gear& gear, const Division& division,
                     const Grouping& grouping, std::vector<DrawnPanel>& drawn);
void add_cell_netting(Collection& to, const Gear& gear, const Division& division,
                      std::vector<DrawnPanel>& drawn);

// Adds knots at a node as a sphere, with the mass of their twine. count: number of bar junctions.
void add_knots(Collection& to, const GearPanel& panel, int part, int node, double count);
// Adds mass and volume of `length` m of twine at a node. extent: length of its element, m.
void add_twine(Collection& to, const GearPanel& panel, int node, double length, double extent);

// Triangles of quadrilateral cells (corners 0 to 3). The diagonal changes at the panel's middle
// line (side -1, 0 or 1), so that mirrored panels get mirrored meshes. In a middle column both
// diagonals have weight 1/2.
struct HalfCell {
  int cell;
  const int* corner;
  double weight;
};
std::vector<HalfCell> half_cells(const std::vector<int>& cells, const std::vector<int>& side);

// Returns facets (3 indices each) between consecutive rows of positions, each row sorted by s. Each
// position forms a facet with the previous positions of both rows.
std::vector<std::array<int, 3>> row_facets(const std::vector<int>& row,
                                           const std::vector<double>& s);

}  // namespace codend
