#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "node_graph.hpp"
#include "solve/assembly_tree.hpp"
#include "solve/compressed_graph.hpp"
#include "solve/ordering.hpp"

namespace {

using codend::AssemblyTree;
using codend::BlockPattern;
using codend::grid;
using codend::NodeGraph;
using codend::SeparatorTree;

// Adds a node in the middle of every edge, as in netting of bars, and a line of nodes that hangs
// from the first one.
NodeGraph with_middles(const NodeGraph& mesh, int line) {
  NodeGraph out;
  for (int i = 0; i < mesh.nodes(); ++i) out.add(0, 0, 0);
  for (int i = 0; i < mesh.nodes(); ++i)
    for (const int j : mesh.neighbours[i]) {
      if (j <= i) continue;
      const int middle = out.add(0, 0, 0);
      out.join(i, middle);
      out.join(middle, j);
    }
  for (int k = 0, from = 0; k < line; ++k) {
    const int next = out.add(0, 0, 0);
    out.join(from, next);
    from = next;
  }
  return out;
}

bool is_ancestor(const SeparatorTree& tree, int above, int vertex) {
  while (vertex >= 0 && vertex < above) vertex = tree.parent[vertex];
  return vertex == above;
}

}  // namespace

TEST_CASE("nested dissection assigns each node once and separates the parts") {
  NodeGraph mesh = grid(23, 17);
  std::vector<double>& x = mesh.places;
  SUBCASE("with coordinates") {}
  SUBCASE("with all nodes at one place") { std::fill(x.begin(), x.end(), 0.0); }
  SUBCASE("with a coordinate that is not a number") { x[30] = std::nan(""); }
  SUBCASE("with nodes of two neighbours") {
    const std::vector<double> places = x;
    mesh = with_middles(mesh, 37);
    std::copy(places.begin(), places.end(), x.begin());
  }
  SUBCASE("with nothing but nodes of two neighbours") { mesh = grid(1, 300); }
  const BlockPattern pattern = mesh.pattern();
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

TEST_CASE("first separator of a grid is one line of nodes") {
  // 40 x 15: a separator that halves it has at least 15 nodes
  NodeGraph mesh = grid(40, 15);
  SUBCASE("with coordinates") {}
  SUBCASE("stretched so that the widest direction cuts worst") {
    for (size_t i = 0; i < mesh.places.size(); i += 3) mesh.places[i] *= 100;
  }
  const SeparatorTree tree = codend::nested_dissection(mesh.pattern(), mesh.places.data());
  const int root = static_cast<int>(tree.parent.size()) - 1;
  CHECK(tree.first_node[root + 1] - tree.first_node[root] == 15);
}

TEST_CASE("compression removes bar middles and free ends and joins the knots") {
  // a closed grid, so that every knot has four neighbours
  const int rows = 7, columns = 9;
  NodeGraph mesh = grid(rows, columns);
  for (int i = 0; i < rows; ++i) mesh.join(i * columns, i * columns + columns - 1);
  for (int j = 0; j < columns; ++j) mesh.join(j, (rows - 1) * columns + j);
  const BlockPattern knots = mesh.pattern();
  const codend::CompressedGraph graph = codend::compress(with_middles(mesh, 1).pattern());
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

TEST_CASE("chain has the fill of a binary tree") {
  // a chain cut at single nodes: a front has at most two neighbours
  const NodeGraph mesh = grid(1, 300);
  const BlockPattern pattern = mesh.pattern();
  const AssemblyTree tree = assembly_tree(pattern, nested_dissection(pattern, mesh.places.data()));
  for (int f = 0; f < tree.fronts(); ++f) CHECK(tree.boundary_nodes(f) <= 2);
}

TEST_CASE("fronts contain exactly the fill of elimination") {
  const NodeGraph mesh = grid(14, 13);
  const BlockPattern pattern = mesh.pattern();
  const AssemblyTree tree = assembly_tree(pattern, nested_dissection(pattern, mesh.places.data()));

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
