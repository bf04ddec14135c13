// Equilibrium of a model: positions of the free nodes with zero net force.
//
// Newton's method with the full nonsymmetric derivative (drag turns with its line; without that
// part it does not converge), made global in two ways: lines become tension-only along an interior
// path (solve/tension_path.hpp), and a drag-like damping D/h holds the nodes back, with a pseudo
// time step h that grows while lines turn little. Near the end both are gone and the step is plain
// Newton's on the law itself. An equilibrium that is unstable (stability.hpp) is perturbed, and the
// nodes are held back until they have followed.
#pragma once

#include "../model/assembly.hpp"
#include "part_balance.hpp"
#include "settle_control.hpp"

namespace codend {

struct SettleCost {
  int iterations = 0, factorisations = 0;
  long long force_evaluations = 0;
  long long factor_entries = 0;  // numbers stored for L and U by the largest factorisation
  double seconds_analysis = 0.0, seconds_forces = 0.0, seconds_jacobian = 0.0,
         seconds_linear = 0.0;  // CPU

  void add(const SettleCost& other);
};

struct SettleReport : SettleCost {
  bool converged = false;
  double residual = 0.0;
  double first_residual = 0.0;   // of the start
  double largest_tension = 0.0;  // N
  int wake_renewals = 0;         // times that wakes were renewed
  int perturbations = 0;         // times that an unstable equilibrium was perturbed
  bool unstable = false;         // whether the last one is still unstable
  double wake_change = 0.0;      // of any point's share of the free flow's speed, the last time
  int worst_node = -1;           // where the largest net force acts
  double worst_force = 0.0;      // N
  // Of the shape that was found, or came last.
  PartResidual parts;
};

// x: 3 per node (m), the start on entry and the result on return; held nodes stay. v: 3 per node
// (m/s), how the held nodes move in the frame of the gear; usually zero.
SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x);

// The same; a settled start that is given up begins again, as one that is near where its residual was
// below LawControl's near_residual, else as any. Steps and seconds are those of both.
SettleReport settle_from(Assembly& assembly, const SettleControl& control, const double* v,
                         double* x);

}  // namespace codend
