// Netting with a drag model that blends Morison-type (twine-by-twine) drag and a screen drag model.
//
// Twine-by-twine drag agrees with measured panels at steep angles to the flow. It is too high for
// netting nearly parallel to the flow, because it neglects the wakes of other twines. Sources:
// flume tests of rhombic panels, ASME OMAE2012, volume 44946, page 49; H. Cheng et al.,
// Aquacultural Engineering 90, 2020. With theta the angle between the netting's normal and the
// flow, the force is
//
//   (1 - w) x (twine-by-twine force) + w x (screen force by Kristiansen & Faltinsen)
//
// The weight w is a product of three smooth factors:
//
// - From 0 at theta = 60 degrees to 1 at 80 degrees. Both limits are choices of this package around
//   the 70 degrees from which shielding reportedly matters.
// - From 1 at a solidity of 0.35 to 0 at 1. Meshes that close leave the range of the screen model
//   and finally have no plane.
// - From 0 at a solidity of 0 to 1 at 0.05, a choice of this package (bars of 40 to 80 diameters).
//   Netting with twines hundreds of diameters apart does not act as a screen. Near theta = 90
//   degrees the screen force is linear in the angle and the twine force quadratic. Without this
//   factor the screen force would exceed the low tension of such netting between nodes.
#pragma once

#include "netting_screen.hpp"
#include "twine_drag.hpp"

namespace codend {

class BlendedNetting : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; a triangle repeats its last corner
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;          // bar length, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations overlap
  std::vector<double> overlap;       // see NettingScreens
  std::vector<int> material;
  std::vector<double> height;  // vertical size at the free surface, m
  std::vector<TwineMaterial> materials;
  SlackDrag slack = SlackDrag::curved;
  ScreenMultipliers multipliers;  // of the screen force

  template <class Visit>
  void fields(Visit& visit) {
    visit.columns("materials", materials);
    visit.count(Among::own_materials, materials.size());
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("rest", rest);
    visit("multiplicity", multiplicity);
    visit("overlap", overlap);
    visit("height", height);
    visit("material", material, {1, Among::own_materials});
  }

  int count() const { return static_cast<int>(rest.size()); }
  // Call once after filling.
  void prepare();
  int nodes_per_element() const override { return 4; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Force (N) on the whole cell.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field& field, double* scale) const override;

 private:
  struct Blended {
    ScreenFlow flow;
    ScreenForce force;  // with its derivatives by area vector and velocity
    // Derivatives of the twine forces by the bar vectors.
    Matrix by_vector[2];
  };
  double bars(int e) const;  // number of bars of one family
  Blended blended(int e, const Field& field) const;
  std::vector<CellShape> shape_;
};

}  // namespace codend
