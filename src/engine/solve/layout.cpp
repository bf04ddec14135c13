#include "layout.hpp"

#include <algorithm>
#include <utility>

#include "../base/geometry.hpp"
#include "block_lu.hpp"

namespace codend {
namespace {

// Ratio of the stiffness of a node at the surface to its stiffness from strings.
constexpr double surface_stiffness = 1e6;

}  // namespace

void lay_out(const StringNet& net, double* x, const std::function<bool()>& watch) {
  const int nodes = static_cast<int>(net.held.size());
  const std::size_t strings = net.rest.size();
  std::vector<int> unknown(nodes, -1), free;
  for (int n = 0; n < nodes; ++n) {
    if (net.held[n]) continue;
    unknown[n] = static_cast<int>(free.size());
    free.push_back(n);
  }
  const int n = static_cast<int>(free.size());
  if (n == 0) return;
  std::vector<std::vector<int>> row(n);
  for (std::size_t s = 0; s < strings; ++s) {
    const int i = unknown[net.ends[2 * s]], j = unknown[net.ends[2 * s + 1]];
    if (i < 0 || j < 0) continue;
    row[i].push_back(j);
    row[j].push_back(i);
  }
  const BlockPattern pattern = block_pattern(std::move(row));
  auto block = [&](int i, int j) {
    return static_cast<std::size_t>(9 * find_block(pattern, i, j));
  };
  // The shape is unknown, so node numbers serve as coordinates.
  std::vector<double> coordinates(3 * static_cast<std::size_t>(n), 0.0);
  for (int i = 0; i < n; ++i) coordinates[3 * static_cast<std::size_t>(i)] = i;
  BlockLU lu;
  lu.analyse(pattern, coordinates.data());

  std::vector<double> density(strings);
  double largest = 0.0;
  for (std::size_t s = 0; s < strings; ++s) {
    density[s] = net.tension[s] / net.rest[s];
    largest = std::max(largest, density[s]);
  }
  std::vector<double> values(9 * pattern.column.size()), right(3 * static_cast<std::size_t>(n));
  // Every buoyant node starts at the surface. Strings pull some nodes down.
  std::vector<char> at_surface(n, 0);
  for (int i = 0; i < n && !net.buoyant.empty(); ++i) at_surface[i] = net.buoyant[free[i]];
  for (int round = 0; round < 40; ++round) {
    if (watch && !watch()) return;
    std::fill(values.begin(), values.end(), 0.0);
    for (int i = 0; i < n; ++i) at(right.data(), i) = at(net.load.data(), free[i]);
    for (std::size_t s = 0; s < strings; ++s) {
      const int ends[2] = {net.ends[2 * s], net.ends[2 * s + 1]};
      for (int k = 0; k < 2; ++k) {
        const int i = unknown[ends[k]], j = unknown[ends[1 - k]];
        if (i < 0) continue;
        for (int d = 0; d < 3; ++d) values[block(i, i) + 4 * d] += density[s];
        if (j >= 0) {
          for (int d = 0; d < 3; ++d) values[block(i, j) + 4 * d] -= density[s];
        } else {
          at(right.data(), i) += density[s] * at(x, ends[1 - k]);
        }
      }
    }
    for (int i = 0; i < n; ++i) {
      if (at_surface[i]) values[block(i, i) + 8] *= surface_stiffness;
    }
    if (!lu.factorise(values.data())) return;
    lu.solve(right.data(), right.data());
    for (int i = 0; i < n; ++i) {
      at(x, free[i]) = at(right.data(), i);
      if (!net.buoyant.empty() && net.buoyant[free[i]]) at_surface[i] = at(x, free[i]).z() >= 0.0;
    }
    for (std::size_t s = 0; s < strings; ++s) {
      const double length = (at(x, net.ends[2 * s + 1]) - at(x, net.ends[2 * s])).norm();
      density[s] *= std::clamp(length / net.rest[s], 0.3, 10.0);
      density[s] = std::max(density[s], 1e-7 * largest);
    }
  }
}

}  // namespace codend
