// Evaluates all elements at given positions and velocities, for reports.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace codend {

// Cause of a force; `surface` is the loss of buoyancy above the water surface.
enum class Cause { flow, ground, surface };
constexpr std::array<const char*, 3> names_of(Cause) { return {"flow", "ground", "surface"}; }

// A force per element that is reported. Tables of drag, force sums and exports use this list. A new
// force needs one more row in evaluate.cpp.
struct ReportedForce {
  const char* name;
  const char* kind;  // kind of element, by its name in Model::fields
  Cause cause;
  // Returns the force (N, 3 per element) at the present state of the assembly.
  std::vector<double> (*of)(const Assembly& assembly);
};
const std::vector<ReportedForce>& reported_forces();

struct Evaluation {
  std::vector<double> force;  // net force, N, 3 per node
  std::vector<double> mass;   // mass and added mass without bodies, kg, 9 per node
  // Tension (N) and length (m) of one line per element. Cells are in list order. Straight bars of
  // plain cells, which do not exist, are 0.
  std::vector<double> bar_tension, bar_length;
  std::vector<double> u_tension, u_length, v_tension, v_length, straight_tension, straight_length;
  std::vector<std::vector<double>> forces;  // in the order of reported_forces(), N, 3 per element
  std::vector<PlateAttitude> plates;
  std::vector<double> ground_places;  // see Assembly::ground_places(), m, 3 each

  // Returns the force with this name. Throws std::out_of_range for an unknown name.
  const std::vector<double>& reported(const std::string& name) const;
};

// x (m), v (m/s): 3 per node.
Evaluation evaluate(Assembly& assembly, const double* x, const double* v);
// Evaluates the present state of the assembly. No nodes may be fixed by Assembly::hold().
Evaluation evaluate_here(Assembly& assembly);

}  // namespace codend
