// Which blocks of a matrix over the free nodes each element touches.
#pragma once

#include <cstdint>
#include <vector>

#include "../base/block_pattern.hpp"
#include "../base/block_sink.hpp"
#include "model.hpp"

namespace codend {

// A point as weighted unknowns: itself, or the free ones among the two nodes that it is tied to;
// none where those are held.
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

// Elements of one kind: `width` points each.
struct ElementPoints {
  int width;
  const std::vector<int>& points;
};

// Blocks (i, j) of all unknowns i, j that meet in an element, and the diagonal.
BlockPattern pattern_of(const FreePoints& free, const std::vector<ElementPoints>& kinds);

// Where the blocks of one kind of element go.
class BlockPlaces {
 public:
  BlockPlaces(const FreePoints& free, const BlockPattern& pattern, const ElementPoints& kind);

  // Valid as long as this is. values: 9 per block of the pattern.
  BlockSink into(double* values) const {
    return {width_, slot_.data(), list_start_.data(), list_block_.data(), list_weight_.data(),
            values};
  }

 private:
  int width_;
  std::vector<std::int64_t> slot_, list_start_, list_block_;  // see BlockSink
  std::vector<double> list_weight_;
};

// Where the blocks of all elements of a matrix over the free nodes lie.
struct BlockLayout {
  BlockLayout(const FreePoints& free, const std::vector<ElementPoints>& kinds);

  BlockPattern pattern;
  std::vector<std::int64_t> diagonal;  // place of every diagonal block in the pattern
  std::vector<BlockPlaces> places;     // one per kind
};

}  // namespace codend
