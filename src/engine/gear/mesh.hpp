// Discretisation of a gear: nodes, bars, netting cells, point bodies and supports as a model's
// arrays, an initial shape, and the positions of nodes on the gear's parts.
#pragma once

#include "../elements/mesh_opening.hpp"
#include "../elements/netting_screen.hpp"
#include "../elements/netting_twist.hpp"
#include "first_shape.hpp"

namespace codend {

// Cells and sheets with blended drag: arrays of BlendedNetting, without materials.
struct BlendedCells {
  std::vector<int> node, material;
  std::vector<double> twine, rest, multiplicity, height, overlap;
};

// Indices of the cells or sheets with a screen drag model or blended drag.
struct WholeDrag {
  std::vector<int> screens, blended;

  template <class Visit>
  void fields(Visit& visit) {
    visit("screens", screens, {1, Among::elements});
    visit("blended", blended, {1, Among::elements});
  }
};

// See bag.hpp.
struct BagTriangles {
  std::vector<int> cell;              // cell of each triangle; -1: on a sheet
  std::vector<int> node;              // 3 each
  std::vector<double> depth, across;  // of its nodes, meshes from the lower edge and along it
  std::vector<double> real;           // fraction counted, because triangles overlap
  std::vector<double> weight;         // the same with the circle's area; negative: inward normal
  std::vector<double> height;         // vertical size at the free surface, m
  bool encloses = true;               // the panels enclose a volume
};

struct SlidingBars {
  std::vector<int> bar;
  double axial_stiffness = 0.0, diameter = 0.0;  // N, m
};

struct Mesh {
  int nodes = 0;
  std::vector<char> held;          // per node
  std::vector<double> load, mass;  // per point: N, including weight - buoyancy, 3; kg
  TieList ties;
  Bars bars;
  CellList cells;
  Spheres spheres;
  LiftingSurfaces lifts;
  NettingScreens screens;
  BlendedCells blended;
  MeshOpenings openings;
  Bends bends;
  NettingTwists twists;
  std::vector<SlidingBars> sliding;
  GroundContacts contacts;
  LineFriction line_friction;
  ImmersedVolumes volumes;
  WakeSheets wake_sheets;
  std::vector<int> bar_part, cell_part, sphere_part, lift_part;  // parts of the elements
  Sheets sheets;
  WholeDrag on_cell, on_sheet;
  BagTriangles bag;
  Division division;
  Counts counts;
  std::vector<DrawnPanel> panels;
  std::vector<double> twine;  // twine length of every panel in its elements, m
  std::vector<double> start;  // m, 3 per node
  std::vector<double> hung;   // start of a gear before it is shot; else empty

  // All fields that hosts read in addition to the model.
  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit.list("bar_part", bar_part, {1, Among::parts});
    visit.list("cell_part", cell_part, {1, Among::parts});
    visit.list("sphere_part", sphere_part, {1, Among::parts});
    visit.list("lift_part", lift_part, {1, Among::parts});
    visit.group("sheets", sheets);
    visit.group("on_cell", on_cell);
    visit.group("on_sheet", on_sheet);
    visit.list("bag_cell", bag.cell, {1, Among::elements});
    visit("encloses", bag.encloses);
    visit.group("division", division);
    visit.group("counts", counts);
    visit.items("panels", panels);
    visit.list("twine", twine);
    visit.list("start", start);
    visit.list("hung", hung);
  }
};

// Mesh size: an approximate number of nodes, or the counts of another discretisation.
struct Fineness {
  double nodes = 1500;
  const Counts* counts = nullptr;
};

// Source of the initial shape: computed from scratch; interpolated from another discretisation; or,
// if both have the same mesh (`alike`), that shape unchanged.
struct FromShape {
  bool given = false, alike = false;
  PartMap map;                   // of the source; used for interpolation
  std::vector<double> position;  // m, 3 per source point, tied points last
};

// Throws InputError if counts or shapes do not match the gear.
Mesh build_mesh(const Gear& gear, const Fineness& fineness, const FromShape& from,
                const LayOut& lay_out);

// Initial positions of the inner nodes of hexagonal triangles, for equally stretched bars: from the
// triangle's centroid along the mean of its two base vectors.
void place_inner_nodes(const CellList& cells, std::vector<double>& position);

// Approximate numbers of nodes of every panel, then of every rope. divided: the gear defines its
// own mesh.
struct NodeCounts {
  std::vector<double> nodes;
  bool divided = false;

  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit("divided", divided);
  }
};
NodeCounts count_nodes(const Gear& gear, double nodes);

}  // namespace codend
