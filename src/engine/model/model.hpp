// Mesh of the engine: points, their constraints, and flat arrays of elements.
//
// Points 0..nodes-1 are nodes. The following points are tied: each lies on the straight line
// between two nodes, x = (1 - share) x_first + share x_second. Its forces are distributed to these
// nodes with the same weights. Example: twine ends of one panel on a seam with other nodes.
#pragma once

#include <algorithm>
#include <vector>

#include "../base/fields.hpp"
#include "../base/ground.hpp"
#include "../base/water.hpp"
#include "../elements/bar.hpp"
#include "../elements/bending.hpp"
#include "../elements/blended_netting.hpp"
#include "../elements/force_multipliers.hpp"
#include "../elements/ground_contact.hpp"
#include "../elements/hexagonal_triangle.hpp"
#include "../elements/immersed_volume.hpp"
#include "../elements/inner_pressure.hpp"
#include "../elements/kind.hpp"
#include "../elements/lifting_plate.hpp"
#include "../elements/lifting_surface.hpp"
#include "../elements/mesh_opening.hpp"
#include "../elements/netting_cell.hpp"
#include "../elements/netting_screen.hpp"
#include "../elements/netting_twist.hpp"
#include "../elements/sliding_rope.hpp"
#include "../elements/sphere.hpp"
#include "cell_list.hpp"
#include "wake.hpp"

namespace codend {

struct Tie {
  int first = 0, second = 0;
  double share = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit("first", first, {1, Among::nodes});
    visit("second", second, {1, Among::nodes});
    visit("share", share);
  }
};

// Contains no pointer into itself, so copies are independent. Call prepare() after filling.
struct Model {
  int nodes = 0;
  std::vector<char> held;  // per node: 1 for a prescribed position
  std::vector<Tie> ties;
  Water water;
  Ground ground;
  SlackDrag slack = SlackDrag::curved;
  std::vector<double> load;  // weight less buoyancy and loads of the plan, N, 3 per point
  std::vector<double> mass;  // kg per point, without added mass
  std::vector<TwineMaterial> materials;
  LoadTable load_table;  // load-strain points of materials with a measured load curve
  Bars bars;
  NettingCells cells;
  HexagonalTriangles hexagons;
  // Per cell of a mixed list: 1 for a hexagonal cell. Empty if plain cells come first.
  std::vector<char> hexagonal;
  Spheres spheres;
  LiftingSurfaces lifts;
  InnerPressure pressure;
  NettingScreens screens;  // netting with a screen drag model
  BlendedNetting blended;
  MeshOpenings openings;
  Bends bends;           // bending stiffness of ropes
  NettingTwists twists;  // of slack netting of bars
  LiftingPlates plates;
  std::vector<SlidingRope> sliding;  // all non-empty
  GroundContacts contacts;
  ImmersedVolumes volumes;  // volumes that displace water, except plates
  ForceMultipliers multipliers;
  WakeSheets wake_sheets;  // netting that slows the water behind it
  // Initial flow speed per point, as a fraction of the free flow; empty: 1.
  std::vector<double> wake;

  // A new kind of element needs one line here and one in kinds().
  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit.count(Among::nodes, static_cast<std::size_t>(nodes));
    visit.columns("ties", ties);
    visit.count(Among::points, static_cast<std::size_t>(points()));
    visit("held", held, {1, Among::numbers, Per::node});
    visit("load", load, {3, Among::numbers, Per::point});
    visit("mass", mass, {1, Among::numbers, Per::point});
    visit("wake", wake, {1, Among::numbers, Per::point, true});
    visit.group("water", water);
    visit.optional("ground", ground, ground.present);
    visit("slack_twine", slack);
    visit.columns("materials", materials);
    visit.count(Among::materials, materials.size());
    visit.optional("load_table", load_table);
    visit.optional("multipliers", multipliers);
    visit.group("bars", bars);
    visit.count(Among::bars, static_cast<std::size_t>(bars.count()));
    DividedCells list{cells, hexagons, hexagonal};
    visit.group("cells", list);
    visit.group("spheres", spheres);
    visit.group("lifts", lifts);
    visit.group("pressure", pressure);
    visit.group("screens", screens);
    visit.group("blended", blended);
    visit.group("openings", openings);
    visit.group("bends", bends);
    visit.group("twists", twists);
    visit.items("plates", plates.plate);
    visit.items("sliding", sliding);
    visit.group("contacts", contacts);
    visit.optional("line_friction", contacts.lines);
    visit.group("volumes", volumes);
    visit.group("wake_sheets", wake_sheets);
  }

  int points() const { return nodes + static_cast<int>(ties.size()); }
  // All elements except lines and contacts.
  std::vector<const ElementKind*> kinds() const {
    std::vector<const ElementKind*> all = {&spheres, &lifts,   &plates,   &volumes, &pressure,
                                           &screens, &blended, &openings, &bends,   &twists};
    for (const SlidingRope& rope : sliding) all.push_back(&rope);
    return all;
  }
  // Must be called once after the fields are filled.
  void prepare() {
    for (std::size_t k = 0; k < load_table.load.size(); ++k) {
      TwineMaterial& material = materials[static_cast<std::size_t>(load_table.material[k])];
      if (material.loads.empty()) {
        material.axial_stiffness = load_table.load[k] / load_table.strain[k];
      }
      material.strains.push_back(load_table.strain[k]);
      material.loads.push_back(load_table.load[k]);
    }
    load_table = {};
    for (std::size_t k = 0; k < std::min(materials.size(), multipliers.normal.size()); ++k) {
      materials[k].law.normal_share = multipliers.normal[k];
    }
    for (TwineMaterial& material : blended.materials) {
      material.law.normal_share = multipliers.blended_normal;
    }
    screens.multipliers = {multipliers.screen_drag, multipliers.screen_lift};
    blended.multipliers = screens.multipliers;
    cells.first_line = bars.count();
    cells.prepare();
    hexagons.first_line = bars.count() + 2 * cells.count();
    hexagons.prepare();
    water.waves.prepare();
    contacts.prepare();
    plates.prepare();
    blended.slack = slack;
    screens.prepare(water.density);
    blended.prepare(water.density);
    openings.prepare();
    twists.prepare(materials, water);
    for (SlidingRope& rope : sliding) rope.prepare(bars);
    // Defaults for bodies without a height, which only a free surface uses.
    spheres.height.resize(spheres.node.size(), 1.0);
    spheres.smooth.resize(spheres.node.size(), 0);
    lifts.height.resize(lifts.node.size(), 1.0);
  }
  // Number of lines, each a family of parallel twines. Order: bars, u lines of all cells, v lines
  // of all cells, then the three families of hexagonal triangles. each_line() uses another order;
  // each line stores its number.
  int lines() const { return bars.count() + 2 * cells.count() + 3 * hexagons.count(); }
  template <int N>
  const TwineMaterial& material(const Line<N>& line) const {
    return materials[static_cast<std::size_t>(line.material)];
  }
  // Number of unilateral elements, whose force can be a dual unknown: lines, then contacts.
  int constraints() const { return lines() + contacts.count(); }
  template <class Visit>
  void each_line(Visit visit) const {
    for (int b = 0; b < bars.count(); ++b) visit(bars.line(b));
    for (int e = 0; e < cells.count(); ++e) {
      for (int which = 0; which < 2; ++which) visit(cells.line(e, which));
    }
    for (int e = 0; e < hexagons.count(); ++e) {
      for (int which = 0; which < 3; ++which) visit(hexagons.line(e, which));
    }
  }
};

}  // namespace codend
