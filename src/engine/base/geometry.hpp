#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

namespace codend {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
// Row-major, so that it maps a block of a solver's value array without a copy.
using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline Eigen::Map<const Vector> at(const double* values, int node) {
  return Eigen::Map<const Vector>(values + 3 * static_cast<std::ptrdiff_t>(node));
}
inline Eigen::Map<Vector> at(double* values, int node) {
  return Eigen::Map<Vector>(values + 3 * static_cast<std::ptrdiff_t>(node));
}

// Returns the largest distance of a vector from the mean of all (`count` vectors, 3 numbers each).
inline double largest_distance_from_mean(const double* values, int count) {
  Vector mean = Vector::Zero();
  for (int n = 0; n < count; ++n) mean += at(values, n) / count;
  double largest = 0.0;
  for (int n = 0; n < count; ++n) largest = std::max(largest, (at(values, n) - mean).norm());
  return largest;
}

}  // namespace codend
