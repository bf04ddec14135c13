#include "immersed_volume.hpp"

#include "../base/immersion.hpp"

namespace codend {

Vector ImmersedVolumes::element_force(int e, const Field& field) const {
  const double share = immersion(at(field.position, node[e]).z(), height[e]).share;
  return {0.0, 0.0, -(buoyancy[e] * (1.0 - share))};
}

void ImmersedVolumes::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) at(force, node[e]) += element_force(e, field);
}

void ImmersedVolumes::add_jacobian(const Field& field, const JacobianRequest& request,
                                   const BlockSink& sink) const {
  if (request.stiffness == 0.0) return;
  for (int e = 0; e < count(); ++e) {
    const double slope = immersion(at(field.position, node[e]).z(), height[e]).slope;
    if (slope == 0.0) continue;
    Matrix block = Matrix::Zero();
    block(2, 2) = -request.stiffness * buoyancy[e] * slope;
    sink.add(e, 0, 0, block);
  }
}

}  // namespace codend
