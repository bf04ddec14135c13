#include "cell_list.hpp"

#include <algorithm>

#include "../base/error.hpp"

namespace codend {
namespace {

template <class Value>
void copy(const std::vector<Value>& from, std::size_t width, std::size_t element,
          std::vector<Value>& to) {
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(width * element);
  to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
}

}  // namespace

void CellList::divide(NettingCells& plain, HexagonalTriangles& hexagons,
                      std::vector<char>& hexagonal) const {
  hexagonal.clear();
  const auto append = [this](std::size_t e, std::size_t corners, auto& to) {
    for (std::size_t k = 0; k < corners; ++k) {
      copy(node, 1, 4 * e + k, to.node);
      copy(twine, 2, 4 * e + k, to.twine);
    }
    to.multiplicity.push_back(multiplicity[e]);
    to.material.push_back(material[e]);
    to.height.push_back(height[e]);
  };
  for (std::size_t e = 0; e < rest.size(); ++e) {
    hexagonal.push_back(straight[e] > 0.0 ? 1 : 0);
    if (hexagonal.back()) {
      if (inner[e] < 0) {
        throw InputError("cells.inner",
                         "cells.inner has no point for a cell that has "
                         "straight bars (cells.straight)");
      }
      append(e, 3, hexagons);
      hexagons.node.push_back(inner[e]);
      hexagons.straight.push_back(straight[e]);
      hexagons.oblique.push_back(rest[e]);
    } else {
      append(e, 4, plain);
      plain.rest.push_back(rest[e]);
    }
  }
}

CellList join_cells(const NettingCells& plain, const HexagonalTriangles& hexagons,
                    const std::vector<char>& hexagonal) {
  CellList out;
  std::size_t next[2] = {0, 0};
  for (const char is : hexagonal) {
    const std::size_t e = next[static_cast<int>(is)]++;
    const auto append = [&out, e](const auto& from, std::size_t corners) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t corner = std::min(k, corners - 1);
        copy(from.node, 1, 4 * e + corner, out.node);
        copy(from.twine, 2, corners * e + corner, out.twine);
      }
      out.multiplicity.push_back(from.multiplicity[e]);
      out.material.push_back(from.material[e]);
      out.height.push_back(from.height[e]);
    };
    if (is) {
      append(hexagons, 3);
      out.inner.push_back(hexagons.node[4 * e + 3]);
      out.straight.push_back(hexagons.straight[e]);
      out.rest.push_back(hexagons.oblique[e]);
    } else {
      append(plain, 4);
      out.inner.push_back(-1);
      out.straight.push_back(0.0);
      out.rest.push_back(plain.rest[e]);
    }
  }
  return out;
}

std::vector<double> in_list_order(const std::vector<char>& hexagonal, std::size_t width,
                                  const std::vector<double>& plain, const double* of_hexagons,
                                  std::size_t hexagons) {
  std::vector<double> out;
  out.reserve(plain.size() + width * hexagons);
  if (hexagonal.empty()) {
    out = plain;
    out.insert(out.end(), of_hexagons, of_hexagons + width * hexagons);
    return out;
  }
  const double* of_plain = plain.data();
  for (const char is : hexagonal) {
    const double*& from = is ? of_hexagons : of_plain;
    out.insert(out.end(), from, from + width);
    from += width;
  }
  return out;
}

}  // namespace codend
