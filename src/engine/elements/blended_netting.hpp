// Netting whose twines stand in each other's wake where it lies nearly along the flow. The sum over
// its twines agrees with measured panels where the flow meets them steeply and gives too much drag
// where it does not, for want of wakes (flume tests of rhombic panels, ASME OMAE2012, volume 44946,
// page 49; H. Cheng et al., Aquacultural Engineering 90, 2020). With theta the angle between the
// netting's normal and the flow, the force is
//
//   (1 - w) x the sum over twines + w x that of a screen by Kristiansen & Faltinsen
//
// where w rises smoothly from 0 at theta = 60 degrees to 1 at 80 degrees: both ends of that are
// this package's choice around the 70 degrees from which shielding is said to matter. Meshes that
// close leave the screen's range and have no plane in the end: w falls to 0 again from a solidity
// of 0.35 to one of 1. Nor is netting a screen whose twines lie hundreds of diameters apart:
// w rises to its full size between a solidity of 0 and 0.05, where bars are some 40 to 80 diameters long (this package's choice as well). Without that the screen's
// force, which near the flow is linear in the angle where a twine's is square, would overrule the
// little tension of such netting from node to node.
#pragma once

#include "netting_screen.hpp"
#include "twine_drag.hpp"

namespace codend {

class BlendedNetting : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; of three corners the last one twice
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell
  std::vector<double> rest;          // bar length, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations overlap
  std::vector<double> overlap;       // as of NettingScreens
  std::vector<int> material;
  std::vector<double> height;  // over which it leaves the water, m
  std::vector<TwineMaterial> materials;
  SlackDrag slack = SlackDrag::curved;
  ScreenMultipliers multipliers;  // of the screen's part

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
    ScreenForce force;  // by S and by U
    Matrix by_vector[2];
  };
  double bars(int e) const;  // of one family
  Blended blended(int e, const Field& field) const;
  std::vector<CellShape> shape_;
};

}  // namespace codend
