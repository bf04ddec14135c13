#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

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

}  // namespace codend
