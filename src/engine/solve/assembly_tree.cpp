#include "assembly_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace codend {

namespace {

struct Lists {
  std::vector<int64_t> first{0};
  std::vector<int> item;

  void close() { first.push_back(static_cast<int64_t>(item.size())); }
  const int* begin(int i) const { return item.data() + first[i]; }
  const int* end(int i) const { return item.data() + first[i + 1]; }
  int size(int i) const { return static_cast<int>(first[i + 1] - first[i]); }
};

Lists lists_by(const std::vector<int>& key, int keys) {
  Lists lists;
  lists.first.assign(keys + 1, 0);
  for (int k : key)
    if (k >= 0) ++lists.first[k + 1];
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  lists.item.resize(lists.first.back());
  std::vector<int64_t> next(lists.first.begin(), lists.first.end() - 1);
  for (size_t i = 0; i < key.size(); ++i)
    if (key[i] >= 0) lists.item[next[key[i]]++] = static_cast<int>(i);
  return lists;
}

// Returns, per vertex, the nodes outside its subtree that its elimination fills in.
Lists boundaries(const BlockPattern& pattern, const SeparatorTree& tree, const Lists& children) {
  const int vertices = static_cast<int>(tree.parent.size());
  std::vector<int> owner(pattern.n), seen(pattern.n, -1);
  for (int t = 0; t < vertices; ++t)
    for (int i = tree.first_node[t]; i < tree.first_node[t + 1]; ++i) owner[tree.node[i]] = t;
  Lists lists;
  for (int t = 0; t < vertices; ++t) {
    const auto add = [&](int node) {
      if (owner[node] <= t || seen[node] == t) return;
      seen[node] = t;
      lists.item.push_back(node);
    };
    for (int i = tree.first_node[t]; i < tree.first_node[t + 1]; ++i) {
      const int node = tree.node[i];
      for (int64_t e = pattern.row_start[node]; e < pattern.row_start[node + 1]; ++e)
        add(pattern.column[e]);
    }
    for (const int* c = children.begin(t); c != children.end(t); ++c)
      for (int64_t i = lists.first[*c]; i < lists.first[*c + 1]; ++i) add(lists.item[i]);
    lists.close();
  }
  return lists;
}

// Estimates the seconds to assemble and factorise a front: a fixed cost, a cost per entry cleared
// and assembled, and one per multiplication and subtraction. Only the ratios matter, and the result
// is insensitive. Doubling or halving one changes the time of a factorisation by a few per cent
// (sheets, tubes and chains of 200 to 10 000 nodes).
double front_seconds(double pivots, double boundary) {
  const double k = 3 * pivots, b = 3 * boundary;
  const double multiplications = k * k * k / 3 + k * k * b + k * b * b;
  return 1.5e-7 + 6e-10 * (k + b) * (k + b) + 1e-10 * multiplications;
}

// Returns the vertex that each vertex is merged into; a vertex that remains maps to itself.
std::vector<int> merge(const SeparatorTree& tree, const Lists& children, const Lists& boundary) {
  const int vertices = static_cast<int>(tree.parent.size());
  std::vector<int> pivots(vertices), into(vertices);
  std::iota(into.begin(), into.end(), 0);
  for (int t = 0; t < vertices; ++t) pivots[t] = tree.first_node[t + 1] - tree.first_node[t];
  std::vector<int> waiting;
  for (int t = 0; t < vertices; ++t) {
    waiting.assign(children.begin(t), children.end(t));
    // the child with the largest boundary has most nodes in common with its parent
    std::stable_sort(waiting.begin(), waiting.end(),
                     [&](int a, int b) { return boundary.size(a) > boundary.size(b); });
    for (int c : waiting) {
      const double apart =
          front_seconds(pivots[c], boundary.size(c)) + front_seconds(pivots[t], boundary.size(t));
      if (front_seconds(pivots[c] + pivots[t], boundary.size(t)) > apart) continue;
      into[c] = t;
      pivots[t] += pivots[c];
    }
  }
  for (int t = vertices - 1; t >= 0; --t) into[t] = into[into[t]];
  return into;
}

// Returns the remaining vertices, each after its descendants, with a minimal stack.
std::vector<int> elimination_order(const std::vector<int>& into, const std::vector<int>& parent,
                                   Lists children, const Lists& boundary) {
  const int vertices = static_cast<int>(parent.size());
  std::vector<double> peak(vertices, 0);
  const auto update = [&](int t) { return 9.0 * boundary.size(t) * boundary.size(t); };
  for (int t = 0; t < vertices; ++t) {
    if (into[t] != t) continue;
    int* first = children.item.data() + children.first[t];
    int* last = children.item.data() + children.first[t + 1];
    std::stable_sort(first, last,
                     [&](int a, int b) { return peak[a] - update(a) > peak[b] - update(b); });
    double held = 0;
    for (const int* c = first; c != last; ++c) {
      peak[t] = std::max(peak[t], held + peak[*c]);
      held += update(*c);
    }
    peak[t] = std::max(peak[t], held + update(t));
  }
  std::vector<int> sequence, stack;
  for (int t = 0; t < vertices; ++t) {
    if (into[t] != t || parent[t] >= 0) continue;
    // a front before its children, the last child first; reversed below
    const size_t start = sequence.size();
    stack.assign(1, t);
    while (!stack.empty()) {
      const int top = stack.back();
      stack.pop_back();
      sequence.push_back(top);
      stack.insert(stack.end(), children.begin(top), children.end(top));
    }
    std::reverse(sequence.begin() + start, sequence.end());
  }
  return sequence;
}

void map_boundaries(AssemblyTree& result) {
  result.first_run.assign(1, 0);
  // both boundaries are sorted, so one pass over the parent's boundary is sufficient
  for (int f = 0; f < result.fronts(); ++f) {
    const int up = result.parent[f];
    if (up >= 0) {
      const int pivots = result.pivots(up);
      const int* in_parent = result.boundary.data() + result.first_boundary[up];
      const int* mine = result.boundary.data() + result.first_boundary[f];
      for (int i = 0; i < result.boundary_nodes(f); ++i) {
        int to;
        if (mine[i] < result.first_pivot[up + 1]) {
          to = mine[i] - result.first_pivot[up];
        } else {
          while (*in_parent != mine[i]) ++in_parent;
          to = pivots +
               static_cast<int>(in_parent - result.boundary.data() - result.first_boundary[up]);
        }
        // a run ends at the end of the parent's pivots
        if (i == 0 || to == pivots || result.run.back().to + result.run.back().length != to)
          result.run.push_back({i, to, 1});
        else
          ++result.run.back().length;
      }
    }
    result.first_run.push_back(static_cast<int64_t>(result.run.size()));
  }
}

}  // namespace

AssemblyTree assembly_tree(const BlockPattern& pattern, const SeparatorTree& tree) {
  const int vertices = static_cast<int>(tree.parent.size());
  const Lists children = lists_by(tree.parent, vertices);
  const Lists boundary = boundaries(pattern, tree, children);
  const std::vector<int> into = merge(tree, children, boundary);

  std::vector<int> parent(vertices, -1);
  for (int t = 0; t < vertices; ++t)
    if (into[t] == t && tree.parent[t] >= 0) parent[t] = into[tree.parent[t]];
  const Lists members = lists_by(into, vertices);
  const std::vector<int> sequence =
      elimination_order(into, parent, lists_by(parent, vertices), boundary);

  AssemblyTree result;
  const int fronts = static_cast<int>(sequence.size());
  std::vector<int> number(vertices, -1);
  for (int f = 0; f < fronts; ++f) number[sequence[f]] = f;

  result.position.resize(pattern.n);
  result.order.reserve(pattern.n);
  result.first_pivot.push_back(0);
  for (int t : sequence) {
    for (const int* m = members.begin(t); m != members.end(t); ++m)
      for (int i = tree.first_node[*m]; i < tree.first_node[*m + 1]; ++i) {
        result.position[tree.node[i]] = static_cast<int>(result.order.size());
        result.order.push_back(tree.node[i]);
      }
    result.first_pivot.push_back(static_cast<int>(result.order.size()));
    result.parent.push_back(parent[t] < 0 ? -1 : number[parent[t]]);
  }
  result.first_boundary.push_back(0);
  for (int t : sequence) {
    for (const int* i = boundary.begin(t); i != boundary.end(t); ++i)
      result.boundary.push_back(result.position[*i]);
    std::sort(result.boundary.begin() + result.first_boundary.back(), result.boundary.end());
    result.first_boundary.push_back(static_cast<int64_t>(result.boundary.size()));
  }
  const Lists by_parent = lists_by(result.parent, fronts);
  result.first_child.assign(by_parent.first.begin(), by_parent.first.end());
  result.child = by_parent.item;
  map_boundaries(result);
  return result;
}

}  // namespace codend
