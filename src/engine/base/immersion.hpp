// Immersed fraction of a body at the water surface z = 0.
//
// A sphere of diameter h with its centre at height z has the immersed volume fraction
//
//   s = t^2 (3 - 2 t),  t = 1/2 - z/h between 0 and 1 (spherical cap).
//
// Bodies of other shapes use the same formula, with h their height.
#pragma once

#include <algorithm>
#include <cmath>

namespace codend {

struct Immersion {
  double share, slope;      // s and ds/dz (1/m)
  double root, root_slope;  // sqrt(s) and its derivative; scales a speed so that drag scales with s
};

inline Immersion immersion(double z, double height) {
  if (2.0 * z <= -height) return {1.0, 0.0, 1.0, 0.0};
  if (2.0 * z >= height) return {0.0, 0.0, 0.0, 0.0};
  const double t = 0.5 - z / height;
  const double rest = 3.0 - 2.0 * t, root = std::sqrt(rest);
  return {t * t * rest, -6.0 * t * (1.0 - t) / height, t * root, -(root - t / root) / height};
}

}  // namespace codend
