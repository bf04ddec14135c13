// Volumes that displace water. The load of a node already contains weight minus full buoyancy. At a
// free surface this element subtracts the buoyancy of the emerged fraction (immersion.hpp). In
// accelerating water it adds the Froude-Krylov force: displaced mass times the acceleration of the
// water.
#pragma once

#include "kind.hpp"

namespace codend {

class ImmersedVolumes : public ElementKind {
 public:
  std::vector<int> node;
  std::vector<double> buoyancy;  // fully immersed, N
  std::vector<double> height;    // vertical size of the body, m

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
  // Largest error of a linearised buoyancy when nodes move by dx (m, 3 per point), as a fraction of
  // the full buoyancy. 0 without a free surface.
  double surfacing(const Field& field, const double* dx) const;
  // Buoyancy missing from one element, N.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
};

}  // namespace codend
