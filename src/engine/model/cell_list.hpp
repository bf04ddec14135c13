// Cells of netting as they are given: plain and hexagonal ones in one list. Those of three corners have
// the last one twice; hexagonal ones have three.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "../elements/hexagonal_triangle.hpp"
#include "../elements/netting_cell.hpp"

namespace codend {

struct CellList {
  std::vector<int> node;      // 4 per cell
  std::vector<double> twine;  // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;   // length of the bars, of hexagonal ones the oblique bars, m
  std::vector<double>
      straight;            // length of the straight bars of a hexagonal one, m; 0: it is plain
  std::vector<int> inner;  // inner point of a hexagonal one; -1: it is plain
  std::vector<double> multiplicity, height;
  std::vector<int> material;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("rest", rest);
    visit("straight", straight);
    visit("inner", inner, {1, Among::points, Per::element, true});
    visit("multiplicity", multiplicity);
    visit("height", height);
    visit("material", material, {1, Among::materials});
  }

  // Adds each to the kind that it is of; hexagonal: which of the list are. Throws InputError where a
  // hexagonal one has no inner point.
  void divide(NettingCells& plain, HexagonalTriangles& hexagons,
              std::vector<char>& hexagonal) const;
};

// The list that was divided into these.
CellList join_cells(const NettingCells& plain, const HexagonalTriangles& hexagons,
                    const std::vector<char>& hexagonal);

// Cells that are divided, by the fields of their list.
struct DividedCells {
  NettingCells& plain;
  HexagonalTriangles& hexagons;
  std::vector<char>& hexagonal;

  template <class Visit>
  void fields(Visit& visit) {
    CellList list = join_cells(plain, hexagons, hexagonal);
    list.fields(visit);
    plain = {};
    hexagons = {};
    list.divide(plain, hexagons, hexagonal);
  }
};

// Numbers of cells (`width` each) in the order of their list.
std::vector<double> in_list_order(const std::vector<char>& hexagonal, std::size_t width,
                                  const std::vector<double>& plain, const double* of_hexagons,
                                  std::size_t hexagons);

}  // namespace codend
