// Pattern of a square matrix of 3x3 blocks, one row and column per node.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace codend {

// Structurally symmetric, rows sorted, diagonal present.
struct BlockPattern {
  int n = 0;                       // nodes
  std::vector<int64_t> row_start;  // n + 1: row i holds column[row_start[i] .. row_start[i + 1])
  std::vector<int> column;
};

// From each node's neighbours, in any order and with repeats; both of a pair must name the other.
inline BlockPattern block_pattern(std::vector<std::vector<int>> neighbours) {
  BlockPattern pattern;
  pattern.n = static_cast<int>(neighbours.size());
  pattern.row_start.assign(1, 0);
  for (int i = 0; i < pattern.n; ++i) {
    std::vector<int>& row = neighbours[i];
    row.push_back(i);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<int64_t>(pattern.column.size()));
    std::vector<int>().swap(row);
  }
  return pattern;
}

// Place of a block among the pattern's columns; the block must be there.
inline int64_t find_block(const BlockPattern& pattern, int row, int column) {
  const auto begin = pattern.column.begin() + pattern.row_start[row];
  const auto end = pattern.column.begin() + pattern.row_start[row + 1];
  return std::lower_bound(begin, end, column) - pattern.column.begin();
}

// For each entry of the pattern, the entry that mirrors it.
inline std::vector<int64_t> mirror_entries(const BlockPattern& pattern) {
  std::vector<int64_t> mirror(pattern.column.size());
  std::vector<int64_t> next(pattern.row_start.begin(), pattern.row_start.end() - 1);
  for (std::size_t e = 0; e < mirror.size(); ++e) mirror[e] = next[pattern.column[e]]++;
  return mirror;
}

}  // namespace codend
