// The water: density, viscosity, a horizontal current that varies with depth, its surface, and waves.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry.hpp"
#include "waves.hpp"

namespace codend {

struct Water {
  double density = 1025.0;     // kg/m3; 0 for a gear in vacuum
  double viscosity = 1.19e-6;  // kinematic, m2/s
  // Current profile, linear between its points and constant beyond them; depths ascend (m, z down).
  std::vector<double> depth = {0.0};
  std::vector<Vector> current = {Vector::Zero()};  // m/s in the frame of the gear
  // How fast the current changes, m/s2, at the same depths; empty: it does not.
  std::vector<Vector> current_rate;

  // Whether bodies lose buoyancy and drag where they leave the water at z = 0 (immersion.hpp); else
  // water reaches everywhere.
  bool free_surface = false;
  Waves waves;

  template <class Visit>
  void fields(Visit& visit) {
    visit("density", density);
    visit("viscosity", viscosity);
    visit("free_surface", free_surface);
    visit("depth", depth);
    visit.component("x", current, 0);
    visit.component("y", current, 1);
    visit.optional("waves", waves);
  }

  // The same current at all depths.
  bool uniform() const { return depth.size() == 1; }
  // Whether a body's drag depends on its height.
  bool varies_with_height() const { return free_surface || !uniform() || waves.present(); }
  // Whether the water's acceleration pushes now.
  bool accelerates() const { return !current_rate.empty() || waves.running(); }

  // Velocity of the current at height z (m, up, 0 at the surface) and its derivative by z (1/s).
  void velocity(double z, Vector& value, Vector& slope) const {
    by_depth(current, z, value, slope);
  }
  // Acceleration of the current at height z, m/s2.
  Vector acceleration(double z) const {
    if (current_rate.empty()) return Vector::Zero();
    Vector value, slope;
    by_depth(current_rate, z, value, slope);
    return value;
  }

 private:
  void by_depth(const std::vector<Vector>& layers, double z, Vector& value, Vector& slope) const {
    const double d = -z;
    slope.setZero();
    if (uniform() || d <= depth.front()) {
      value = layers.front();
      return;
    }
    if (d >= depth.back()) {
      value = layers.back();
      return;
    }
    std::size_t k = 1;
    while (depth[k] < d) ++k;
    const double span = depth[k] - depth[k - 1];
    const double share = (d - depth[k - 1]) / span;
    value = (1.0 - share) * layers[k - 1] + share * layers[k];
    slope = (layers[k - 1] - layers[k]) / span;
  }
};

}  // namespace codend
