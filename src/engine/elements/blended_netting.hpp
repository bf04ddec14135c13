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

namespace codend {

class BlendedNetting : public WholeCells {
 public:
  std::vector<double> rest;  // bar length, m
  std::vector<int> material;
  std::vector<TwineMaterial> materials;
  SlackDrag slack = SlackDrag::curved;

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

 private:
  void describe(std::size_t e, std::size_t place, double density, const CellShape& shape,
                NettingProperties& to, TwineProperties* twines) const override;
  bool has_twines() const override { return true; }
  void set_laws(std::size_t first, NettingStrip::Twines& twines) const override;
};

}  // namespace codend
