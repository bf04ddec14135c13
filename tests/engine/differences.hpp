// Matrices of an assembly as dense matrices, and by finite differences of its forces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/assembly.hpp"
#include "node_graph.hpp"

namespace codend {

constexpr double difference = 2e-5;  // m, m/s

using Dense = Eigen::MatrixXd;

inline Dense dense(const Assembly& assembly, const std::vector<double>& values) {
  return dense(assembly.pattern(), values);
}

// Returns -dF/dy on the free nodes by differences; y is x or v, force(F) fills 3 values per node.
template <class Force>
Dense by_differences(const Assembly& assembly, std::vector<double>& y, Force force) {
  const std::vector<int>& free = assembly.free_nodes();
  const std::size_t size = y.size();
  Dense out(3 * free.size(), 3 * free.size());
  std::vector<double> f[4] = {std::vector<double>(size), std::vector<double>(size),
                              std::vector<double>(size), std::vector<double>(size)};
  const double steps[4] = {1.0, -1.0, 2.0, -2.0}, weights[4] = {8.0, -8.0, -1.0, 1.0};
  for (std::size_t j = 0; j < free.size(); ++j) {
    for (int c = 0; c < 3; ++c) {
      double& moved = y[3 * static_cast<std::size_t>(free[j]) + c];
      const double before = moved;
      for (int k = 0; k < 4; ++k) {
        moved = before + steps[k] * difference;
        force(f[k]);
      }
      moved = before;
      for (std::size_t i = 0; i < free.size(); ++i) {
        for (int r = 0; r < 3; ++r) {
          double sum = 0.0;
          for (int k = 0; k < 4; ++k) {
            sum += weights[k] * f[k][3 * static_cast<std::size_t>(free[i]) + r];
          }
          out(3 * i + r, 3 * j + c) = -sum / (12.0 * difference);
        }
      }
    }
  }
  return out;
}

}  // namespace codend
