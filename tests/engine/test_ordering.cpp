#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "solve/assembly_tree.hpp"
#include "solve/compressed_graph.hpp"
#include "solve/ordering.hpp"

namespace {

using codend::AssemblyTree;
using codend::BlockPattern;
using codend::SeparatorTree;

// A grid of rows x columns nodes, each joined to its neighbours along the two directions.
BlockPattern grid(int rows, int columns) {
  BlockPattern pattern;
  pattern.n = rows * columns;
  pattern.row_start.push_back(0);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int k = i * columns + j;
      if (i > 0) pattern.column.push_back(k - columns);
      if (j > 0) pattern.column.push_back(k - 1);
      pattern.column.push_back(k);
      if (j + 1 < columns) pattern.column.push_back(k + 1);
      if (i + 1 < rows) pattern.column.push_back(k + columns);
      pattern.row_start.push_back(static_cast<int64_t>(pattern.column.size()));
    }
  return pattern;
}

// The graph with a node in the middle of every edge, as netting of bars has, and a line of nodes
// hung from its first one.
BlockPattern with_middles(const BlockPattern& pattern, int line) {
  std::vector<std::vector<int>> neighbours(pattern.n);
  const auto join = [&](int a, int b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
      if (pattern.column[e] <= i) continue;
      const int middle = static_cast<int>(neighbours.size());
      neighbours.emplace_back();
      join(i, middle);
      join(middle, pattern.column[e]);
    }
  for (int k = 0, from = 0; k < line; ++k) {
    const int next = static_cast<int>(neighbours.size());
    neighbours.emplace_back();
    join(from, next);
    from = next;
  }
  return codend::block_pattern(std::move(neighbours));
}

std::vector<double> flat(int rows, int columns) {
  std::vector<double> x;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) x.insert(x.end(), {1.0 * j, 1.0 * i, 0.0});
  return x;
}

bool is_ancestor(const SeparatorTree& tree, int above, int vertex) {
  while (vertex >= 0 && vertex < above) vertex = tree.parent[vertex];
  return vertex == above;
}

}  // namespace

TEST_CASE("nested dissection owns each node once and separates") {
  BlockPattern pattern = grid(23, 17);
  std::vector<double> x = flat(23, 17);
  SUBCASE("with coordinates") {}
  SUBCASE("with all nodes at one place") { std::fill(x.begin(), x.end(), 0.0); }
  SUBCASE("with a coordinate that is not a number") { x[30] = std::nan(""); }
  SUBCASE("with nodes of two neighbours") {
    pattern = with_middles(pattern, 37);
    x.resize(3 * static_cast<size_t>(pattern.n), 0.0);
  }
  SUBCASE("with nothing but nodes of two neighbours") {
    pattern = grid(1, 300);
    x = flat(1, 300);
  }
  const SeparatorTree tree = codend::nested_dissection(pattern, x.data());
  std::vector<int> owner(pattern.n, -1);
  for (size_t t = 0; t < tree.parent.size(); ++t) {
    CHECK((tree.parent[t] == -1 || tree.parent[t] > static_cast<int>(t)));
    for (int i = tree.first_node[t]; i < tree.first_node[t + 1]; ++i) {
      CHECK(owner[tree.node[i]] == -1);
      owner[tree.node[i]] = static_cast<int>(t);
    }
  }
  CHECK(*std::min_element(owner.begin(), owner.end()) == 0);
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
      const int a = owner[i], b = owner[pattern.column[e]];
      CHECK(is_ancestor(tree, std::max(a, b), std::min(a, b)));
    }
}

TEST_CASE("the first separator of a grid is one line of its nodes") {
  // 40 x 15: no set of fewer than 15 nodes halves it
  std::vector<double> x = flat(40, 15);
  SUBCASE("with coordinates") {}
  SUBCASE("stretched so that the widest direction cuts worst") {
    for (size_t i = 0; i < x.size(); i += 3) x[i] *= 100;
  }
  const SeparatorTree tree = codend::nested_dissection(grid(40, 15), x.data());
  const int root = static_cast<int>(tree.parent.size()) - 1;
  CHECK(tree.first_node[root + 1] - tree.first_node[root] == 15);
}

TEST_CASE("compression takes bar middles and free ends out and joins the knots") {
  // a closed grid, so that every knot has four neighbours
  const int rows = 7, columns = 9;
  std::vector<std::vector<int>> neighbours(rows * columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int k = i * columns + j;
      for (const int other : {i * columns + (j + 1) % columns, (i + 1) % rows * columns + j}) {
        neighbours[k].push_back(other);
        neighbours[other].push_back(k);
      }
    }
  const BlockPattern knots = codend::block_pattern(std::move(neighbours));
  const codend::CompressedGraph graph = codend::compress(with_middles(knots, 1));
  REQUIRE(static_cast<int>(graph.node.size()) == knots.n);
  for (int i = 0; i < knots.n; ++i) {
    CHECK(graph.node[i] == i);
    std::vector<int> row(graph.neighbour.begin() + graph.first[i],
                         graph.neighbour.begin() + graph.first[i + 1]);
    row.push_back(i);
    std::sort(row.begin(), row.end());
    CHECK(row == std::vector<int>(knots.column.begin() + knots.row_start[i],
                                  knots.column.begin() + knots.row_start[i + 1]));
    // each with half of its four middles, and knot 0 with the free end
    CHECK(graph.weight[i] == (i == 0 ? 4 : 3) * graph.weight[1] / 3);
  }
}

TEST_CASE("the fill of a chain is that of its tree of halves") {
  // a chain cut at single nodes: no front has more than two neighbours
  const BlockPattern pattern = grid(1, 300);
  const std::vector<double> x = flat(1, 300);
  const AssemblyTree tree = assembly_tree(pattern, nested_dissection(pattern, x.data()));
  for (int f = 0; f < tree.fronts(); ++f) CHECK(tree.boundary_nodes(f) <= 2);
}

TEST_CASE("fronts hold exactly what elimination fills in") {
  const BlockPattern pattern = grid(14, 13);
  const std::vector<double> x = flat(14, 13);
  const AssemblyTree tree = assembly_tree(pattern, nested_dissection(pattern, x.data()));

  std::vector<int> sorted = tree.order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(pattern.n);
  std::iota(all.begin(), all.end(), 0);
  CHECK(sorted == all);

  // eliminate node by node on a dense pattern
  std::vector<std::vector<char>> filled(pattern.n, std::vector<char>(pattern.n, 0));
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      filled[tree.position[i]][tree.position[pattern.column[e]]] = 1;
  for (int p = 0; p < pattern.n; ++p)
    for (int i = p + 1; i < pattern.n; ++i)
      for (int j = p + 1; j < pattern.n; ++j)
        if (filled[i][p] && filled[p][j]) filled[i][j] = 1;

  for (int f = 0; f < tree.fronts(); ++f) {
    std::vector<int> expected;
    for (int q = tree.first_pivot[f + 1]; q < pattern.n; ++q)
      for (int p = tree.first_pivot[f]; p < tree.first_pivot[f + 1]; ++p)
        if (filled[p][q]) {
          expected.push_back(q);
          break;
        }
    const std::vector<int> boundary(tree.boundary.begin() + tree.first_boundary[f],
                                    tree.boundary.begin() + tree.first_boundary[f + 1]);
    CHECK(boundary == expected);

    const int up = tree.parent[f];
    int mapped = 0;
    for (int64_t r = tree.first_run[f]; r < tree.first_run[f + 1]; ++r)
      for (int i = 0; i < tree.run[r].length; ++i, ++mapped) {
        CHECK(tree.run[r].from + i == mapped);
        const int to = tree.run[r].to + i;
        const int position = to < tree.pivots(up)
                                 ? tree.first_pivot[up] + to
                                 : tree.boundary[tree.first_boundary[up] + to - tree.pivots(up)];
        CHECK(position == boundary[mapped]);
      }
    CHECK(mapped == (up < 0 ? 0 : tree.boundary_nodes(f)));
  }
}
