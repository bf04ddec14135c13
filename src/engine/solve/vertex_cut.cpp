#include "vertex_cut.hpp"

#include <algorithm>
#include <cstdlib>

namespace codend {

namespace {

constexpr int none = -1;
constexpr int outside = -2;  // start or end of a path
constexpr char starts = 1, ends = 2;

}  // namespace

template <class Visit>
void VertexCut::for_each_neighbour(int v, Visit visit) const {
  const int node = band_[v];
  for (int e = graph_.first[node]; e < graph_.last[node]; ++e) {
    const int other = band_place_[graph_.neighbour[e]];
    if (other >= 0) visit(other);
  }
}

void VertexCut::separate(const CutGraph& graph, int begin, int end, int64_t total, int layers,
                         double share, Side* side) {
  graph_ = graph;
  find_band(begin, end, total, layers, share, side);
  flow_.assign(band_.size(), {none, none});
  level_.resize(2 * band_.size());
  cursor_.resize(band_.size());
  while (layer_paths()) augment();
  divide(total, side);
  for (const int node : band_) band_place_[node] = -1;
}

void VertexCut::find_band(int begin, int end, int64_t total, int layers, double share,
                          const Side* side) {
  band_.clear();
  end_.clear();
  near_core_ = 0;
  std::vector<int>& far = queue_;
  far.clear();
  for (int p = begin; p < end; ++p) {
    if (side[p] == near_side) near_core_ += graph_.weight[p];
    for (int e = graph_.first[p]; e < graph_.last[p]; ++e) {
      if (side[graph_.neighbour[e]] == side[p]) continue;
      (side[p] == near_side ? band_ : far).push_back(p);
      break;
    }
  }
  const auto least = static_cast<int64_t>(share * static_cast<double>(total));
  const int64_t far_weight = total - near_core_;
  add_layers(near_side, near_core_, layers, least, side);
  for (size_t v = 0; v < band_.size(); ++v) near_core_ -= graph_.weight[band_[v]];
  band_.insert(band_.end(), far.begin(), far.end());
  add_layers(far_side, far_weight, layers, least, side);
}

// Adds layers around the unmarked nodes at the end of the band, and marks the last layer.
void VertexCut::add_layers(Side mine, int64_t behind, int layers, int64_t least, const Side* side) {
  size_t first = end_.size();
  for (size_t v = first; v < band_.size(); ++v) {
    band_place_[band_[v]] = static_cast<int>(v);
    behind -= graph_.weight[band_[v]];
  }
  for (int layer = 1; layer < layers; ++layer) {
    const size_t last = band_.size();
    for (size_t v = first; v < last; ++v)
      for (int e = graph_.first[band_[v]]; e < graph_.last[band_[v]]; ++e) {
        const int other = graph_.neighbour[e];
        if (side[other] != mine || band_place_[other] >= 0) continue;
        band_place_[other] = static_cast<int>(band_.size());
        band_.push_back(other);
        behind -= graph_.weight[other];
      }
    if (band_.size() == last || behind < least) {
      while (band_.size() > last) {
        band_place_[band_.back()] = -1;
        band_.pop_back();
      }
      break;
    }
    first = last;
  }
  end_.resize(first, 0);
  end_.resize(band_.size(), mine == near_side ? starts : ends);
}

// Computes breadth-first layers of states from the starts of paths; returns true if one can end.
bool VertexCut::layer_paths() {
  std::fill(level_.begin(), level_.end(), -1);
  queue_.clear();
  const auto reach = [&](int state, int level) {
    if (level_[state] >= 0) return;
    level_[state] = level;
    queue_.push_back(state);
  };
  for (size_t v = 0; v < band_.size(); ++v)
    if (end_[v] == starts) reach(2 * static_cast<int>(v), 0);
  bool open = false;
  for (size_t i = 0; i < queue_.size(); ++i) {
    const int v = queue_[i] / 2, level = level_[queue_[i]] + 1;
    const bool used = flow_[v].previous != none;
    if (queue_[i] % 2 == 0) {
      if (!used)
        reach(2 * v + 1, level);
      else if (flow_[v].previous >= 0)
        reach(2 * flow_[v].previous + 1, level);
    } else {
      if (end_[v] == ends && flow_[v].next != outside) open = true;
      if (used) reach(2 * v, level);
      for_each_neighbour(v, [&](int other) { reach(2 * other, level); });
    }
  }
  return open;
}

// Adds paths along the layers until no more exist.
void VertexCut::augment() {
  for (size_t v = 0; v < band_.size(); ++v) cursor_[v] = graph_.first[band_[v]];
  for (size_t root = 0; root < band_.size(); ++root) {
    if (end_[root] != starts || flow_[root].previous == outside) continue;
    path_.assign(1, 2 * static_cast<int>(root));
    while (!path_.empty()) {
      const int state = path_.back(), v = state / 2, level = level_[state] + 1;
      int next = none;
      const auto try_state = [&](int candidate) {
        if (level_[candidate] == level) next = candidate;
      };
      const bool used = flow_[v].previous != none;
      if (state % 2 == 0) {
        if (!used)
          try_state(2 * v + 1);
        else if (flow_[v].previous >= 0)
          try_state(2 * flow_[v].previous + 1);
      } else {
        if (end_[v] == ends && flow_[v].next != outside) {
          follow_to_sink();
          break;
        }
        if (used) try_state(2 * v);
        while (next == none && cursor_[v] < graph_.last[band_[v]]) {
          const int other = band_place_[graph_.neighbour[cursor_[v]++]];
          if (other >= 0) try_state(2 * other);
        }
      }
      if (next == none) {
        level_[state] = -1;
        path_.pop_back();
      } else {
        path_.push_back(next);
      }
    }
  }
}

// Sends one unit of flow along path_. Its states are then used up in these layers.
void VertexCut::follow_to_sink() {
  flow_[path_.front() / 2].previous = outside;
  for (size_t i = 0; i + 1 < path_.size(); ++i) {
    const int v = path_[i] / 2, w = path_[i + 1] / 2;
    level_[path_[i]] = -1;
    if (path_[i] % 2 == 0) continue;
    if (v == w) {
      flow_[v] = {none, none};
    } else {
      flow_[v].next = w;
      flow_[w].previous = v;
    }
  }
  flow_[path_.back() / 2].next = outside;
  level_[path_.back()] = -1;
}

// Derives the separator from the last search: nodes that were entered but not left. Alternatively,
// a search from the ends gives the other extreme separator.
void VertexCut::divide(int64_t total, Side* side) {
  int64_t near = near_core_, near_if_late = near_core_, separator = 0;
  for (size_t v = 0; v < band_.size(); ++v) {
    const bool entered = level_[2 * v] >= 0, left = level_[2 * v + 1] >= 0;
    side[band_[v]] = left ? near_side : entered ? separator_side : far_side;
    if (left) near += graph_.weight[band_[v]];
    if (entered && !left) separator += graph_.weight[band_[v]];
  }
  // the same from the other end, against the arcs
  std::fill(level_.begin(), level_.end(), -1);
  queue_.clear();
  const auto reach = [&](int state) {
    if (level_[state] >= 0) return;
    level_[state] = 0;
    queue_.push_back(state);
  };
  for (size_t v = 0; v < band_.size(); ++v)
    if (end_[v] == ends) reach(2 * static_cast<int>(v) + 1);
  for (size_t i = 0; i < queue_.size(); ++i) {
    const int v = queue_[i] / 2;
    const bool used = flow_[v].previous != none;
    if (queue_[i] % 2 == 1) {
      if (!used) reach(2 * v);
      if (flow_[v].next >= 0) reach(2 * flow_[v].next);
    } else {
      if (used) reach(2 * v + 1);
      for_each_neighbour(v, [&](int other) { reach(2 * other + 1); });
    }
  }
  int64_t separator_if_late = 0;
  for (size_t v = 0; v < band_.size(); ++v) {
    const bool enters = level_[2 * v] >= 0, leaves = level_[2 * v + 1] >= 0;
    if (!leaves && !enters) near_if_late += graph_.weight[band_[v]];
    if (leaves && !enters) separator_if_late += graph_.weight[band_[v]];
  }
  const auto uneven = [&](int64_t mine, int64_t between) {
    return std::abs(2 * mine + between - total);
  };
  if (uneven(near_if_late, separator_if_late) >= uneven(near, separator)) return;
  for (size_t v = 0; v < band_.size(); ++v) {
    const bool enters = level_[2 * v] >= 0, leaves = level_[2 * v + 1] >= 0;
    side[band_[v]] = enters ? far_side : leaves ? separator_side : near_side;
  }
}

}  // namespace codend
