// Bars: a rope element, a twine, or many twines of grouped netting as one equivalent bar.
// Grouping by lambda twines in both directions: length lambda times the real bar's, lambda lines
// in parallel; that keeps mass, weight, projected area and stiffness of the netting.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "line.hpp"

namespace codend {

class Bars {
 public:
  std::vector<int> node;             // 2 per bar
  std::vector<double> rest;          // unstretched length, m
  std::vector<double> multiplicity;  // lines in parallel
  std::vector<int> material;         // index into materials
  std::vector<double> height;        // over which it leaves the water, m; where there is a surface

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {2, Among::points});
    visit("rest", rest);
    visit("multiplicity", multiplicity);
    visit("height", height);
    visit("material", material, {1, Among::materials});
  }

  int count() const { return static_cast<int>(rest.size()); }
  Line<2> line(int bar) const {
    return {&node[2 * static_cast<std::size_t>(bar)],
            {-1.0, 1.0},
            rest[bar],
            multiplicity[bar],
            material[bar],
            bar};
  }

  // Differences between the ends of bars [begin, end) of a quantity x (3 per point), by component
  // into e[.][0 .. end - begin).
  void vectors(const double* x, int begin, int end, double* const e[3]) const;
  // Adds drag, and pull by given tensions of one line each (N), to the points of all bars.
  void add_force(const LineArrays& lines, const double* tension, double* force) const;
  // Adds added mass (kg, 9 per point) to the points of all bars.
  void add_added_mass(const LineArrays& lines, double* mass) const;
};

}  // namespace codend
