// Netting cells: four points with twine coordinates (u, v), whose twines of one family are parallel in
// the mean (cell_shape.hpp).
//
// One length stands for all bars of a family, the root mean square of their vectors over the cell:
//   len^2 = |e|^2 + kappa |q|^2,  e the mean bar vector, q the cell's twist
// with a kappa that tells how far its twines bow (bows.hpp).
// A cell has two constraints of length where its twines are stiff, and as there are as many cells as
// points, netting keeps one freedom a point: it does not lock. A triangle has two constraints too, but
// there are two triangles a point. The energy is W(len) of every bar, as of a line (twine.hpp); drag is
// that of all bars along e. A cell of three corners is a triangle of parallel, equally long bars
// (D. Priour, A Finite Element Method for Netting, Springer 2013).
//
// Nothing holds the twist of a slack cell, and netting that is slack then balances in many ways. So the
// twist is held, taut or slack, as by a tension of 1/2 rho d L0 V^2 in every bar, with V = 4 m/s: of the
// size of the drag of a bar or some, where a cell carries that of many. With 0.5 m/s the shipped dip
// net, slack all round, does not settle; with 4 m/s a hung panel's width at 1,000 nodes is 0.1 % more,
// at 5,000 nodes 0.02 %: it goes to nothing with the size of cells.
//
// The twist's own motion, which the cell's mean velocity does not see, is damped by the mean over all
// directions of the drag of its twines, c: over the cell its mean square is a ninth of that at the
// corners, so with w = amplitude sum_k g_k v_k corner k takes -amplitude g_k c w / 9.
#pragma once

#include <vector>

#include "cell_shape.hpp"
#include "line.hpp"

namespace codend {

class NettingCells {
 public:
  std::vector<int> node;      // 4 per cell; of three corners the last one twice
  std::vector<double> twine;  // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;   // bar length, m
  std::vector<double> multiplicity;
  std::vector<int> material;
  std::vector<double> height;  // over which it leaves the water, m; where there is a surface
  int first_line = 0;  // number of the first u line among the model's; v lines follow all u lines

  // Of cell_shape(), one array each with room for 7 cells more; from prepare().
  std::vector<double> along[2][4], twist[4], share[4], twist_weight[2], bow_weight[2], bars,
      amplitude;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(rest.size()); }
  // which: 0 along u, 1 along v. Its drag is of the whole line.
  Line<4> line(int cell, int which) const;

  // Mean bar vectors and twists of cells [begin, end) made from a quantity x (3 per point) as those of
  // the netting are from places, by component into u[.], v[.] and q[.][0 .. end - begin).
  void vectors(const double* x, int begin, int end, double* const u[3], double* const v[3],
               double* const q[3]) const;
  // Adds drag, and pull by given tensions of one line each (N), to the points of cells [begin, end).
  void add_force(const LineArrays& lines, const double* tension, int begin, int end,
                 double* force) const;
  // Adds added mass (kg, 9 per point) to the points of all cells.
  void add_added_mass(const LineArrays& lines, double* mass) const;
};

}  // namespace codend
