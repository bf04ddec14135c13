// What a reader of a state wants to know of every element, at given positions and velocities.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace codend {

struct Evaluation {
  std::vector<double> force;  // net force per node, N, 3 each
  std::vector<double> mass;   // mass and added mass per node, kg, 9 each
  // One line of each element: tension N, length m.
  std::vector<double> bar_tension, bar_length;
  std::vector<double> u_tension, u_length, v_tension, v_length;
  // Of hexagonal triangles: the straight bars, then those along A, then those along B.
  std::vector<double> hexagon_tension, hexagon_length;
  // Hydrodynamic force of each whole element, N, 3 each.
  std::vector<double> bar_drag, triangle_drag, hexagon_drag, sphere_drag, lift_force, catch_force,
      screen_force, blended_force;
  // Force of the ground on each contact, and of the surface on each volume (buoyancy that is lost),
  // N, 3 each.
  std::vector<double> contact_force, volume_force;
  std::vector<BoardAttitude> boards;
};

// x (m), v (m/s): 3 per node.
Evaluation evaluate(Assembly& assembly, const double* x, const double* v);

}  // namespace codend
