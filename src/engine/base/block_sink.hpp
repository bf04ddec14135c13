// Adds the 3x3 blocks of one kind of element to a solver's value array.
#pragma once

#include <cstdint>

namespace codend {

struct BlockSink {
  int width;  // points per element
  // width x width entries per element. An entry >= 0 is the index of a block. The entry -1 is a
  // fixed node, whose block is dropped. The entry -2 - k is a tied point, whose block goes to all
  // blocks of list k with their weights.
  const std::int64_t* slot;
  const std::int64_t* list_start;  // list k: [list_start[k], list_start[k + 1])
  const std::int64_t* list_block;
  const double* list_weight;
  double* values;  // 9 per block, row-major

  // Adds block(i, j), i, j = 0..2, for the element's local points a and b.
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
