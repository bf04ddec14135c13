// Drag of one family of parallel twines at a time, the same as that of lines (twine.hpp), for
// elements that weigh it. Lines themselves are computed many at a time (line_kernels.hpp).
#pragma once

#include "../base/geometry.hpp"
#include "../base/water.hpp"
#include "twine.hpp"

namespace codend {

struct TwineDrag {
  Vector value;        // N
  Matrix by_vector;    // by the vector along the twine, N/m
  Matrix by_velocity;  // by the velocity of the water relative to it, N s/m
};

// Of twines of this many metres in all at their rest length `rest` (m) each, whose vectors are e
// (m), in water of relative velocity u (m/s).
TwineDrag twine_drag(const TwineMaterial& material, double metres, double rest, const Vector& e,
                     const Vector& u, const Water& water, SlackDrag slack);

}  // namespace codend
