// The lattice of a gear: nodes, bars, netting cells, point pieces and supports as a model's arrays, a
// shape to start from, and where on the gear's parts the nodes lie.
#pragma once

#include "../elements/mesh_opening.hpp"
#include "../elements/netting_screen.hpp"
#include "first_shape.hpp"

namespace codend {

// Whole cells and sheets whose drag is blended: as BlendedNetting, without its materials.
struct BlendedCells {
  std::vector<int> node, material;
  std::vector<double> twine, rest, multiplicity, height, overlap;
};

// Which cells or sheets have their drag as a whole: as a screen or blended.
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
  std::vector<int> cell;              // that each is of; -1: of a sheet
  std::vector<int> node;              // 3 each
  std::vector<double> depth, across;  // of these, meshes from the lower edge and along it
  std::vector<double> real;           // share of each that is real
  std::vector<double> weight;  // the same with the circle's share; negative: it points inward
  bool encloses = true;        // whether the panels enclose anything
};

struct SlidingBars {
  std::vector<int> bar;
  double axial_stiffness = 0.0;
};

struct Lattice {
  int nodes = 0;
  std::vector<char> held;          // per node
  std::vector<double> load, mass;  // per point: N, weight less buoyancy with it, 3 each; kg
  TieList ties;
  Bars bars;
  CellList cells;
  Spheres spheres;
  LiftingSurfaces lifts;
  NettingScreens screens;
  BlendedCells blended;
  MeshOpenings openings;
  Bends bends;
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
  std::vector<double> twine;  // m of every panel's twine, as its elements have it
  std::vector<double> start;  // m, 3 per node
  std::vector<double> hung;   // the same of a gear that is let go, as it hangs before; else empty

  // All that hosts read beside the model.
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

// How a gear is divided: at about so many nodes, or by the counts of another lattice of it.
struct Fineness {
  double nodes = 1500;
  const Counts* counts = nullptr;
};

// Where a lattice starts: from a crude first shape, from another lattice's shape carried over, or, where
// both are divided alike, from that shape as it is.
struct FromShape {
  bool given = false, alike = false;
  PartMap map;                   // where it is carried over
  std::vector<double> position;  // m, 3 per point of it, tied points last
};

// Throws InputError for what does not fit.
Lattice build_lattice(const Gear& gear, const Fineness& fineness, const FromShape& from,
                      const LayOut& lay_out);

// Puts inner nodes of hexagonal triangles where their bars would lie if all were stretched alike: from
// the triangle's middle along the mean of its two base vectors.
void place_inner_nodes(const CellList& cells, std::vector<double>& position);

// How many nodes a gear would have, of every panel, then of every rope, and whether it says so itself.
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
