// What a reader of a state wants to know of every element, at given positions and velocities.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace codend {

// What a force on an element comes from: the flow of the water, the sea bed, or the water's surface
// (buoyancy that is lost above it).
enum class Cause { flow, ground, surface };
constexpr std::array<const char*, 3> names_of(Cause) { return {"flow", "ground", "surface"}; }

// A force that readers are told of, of every element of a kind. Tables of drag, balances and exports go
// by the list of these, so that a force of a new kind of element is one row more (evaluate.cpp).
struct ReportedForce {
  const char* name;
  const char* kind;  // whose elements, by their name in the model (Model::fields)
  Cause cause;
  // N, 3 per element, where the assembly was last moved to.
  std::vector<double> (*of)(const Assembly& assembly);
};
const std::vector<ReportedForce>& reported_forces();

struct Evaluation {
  std::vector<double> force;  // net force per node, N, 3 each
  std::vector<double> mass;   // mass and added mass per node, kg, 9 each; without bodies'
  // One line of each element: tension N, length m. Cells in the order of their list; the straight
  // bars of plain ones, which have none, are 0.
  std::vector<double> bar_tension, bar_length;
  std::vector<double> u_tension, u_length, v_tension, v_length, straight_tension, straight_length;
  std::vector<std::vector<double>> forces;  // as reported_forces(), N, 3 per element
  std::vector<PlateAttitude> plates;
  std::vector<double> ground_places;  // as Assembly::ground_places(), m, 3 each

  // One of `forces` by its name; throws std::out_of_range for another.
  const std::vector<double>& reported(const std::string& name) const;
};

// x (m), v (m/s): 3 per node.
Evaluation evaluate(Assembly& assembly, const double* x, const double* v);
// Where the assembly was last moved to, while it holds no nodes back.
Evaluation evaluate_here(Assembly& assembly);

}  // namespace codend
