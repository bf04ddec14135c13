// Contributions of a gear's parts to its discretisation: nodes, tied points, elements, masses. Tied
// points have numbers -1, -2, ... until all nodes are known.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "../elements/bar.hpp"
#include "../elements/lifting_surface.hpp"
#include "../elements/netting_twist.hpp"
#include "../elements/sphere.hpp"
#include "../model/cell_list.hpp"
#include "../model/wake.hpp"

namespace codend {

struct TieList {
  std::vector<int> first, second;
  std::vector<double> share;
};

// Sheets of netting between equivalent bars. They carry properties that cells have as a whole.
struct Sheets {
  std::vector<int> node;      // 4 each; a triangle repeats its last corner
  std::vector<double> twine;  // u0 v0 ... u3 v3 each
  std::vector<double> height;
  std::vector<int> part;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("height", height);
    visit("part", part, {1, Among::parts});
  }
};

struct Mass {
  int node;
  double mass, volume;  // kg, m3
  double height;        // of the body, m
  double surface;       // vertical size at the free surface, m
  double area;          // ground contact area, m2
};

// Minimum height over which a line leaves the water, as a fraction of its length. One line
// represents all the material around it. With a smaller height, drag and buoyancy would change with
// every millimetre, and a net at the surface would not converge. The effect decreases with
// refinement.
constexpr double surface_share = 0.05;
inline double surface_height(double diameter, double length) {
  return std::max(diameter, surface_share * length);
}

struct Collection {
  int nodes = 0;
  TieList ties;
  Bars bars;
  CellList cells;
  Spheres spheres;
  LiftingSurfaces lifts;
  WakeSheets wake_sheets;
  Sheets sheets;
  NettingTwists twists;
  std::vector<int> bar_part, cell_part, sphere_part, lift_part;
  std::vector<Mass> masses;

  // Adds a point on the straight line between two nodes; returns its number.
  int tie(int first, int second, double share) {
    ties.first.push_back(first);
    ties.second.push_back(second);
    ties.share.push_back(share);
    return -static_cast<int>(ties.share.size());
  }
  void add_bar(int first, int second, double rest, double multiplicity, double height, int material,
               int part) {
    bars.node.insert(bars.node.end(), {first, second});
    bars.rest.push_back(rest);
    bars.multiplicity.push_back(multiplicity);
    bars.height.push_back(height);
    bars.material.push_back(material);
    bar_part.push_back(part);
  }
  void add_sphere(int node, double drag_area, double diameter, bool smooth, double added_mass,
                  double height, int part) {
    spheres.node.push_back(node);
    spheres.drag_area.push_back(drag_area);
    spheres.diameter.push_back(diameter);
    spheres.smooth.push_back(smooth);
    spheres.added_mass.push_back(added_mass);
    spheres.height.push_back(height);
    sphere_part.push_back(part);
  }
  void add_lift(int node, double area, LiftDirection direction, double height, int part) {
    lifts.node.push_back(node);
    lifts.lift_area.push_back(area);
    lifts.direction.push_back(direction);
    lifts.height.push_back(height);
    lift_part.push_back(part);
  }
  void add_twist(std::array<int, 4> node, double weight, int material) {
    twists.node.insert(twists.node.end(), node.begin(), node.end());
    twists.weight.push_back(weight);
    twists.material.push_back(material);
  }
  // Replaces the numbers of tied points once all nodes are known.
  void number_ties() {
    const auto number = [&](int& node) {
      if (node < 0) node = nodes - 1 - node;
    };
    for (std::vector<int>* of : {&bars.node, &cells.node, &spheres.node, &lifts.node,
                                 &wake_sheets.node, &sheets.node, &twists.node}) {
      for (int& node : *of) number(node);
    }
    for (Mass& mass : masses) number(mass.node);
  }
};

}  // namespace codend
