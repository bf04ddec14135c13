// Drag of one family of parallel twines, by the same model as for lines (twine.hpp). Elements that
// weight this drag use it; lines use the vectorised line_kernels.hpp.
#pragma once

#include "../base/geometry.hpp"
#include "../base/water.hpp"
#include "twine.hpp"

namespace codend {

struct TwineDrag {
  Vector value;        // N
  Matrix by_vector;    // derivative by the vector along the twine, N/m
  Matrix by_velocity;  // derivative by the relative velocity of the water, N s/m
};

// Computes the drag of twines with the total rest length `metres` (m). Each has the rest length
// `rest` (m) and the vector e (m). u: relative velocity of the water, m/s.
TwineDrag twine_drag(const TwineMaterial& material, double metres, double rest, const Vector& e,
                     const Vector& u, const Water& water, SlackDrag slack);

}  // namespace codend
