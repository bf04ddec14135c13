// A lattice as the engine sees it: points, what holds them, and flat arrays of elements.
//
// Points 0..nodes-1 are nodes; the following ones are tied: each lies on the straight line between
// two nodes, x = (1 - share) x_first + share x_second, and hands its forces to them in the same
// shares (the twine ends of one panel on a seam that owns other nodes).
#pragma once

#include <vector>

#include "../base/water.hpp"
#include "../elements/bar.hpp"
#include "../elements/bending.hpp"
#include "../elements/blended_netting.hpp"
#include "../elements/catch_pressure.hpp"
#include "../elements/ground_contact.hpp"
#include "../elements/hexagonal_triangle.hpp"
#include "../elements/immersed_volume.hpp"
#include "../elements/kind.hpp"
#include "../elements/lifting_surface.hpp"
#include "../elements/mesh_opening.hpp"
#include "../elements/netting_screen.hpp"
#include "../elements/netting_triangle.hpp"
#include "../elements/otter_board.hpp"
#include "../elements/sliding_rope.hpp"
#include "../elements/sphere.hpp"
#include "wake.hpp"

namespace codend {

struct Tie {
  int first, second;
  double share;
};

struct Model {
  int nodes = 0;
  std::vector<char> held;  // per node: 1 where its position is given
  std::vector<Tie> ties;
  Water water;
  SlackDrag slack = SlackDrag::curved;
  std::vector<double> load;  // N, 3 per point: weight less buoyancy, and loads of the plan
  std::vector<double> mass;  // kg per point, without added mass
  std::vector<TwineMaterial> materials;
  Bars bars;
  NettingTriangles triangles;
  HexagonalTriangles hexagons;
  Spheres spheres;
  LiftingSurfaces lifts;
  CatchPressure pressure;       // of the catch on netting
  NettingScreens drag_screens;  // netting whose drag is a screen's
  BlendedNetting blended;
  MeshOpenings openings;
  Bends bends;  // of ropes that resist bending
  OtterBoards boards;
  std::vector<SlidingRope> sliding;  // none of them empty
  GroundContacts contacts;
  ImmersedVolumes volumes;  // empty where water reaches everywhere
  Screens screens;          // netting that slows the water behind it
  // Speed of the flow past each point as a share of the free flow's, to begin with; empty: 1.
  std::vector<double> wake;

  int points() const { return nodes + static_cast<int>(ties.size()); }
  // All elements but lines and contacts.
  std::vector<const ElementKind*> kinds() const {
    std::vector<const ElementKind*> all = {&spheres,      &lifts,   &boards,   &volumes, &pressure,
                                           &drag_screens, &blended, &openings, &bends};
    for (const SlidingRope& rope : sliding) all.push_back(&rope);
    return all;
  }
  // Call once after filling; copies of a Model need it again.
  void connect() {
    bars.materials = triangles.materials = hexagons.materials = &materials;
    triangles.first_line = bars.count();
    triangles.prepare();
    hexagons.first_line = bars.count() + 2 * triangles.count();
    hexagons.prepare();
    boards.prepare();
    for (SlidingRope& rope : sliding) rope.connect(bars);
    // Bodies of unknown height: only asked for at a free surface.
    spheres.height.resize(spheres.node.size(), 1.0);
    spheres.smooth.resize(spheres.node.size(), 0);
    lifts.height.resize(lifts.node.size(), 1.0);
  }
  // One family of parallel twines each: the bars, then the u lines of all triangles, then their v
  // lines, then the three families of hexagonal triangles. each_line() visits them in another
  // order; they know their number.
  int lines() const { return bars.count() + 2 * triangles.count() + 3 * hexagons.count(); }
  // What a solver may carry the force of: lines, then contacts with the ground.
  int carriers() const { return lines() + contacts.count(); }
  template <class Visit>
  void each_line(Visit visit) const {
    for (int b = 0; b < bars.count(); ++b) visit(bars.line(b));
    for (int e = 0; e < triangles.count(); ++e) {
      visit(triangles.u_line(e));
      visit(triangles.v_line(e));
    }
    for (int e = 0; e < hexagons.count(); ++e) {
      for (int which = 0; which < 3; ++which) visit(hexagons.line(e, which));
    }
  }
};

}  // namespace codend
