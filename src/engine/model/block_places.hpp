// Maps elements to the blocks of a matrix over the free nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "../base/block_pattern.hpp"
#include "../base/block_sink.hpp"
#include "model.hpp"

namespace codend {

// Expresses a point by weighted unknowns. A node is its own unknown; a tied point uses its two
// nodes. Fixed nodes are omitted.
class FreePoints {
 public:
  explicit FreePoints(const Model& model);

  struct Share {
    int unknown;
    double weight;
  };
  // Fills out[0 .. n) and returns n.
  int shares(int point, Share out[2]) const {
    int n = 0;
    auto add = [&](int node, double weight) {
      const int unknown = unknown_[static_cast<std::size_t>(node)];
      if (unknown >= 0) out[n++] = {unknown, weight};
    };
    if (point < model_.nodes) {
      add(point, 1.0);
    } else {
      const Tie& tie = model_.ties[static_cast<std::size_t>(point - model_.nodes)];
      add(tie.first, 1.0 - tie.share);
      add(tie.second, tie.share);
    }
    return n;
  }

  const std::vector<int>& nodes() const { return free_; }  // unknown -> node

 private:
  const Model& model_;
  std::vector<int> free_;
  std::vector<int> unknown_;  // node -> unknown, or -1
};

// Elements of one kind with `width` points each.
struct ElementPoints {
  int width;
  const std::vector<int>& points;
};

// Returns the pattern of all pairs of unknowns that share an element, with the diagonal.
BlockPattern pattern_of(const FreePoints& free, const std::vector<ElementPoints>& kinds);

class BlockPlaces {
 public:
  BlockPlaces(const FreePoints& free, const BlockPattern& pattern, const ElementPoints& kind);

  // Returns a sink for `values` (9 per block of the pattern). This object must outlive the sink.
  BlockSink into(double* values) const {
    return {width_, slot_.data(), list_start_.data(), list_block_.data(), list_weight_.data(),
            values};
  }

 private:
  int width_;
  std::vector<std::int64_t> slot_, list_start_, list_block_;  // see BlockSink
  std::vector<double> list_weight_;
};

struct BlockLayout {
  BlockLayout(const FreePoints& free, const std::vector<ElementPoints>& kinds);

  BlockPattern pattern;
  std::vector<std::int64_t> diagonal;  // index of each diagonal block in the pattern
  std::vector<BlockPlaces> places;     // one per kind
};

}  // namespace codend
