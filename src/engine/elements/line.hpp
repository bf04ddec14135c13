// One family of parallel lines, common to bars and netting. Its vector is e = sum_k a_k x_k over N
// points. In a netting cell the lines vary with the twist q = sum_k g_k x_k, and their length is
// sqrt(|e|^2 + kappa |q|^2).
#pragma once

#include <algorithm>
#include <cmath>

#include "../base/geometry.hpp"
#include "line_kernels.hpp"
#include "twine.hpp"

namespace codend {

template <int N>
struct Line {
  const int* nodes;
  double shape[N];               // a_k
  double rest;                   // L0, m
  double multiplicity;           // number of lines in parallel
  int material;                  // index into the model's materials
  int index;                     // index into all lines of the model
  double point_share = 1.0 / N;  // fraction of drag per point in the line arrays
  double twist[N] = {};          // g_k
  double twist_weight = 0.0;     // kappa
  double share[N] = {};          // fraction of drag at each point, if fractions differ

  // Length of one line with points at x (3 per point), m.
  double length(const double* x) const {
    Vector e = Vector::Zero(), q = Vector::Zero();
    for (int k = 0; k < N; ++k) {
      e += shape[k] * at(x, nodes[k]);
      q += twist[k] * at(x, nodes[k]);
    }
    return std::sqrt(e.squaredNorm() + twist_weight * q.squaredNorm());
  }
  // Rate of change of length (m/s) for velocities v of the points (m/s).
  double stretching(const LineArrays& lines, const double* v) const {
    Vector e_rate = Vector::Zero(), twist_rate = Vector::Zero();
    for (int k = 0; k < N; ++k) {
      e_rate += shape[k] * at(v, nodes[k]);
      twist_rate += twist[k] * at(v, nodes[k]);
    }
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
      sum += lines.e[c][index] * e_rate[c];
      if (twist_weight > 0.0) {
        sum += lines.twist_weight[index] * lines.twist[c][index] * twist_rate[c];
      }
    }
    return lines.inverse_length[index] * sum;
  }
  // Energy (J) of the additional stiffness against twist (netting_cell.hpp). `held_power` is its
  // power (W) on points that move at v (m/s).
  double held_energy(const LineArrays& lines) const {
    if (twist_weight == 0.0) return 0.0;
    return 0.5 * lines.twist_stiffness[index] * twist_of(lines).squaredNorm();
  }
  double held_power(const LineArrays& lines, const double* v) const {
    if (twist_weight == 0.0) return 0.0;
    Vector twist_rate = Vector::Zero();
    for (int k = 0; k < N; ++k) twist_rate += twist[k] * at(v, nodes[k]);
    return -lines.twist_stiffness[index] * twist_of(lines).dot(twist_rate);
  }
  // Largest force at point k per unit of tension.
  double pull_at(int k) const {
    return std::sqrt(shape[k] * shape[k] + twist_weight * twist[k] * twist[k]);
  }

 private:
  Vector twist_of(const LineArrays& lines) const {
    return {lines.twist[0][index], lines.twist[1][index], lines.twist[2][index]};
  }
};

// Added mass of the immersed part of a line, one point's fraction, kg. A slack line is curved: the
// fraction L/L0 counts along the chord, the remainder isotropically.
inline Block added_mass(const LineArrays& lines, int line) {
  const Vector t =
      lines.inverse_span[line] * Vector(lines.e[0][line], lines.e[1][line], lines.e[2][line]);
  const double along = lines.added_tangential[line] - lines.added_normal[line];
  const double straight = std::clamp(1.0 + lines.strain[line], 0.0, 1.0);
  Block mass = straight * along * (t * t.transpose());
  mass.diagonal().array() += lines.added_normal[line] + (1.0 - straight) / 3.0 * along;
  if (lines.wet) mass *= lines.wet[line];
  return mass;
}

}  // namespace codend
