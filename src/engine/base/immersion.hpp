// How much of a body is under water when it crosses the surface at z = 0.
//
// A sphere of diameter h whose centre is at height z has the share s = t^2 (3 - 2 t) of its volume
// under water, t = 1/2 - z/h between 0 and 1 (a spherical cap). The same law is taken for bodies of
// other shapes, with h their height.
#pragma once

#include <algorithm>
#include <cmath>

namespace codend {

struct Immersion {
  double share, slope;      // s and ds/dz (1/m)
  double root, root_slope;  // sqrt(s), its derivative: the share of a speed whose square drags
};

inline Immersion immersion(double z, double height) {
  const double t = 0.5 - z / height;
  if (t >= 1.0) return {1.0, 0.0, 1.0, 0.0};
  if (t <= 0.0) return {0.0, 0.0, 0.0, 0.0};
  const double rest = 3.0 - 2.0 * t, root = std::sqrt(rest);
  return {t * t * rest, -6.0 * t * (1.0 - t) / height, t * root, -(root - t / root) / height};
}

}  // namespace codend
