// Receives the 3x3 blocks of one kind of element and adds them where they belong in a solver's
// array of values.
#pragma once

#include <cstdint>

#include "geometry.hpp"

namespace codend {

struct BlockSink {
  int width;                        // points per element
  const std::int64_t* slot;         // width x width per element: a block >= 0; -1: nowhere, for a
                                    // held node; -2 - k: list k of weighted blocks, for a tied point
  const std::int64_t* list_start;   // list k is [list_start[k], list_start[k + 1])
  const std::int64_t* list_block;
  const double* list_weight;
  double* values;                   // 9 per block, row-major

  // a and b are places in the element's own list of points.
  void add(std::int64_t element, int a, int b, const Matrix& block) const {
    const std::int64_t s = slot[(element * width + a) * width + b];
    if (s >= 0) {
      place(s) += block;
    } else if (s <= -2) {
      for (std::int64_t k = list_start[-2 - s]; k < list_start[-1 - s]; ++k) {
        place(list_block[k]) += list_weight[k] * block;
      }
    }
  }

 private:
  Eigen::Map<Block> place(std::int64_t block) const { return Eigen::Map<Block>(values + 9 * block); }
};

}  // namespace codend
