#include "ordering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "compressed_graph.hpp"
#include "vertex_cut.hpp"

namespace codend {

namespace {

// Parts of at most this many nodes are not cut further. The value is small, because the assembly
// tree merges vertices again if one larger front is cheaper.
constexpr int leaf_nodes = 6;
// Cutting parts of at least this many nodes takes some hundredths of a second.
constexpr int nodes_to_pause = 10000;
constexpr int most_slices = 128;
// Preferred minimum weight on each side of a cut, as a fraction.
constexpr double least_side = 0.25;

// A part of the graph under dissection. Nodes are numbered by index, without gaps in a part.
struct Part {
  std::vector<int> node;     // of the compressed graph
  std::vector<float> place;  // 3 coordinates
  std::vector<int> weight;
  std::vector<int> first;  // into neighbour
  std::vector<int> last;
  std::vector<int> neighbour;  // indices in the store

  void resize(size_t nodes, size_t edges) {
    node.resize(nodes);
    place.resize(3 * nodes);
    weight.resize(nodes);
    first.resize(nodes);
    last.resize(nodes);
    neighbour.resize(edges);
  }
};

class Dissector {
 public:
  Dissector(const CompressedGraph& graph, const double* coordinates,
            const std::function<void()>& pause)
      : pause_(pause),
        nodes_(static_cast<int>(graph.weight.size())),
        side_(nodes_),
        moved_(nodes_),
        key_(nodes_),
        queue_(nodes_),
        cut_(nodes_) {
    const size_t edges = graph.neighbour.size();
    for (Part& part : part_) part.resize(nodes_, edges);
    Part& whole = part_[0];
    for (int i = 0; i < nodes_; ++i) {
      whole.node[i] = i;
      for (int k = 0; k < 3; ++k)
        whole.place[3 * static_cast<size_t>(i) + k] =
            static_cast<float>(coordinates[3 * static_cast<int64_t>(graph.node[i]) + k]);
      whole.weight[i] = graph.weight[i];
      whole.first[i] = graph.first[i];
      whole.last[i] = graph.first[i + 1];
    }
    whole.neighbour = graph.neighbour;
    tree_.first_node.push_back(0);
    tree_.node.reserve(nodes_);
  }

  SeparatorTree run() {
    dissect(0, nodes_, 0);
    return std::move(tree_);
  }

 private:
  // Dissects the nodes [begin, end) of part_[which].
  void dissect(int begin, int end, int which) {
    if (begin == end) return;
    const size_t orphans_before = orphans_.size();
    int separator = begin, owner = which;
    if (pause_ && end - begin >= nodes_to_pause) pause_();
    if (end - begin > leaf_nodes) {
      bisect(part_[which], begin, end);
      const auto [middle, last] = divide(begin, end, which);
      separator = last;
      owner = 1 - which;
      dissect(begin, middle, owner);
      dissect(middle, separator, owner);
    }
    if (separator == end) return;  // empty separator: the parts become children of the vertex above
    const int vertex = static_cast<int>(tree_.parent.size());
    tree_.parent.push_back(-1);
    const std::vector<int>& node = part_[owner].node;
    tree_.node.insert(tree_.node.end(), node.begin() + separator, node.begin() + end);
    tree_.first_node.push_back(static_cast<int>(tree_.node.size()));
    for (size_t i = orphans_before; i < orphans_.size(); ++i) tree_.parent[orphans_[i]] = vertex;
    orphans_.resize(orphans_before);
    orphans_.push_back(vertex);
  }

  // Moves a part into the other store: near side, far side, separator. Returns the starts of the
  // far side and of the separator.
  std::array<int, 2> divide(int begin, int end, int which) {
    const Part& from = part_[which];
    Part& to = part_[1 - which];
    std::array<int, 3> next{begin, begin, begin};
    for (int p = begin; p < end; ++p) {
      next[1] += side_[p] == near_side;
      next[2] += side_[p] != separator_side;
    }
    const std::array<int, 2> ends{next[1], next[2]};
    for (int p = begin; p < end; ++p) {
      const int q = next[side_[p]]++;
      moved_[p] = q;
      to.node[q] = from.node[p];
    }
    // nodes of a side keep their order, so that edges are written sequentially
    int edge = begin == end ? 0 : from.first[begin];
    for (const Side side : {near_side, far_side})
      for (int p = begin; p < end; ++p) {
        if (side_[p] != side) continue;
        const int q = moved_[p];
        to.weight[q] = from.weight[p];
        for (int k = 0; k < 3; ++k)
          to.place[3 * static_cast<size_t>(q) + k] = from.place[3 * static_cast<size_t>(p) + k];
        to.first[q] = edge;
        for (int e = from.first[p]; e < from.last[p]; ++e) {
          const int other = from.neighbour[e];
          if (side_[other] == side) to.neighbour[edge++] = moved_[other];
        }
        to.last[q] = edge;
      }
    return ends;
  }

  void bisect(const Part& part, int begin, int end) {
    total_ = 0;
    for (int p = begin; p < end; ++p) total_ += part.weight[p];
    slices_ = std::clamp((end - begin) / 2, 6, most_slices);
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&] {
      const auto [cost, slice] = cheapest_slice(part, begin, end);
      if (cost >= least) return;
      least = cost;
      for (int p = begin; p < end; ++p) side_[p] = key_[p] <= slice ? near_side : far_side;
    };
    for (int axis = 0; axis < 3; ++axis)
      if (slice_by_coordinate(part, begin, end, axis)) consider();
    slice_by_distance(part, begin, end);
    consider();
    const CutGraph graph{part.first.data(), part.last.data(), part.neighbour.data(),
                         part.weight.data()};
    const int layers = 2 + static_cast<int>(0.03 * std::sqrt(static_cast<double>(end - begin)));
    cut_.separate(graph, begin, end, total_, layers, least_side, side_.data());
  }

  // Divides the middle of the part's extent along an axis into slices. Both ends, where no cut can
  // be balanced, belong to the first and the last slice. Returns false without an extent.
  bool slice_by_coordinate(const Part& part, int begin, int end, int axis) {
    const float* x = part.place.data() + axis;
    sample_.clear();
    const int stride = std::max(1, (end - begin) / 32);
    for (int p = begin; p < end; p += stride) sample_.push_back(x[3 * static_cast<size_t>(p)]);
    std::sort(sample_.begin(), sample_.end());
    float low = sample_[sample_.size() / 5];
    float high = sample_[sample_.size() - 1 - sample_.size() / 5];
    if (!(high > low)) {
      low = sample_.front();
      high = sample_.back();
      if (!(high > low)) return false;
    }
    const float scale = static_cast<float>(slices_ - 2) / (high - low);
    const auto last = static_cast<float>(slices_ - 1);
    for (int p = begin; p < end; ++p) {
      const float at = 1 + (x[3 * static_cast<size_t>(p)] - low) * scale;
      key_[p] = static_cast<unsigned char>(std::min(last, std::max(0.0f, at)));
    }
    return true;
  }

  // Slices the part by distance along the graph from one end.
  void slice_by_distance(const Part& part, int begin, int end) {
    int start = begin;
    const int size = end - begin;
    for (int sweep = 0; sweep < 2; ++sweep) {
      for (int p = begin; p < end; ++p) moved_[p] = -1;
      int reached = 0;
      const auto reach_from = [&](int root) {
        int next = reached;
        queue_[reached++] = root;
        moved_[root] = 0;
        for (; next < reached; ++next)
          for (int e = part.first[queue_[next]]; e < part.last[queue_[next]]; ++e) {
            const int other = part.neighbour[e];
            if (moved_[other] >= 0) continue;
            moved_[other] = 0;
            queue_[reached++] = other;
          }
      };
      reach_from(start);
      start = queue_[reached - 1];
      for (int p = begin; p < end && reached < size; ++p)
        if (moved_[p] < 0) reach_from(p);
    }
    for (int i = 0; i < size; ++i)
      key_[queue_[i]] = static_cast<unsigned char>(static_cast<int64_t>(i) * slices_ / size);
  }

  // Returns the cost of the cheapest cut, and the slice before it.
  std::pair<double, int> cheapest_slice(const Part& part, int begin, int end) {
    std::fill_n(tally_.begin(), slices_ + 1, Tally{});
    for (int p = begin; p < end; ++p) {
      const int mine = key_[p];
      int lowest = mine, highest = mine;
      for (int e = part.first[p]; e < part.last[p]; ++e) {
        const int other = key_[part.neighbour[e]];
        lowest = std::min(lowest, other);
        highest = std::max(highest, other);
      }
      tally_[mine].weight += part.weight[p];
      // adjacent to the other side of every cut after slices [mine, highest) and [lowest, mine)
      ++tally_[mine].near;
      --tally_[highest].near;
      ++tally_[lowest].far;
      --tally_[mine].far;
    }
    std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
    int64_t before = 0;
    int near_touching = 0, far_touching = 0;
    for (int s = 0; s + 1 < slices_; ++s) {
      before += tally_[s].weight;
      near_touching += tally_[s].near;
      far_touching += tally_[s].far;
      if (before == 0 || before == total_) continue;
      const double cost = cost_of(std::min(near_touching, far_touching), before);
      if (cost < best.first) best = {cost, s};
    }
    return best;
  }

  // Returns the cost of a separator with this many nodes and the weight `side` on one side.
  double cost_of(int separator, int64_t side) const {
    const double uneven = static_cast<double>(2 * side - total_) / static_cast<double>(total_);
    const double share = (1 - std::fabs(uneven)) / 2;
    double cost = (separator + 0.5) * (1 + uneven * uneven);
    if (share < least_side) cost *= 1 + 100 * (least_side - share);
    return cost;
  }

  // A slice's weight, and changes of the number of nodes on either side that touch the other side,
  // compared with the previous slice.
  struct Tally {
    int64_t weight;
    int near, far;
  };

  const std::function<void()>& pause_;
  int nodes_;
  std::array<Part, 2> part_;  // a part is in one store and its halves are in the other
  SeparatorTree tree_;
  std::vector<int> orphans_;  // finished vertices without a parent
  std::vector<Side> side_;
  std::vector<int> moved_;
  int slices_ = 0;
  std::vector<unsigned char> key_;  // slice
  std::array<Tally, most_slices + 1> tally_;
  std::vector<int> queue_;
  std::vector<float> sample_;
  VertexCut cut_;
  int64_t total_ = 0;  // weight of the present part
};

[[noreturn]] void refuse(int row, const char* fault) {
  throw std::invalid_argument("block pattern: row " + std::to_string(row) + " " + fault);
}

}  // namespace

SeparatorTree nested_dissection(const BlockPattern& pattern, const double* coordinates,
                                const std::function<void()>& pause) {
  const CompressedGraph graph = compress(pattern);
  return expand(graph, Dissector(graph, coordinates, pause).run());
}
void check_pattern(const BlockPattern& pattern) {
  if (pattern.n < 0 || pattern.row_start.size() != static_cast<size_t>(pattern.n) + 1 ||
      pattern.row_start.front() != 0 ||
      pattern.row_start.back() != static_cast<int64_t>(pattern.column.size()))
    throw std::invalid_argument("block pattern: row_start must hold n + 1 offsets into column");
  if (pattern.column.size() > static_cast<size_t>(std::numeric_limits<int>::max()))
    throw std::invalid_argument("block pattern: more than 2147483647 blocks");
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
      // rows are visited in order, so the transposed entries of row j must appear in order too
      if (next[j] == pattern.row_start[j + 1] || pattern.column[next[j]++] != i)
        refuse(i, "has an entry without its mirror image");
    }
    if (!diagonal) refuse(i, "has no diagonal entry");
  }
}

}  // namespace codend
