#include "compressed_graph.hpp"

#include <algorithm>
#include <numeric>

namespace codend {

namespace {

constexpr int node_weight = 4;  // can be halved twice

}  // namespace

CompressedGraph compress(const BlockPattern& pattern) {
  CompressedGraph graph;
  const int n = pattern.n;
  std::vector<int>& neighbour = graph.neighbour;
  neighbour.reserve(pattern.column.size() - n);
  std::vector<int> first(n), last(n);
  for (int i = 0; i < n; ++i) {
    first[i] = static_cast<int>(neighbour.size());
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      if (pattern.column[e] != i) neighbour.push_back(pattern.column[e]);
    last[i] = static_cast<int>(neighbour.size());
  }
  std::vector<int> weight(n, node_weight), place(n, -1), seen(n, -1);
  graph.node.resize(n);
  std::iota(graph.node.begin(), graph.node.end(), 0);
  while (true) {
    const size_t before = graph.eliminated.size();
    // place: index in graph.eliminated; neighbours of eliminated nodes wait for the next round
    for (const int i : graph.node) {
      const int degree = last[i] - first[i];
      if (degree == 0 || degree > 2 || seen[i] >= 0) continue;
      const int a = neighbour[first[i]], b = degree == 2 ? neighbour[first[i] + 1] : -1;
      place[i] = static_cast<int>(graph.eliminated.size());
      graph.eliminated.push_back({i, {a, b}});
      seen[a] = 0;
      if (b >= 0) seen[b] = 0;
      weight[a] += b >= 0 ? weight[i] / 2 : weight[i];
      if (b >= 0) weight[b] += weight[i] - weight[i] / 2;
    }
    if (graph.eliminated.size() == before) break;
    size_t kept = 0;
    for (const int i : graph.node)
      if (place[i] < 0) graph.node[kept++] = i;
    graph.node.resize(kept);
    std::fill(seen.begin(), seen.end(), -1);
    for (const int i : graph.node) {
      int to = first[i];
      for (int e = first[i]; e < last[i]; ++e) {
        int other = neighbour[e];
        if (place[other] >= 0) {
          const int* ends = graph.eliminated[place[other]].neighbours;
          other = ends[0] == i ? ends[1] : ends[0];
        }
        if (other < 0 || seen[other] == i) continue;
        seen[other] = i;
        neighbour[to++] = other;
      }
      last[i] = to;
    }
    std::fill(seen.begin(), seen.end(), -1);
    if (graph.eliminated.size() - before < kept / 8) break;
  }
  for (size_t k = 0; k < graph.node.size(); ++k) place[graph.node[k]] = static_cast<int>(k);
  int to = 0;
  for (const int i : graph.node) {
    graph.first.push_back(to);
    for (int e = first[i]; e < last[i]; ++e) neighbour[to++] = place[neighbour[e]];
    graph.weight.push_back(weight[i]);
  }
  graph.first.push_back(to);
  neighbour.resize(to);
  return graph;
}

SeparatorTree expand(const CompressedGraph& graph, const SeparatorTree& tree) {
  const int vertices = static_cast<int>(tree.parent.size());
  const int eliminated = static_cast<int>(graph.eliminated.size());
  const int n = static_cast<int>(graph.node.size()) + eliminated;
  // Vertex `vertices + k` is the k-th eliminated node. Its parent is the deeper vertex of its
  // two neighbours; the other vertex is an ancestor.
  std::vector<int> owner(n), depth(vertices + eliminated, 0);
  std::vector<int> first_below(vertices + eliminated, -1), next(eliminated, -1);
  for (int t = vertices - 1; t >= 0; --t) {
    for (int i = tree.first_node[t]; i < tree.first_node[t + 1]; ++i)
      owner[graph.node[tree.node[i]]] = t;
    if (tree.parent[t] >= 0) depth[t] = depth[tree.parent[t]] + 1;
  }
  for (int k = eliminated - 1; k >= 0; --k) {
    const auto& [node, neighbours] = graph.eliminated[k];
    int above = owner[neighbours[0]];
    if (neighbours[1] >= 0 && depth[owner[neighbours[1]]] > depth[above])
      above = owner[neighbours[1]];
    owner[node] = vertices + k;
    depth[vertices + k] = depth[above] + 1;
    next[k] = first_below[above];
    first_below[above] = k;
  }

  SeparatorTree result;
  result.node.reserve(n);
  result.parent.reserve(vertices + eliminated);
  result.first_node.assign(1, 0);
  std::vector<int> number(vertices), orphans;
  struct Open {
    int vertex;
    int below;       // next eliminated node to be numbered before it
    size_t orphans;  // start of its finished vertices without a parent
  };
  std::vector<Open> open;
  for (int t = 0; t < vertices; ++t) {
    open.assign(1, {t, first_below[t], 0});
    while (!open.empty()) {
      Open& top = open.back();
      if (top.below >= 0) {
        const int k = top.below;
        top.below = next[k];
        open.push_back({vertices + k, first_below[vertices + k], orphans.size()});
        continue;
      }
      const int mine = static_cast<int>(result.parent.size());
      if (top.vertex >= vertices) {
        result.node.push_back(graph.eliminated[top.vertex - vertices].node);
      } else {
        for (int i = tree.first_node[t]; i < tree.first_node[t + 1]; ++i)
          result.node.push_back(graph.node[tree.node[i]]);
      }
      result.first_node.push_back(static_cast<int>(result.node.size()));
      result.parent.push_back(-1);
      for (size_t i = top.orphans; i < orphans.size(); ++i) result.parent[orphans[i]] = mine;
      orphans.resize(top.orphans);
      if (top.vertex < vertices)
        number[t] = mine;
      else
        orphans.push_back(mine);
      open.pop_back();
    }
  }
  for (int t = 0; t < vertices; ++t)
    if (tree.parent[t] >= 0) result.parent[number[t]] = number[tree.parent[t]];
  return result;
}

}  // namespace codend
