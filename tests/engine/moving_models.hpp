// Two models whose motion has a closed form, by which every time scheme is measured.
#pragma once

#include "model/model.hpp"

namespace codend {

// 1 kg (node 1) between two bars that are both taut within 0.5 m of the middle: a linear spring of
// 100 N/m along x, so 10 rad/s. In vacuum. Held nodes belong at x = -1.5 m and 1.5 m.
inline void make_oscillator(Model& model) {
  model.nodes = 3;
  model.held = {1, 0, 1};
  model.water.density = 0.0;
  model.load.assign(9, 0.0);
  model.mass = {0.0, 1.0, 0.0};
  TwineMaterial material;
  material.axial_stiffness = 50.0;
  model.materials = {material};
  model.bars.node = {0, 1, 1, 2};
  model.bars.rest = {1.0, 1.0};
  model.bars.multiplicity = {1.0, 1.0};
  model.bars.material = {0, 0};
  model.prepare();
}

constexpr double oscillator_start[9] = {-1.5, 0.0, 0.0, 0.1, 0.0, 0.0, 1.5, 0.0, 0.0};

// A sphere of 0.3 m and 2000 kg/m3 in water of 1025 kg/m3, C_D 0.47, added mass 0.5.
inline void make_sinker(Model& model) {
  const double volume = 3.14159265358979323846 / 6.0 * 0.027;
  model.nodes = 1;
  model.held = {0};
  model.load = {0.0, 0.0, -9.81 * volume * (2000.0 - 1025.0)};
  model.mass = {2000.0 * volume};
  model.spheres.node = {0};
  model.spheres.drag_area = {0.47 * 3.14159265358979323846 / 4.0 * 0.09};
  model.spheres.diameter = {0.0};
  model.spheres.added_mass = {0.5 * volume};
  model.prepare();
}

}  // namespace codend
