#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "solve/vertex_cut.hpp"

namespace {

using codend::Side;

struct Graph {
  std::vector<std::vector<char>> joined;
  std::vector<int> first, last, neighbour, weight;

  int nodes() const { return static_cast<int>(joined.size()); }
  codend::CutGraph view() const {
    return {first.data(), last.data(), neighbour.data(), weight.data()};
  }
};

Graph random_graph(int nodes, double edges_per_pair, unsigned seed) {
  std::mt19937 generator(seed);
  Graph graph;
  graph.joined.assign(nodes, std::vector<char>(nodes, 0));
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < i; ++j)
      graph.joined[i][j] = graph.joined[j][i] = generator() < edges_per_pair * 4294967296.0;
  for (int i = 0; i < nodes; ++i) {
    graph.first.push_back(static_cast<int>(graph.neighbour.size()));
    for (int j = 0; j < nodes; ++j)
      if (graph.joined[i][j]) graph.neighbour.push_back(j);
    graph.last.push_back(static_cast<int>(graph.neighbour.size()));
    graph.weight.push_back(1 + static_cast<int>(generator() % 3));
  }
  return graph;
}

// Returns the smallest number of nodes whose removal disconnects `from` and `to`, by trying all
// sets. Nodes of the two ends count.
int least_separator(const Graph& graph, const std::vector<char>& from,
                    const std::vector<char>& to) {
  const int n = graph.nodes();
  int least = n;
  for (unsigned removed = 0; removed < 1u << n; ++removed) {
    int count = 0;
    for (int i = 0; i < n; ++i) count += removed >> i & 1;
    if (count >= least) continue;
    std::vector<int> queue;
    unsigned seen = removed;
    bool through = false;
    const auto reach = [&](int i) {
      if (seen >> i & 1) return;
      seen |= 1u << i;
      queue.push_back(i);
      through = through || to[i];
    };
    for (int i = 0; i < n; ++i)
      if (from[i]) reach(i);
    for (size_t q = 0; q < queue.size() && !through; ++q)
      for (int j = 0; j < n; ++j)
        if (graph.joined[queue[q]][j]) reach(j);
    if (!through) least = count;
  }
  return least;
}

}  // namespace

TEST_CASE("separator of one layer is smallest among nodes at the cut") {
  const int nodes = 12;
  codend::VertexCut cut(nodes);
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Graph graph = random_graph(nodes, seed % 2 ? 0.15 : 0.35, seed);
    std::vector<Side> side(nodes);
    std::vector<char> near(nodes, 0), far(nodes, 0);
    int64_t total = 0;
    for (int i = 0; i < nodes; ++i) {
      side[i] = i < nodes / 2 ? codend::near_side : codend::far_side;
      total += graph.weight[i];
      for (int j = 0; j < nodes; ++j)
        if (graph.joined[i][j] && (i < nodes / 2) != (j < nodes / 2))
          (i < nodes / 2 ? near : far)[i] = 1;
    }
    // only the edges of the cut: a path inside a side needs no cut
    Graph across = graph;
    for (int i = 0; i < nodes; ++i)
      for (int j = 0; j < nodes; ++j)
        if ((i < nodes / 2) == (j < nodes / 2)) across.joined[i][j] = 0;
    cut.separate(graph.view(), 0, nodes, total, 1, 0.0, side.data());
    const auto separator = std::count(side.begin(), side.end(), codend::separator_side);
    CHECK(separator == least_separator(across, near, far));
    for (int i = 0; i < nodes; ++i)
      for (int j = 0; j < nodes; ++j)
        if (graph.joined[i][j])
          CHECK_FALSE((side[i] == codend::near_side && side[j] == codend::far_side));
  }
}

TEST_CASE("separator of several layers finds the neck nearby") {
  // two strips of 6 x 9 nodes joined by a neck of 2 x 3; the cut is two columns from the neck
  const int rows = 6, columns = 21;
  std::vector<int> number(rows * columns, -1);
  int nodes = 0;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      if (j < 9 || j > 11 || i == 2 || i == 3) number[i * columns + j] = nodes++;
  Graph graph;
  graph.joined.assign(nodes, std::vector<char>(nodes, 0));
  std::vector<Side> side(nodes);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int here = number[i * columns + j];
      if (here < 0) continue;
      side[here] = j < 7 ? codend::near_side : codend::far_side;
      for (const int other : {i + 1 < rows ? number[(i + 1) * columns + j] : -1,
                              j + 1 < columns ? number[i * columns + j + 1] : -1})
        if (other >= 0) graph.joined[here][other] = graph.joined[other][here] = 1;
    }
  for (int a = 0; a < nodes; ++a) {
    graph.first.push_back(static_cast<int>(graph.neighbour.size()));
    for (int b = 0; b < nodes; ++b)
      if (graph.joined[a][b]) graph.neighbour.push_back(b);
    graph.last.push_back(static_cast<int>(graph.neighbour.size()));
    graph.weight.push_back(1);
  }
  codend::VertexCut cut(nodes);
  int expected = 0;
  int layers = 0;
  double share = 0.1;
  SUBCASE("out of reach") {
    layers = 1;
    expected = 6;
  }
  SUBCASE("within reach") {
    layers = 4;
    expected = 2;
  }
  SUBCASE("within reach, but too uneven") {
    layers = 4;
    share = 0.6;
    expected = 6;
  }
  cut.separate(graph.view(), 0, nodes, nodes, layers, share, side.data());
  CHECK(std::count(side.begin(), side.end(), codend::separator_side) == expected);
}
