#include "cell_shape.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

constexpr double h[4] = {1.0, -1.0, 1.0, -1.0};
constexpr int corners[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

// a_t.h and b_t.h of a triangle of three corners, and its area.
struct TriangleShape {
  double along[2], area;
};
TriangleShape triangle_shape(const double* twine, const int* corner) {
  const double *p = twine + 2 * corner[0], *q = twine + 2 * corner[1], *r = twine + 2 * corner[2];
  const double d = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  const double hp = h[corner[0]], hq = h[corner[1]], hr = h[corner[2]];
  return {{(hp * (q[1] - r[1]) + hq * (r[1] - p[1]) + hr * (p[1] - q[1])) / d,
           (hp * (r[0] - q[0]) + hq * (p[0] - r[0]) + hr * (q[0] - p[0])) / d},
          0.5 * std::abs(d)};
}

// Computes the sag part b of kappa for u and v. The cell is replaced by the parallelogram whose
// sides are the means of opposite sides. of_h: g.h.
void sag_weights(const double* twine, double of_h, double* weight) {
  double across[2], down[2];  // half sides: u and v components
  for (int f = 0; f < 2; ++f) {
    const double* c = twine + f;
    across[f] = 0.25 * (-c[0] + c[2] + c[4] - c[6]);
    down[f] = 0.25 * (-c[0] - c[2] + c[4] + c[6]);
  }
  const double area = across[0] * down[1] - across[1] * down[0];
  for (int f = 0; f < 2; ++f) {
    const double bend = 2.0 * across[1 - f] * down[1 - f] / (area * area * of_h);
    weight[f] = bend * bend * (across[f] * across[f] + down[f] * down[f]) / 3.0;
  }
}

}  // namespace

CellShape cell_shape(const double* twine) {
  constexpr double third = 1.0 / 3.0, no_area = 1e-9, rounding = 1e-24;
  const double *u = twine, *v = twine + 1;  // corner k is at index 2 k
  CellShape s{};
  const double d = (u[4] - u[0]) * (v[6] - v[2]) - (u[6] - u[2]) * (v[4] - v[0]);
  s.bars = 0.5 * std::abs(d);
  double hu = 0.0, hv = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int next = 2 * ((k + 1) % 4), last = 2 * ((k + 3) % 4);
    s.along[0][k] = (v[next] - v[last]) / d;
    s.along[1][k] = (u[last] - u[next]) / d;
    hu += h[k] * u[2 * k];
    hv += h[k] * v[2 * k];
  }
  double of_h = 0.0, mean[2] = {0.0, 0.0};
  for (int k = 0; k < 4; ++k) {
    s.twist[k] = 0.25 * (h[k] - hu * s.along[0][k] - hv * s.along[1][k]);
    of_h += s.twist[k] * h[k];
    for (int f = 0; f < 2; ++f) mean[f] += s.along[f][k] * h[k];
  }
  for (const int* t : corners) {
    const TriangleShape triangle = triangle_shape(twine, t);
    if (triangle.area <= no_area * s.bars) continue;
    const double weight = triangle.area / (2.0 * s.bars);
    for (int k = 0; k < 3; ++k) s.share[t[k]] += third * weight;
    for (int f = 0; f < 2; ++f) {
      const double c = (triangle.along[f] - mean[f]) / of_h;
      s.twist_weight[f] += third * weight * c * c;
    }
  }
  sag_weights(twine, of_h, s.sag_weight);
  for (int f = 0; f < 2; ++f) {
    s.sag_weight[f] = std::min(s.sag_weight[f], s.twist_weight[f]);
    if (s.sag_weight[f] < rounding * s.twist_weight[f]) s.sag_weight[f] = 0.0;
  }
  s.amplitude = 1.0 / of_h;
  if (u[4] == u[6] && v[4] == v[6]) {  // three corners have no twist
    std::fill(s.twist, s.twist + 4, 0.0);
    s.twist_weight[0] = s.twist_weight[1] = s.sag_weight[0] = s.sag_weight[1] = 0.0;
    s.amplitude = 0.0;
  }
  return s;
}

}  // namespace codend
