// What bars and netting triangles share: one family of parallel lines whose vector is
// e = sum_k a_k x_k over N points and whose drag is shared equally over them.
#pragma once

#include "../geometry.hpp"
#include "twine.hpp"

namespace codend {

template <int N>
struct Line {
  const int* nodes;
  double shape[N];         // a_k
  double rest;             // L0, m
  double multiplicity;     // lines in parallel
  const TwineMaterial* material;
  int index;               // among all lines of the model

  Vector vector(const double* x) const {
    Vector e = Vector::Zero();
    for (int k = 0; k < N; ++k) e += shape[k] * at(x, nodes[k]);
    return e;
  }
};

}  // namespace codend
