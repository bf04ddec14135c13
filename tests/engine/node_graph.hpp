// Graphs of nodes with positions, and matrices of 3 x 3 blocks on them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <random>
#include <vector>

#include "base/block_pattern.hpp"

namespace codend {

struct NodeGraph {
  std::vector<double> places;  // three per node
  std::vector<std::vector<int>> neighbours;

  int nodes() const { return static_cast<int>(neighbours.size()); }
  int add(double x, double y, double z) {
    places.insert(places.end(), {x, y, z});
    neighbours.emplace_back();
    return nodes() - 1;
  }
  void join(int a, int b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  BlockPattern pattern() const { return block_pattern(neighbours); }
};

// Nodes in rows and columns, each joined to the next one in both directions.
inline NodeGraph grid(int rows, int columns) {
  NodeGraph mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int k = mesh.add(j, i, 0.0);
      if (i > 0) mesh.join(k, k - columns);
      if (j > 0) mesh.join(k, k - 1);
    }
  return mesh;
}

// Random numbers from -1 to 1, the same with every compiler.
inline std::vector<double> random_vector(std::size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<double> v(size);
  for (double& x : v) x = generator() / 2147483648.0 - 1;
  return v;
}

// Calls visit(row, column, nine values) for every block.
template <class Values, class Visit>
void each_block(const BlockPattern& pattern, Values& values, Visit visit) {
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      visit(i, pattern.column[e], &values[9 * e]);
}

// Springs of stiffness(i, j) between neighbours, each with a non-symmetric fraction, and `own` on
// every node.
template <class Stiffness>
std::vector<double> springs(const BlockPattern& pattern, Stiffness stiffness, double share,
                            double own, unsigned seed) {
  std::vector<double> values = random_vector(9 * pattern.column.size(), seed);
  for (int i = 0; i < pattern.n; ++i) {
    double* diagonal = &values[9 * find_block(pattern, i, i)];
    for (int q = 0; q < 9; ++q) diagonal[q] = q % 4 == 0 ? own : 0.0;
  }
  each_block(pattern, values, [&](int i, int j, double* block) {
    if (i == j) return;
    double* diagonal = &values[9 * find_block(pattern, i, i)];
    const double s = stiffness(i, j);
    for (int q = 0; q < 9; ++q) {
      block[q] *= share * s;
      if (q % 4 != 0) continue;
      block[q] -= s;
      diagonal[q] += s;
    }
  });
  return values;
}

inline Eigen::MatrixXd dense(const BlockPattern& pattern, const std::vector<double>& values) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * pattern.n, 3 * pattern.n);
  each_block(pattern, values, [&](int i, int j, const double* block) {
    out.block<3, 3>(3 * i, 3 * j) =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(block);
  });
  return out;
}

}  // namespace codend
