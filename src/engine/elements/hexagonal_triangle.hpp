// Triangles of hexagonal netting: three points with twine coordinates (u, v) and linear
// interpolation, so that all meshes of a triangle are identical (D. Priour, A Finite Element Method
// for Netting, Springer 2013, which also treats hexagonal meshes). Netting with knots of finite
// length uses this element too: the knots are short bars.
//
// Meshes repeat along the base vectors A = sum_k a_k x_k and B = sum_k b_k x_k. The coefficients a
// and b are those that a three-cornered cell has (cell_shape.hpp): one unit of u is one step A.
// Every unit cell has two nodes P and Q and three bars. The straight bar from P to Q is r. The
// oblique bars from Q to the next P are A - r and B - r. The triangle contains |d|/2 unit cells,
// times `multiplicity`.
//
// At the offset r the three bars are in equilibrium: T(r) = T(A - r) + T(B - r) as vectors. A
// fourth point of the element, at the triangle's centroid plus r, represents it. The solver treats
// this point like all others, so that bars stay tension-only on the path to the solution. Its
// elimination solves the 3x3 equations for r inside every triangle. At equilibrium the forces on
// the corners are the gradient of the energy minimised over r (envelope theorem).
//
// Half of every bar belongs to a P and half to a Q. The fourth point therefore takes 1/2 of drag
// and mass, and every corner 1/6.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "line.hpp"

namespace codend {

class HexagonalTriangles {
 public:
  static constexpr std::array<double, 4> share{1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0, 0.5};

  std::vector<int> node;             // 4 per triangle: corners and inner point
  std::vector<double> twine;         // u1 v1 u2 v2 u3 v3 per triangle
  std::vector<double> straight;      // length of the straight bars, m
  std::vector<double> oblique;       // length of the oblique bars, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<int> material;
  std::vector<double> height;  // vertical size at the free surface, m
  // Index of the first straight line in the model. Lines along A, then along B follow.
  int first_line = 0;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(straight.size()); }
  // which: 0 straight, 1 along A, 2 along B. The drag of the result is the drag of the whole line.
  Line<4> line(int triangle, int which) const;

  // Interpolates a quantity x (3 per point) as bar vectors are interpolated from positions. Covers
  // one family of triangles [begin, end); writes by component to e[.][0 .. end - begin).
  void vectors(int which, const double* x, int begin, int end, double* const e[3]) const;
  // Adds drag and pull to the points of all triangles. tension: of one line, N.
  void add_force(const LineArrays& lines, const double* tension, double* force) const;
  // Adds blocks from the derivatives of all lines (LineKernels::slopes). `slopes` lists the
  // triangles of each family in order.
  void add_jacobian(const double* slopes, const BlockSink& sink) const;
  // Adds the added mass of all triangles to their points, kg (9 per point).
  void add_added_mass(const LineArrays& lines, double* mass) const;

 private:
  std::vector<double> shape_, cells_;  // a1 a2 a3 b1 b2 b3 per triangle; |d|/2
};

}  // namespace codend
