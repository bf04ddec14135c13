// Carries strains from one lattice to another of the same parts: with a carried shape alone the strains
// of stiff lines would be those of its interpolation.
#pragma once

#include <vector>

#include "lattice.hpp"

namespace codend {

// The lines of a lattice: what they join, the parts that they are of, and their lengths.
struct LineMap {
  int part_count = 0;
  std::vector<int> bar_node, cell_node;  // points, 2 and 4 each
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
  // Whether both have the same lines, of whatever length.
  bool alike(const LineMap& other) const {
    return bar_node == other.bar_node && cell_node == other.cell_node;
  }
  // Throws InputError where it is not one of a gear with these parts.
  void check(const Gear& gear) const;
};
LineMap line_map(const Gear& gear, const Lattice& lattice);

// What is known of all lines in the order of Model::lines(), from what is known of bars and of cells'
// twines: bars, then the u and the v twines of plain cells, then straight bars, u and v of hexagonal ones.
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

// Where the middle of a line lies. family: of the rope or the family of twine, the same in every lattice
// of these parts; s, t: shares across and deep, of ropes along them and 0.
struct LinePlace {
  int family = 0;
  double s = 0.0, t = 0.0;
};
std::vector<LinePlace> line_places(const Gear& gear, const PartMap& map, const LineMap& lines);

// Strains of all lines of `to`, from those of `from`: along and across every rope and family of twine,
// straight between its lines; 0 of families that `from` does not have.
std::vector<double> carry_strains(const Gear& gear, const PartMap& to_map, const LineMap& to,
                                  const PartMap& from_map, const LineMap& from,
                                  const std::vector<double>& strain);

}  // namespace codend
