// Points of ropes, netting and pieces that may lie on the sea bed (ground.hpp).
#pragma once

#include "../ground.hpp"
#include "kind.hpp"

namespace codend {

class GroundContacts : public ElementKind {
 public:
  std::vector<int> node;
  std::vector<double> area;       // on the ground, m2
  std::vector<double> clearance;  // from the point to the underside, m
  Ground ground;

  int count() const { return static_cast<int>(node.size()); }
  int nodes_per_element() const override { return 1; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Adds one element's force (N) to force[0..2].
  void add_element_force(int e, const Field& field, double* force) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field& field, double* scale) const override;
};

}  // namespace codend
