// Volumes that displace water. What a node carries is loaded with the weight less the full buoyancy:
// at a free surface the share of it that is out of the water (immersion.hpp) is taken back here. Water
// that accelerates pushes what is in it as it would push the water in its place (Froude and Krylov).
#pragma once

#include "kind.hpp"

namespace codend {

class ImmersedVolumes : public ElementKind {
 public:
  std::vector<int> node;
  std::vector<double> buoyancy;  // in full, N
  std::vector<double> height;    // of the body, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("buoyancy", buoyancy);
    visit("height", height);
  }

  int count() const { return static_cast<int>(node.size()); }
  int nodes_per_element() const override { return 1; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // The most that any body's buoyancy would differ, where nodes move by dx (m, 3 per point), from what its
  // slope says: as a share of the full one.
  double surfacing(const Field& field, const double* dx) const;
  // Buoyancy (N) that one element lacks.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field&, double*) const override {}
};

}  // namespace codend
