// Creates the model of a gear from its discretisation, with water, ground and materials.
#pragma once

#include "../model/model.hpp"
#include "mesh.hpp"

namespace codend {

// Additional input of a model, with the fields of Model. Materials: ropes, panels' twine and plates
// in the order of their parts. The discretisation adds the nodes of plates.
struct GearModel {
  Water water;
  Ground ground;
  SlackDrag slack = SlackDrag::curved;
  std::vector<TwineMaterial> materials,
      blended;  // blended: twine of panels with blended drag
  LoadTable load_table;
  ForceMultipliers multipliers;
  std::vector<LiftingPlate> plates;
  double drag_coefficient = 0.0;  // of the pressure in a bag

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
    visit.count(Among::points, 1000000000);  // not checked: replaced by the discretisation
    visit.items("plates", plates);
    visit("drag_coefficient", drag_coefficient);
  }
};

// The result is not yet prepared for use, and lacks nodes and weights of the pressure.
Model model_of(const Gear& gear, const Mesh& mesh, const GearModel& numbers);

// Part of every line of the model (Model::lines()).
std::vector<int> line_parts(const Mesh& mesh);

}  // namespace codend
