// Triangles of hexagonal netting: three points with twine coordinates (u, v), linear inside, so
// that all meshes of a triangle are alike (D. Priour, A Finite Element Method for Netting, Springer
// 2013, which treats hexagonal meshes too). Netting whose knots have a length
// is of this kind too, with the knots as short bars.
//
// A mesh repeats along the lattice's base vectors A = sum_k a_k x_k and B = sum_k b_k x_k, a and b
// as of a cell of three corners (cell_shape.hpp): one unit of u is one step A. Every cell has two ends
// of bars, P and Q, and three bars: the straight one from P to Q, r, and the oblique ones from Q to the next P,
// A - r and B - r. The triangle holds |d|/2 cells, times `multiplicity`.
//
// The offset r is where the three bars balance, T(r) = T(A - r) + T(B - r) as vectors. It is a
// fourth point of the element, at the triangle's middle plus r: the solver finds it with all
// others, so that bars stay tension-only along its path, and its elimination is that of the 3x3
// equations for r inside every triangle. At balance the forces on the corners are those of the
// energy at its minimum over r (envelope theorem).
//
// Half of every bar belongs to a P and half to a Q, and so do drag and mass: a share of 1/2 acts on
// the fourth point and 1/6 on every corner.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "line.hpp"

namespace codend {

class HexagonalTriangles {
 public:
  static constexpr std::array<double, 4> share{1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0, 0.5};

  std::vector<int> node;             // 4 per triangle: its corners and the inner point
  std::vector<double> twine;         // u1 v1 u2 v2 u3 v3 per triangle
  std::vector<double> straight;      // length of the straight bars, m
  std::vector<double> oblique;       // length of the oblique bars, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<int> material;
  std::vector<double> height;  // over which it leaves the water, m; where there is a surface
  int first_line = 0;  // the straight lines' among the model's; then those along A, then along B

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(straight.size()); }
  // which: 0 straight, 1 along A, 2 along B. Its drag is of the whole line.
  Line<4> line(int triangle, int which) const;

  // Vectors of one family of triangles [begin, end) made from a quantity x (3 per point) as the
  // bars' are from positions, by component into e[.][0 .. end - begin).
  void vectors(int which, const double* x, int begin, int end, double* const e[3]) const;
  // Adds drag, and pull by given tensions of one line each (N), to the points of all triangles.
  void add_force(const LineArrays& lines, const double* tension, double* force) const;
  // Adds blocks from the slopes of all lines (see LineKernels::slopes), triangle after triangle in
  // each family.
  void add_jacobian(const double* slopes, const BlockSink& sink) const;
  // Adds added mass (kg, 9 per point) to the points of all triangles.
  void add_added_mass(const LineArrays& lines, double* mass) const;

 private:
  std::vector<double> shape_, cells_;  // a1 a2 a3 b1 b2 b3 per triangle; |d|/2
};

}  // namespace codend
