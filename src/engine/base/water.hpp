// Properties of the water: density, viscosity, current profile, surface and waves.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry.hpp"
#include "waves.hpp"

namespace codend {

struct Water {
  double density = 1025.0;     // kg/m3; 0 for a gear in vacuum
  double viscosity = 1.19e-6;  // kinematic, m2/s
  // Current profile, linear between its points and constant outside; depths ascend (m, downwards).
  std::vector<double> depth = {0.0};
  std::vector<Vector> current = {Vector::Zero()};  // m/s in the frame of the gear
  // Largest speed of the water past the gear (m/s): a constant of the gear, the same if its motion
  // is in the water's frame instead.
  double speed = 0.0;
  // Rate of change of the current (m/s2) at the same depths; empty for a steady current.
  std::vector<Vector> current_rate;

  // If true, bodies lose buoyancy and drag above z = 0; otherwise water is everywhere.
  bool free_surface = false;
  Waves waves;

  template <class Visit>
  void fields(Visit& visit) {
    visit("density", density);
    visit("viscosity", viscosity);
    visit("free_surface", free_surface);
    visit("depth", depth);
    visit("speed", speed);
    visit.component("x", current, 0);
    visit.component("y", current, 1);
    visit.optional("waves", waves);
  }

  bool uniform() const { return depth.size() == 1; }
  bool varies_with_height() const { return free_surface || !uniform() || waves.present(); }
  // True if the acceleration of the water exerts a force now.
  bool accelerates() const { return !current_rate.empty() || waves.running(); }

  // Computes the current (m/s) at height z (m, 0 at the surface), and its derivative by z (1/s).
  void velocity(double z, Vector& value, Vector& slope) const {
    by_depth(current, z, value, slope);
  }
  // Returns the acceleration of the current (m/s2) at height z.
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
