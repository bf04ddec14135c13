// Data of a gear and its discretisation for measures, in addition to the model: the part of each
// element, and the nodes of locations, ropes and meshes of panels.
#pragma once

#include <vector>

#include "../gear/mesh.hpp"
#include "meshes.hpp"

namespace codend {

// Nodes along a rope in order, and its material.
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

// Edges joined by a seam. gathered: the seam gathers them in one location.
struct SeamFrame {
  std::vector<int> edge;
  bool gathered = false;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("edge", edge, {1, Among::edges});
    visit("gathered", gathered);
  }
};

// Part of every element of the kinds with hydrodynamic forces (model/evaluate.hpp). Elements of
// `pressure` belong to no rope, panel, piece or plate.
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

// Netting cells in the order of their list: number of bars of one family, lengths of a bar (m).
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
  // Node at or before every location (gear/gear.hpp), the next node, and the next node's weight in a
  // linear interpolation. Only the middle of a rope and fractions of its length are between nodes.
  std::vector<int> places, next_places;
  std::vector<double> next_weights;
  std::vector<int> supports;  // nodes with a given position
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
    visit.list("next_places", next_places, {1, Among::nodes});
    visit.list("next_weights", next_weights);
    visit.list("supports", supports, {1, Among::nodes});
    visit.group("part", part);
    visit.items("ropes", ropes);
    visit.items("seams", seams);
    visit.group("edges", edges);
    visit.group("cells", cells);
    visit.group("meshes", meshes);
  }
};
MeasureFrame measure_frame(const Gear& gear, const Mesh& mesh);

}  // namespace codend
