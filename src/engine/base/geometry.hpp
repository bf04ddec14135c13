// Small fixed-size vectors and matrices of the engine (Eigen's).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace codend {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
// A block inside a solver's value array: row-major, so that it needs no copy.
using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline Eigen::Map<const Vector> at(const double* values, int node) {
  return Eigen::Map<const Vector>(values + 3 * static_cast<std::ptrdiff_t>(node));
}
inline Eigen::Map<Vector> at(double* values, int node) {
  return Eigen::Map<Vector>(values + 3 * static_cast<std::ptrdiff_t>(node));
}

}  // namespace codend
