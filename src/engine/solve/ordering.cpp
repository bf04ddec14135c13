#include "ordering.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace codend {

namespace {

// Parts of at most this many nodes are not cut further. Small, because the assembly tree merges
// vertices again where one larger front is cheaper.
constexpr int leaf_nodes = 4;

class Dissector {
 public:
  Dissector(const BlockPattern& pattern, const double* coordinates)
      : pattern_(pattern),
        coordinates_(coordinates),
        node_(pattern.n),
        side_(pattern.n, -1),
        mate_(pattern.n, -1),
        level_(pattern.n, -1),
        cursor_(pattern.n, 0) {
    std::iota(node_.begin(), node_.end(), 0);
    candidate_.reserve(pattern.n);
    best_.reserve(pattern.n);
    tree_.first_node.push_back(0);
    tree_.node.reserve(pattern.n);
  }

  SeparatorTree run() {
    dissect(0, pattern_.n);
    return std::move(tree_);
  }

 private:
  void dissect(int begin, int end) {
    if (begin == end) return;
    const size_t orphans_before = orphans_.size();
    int separator = begin;
    if (end - begin > leaf_nodes) {
      const auto [middle, last] = bisect(begin, end);
      separator = last;
      dissect(begin, middle);
      dissect(middle, separator);
    }
    if (separator == end) return;  // nothing to own: the parts become children of the vertex above
    const int vertex = static_cast<int>(tree_.parent.size());
    tree_.parent.push_back(-1);
    tree_.node.insert(tree_.node.end(), node_.begin() + separator, node_.begin() + end);
    tree_.first_node.push_back(static_cast<int>(tree_.node.size()));
    for (size_t i = orphans_before; i < orphans_.size(); ++i) tree_.parent[orphans_[i]] = vertex;
    orphans_.resize(orphans_before);
    orphans_.push_back(vertex);
  }

  // Rearranges node_[begin, end) into one side, the other side and their separator; returns where
  // the second and the third begin.
  std::array<int, 2> bisect(int begin, int end) {
    const int size = end - begin;
    const int half = size / 2;
    int64_t least = -1;
    const auto consider = [&] {
      const int64_t cut = cut_size(half);
      if (least >= 0 && cut >= least) return;
      least = cut;
      best_.swap(candidate_);
    };
    for (int axis : axes_by_extent(begin, end)) {
      candidate_.assign(node_.begin() + begin, node_.begin() + end);
      std::nth_element(candidate_.begin(), candidate_.begin() + half, candidate_.end(),
                       [&](int a, int b) {
                         const double xa = coordinates_[3 * static_cast<int64_t>(a) + axis];
                         const double xb = coordinates_[3 * static_cast<int64_t>(b) + axis];
                         return xa < xb || (xa == xb && a < b);
                       });
      consider();
    }
    order_by_distance(begin, end);
    consider();

    mark_sides(best_, half);
    cover_cut_edges(half);
    const auto place = [&](int at, int side) {
      for (int node : best_)
        if (side_[node] == side) node_[at++] = node;
      return at;
    };
    const int middle = place(begin, near_);
    const int separator = place(middle, far_);
    place(separator, cover_);
    return {middle, separator};
  }

  // The axes along which the part has any extent, the longest first.
  std::vector<int> axes_by_extent(int begin, int end) const {
    std::array<double, 3> extent{};
    for (int axis = 0; axis < 3; ++axis) {
      double low = coordinates_[3 * static_cast<int64_t>(node_[begin]) + axis], high = low;
      for (int i = begin; i < end; ++i) {
        const double x = coordinates_[3 * static_cast<int64_t>(node_[i]) + axis];
        low = std::min(low, x);
        high = std::max(high, x);
      }
      extent[axis] = high - low;
    }
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis)
      if (extent[axis] > 0) axes.push_back(axis);
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return extent[a] > extent[b]; });
    return axes;
  }

  // Fills candidate_ with the part's nodes by distance along the graph from one of its ends.
  void order_by_distance(int begin, int end) {
    int start = node_[begin];
    for (int sweep = 0; sweep < 2; ++sweep) {
      const int inside = ++stamp_;
      for (int i = begin; i < end; ++i) side_[node_[i]] = inside;
      const int reached = ++stamp_;
      candidate_.clear();
      const auto reach_from = [&](int node) {
        size_t next = candidate_.size();
        candidate_.push_back(node);
        side_[node] = reached;
        for (; next < candidate_.size(); ++next)
          for_each_neighbour(candidate_[next], [&](int neighbour) {
            if (side_[neighbour] != inside) return;
            side_[neighbour] = reached;
            candidate_.push_back(neighbour);
          });
      };
      reach_from(start);
      start = candidate_.back();
      for (int i = begin; i < end; ++i)
        if (side_[node_[i]] == inside) reach_from(node_[i]);
    }
  }

  void mark_sides(const std::vector<int>& nodes, int half) {
    near_ = ++stamp_;
    far_ = ++stamp_;
    cover_ = ++stamp_;
    for (size_t i = 0; i < nodes.size(); ++i)
      side_[nodes[i]] = static_cast<int>(i) < half ? near_ : far_;
  }

  // Nodes that touch the other side, on the side that has fewer of them: a bound on the separator.
  int64_t cut_size(int half) {
    mark_sides(candidate_, half);
    std::array<int64_t, 2> touching{};
    for (size_t i = 0; i < candidate_.size(); ++i) {
      const int other = static_cast<int>(i) < half ? far_ : near_;
      touching[other == near_] += touches(candidate_[i], other);
    }
    return std::min(touching[0], touching[1]);
  }

  bool touches(int node, int side) const {
    for (int64_t e = pattern_.row_start[node]; e < pattern_.row_start[node + 1]; ++e)
      if (side_[pattern_.column[e]] == side) return true;
    return false;
  }

  template <class Visit>
  void for_each_neighbour(int node, Visit visit) const {
    for (int64_t e = pattern_.row_start[node]; e < pattern_.row_start[node + 1]; ++e)
      visit(pattern_.column[e]);
  }

  // Moves into side cover_ the least set of nodes that covers every edge between near_ and far_.
  void cover_cut_edges(int half) {
    near_cut_.clear();
    far_cut_.clear();
    for (size_t i = 0; i < best_.size(); ++i) {
      const int node = best_[i];
      const bool near = static_cast<int>(i) < half;
      if (!touches(node, near ? far_ : near_)) continue;
      (near ? near_cut_ : far_cut_).push_back(node);
      mate_[node] = -1;
    }
    while (layer_from_unmatched()) {
      for (int node : near_cut_) cursor_[node] = pattern_.row_start[node];
      for (int node : near_cut_)
        if (mate_[node] < 0) augment_from(node);
    }
    // Koenig: near nodes that no alternating path reaches, and far nodes that one does
    for (int node : near_cut_)
      if (level_[node] < 0) side_[node] = cover_;
    for (int node : far_cut_)
      if (level_[node] >= 0) side_[node] = cover_;
  }

  // Breadth-first layers of alternating paths from unmatched near nodes; true if one of them ends
  // at an unmatched far node.
  bool layer_from_unmatched() {
    queue_.clear();
    for (int node : far_cut_) level_[node] = -1;
    for (int node : near_cut_) {
      level_[node] = mate_[node] < 0 ? 0 : -1;
      if (mate_[node] < 0) queue_.push_back(node);
    }
    bool open = false;
    for (size_t next = 0; next < queue_.size(); ++next) {
      const int node = queue_[next];
      for_each_neighbour(node, [&](int neighbour) {
        if (side_[neighbour] != far_ || level_[neighbour] >= 0) return;
        level_[neighbour] = level_[node] + 1;
        const int behind = mate_[neighbour];
        if (behind < 0) {
          open = true;
        } else {
          level_[behind] = level_[neighbour] + 1;
          queue_.push_back(behind);
        }
      });
    }
    return open;
  }

  void augment_from(int root) {
    path_.assign(1, root);
    while (!path_.empty()) {
      const int node = path_.back();
      if (cursor_[node] == pattern_.row_start[node + 1]) {
        path_.pop_back();
        continue;
      }
      const int neighbour = pattern_.column[cursor_[node]++];
      if (side_[neighbour] != far_ || level_[neighbour] != level_[node] + 1) continue;
      const int behind = mate_[neighbour];
      if (behind >= 0) {
        if (level_[behind] == level_[neighbour] + 1) path_.push_back(behind);
        continue;
      }
      int free = neighbour;
      for (size_t i = path_.size(); i-- > 0;) {
        std::swap(mate_[path_[i]], free);
        mate_[mate_[path_[i]]] = path_[i];
      }
      return;
    }
  }

  const BlockPattern& pattern_;
  const double* coordinates_;
  SeparatorTree tree_;
  std::vector<int> node_;      // permuted in place; each call owns a range
  std::vector<int> orphans_;   // finished vertices that have no parent yet
  std::vector<int> candidate_, best_;
  std::vector<int> side_;      // the last stamp each node was given
  int stamp_ = -1, near_ = -1, far_ = -1, cover_ = -1;
  std::vector<int> near_cut_, far_cut_, mate_, level_, queue_, path_;
  std::vector<int64_t> cursor_;
};

[[noreturn]] void refuse(int row, const char* fault) {
  throw std::invalid_argument("block pattern: row " + std::to_string(row) + " " + fault);
}

}  // namespace

SeparatorTree nested_dissection(const BlockPattern& pattern, const double* coordinates) {
  return Dissector(pattern, coordinates).run();
}

void check_pattern(const BlockPattern& pattern) {
  if (pattern.n < 0 || pattern.row_start.size() != static_cast<size_t>(pattern.n) + 1 ||
      pattern.row_start.front() != 0 ||
      pattern.row_start.back() != static_cast<int64_t>(pattern.column.size()))
    throw std::invalid_argument("block pattern: row_start must hold n + 1 offsets into column");
  std::vector<int64_t> next(pattern.row_start.begin(), pattern.row_start.end() - 1);
  for (int i = 0; i < pattern.n; ++i)
    if (pattern.row_start[i + 1] < pattern.row_start[i]) refuse(i, "ends before it starts");
  for (int i = 0; i < pattern.n; ++i) {
    bool diagonal = false;
    int previous = -1;
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
      const int j = pattern.column[e];
      if (j < 0 || j >= pattern.n) refuse(i, "has a column outside the matrix");
      if (j <= previous) refuse(i, "is not sorted");
      previous = j;
      diagonal = diagonal || j == i;
      // rows are visited in order, so the mirror entries of row j must come up in order too
      if (next[j] == pattern.row_start[j + 1] || pattern.column[next[j]++] != i)
        refuse(i, "has an entry without its mirror image");
    }
    if (!diagonal) refuse(i, "has no diagonal entry");
  }
}

}  // namespace codend
