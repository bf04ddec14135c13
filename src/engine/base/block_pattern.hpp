// Sparsity pattern of a square matrix of 3x3 blocks, with one row and one column per node.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace codend {

// The pattern is structurally symmetric. Rows are sorted and contain the diagonal.
struct BlockPattern {
  int n = 0;                       // number of nodes
  std::vector<int64_t> row_start;  // n + 1; row i: column[row_start[i] .. row_start[i + 1])
  std::vector<int> column;
};

// Builds the pattern from the neighbours of each node, unsorted and with repeats, but symmetric.
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

// Returns the index of a block in `column`. The block must exist.
inline int64_t find_block(const BlockPattern& pattern, int row, int column) {
  const auto begin = pattern.column.begin() + pattern.row_start[row];
  const auto end = pattern.column.begin() + pattern.row_start[row + 1];
  return std::lower_bound(begin, end, column) - pattern.column.begin();
}

// Returns, for each entry, the index of the transposed entry.
inline std::vector<int64_t> mirror_entries(const BlockPattern& pattern) {
  std::vector<int64_t> mirror(pattern.column.size());
  std::vector<int64_t> next(pattern.row_start.begin(), pattern.row_start.end() - 1);
  for (std::size_t e = 0; e < mirror.size(); ++e) mirror[e] = next[pattern.column[e]]++;
  return mirror;
}

}  // namespace codend
