// Receives the 3x3 blocks of one kind of element and adds them where they belong in a solver's
// array of values.
#pragma once

#include <cstdint>

namespace codend {

struct BlockSink {
  int width;  // points per element
  // width x width per element. A block >= 0; -1: nowhere, for a held node; -2 - k: the blocks of
  // list k by their weights, for a tied point.
  const std::int64_t* slot;
  const std::int64_t* list_start;  // list k is [list_start[k], list_start[k + 1])
  const std::int64_t* list_block;
  const double* list_weight;
  double* values;  // 9 per block, row-major

  // a and b are places in the element's own list of points; block(i, j) gives its numbers.
  template <class Block>
  void add(std::int64_t element, int a, int b, const Block& block) const {
    const std::int64_t s = slot[(element * width + a) * width + b];
    if (s >= 0) {
      add_scaled(s, 1.0, block);
    } else if (s <= -2) {
      for (std::int64_t k = list_start[-2 - s]; k < list_start[-1 - s]; ++k) {
        add_scaled(list_block[k], list_weight[k], block);
      }
    }
  }

 private:
  template <class Block>
  void add_scaled(std::int64_t place, double weight, const Block& block) const {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) values[9 * place + 3 * i + j] += weight * block(i, j);
    }
  }
};

}  // namespace codend
