// Triangles of netting as they are given: plain and hexagonal ones in one list.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "../elements/hexagonal_triangle.hpp"
#include "../elements/netting_triangle.hpp"

namespace codend {

struct TriangleList {
  std::vector<int> node;      // 3 per triangle
  std::vector<double> twine;  // u1 v1 u2 v2 u3 v3 per triangle
  std::vector<double> rest;   // length of the bars, of hexagonal ones the oblique bars, m
  std::vector<double>
      straight;            // length of the straight bars of a hexagonal one, m; 0: it is plain
  std::vector<int> inner;  // inner point of a hexagonal one; -1: it is plain
  std::vector<double> multiplicity, height;
  std::vector<int> material;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {3, Among::points});
    visit("twine", twine, {6});
    visit("rest", rest);
    visit("straight", straight);
    visit("inner", inner, {1, Among::points, Per::element, true});
    visit("multiplicity", multiplicity);
    visit("height", height);
    visit("material", material, {1, Among::materials});
  }

  // Adds each to the kind that it is of; hexagonal: which of the list are. Throws InputError where a
  // hexagonal one has no inner point.
  void divide(NettingTriangles& plain, HexagonalTriangles& hexagons,
              std::vector<char>& hexagonal) const;
};

// Numbers of triangles (`width` each) in the order of their list.
std::vector<double> in_list_order(const std::vector<char>& hexagonal, std::size_t width,
                                  const std::vector<double>& plain, const double* of_hexagons,
                                  std::size_t hexagons);

}  // namespace codend
