// Shape functions of a netting cell: four corners with twine coordinates (u, v), in order around
// the cell. One unit of u is one bar along a u twine. A triangular cell repeats its last corner.
//
// The mean bar vectors over the cell are e_u = sum_k a_k x_k and e_v = sum_k b_k x_k, exact for
// bilinear positions. With n = k + 1 and l = k + 3 (mod 4)
//
//   D = (u2-u0)(v3-v1) - (u3-u1)(v2-v0),  a_k = (v_n - v_l)/D,  b_k = (u_l - u_n)/D.
//
// Within the cell bar vectors vary in proportion to one more vector, the twist q = sum_k g_k x_k.
// It is zero if positions are linear in u and v:
//
//   h = (1,-1,1,-1),  g_k = (h_k - (h.u) a_k - (h.v) b_k)/4
//
// The mean square of a family's bar vector over the cell is |e|^2 + kappa |q|^2, with
//
//   kappa = 1/3 sum_t A_t/(2A) ((a_t.h - a.h)/(g.h))^2
//
// over the four triangles t of its corners, with areas A_t and shape functions a_t. This is a third
// of their mean square, which is exact for a bilinear parallelogram:
//
// - (1/p^2 + 1/q^2)/3 for both families, if the sides cross p and q bars of each.
// - 4/(3 p^2) for u and 4/(3 q^2) for v, if the cell has p by q bars along its twines.
//
// The part b of kappa is due to the change of the bar vector along the family's own twines, their
// sag (sag.inl). It is all of kappa in a cell whose sides cross p by q meshes, and zero if the
// sides run along the twines. With half sides (u_s, v_s) and (u_t, v_t) and J = u_s v_t - v_s u_t,
// for u
//
//   b = min(kappa, (2 v_s v_t/(J^2 g.h))^2 (u_s^2 + u_t^2)/3)
//
// and for v the same with u and v exchanged.
#pragma once

namespace codend {

struct CellShape {
  double bars;             // |D|/2: number of bars of one family, and of knots
  double along[2][4];      // a, b, 1
  double twist[4];         // g, 1
  double twist_weight[2];  // kappa of u and v
  double sag_weight[2];    // b of u and v
  double share[4];         // fraction of an evenly distributed load at each corner; the sum is 1
  double amplitude;        // 1/(g.h): the motion h_k w has the twist w/amplitude
};

// twine: u and v of the four corners. A cell without area has no shape functions: the result is not
// finite.
CellShape cell_shape(const double* twine);

}  // namespace codend
