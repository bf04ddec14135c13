// The linear shape of a cell of netting: four corners with twine coordinates (u, v), in order around
// it. One unit of u is one bar along a u twine. A cell of three corners has its last one twice.
//
// With n = k + 1 and l = k + 3 (mod 4) the mean bar vectors over the cell are e_u = sum_k a_k x_k,
// e_v = sum_k b_k x_k (exactly, of bilinear places):
//   D = (u2-u0)(v3-v1) - (u3-u1)(v2-v0),  a_k = (v_n - v_l)/D,  b_k = (u_l - u_n)/D
// and bar vectors differ within it by one more vector, its twist q = sum_k g_k x_k, which is zero
// where places are linear in u and v:
//   h = (1,-1,1,-1),  g_k = (h_k - (h.u) a_k - (h.v) b_k)/4
// The mean square of a family's bar vector over the cell is |e|^2 + kappa |q|^2, with
//   kappa = 1/3 sum_t A_t/(2A) ((a_t.h - a.h)/(g.h))^2
// over the four triangles t of its corners, of areas A_t and shapes a_t: their mean square at a third,
// which is exact of a bilinear parallelogram: (1/p^2 + 1/q^2)/3 of both families, of a cell whose
// sides run across p and q bars of each; 4/(3 p^2) of u and 4/(3 q^2) of v, of one of p by q bars.
//
// What of kappa changes along a family's own twines, b, is their bow (bows.hpp): all of it in a cell
// whose sides run across p by q meshes, nothing where they run along the twines. With half sides
// (u_s, v_s) and (u_t, v_t) and J = u_s v_t - v_s u_t it is for u
//   b = (2 v_s v_t/(J^2 g.h))^2 (u_s^2 + u_t^2)/3, and no more than kappa
// and for v the same with u and v exchanged.
#pragma once

namespace codend {

struct CellShape {
  double bars;             // |D|/2, of one family; as many knots
  double along[2][4];      // a, b, 1
  double twist[4];         // g, 1
  double twist_weight[2];  // kappa of u and v
  double bow_weight[2];    // b of u and v
  double share[4];         // of what is spread evenly over the cell, of each corner; their sum is 1
  double amplitude;        // 1/(g.h): of the motion h_k w, of which the twist is w/amplitude
};

// twine: u and v of the four corners. A cell without area has no shape: its numbers are not finite.
CellShape cell_shape(const double* twine);

}  // namespace codend
