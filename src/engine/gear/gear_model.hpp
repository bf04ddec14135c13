// The model of a gear's lattice: its elements with the water, the ground and the materials that they are
// of.
#pragma once

#include "../model/model.hpp"
#include "lattice.hpp"

namespace codend {

// What a model takes of a gear beside its lattice, as Model has it: materials of ropes, panels' twine and
// plates in the order of their parts, and plates, whose nodes the lattice gives.
struct GearModel {
  Water water;
  Ground ground;
  SlackDrag slack = SlackDrag::curved;
  std::vector<TwineMaterial> materials,
      blended;  // blended: of netting's twine where it is in part a screen
  LoadTable load_table;
  ForceMultipliers multipliers;
  std::vector<LiftingPlate> plates;
  double drag_coefficient = 0.0;  // of the pressure within a bag

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("water", water);
    visit.optional("ground", ground, ground.present);
    visit("slack_twine", slack);
    visit.columns("materials", materials);
    visit.count(Among::materials, materials.size());
    visit.columns("blended", blended);
    visit.optional("load_table", load_table);
    visit.optional("multipliers", multipliers);
    visit.count(Among::points, 1000000000);  // nodes of another lattice
    visit.items("plates", plates);
    visit("drag_coefficient", drag_coefficient);
  }
};

// Not ready for use, and without the nodes and weights of the pressure.
Model model_of(const Gear& gear, const Lattice& lattice, const GearModel& numbers);

// The part of every line of the model (Model::lines()).
std::vector<int> line_parts(const Lattice& lattice);

}  // namespace codend
