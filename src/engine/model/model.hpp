// A lattice as the engine sees it: points, what holds them, and flat arrays of elements.
//
// Points 0..nodes-1 are nodes; the following ones are tied: each lies on the straight line between
// two nodes, x = (1 - share) x_first + share x_second, and hands its forces to them in the same
// shares (the twine ends of one panel on a seam that owns other nodes).
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

// Holds no pointer into itself: copies are whole. What hosts fill and read is not ready for use, see
// prepare().
struct Model {
  int nodes = 0;
  std::vector<char> held;  // per node: 1 where its position is given
  std::vector<Tie> ties;
  Water water;
  Ground ground;
  SlackDrag slack = SlackDrag::curved;
  std::vector<double> load;  // N, 3 per point: weight less buoyancy, and loads of the plan
  std::vector<double> mass;  // kg per point, without added mass
  std::vector<TwineMaterial> materials;
  LoadTable load_table;  // of materials whose loads are given by strain
  Bars bars;
  NettingCells cells;
  HexagonalTriangles hexagons;
  // Of every cell of a list in which both kinds stand mixed, whether it is hexagonal; empty: the
  // plain ones come first.
  std::vector<char> hexagonal;
  Spheres spheres;
  LiftingSurfaces lifts;
  InnerPressure pressure;
  NettingScreens screens;  // netting whose drag is a screen's
  BlendedNetting blended;
  MeshOpenings openings;
  Bends bends;  // of ropes that resist bending
  LiftingPlates plates;
  std::vector<SlidingRope> sliding;  // none of them empty
  GroundContacts contacts;
  ImmersedVolumes volumes;  // what displaces water but plates
  ForceMultipliers multipliers;
  WakeSheets wake_sheets;  // netting that slows the water behind it
  // Speed of the flow past each point as a share of the free flow's, to begin with; empty: 1.
  std::vector<double> wake;

  // All that is read of a model, by name (fields.hpp). A new kind of element has a line here and one in
  // kinds().
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
    visit.items("plates", plates.plate);
    visit.items("sliding", sliding);
    visit.group("contacts", contacts);
    visit.optional("line_friction", contacts.lines);
    visit.group("volumes", volumes);
    visit.group("wake_sheets", wake_sheets);
  }

  int points() const { return nodes + static_cast<int>(ties.size()); }
  // All elements but lines and contacts.
  std::vector<const ElementKind*> kinds() const {
    std::vector<const ElementKind*> all = {&spheres, &lifts,   &plates,   &volumes, &pressure,
                                           &screens, &blended, &openings, &bends};
    for (const SlidingRope& rope : sliding) all.push_back(&rope);
    return all;
  }
  // Call once after filling.
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
    screens.multipliers = {multipliers.screen_drag, multipliers.screen_lift,
                           multipliers.screen_friction};
    blended.multipliers = screens.multipliers;
    cells.first_line = bars.count();
    cells.prepare();
    hexagons.first_line = bars.count() + 2 * cells.count();
    hexagons.prepare();
    water.waves.prepare();
    contacts.prepare();
    plates.prepare();
    blended.slack = slack;
    screens.prepare();
    blended.prepare();
    openings.prepare();
    for (SlidingRope& rope : sliding) rope.prepare(bars);
    // Bodies of unknown height: only asked for at a free surface.
    spheres.height.resize(spheres.node.size(), 1.0);
    spheres.smooth.resize(spheres.node.size(), 0);
    lifts.height.resize(lifts.node.size(), 1.0);
  }
  // One family of parallel twines each: the bars, then the u lines of all cells, then their v
  // lines, then the three families of hexagonal triangles. each_line() visits them in another
  // order; they know their number.
  int lines() const { return bars.count() + 2 * cells.count() + 3 * hexagons.count(); }
  template <int N>
  const TwineMaterial& material(const Line<N>& line) const {
    return materials[static_cast<std::size_t>(line.material)];
  }
  // What acts one way only, and whose force may be a dual unknown of a solver: lines, then contacts
  // with the ground.
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
