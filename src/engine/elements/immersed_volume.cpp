#include "immersed_volume.hpp"

#include <algorithm>
#include <cmath>

#include "../base/immersion.hpp"

namespace codend {

Vector ImmersedVolumes::element_force(int e, const Field& field) const {
  return {0.0, 0.0, -(buoyancy[e] * (1.0 - field.immersed_share(node[e], height[e])))};
}

void ImmersedVolumes::add_force(const Field& field, double* force) const {
  const bool pushed = field.water->accelerates();
  if (!field.water->free_surface && !pushed) return;
  for (int e = 0; e < count(); ++e) {
    if (field.is_still(node[e])) continue;
    const double wet = field.immersed_share(node[e], height[e]);
    at(force, node[e]).z() -= buoyancy[e] * (1.0 - wet);
    if (pushed) at(force, node[e]) += buoyancy[e] / gravity * wet * field.acceleration(node[e]);
  }
}

double ImmersedVolumes::surfacing(const Field& field, const double* dx) const {
  if (!field.water->free_surface) return 0.0;
  double most = 0.0;
  for (int e = 0; e < count(); ++e) {
    const double z = field.above_surface(node[e]), rise = at(dx, node[e]).z();
    const Immersion here = immersion(z, height[e]);
    const double off = immersion(z + rise, height[e]).share - here.share - here.slope * rise;
    most = std::max(most, std::abs(off));
  }
  return most;
}

void ImmersedVolumes::add_jacobian(const Field& field, const JacobianRequest& request,
                                   const BlockSink& sink) const {
  if (request.stiffness == 0.0 || !field.water->free_surface) return;
  const bool pushed = field.water->accelerates();
  for (int e = 0; e < count(); ++e) {
    if (field.is_still(node[e])) continue;
    const double slope = immersion(field.above_surface(node[e]), height[e]).slope;
    if (slope == 0.0) continue;
    Vector of_share(0.0, 0.0, buoyancy[e]);
    if (pushed) of_share += buoyancy[e] / gravity * field.acceleration(node[e]);
    Vector down(0.0, 0.0, 1.0);  // derivative of the height above the surface by position
    if (field.waves) {
      down.x() = -field.waves[node[e]].slope_x;
      down.y() = -field.waves[node[e]].slope_y;
    }
    const Matrix block = (-request.stiffness * slope) * of_share * down.transpose();
    sink.add(e, 0, 0, block);
  }
}

}  // namespace codend
