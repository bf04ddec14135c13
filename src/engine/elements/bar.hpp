// Bars: a rope element, a twine, or many twines of netting grouped into one equivalent bar.
// Grouping by lambda twines in both directions gives a bar lambda times as long as a mesh bar, with
// lambda lines in parallel. This preserves the mass, weight, projected area and stiffness of the
// netting.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "line.hpp"

namespace codend {

class Bars {
 public:
  std::vector<int> node;             // 2 per bar
  std::vector<double> rest;          // unstretched length, m
  std::vector<double> multiplicity;  // number of lines in parallel
  std::vector<int> material;         // index into materials
  std::vector<double> height;        // vertical size at the free surface, m (immersion.hpp)

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

  // Writes x(end node) - x(start node) of bars [begin, end), for a quantity x (3 per point), by
  // component to e[.][0 .. end - begin).
  void vectors(const double* x, int begin, int end, double* const e[3]) const;
  // Adds each bar's drag and its pull to its points. tension: of one line, N.
  void add_force(const LineArrays& lines, const double* tension, double* force) const;
  // Adds the bars' added mass to their points, kg (9 per point).
  void add_added_mass(const LineArrays& lines, double* mass) const;
};

}  // namespace codend
