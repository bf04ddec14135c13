// Interpolates strains between two discretisations of the same parts. An interpolated shape without
// strains would give large errors in stiff lines.
#pragma once

#include <vector>

#include "mesh.hpp"

namespace codend {

// The lines of a discretisation: their points, parts and lengths.
struct LineMap {
  int part_count = 0;
  std::vector<int> bar_node, cell_node;  // points, 2 and 4 per line
  std::vector<int> bar_part, cell_part;
  std::vector<double> bar_rest, cell_straight;  // m

  template <class Visit>
  void fields(Visit& visit) {
    visit("part_count", part_count);
    visit.count(Among::parts, static_cast<std::size_t>(part_count));
    visit.list("bar_node", bar_node, {2, Among::points});
    visit.list("cell_node", cell_node, {4, Among::points});
    visit.list("bar_part", bar_part, {1, Among::parts});
    visit.list("cell_part", cell_part, {1, Among::parts});
    visit.list("bar_rest", bar_rest);
    visit.list("cell_straight", cell_straight);
  }
  // True if both have the same lines; lengths may differ.
  bool alike(const LineMap& other) const {
    return bar_node == other.bar_node && cell_node == other.cell_node;
  }
  // Throws InputError if the map does not match the gear's parts.
  void check(const Gear& gear) const;
};
LineMap line_map(const Gear& gear, const Mesh& mesh);

// Arranges values in the order of Model::lines(), given values of bars and of the twines of cells.
// Order: bars, u and v of plain cells, then straight bars, u and v of hexagonal cells.
template <class Value>
std::vector<Value> in_line_order(const std::vector<double>& cell_straight, std::vector<Value> bars,
                                 const std::vector<Value>& u, const std::vector<Value>& v,
                                 const std::vector<Value>& straight) {
  const auto add = [&](const std::vector<Value>& of, bool hexagonal) {
    for (std::size_t c = 0; c < of.size(); ++c) {
      if ((cell_straight[c] > 0) == hexagonal) bars.push_back(of[c]);
    }
  };
  add(u, false);
  add(v, false);
  add(straight, true);
  add(u, true);
  add(v, true);
  return bars;
}

// Position of the middle of a line. family: rope or family of twine, the same number in every
// discretisation with these parts. s, t: fractions across and deep; ropes: fraction along and 0.
struct LinePlace {
  int family = 0;
  double s = 0.0, t = 0.0;
};
std::vector<LinePlace> line_places(const Gear& gear, const PartMap& map, const LineMap& lines);

// Interpolates strains of all lines of `to` from the lines of `from`, linearly along and across
// every rope and family of twine. Families that `from` lacks get 0.
std::vector<double> carry_strains(const Gear& gear, const PartMap& to_map, const LineMap& to,
                                  const PartMap& from_map, const LineMap& from,
                                  const std::vector<double>& strain);

}  // namespace codend
