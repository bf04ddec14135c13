#include "block_places.hpp"

#include <algorithm>

namespace codend {

FreePoints::FreePoints(const Model& model) : model_(model), unknown_(model.nodes, -1) {
  for (int n = 0; n < model.nodes; ++n) {
    if (model.held[n]) continue;
    unknown_[n] = static_cast<int>(free_.size());
    free_.push_back(n);
  }
}

BlockPattern pattern_of(const FreePoints& free, const std::vector<ElementPoints>& kinds) {
  auto each_pair = [&](auto visit) {
    FreePoints::Share rows[2], columns[2];
    for (const ElementPoints& kind : kinds) {
      const std::size_t width = static_cast<std::size_t>(kind.width);
      for (std::size_t e = 0; e + width <= kind.points.size(); e += width) {
        for (std::size_t a = 0; a < width; ++a) {
          const int n = free.shares(kind.points[e + a], rows);
          for (std::size_t b = 0; b < width; ++b) {
            const int m = free.shares(kind.points[e + b], columns);
            for (int r = 0; r < n; ++r) {
              for (int c = 0; c < m; ++c) {
                if (rows[r].unknown != columns[c].unknown) {
                  visit(rows[r].unknown, columns[c].unknown);
                }
              }
            }
          }
        }
      }
    }
  };
  // Counting sort of the columns into rows, with repeats, after each row's diagonal.
  BlockPattern pattern;
  pattern.n = static_cast<int>(free.nodes().size());
  const std::size_t n = static_cast<std::size_t>(pattern.n);
  std::vector<std::int64_t> end(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) end[i + 1] = 1;
  each_pair([&](int row, int) { ++end[static_cast<std::size_t>(row) + 1]; });
  for (std::size_t i = 0; i < n; ++i) end[i + 1] += end[i];
  std::vector<int> column(static_cast<std::size_t>(end[n]));
  for (std::size_t i = 0; i < n; ++i) {
    column[static_cast<std::size_t>(end[i]++)] = static_cast<int>(i);
  }
  each_pair([&](int row, int other) { column[static_cast<std::size_t>(end[row]++)] = other; });

  pattern.row_start.reserve(n + 1);
  pattern.row_start.push_back(0);
  auto begin = column.begin(), kept = column.begin();
  for (std::size_t i = 0; i < n; ++i) {
    const auto stop = column.begin() + end[i];
    std::sort(begin, stop);
    kept = std::unique_copy(begin, stop, kept);
    pattern.row_start.push_back(kept - column.begin());
    begin = stop;
  }
  pattern.column.assign(column.begin(), kept);
  return pattern;
}

BlockPlaces::BlockPlaces(const FreePoints& free, const BlockPattern& pattern,
                         const ElementPoints& kind)
    : width_(kind.width) {
  const std::size_t width = static_cast<std::size_t>(width_);
  slot_.reserve(kind.points.size() * width);
  list_start_.push_back(0);
  FreePoints::Share rows[2], columns[2];
  for (std::size_t e = 0; e < kind.points.size(); e += width) {
    for (std::size_t a = 0; a < width; ++a) {
      const int n = free.shares(kind.points[e + a], rows);
      for (std::size_t b = 0; b < width; ++b) {
        const int m = free.shares(kind.points[e + b], columns);
        if (n * m == 0) {
          slot_.push_back(-1);
        } else if (n * m == 1 && rows[0].weight * columns[0].weight == 1.0) {
          slot_.push_back(find_block(pattern, rows[0].unknown, columns[0].unknown));
        } else {
          slot_.push_back(-1 - static_cast<std::int64_t>(list_start_.size()));
          for (int r = 0; r < n; ++r) {
            for (int c = 0; c < m; ++c) {
              list_block_.push_back(find_block(pattern, rows[r].unknown, columns[c].unknown));
              list_weight_.push_back(rows[r].weight * columns[c].weight);
            }
          }
          list_start_.push_back(static_cast<std::int64_t>(list_block_.size()));
        }
      }
    }
  }
}

BlockLayout::BlockLayout(const FreePoints& free, const std::vector<ElementPoints>& kinds)
    : pattern(pattern_of(free, kinds)) {
  places.reserve(kinds.size());
  for (const ElementPoints& kind : kinds) places.emplace_back(free, pattern, kind);
  diagonal.reserve(static_cast<std::size_t>(pattern.n));
  for (int i = 0; i < pattern.n; ++i) diagonal.push_back(find_block(pattern, i, i));
}

}  // namespace codend
