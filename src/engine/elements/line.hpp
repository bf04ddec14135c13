// What bars and triangles of netting share: one family of parallel lines whose vector is
// e = sum_k a_k x_k over N points; of bars and triangles drag is shared equally over them.
#pragma once

#include "../base/geometry.hpp"
#include "line_kernels.hpp"
#include "twine.hpp"

namespace codend {

template <int N>
struct Line {
  const int* nodes;
  double shape[N];               // a_k
  double rest;                   // L0, m
  double multiplicity;           // lines in parallel
  int material;                  // place among the model's
  int index;                     // among all lines of the model
  double point_share = 1.0 / N;  // of drag, in the arrays of lines

  Vector vector(const double* x) const {
    Vector e = Vector::Zero();
    for (int k = 0; k < N; ++k) e += shape[k] * at(x, nodes[k]);
    return e;
  }
};

// Added mass of a line, of what is in the water, a point's share, kg.
inline Block added_mass(const LineArrays& lines, int line) {
  const Vector t =
      lines.inverse_length[line] * Vector(lines.e[0][line], lines.e[1][line], lines.e[2][line]);
  Block mass = (lines.added_tangential[line] - lines.added_normal[line]) * (t * t.transpose());
  mass.diagonal().array() += lines.added_normal[line];
  if (lines.wet) mass *= lines.wet[line];
  return mass;
}

}  // namespace codend
