// Bows of the twines within a netting cell, one number s a cell.
//
// Bilinear places bow the twines of a cell with its twist q: those of u one way and those of v, which
// cross them, the other (cell_shape.hpp, where b of kappa is what bows make). Knots within a cell are
// free, though: where the twines of one family pull more they straighten, and bow the others as much
// more. With s from -1 to 1
//   L_u^2 = |e_u|^2 + (kappa_u - b_u) |q|^2 + b_u (1 - s)^2 |q|^2
//   L_v^2 = |e_v|^2 + (kappa_v - b_v) |q|^2 + b_v (1 + s)^2 |q|^2
// and s is where the energy is least: with k = T/L and what holds the twist besides,
//   s = (k_u b_u - k_v b_v)/(k_u b_u + k_v b_v)
// 0 where both pull alike; where one is slack the other is straight. So bows cost 4 k_u k_v/(k_u + k_v)
// instead of k_u + k_v. As s is at a least of the energy it does no work, and forces are those at this s
// (static condensation; E. L. Wilson, Int. J. Numer. Methods Eng. 8 (1974) 198-203).
//
// With l = dL/ds, m a line's modulus, A = m/L0 - T/L, and the stiffness of s, D = sum A l^2 +
// |q|^2 sum k b: where lengths change by dL and tensions have missed the law by strains r,
//   ds = -sum l (m r + A dL)/D,  dT = m (r + (dL + l ds)/L0)
// and the cell's stiffness is less by z_k z_l^T/D with z_k = sum A l G_k (netting_cell.hpp).
#pragma once

#include <vector>

#include "netting_cell.hpp"

namespace codend {

// Sets the bows of cells [begin, end) by the law, and what follows from them: weights of twist, what
// holds it, slopes. Vectors and twists of the lines are given.
void set_bows(const NettingCells& cells, const LineArrays& lines, int begin, int end);

// Leads them by a solver's tensions of one line each (N), from `bow`, one per cell, and sets lengths and
// strains too.
void lead_bows(const NettingCells& cells, const LineArrays& lines, int begin, int end,
               const double* tension, double* bow);

// Adds to changes of strain (per line, at the bows that there are) those by bows that go to where the law
// balances them after the change: not to first order, since bows of limp twines turn over at next to no
// change.
void change_bows(const NettingCells& cells, const LineArrays& lines, int begin, int end,
                 double* strain);

// Per line: tension and modulus (N), strain by which the tension misses the law (or null), change of
// strain at given bows (or null).
struct BowRequest {
  const double *tension, *modulus, *mismatch, *change;
};
// Adds l ds/L0 to `strain`, per line.
void add_bow_strains(const NettingCells& cells, const LineArrays& lines, int begin, int end,
                     const BowRequest& request, double* strain);

}  // namespace codend
