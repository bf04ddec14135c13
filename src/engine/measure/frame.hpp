// What measures take of a gear on its lattice, beside the model: which part each element is of, where
// places, ropes and meshes of panels lie among the nodes.
#pragma once

#include <vector>

#include "../gear/lattice.hpp"
#include "meshes.hpp"

namespace codend {

// Nodes along a rope in order, and what it is made of.
struct RopeFrame {
  std::vector<int> node;
  double mass_per_length = 0.0, volume_per_length = 0.0;  // kg/m, m2
  bool strut = false;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("node", node, {1, Among::nodes});
    visit("mass_per_length", mass_per_length);
    visit("volume_per_length", volume_per_length);
    visit("strut", strut);
  }
};

// Edges that a seam joins, and whether it gathers them in a place.
struct SeamFrame {
  std::vector<int> edge;
  bool gathered = false;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("edge", edge, {1, Among::edges});
    visit("gathered", gathered);
  }
};

// The part of every element of the kinds that have forces of the flow (model/evaluate.hpp). Elements of
// `pressure` are of no rope, panel, piece or plate.
struct ElementParts {
  std::vector<int> bars, cells, spheres, lifts, plates, screens, blended;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("bars", bars, {1, Among::parts});
    visit.list("cells", cells, {1, Among::parts});
    visit.list("spheres", spheres, {1, Among::parts});
    visit.list("lifts", lifts, {1, Among::parts});
    visit.list("plates", plates, {1, Among::parts});
    visit.list("screens", screens, {1, Among::parts});
    visit.list("blended", blended, {1, Among::parts});
  }
};

// Cells of netting as their list has them: bars of one family in each, lengths of a bar.
struct CellFrame {
  std::vector<double> bars, rest, straight;

  template <class Visit>
  void fields(Visit& visit) {
    visit("bars", bars);
    visit("rest", rest);
    visit("straight", straight);
  }
};

struct MeasureFrame {
  int nodes = 0, points = 0, parts = 0, panel_count = 0;
  std::vector<int> places;    // node of every place (gear/gear.hpp)
  std::vector<int> supports;  // nodes whose places are given
  ElementParts part;
  std::vector<RopeFrame> ropes;
  std::vector<SeamFrame> seams;
  EdgeNodes edges;
  CellFrame cells;
  MeshFrame meshes;

  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit("points", points);
    visit("parts", parts);
    visit("panel_count", panel_count);
    visit.count(Among::nodes, static_cast<std::size_t>(nodes));
    visit.count(Among::points, static_cast<std::size_t>(points));
    visit.count(Among::parts, static_cast<std::size_t>(parts));
    visit.count(Among::panels, static_cast<std::size_t>(panel_count));
    visit.count(Among::edges, 4 * static_cast<std::size_t>(panel_count));
    visit.list("places", places, {1, Among::nodes});
    visit.list("supports", supports, {1, Among::nodes});
    visit.group("part", part);
    visit.items("ropes", ropes);
    visit.items("seams", seams);
    visit.group("edges", edges);
    visit.group("cells", cells);
    visit.group("meshes", meshes);
  }
};
MeasureFrame measure_frame(const Gear& gear, const Lattice& lattice);

}  // namespace codend
