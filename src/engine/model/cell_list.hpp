// Netting cells as given in the input: plain and hexagonal cells in one list. Plain triangles
// repeat their last corner. Hexagonal cells have three corners.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "../elements/hexagonal_triangle.hpp"
#include "../elements/netting_cell.hpp"

namespace codend {

struct CellList {
  std::vector<int> node;      // 4 per cell
  std::vector<double> twine;  // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;   // length of the bars, or of the oblique bars of a hexagonal cell, m
  std::vector<double>
      straight;            // length of the straight bars of a hexagonal cell, m; 0: plain cell
  std::vector<int> inner;  // inner point of a hexagonal cell; -1: plain cell
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

  // Appends each cell to the list of its kind. `hexagonal` gets one flag per cell. Throws
  // InputError for a hexagonal cell without an inner point.
  void divide(NettingCells& plain, HexagonalTriangles& hexagons,
              std::vector<char>& hexagonal) const;
};

// Inverse of CellList::divide().
CellList join_cells(const NettingCells& plain, const HexagonalTriangles& hexagons,
                    const std::vector<char>& hexagonal);

// Adapter that reads divided cells by the fields of their list.
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

// Returns cell values (`width` each) in the order of the list. of_hexagons: values of the
// `hexagons` hexagonal cells.
std::vector<double> in_list_order(const std::vector<char>& hexagonal, std::size_t width,
                                  const std::vector<double>& plain, const double* of_hexagons,
                                  std::size_t hexagons);

}  // namespace codend
