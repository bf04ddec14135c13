// Netting cells: four points with twine coordinates (u, v). The twines of one family are parallel
// on average (cell_shape.hpp).
//
// One length represents all bars of a family, the root mean square of their vectors over the cell:
//
//   len^2 = |e|^2 + kappa |q|^2,  e the mean bar vector, q the cell's twist
//
// kappa depends on the sag of the twines (sag.inl). The energy is W(len) for every bar, as for a
// line (twine.hpp). Drag is computed for all bars along e. A three-cornered cell is a triangle of
// parallel, equally long bars (D. Priour, A Finite Element Method for Netting, Springer 2013).
//
// Cells do not lock. Stiff twines impose two length constraints per cell, and there are as many
// cells as points, so that one degree of freedom per point remains. A triangle also has two
// constraints, but there are two triangles per point.
//
// A slack cell has no stiffness against twist, and slack netting then has many equilibria.
// Therefore an additional stiffness acts on the twist of taut and slack cells. It equals a tension
// of 1/2 rho d L0 V^2 in every bar, with V^2 = (2 U)^2 + 400 g d. U is the speed of the water past
// the gear (Water::speed) and d the twine's diameter, so that the law follows Froude's scaling. This
// force is about the drag of one or a few bars, and a cell carries the drag of many. The effect
// vanishes with the size of cells.
//
// The twist's own motion, which does not contribute to the cell's mean velocity, is damped by c.
// This is the mean over all directions of the drag of the cell's twines. The mean square of the
// motion over the cell is a ninth of the mean square at the corners. With w = amplitude sum_k g_k
// v_k corner k therefore takes -amplitude g_k c w / 9.
#pragma once

#include <vector>

#include "cell_shape.hpp"
#include "line.hpp"

namespace codend {

class NettingCells {
 public:
  std::vector<int> node;      // 4 per cell; a triangle repeats its last corner
  std::vector<double> twine;  // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;   // bar length, m
  std::vector<double> multiplicity;
  std::vector<int> material;
  std::vector<double> height;  // vertical size at the free surface, m
  int first_line = 0;          // index of the first u line in the model; v lines follow all u lines

  // Results of cell_shape(), one array each with space for 7 more cells; set by prepare().
  std::vector<double> along[2][4], twist[4], share[4], twist_weight[2], sag_weight[2], bars,
      amplitude;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(rest.size()); }
  CellArrays arrays() const;
  // which: 0 along u, 1 along v. The drag of the result is the drag of the whole line.
  Line<4> line(int cell, int which) const;

  // Interpolates a quantity x (3 per point) of cells [begin, end) as mean bar vectors and twists
  // are interpolated from positions. Writes by component to u[.], v[.] and q[.][0 .. end - begin).
  void vectors(const double* x, int begin, int end, double* const u[3], double* const v[3],
               double* const q[3]) const;
  // Adds the added mass of all cells to their points, kg (9 per point).
  void add_added_mass(const LineArrays& lines, double* mass) const;
};

}  // namespace codend
