// Sag (curvature) of the twines within a netting cell, described by one parameter s per cell.
//
// Bilinear interpolation of positions bends the twines of a cell in proportion to its twist q.
// Twines of u and of v bend in opposite directions (cell_shape.hpp, where b is the part of kappa
// due to sag). However, knots within a cell can move: the family with the higher tension
// straightens and bends the other family more. With s from -1 to 1
//
//   L_u^2 = |e_u|^2 + (kappa_u - b_u) |q|^2 + b_u (1 - s)^2 |q|^2
//   L_v^2 = |e_v|^2 + (kappa_v - b_v) |q|^2 + b_v (1 + s)^2 |q|^2
//
// and s minimises the energy. With k = T/L plus the additional stiffness against twist,
//   s = (k_u b_u - k_v b_v)/(k_u b_u + k_v b_v).
// If k b is equal in both families, s is 0. If one family is slack, the other is straight. The
// stiffness of sag is therefore 4 k_u k_v/(k_u + k_v) instead of k_u + k_v. At the minimum s does
// no work, so that forces are the forces at fixed s (static condensation; E. L. Wilson, Int. J.
// Numer. Methods Eng. 8 (1974) 198-203).
//
// Derivatives: let l = dL/ds, m the modulus of a line, A = m/L0 - T/L, and D = sum A l^2 + |q|^2
// sum k b the stiffness of s. If lengths change by dL and tensions differ from the constitutive law
// by strains r,
//   ds = -sum l (m r + A dL)/D,  dT = m (r + (dL + l ds)/L0).
// The cell's stiffness decreases by z_k z_l^T/D with z_k = sum A l G_k (netting_cell.hpp).
#pragma once

#include <vector>

#include "netting_cell.hpp"

namespace codend {

// Computes the sag of cells [begin, end) from the constitutive law. Sets twist weights, twist
// stiffnesses and dL/ds of their lines. Requires the vectors and twists of the lines.
void set_sag(const NettingCells& cells, const LineArrays& lines, int begin, int end);

// Computes the sag from given tensions (N, one line each), starting from `sag` (s, one per cell),
// which it updates. Also sets lengths and strains.
void lead_sag(const NettingCells& cells, const LineArrays& lines, int begin, int end,
              const double* tension, double* sag);

// Corrects changes of strain at fixed sag (per line) for the change of sag: s moves to its
// equilibrium by the constitutive law after the change. This is not linearised, because the sag of
// slack twines reverses with almost no change of length.
void change_sag(const NettingCells& cells, const LineArrays& lines, int begin, int end,
                double* strain);

// Arrays per line: tension and modulus (N), difference of the tension from the constitutive law as
// a strain (or null), change of strain at fixed sag (or null).
struct BowRequest {
  const double *tension, *modulus, *mismatch, *change;
};
// Adds l ds/L0 to `strain`, per line.
void add_sag_strains(const NettingCells& cells, const LineArrays& lines, int begin, int end,
                     const BowRequest& request, double* strain);

}  // namespace codend
