// Netting triangles: three points with twine coordinates (u, v), linear inside, so that all twines
// of one family in a triangle are parallel and equally long (D. Priour, A Finite Element Method
// for Netting, Springer 2013). One unit of u is one bar along a u twine.
//
// With d = (u2-u1)(v3-v1) - (u3-u1)(v2-v1) the bar vectors are e_u = sum_k a_k x_k,
// a = (v2-v3, v3-v1, v1-v2)/d, and e_v = sum_k b_k x_k, b = (u3-u2, u1-u3, u2-u1)/d. The triangle
// holds |d|/2 bars of each family and |d|/2 knots, times `multiplicity`.
#pragma once

#include <cmath>
#include <vector>

#include "line.hpp"

namespace codend {

class NettingTriangles {
 public:
  std::vector<int> node;             // 3 per triangle
  std::vector<double> twine;         // u1 v1 u2 v2 u3 v3 per triangle
  std::vector<double> rest;          // bar length, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<int> material;
  std::vector<double> height;  // over which it leaves the water, m; where there is a surface
  int first_line = 0;  // number of the first u line among the model's; v lines follow all u lines

  // a1 a2 a3 b1 b2 b3, one array each with room for 7 triangles more, and d; from prepare().
  std::vector<double> shape[6], twice_bars;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(rest.size()); }
  Line<3> u_line(int triangle) const { return family(triangle, 0); }
  Line<3> v_line(int triangle) const { return family(triangle, 1); }

  // Vectors of triangles [begin, end) made from a quantity x (3 per point) as e_u and e_v from
  // positions, by component into u[.] and v[.][0 .. end - begin).
  void vectors(const double* x, int begin, int end, double* const u[3], double* const v[3]) const;
  // Adds drag, and pull by given tensions of one line each (N), to the points of all triangles.
  void add_force(const LineArrays& lines, const double* tension, double* force) const;
  // Adds added mass (kg, 9 per point) to the points of all triangles.
  void add_added_mass(const LineArrays& lines, double* mass) const;

 private:
  Line<3> family(int triangle, int which) const {
    const std::size_t e = static_cast<std::size_t>(triangle);
    const std::vector<double>* a = shape + 3 * which;
    return {&node[3 * e], {a[0][e], a[1][e], a[2][e]},
            rest[e],      0.5 * std::abs(twice_bars[e]) * multiplicity[e],
            material[e],  first_line + which * count() + triangle};
  }
};

}  // namespace codend
