// Netting as elements: cells of a panel's grid, or equivalent bars on its twines. Both put the same
// twine, knots, mass and projected area into the water, and both meet at the panel's edges.
//
// Mesh coordinates of a panel: i meshes across (from the left end of the upper edge), j meshes deep.
// Twine coordinates: diamond and turned meshes u = i + j, v = j - i; square meshes u = i, v = j; one
// unit is one bar.
#pragma once

#include <vector>

#include "collection.hpp"
#include "division.hpp"
#include "resolution.hpp"

namespace codend {

// Area of a cell in twine coordinates, which is the number of bars of each family inside.
double cell_area(const double* u, const double* v);
double triangle_area(const double* u, const double* v, int a, int b, int c);
// The four triangles of a cell's corners.
constexpr int corner_triangles[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

// What is drawn of a panel: cells by the place of their upper left corner in the grid, counted from 1;
// or knots and middles of bars with their mesh coordinates, by their nodes from 1, tied points -1, -2.
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

// Adds the netting of all panels: of bars, then of cells. Cells of hexagonal netting are halved along a
// diagonal, and where a panel ends in a point cells have three corners.
//
// Of equivalent bars knots lie lambda bars apart along the twines. Twines end where they cross an
// edge, and what lies on an edge is tied to the edge's nodes; there are no knots within a quarter of an
// equivalent mesh of an edge but where a twine runs nearly along it, and these are moved onto it.
// Multiplicities are scaled to the panel's exact length of twine. Panels whose drag is a screen's or
// blended, whose knots are stiff or that are a bag get sheets between the rows of their knots.
std::vector<DrawnPanel> add_netting(Collection& to, const Gear& gear, const Division& division,
                                    const Grouping& grouping);

// The same for some of the panels.
void add_bar_netting(Collection& to, const Gear& gear, const Division& division,
                     const Grouping& grouping, std::vector<DrawnPanel>& drawn);
void add_cell_netting(Collection& to, const Gear& gear, const Division& division,
                      std::vector<DrawnPanel>& drawn);

// Knots at a node, with the mass of their twine, as a sphere; count: joins of bars there.
void add_knots(Collection& to, const GearPanel& panel, int part, int node, double count);
// Mass and volume of so many m of twine at a node; extent: length (m) of the element that it is of.
void add_twine(Collection& to, const GearPanel& panel, int node, double length, double extent);

// Cells of four corners (0 to 3) as triangles: the diagonal changes sides at the panel's middle line
// (side -1, 0 or 1), so that a panel's mirror image is divided as its mirror image; in a middle column
// both diagonals have half weight.
struct HalfCell {
  int cell;
  const int* corner;
  double weight;
};
std::vector<HalfCell> half_cells(const std::vector<int>& cells, const std::vector<int>& side);

// Facets (3 places each) between the places of each row, in order of s, and the next one of the same
// panel: each place of two rows makes one with the last ones met of its own and of the other row.
std::vector<std::array<int, 3>> row_facets(const std::vector<int>& row,
                                           const std::vector<double>& s);

}  // namespace codend
