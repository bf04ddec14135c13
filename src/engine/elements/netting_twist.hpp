// Stiffness of slack bars of netting against twist.
//
// The twist of an equivalent mesh is w = x0 - x1 + x2 - x3, with its four knots in order. Slack bars
// have no stiffness against it, so that slack netting has many equilibria. Cells have such a
// stiffness (netting_cell.hpp).
//
// An equivalent mesh has m lines of both families, with m bars each. The vectors of the lines vary
// evenly from one side of the mesh to the other. Their variance is (1 - 1/m^2) w^2/12. As in cells,
// the stiffness k corresponds to a tension of 1/2 rho d L V^2. Here L is the length of m bars:
//
//   k = (m - 1/m)/6 twist_stiffness(),  energy 1/2 k w^2
//
// Real meshes (m = 1) have none. The effect vanishes with refinement.
#pragma once

#include <vector>

#include "kind.hpp"
#include "twine.hpp"

namespace codend {

class NettingTwists : public ElementKind {
 public:
  std::vector<int> node;       // 4 per mesh
  std::vector<double> weight;  // (m - 1/m)/6
  std::vector<int> material;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("weight", weight);
    visit("material", material, {1, Among::materials});
  }

  int count() const { return static_cast<int>(weight.size()); }
  // Call once after filling.
  void prepare(const std::vector<TwineMaterial>& materials, const Water& water);
  int nodes_per_element() const override { return 4; }
  const std::vector<int>& nodes() const override { return node; }
  double element_energy(int e, const Field& field) const;  // J
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;

 private:
  Vector twist(int e, const Field& field) const;
  std::vector<double> stiffness_;  // N/m
};

}  // namespace codend
