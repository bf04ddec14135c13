// Static equilibrium of a model: positions of the free nodes with zero net force.
//
// The solver is Newton's method with the full nonsymmetric derivative. It does not converge without
// the rotation of drag with its line. Two measures make it globally convergent. Lines become
// tension-only along an interior path (solve/tension_path.hpp). A drag-like damping D/h restrains
// the nodes, with a pseudo time step h that grows while lines rotate little. Both vanish near the
// solution, where the step is plain Newton on the constitutive law.
//
// The only fallback is continuation in the parameter of the interior path (PathControl).
//
// An unstable equilibrium (stability.hpp) is perturbed, and nodes are damped until they follow.
#pragma once

#include "../model/assembly.hpp"
#include "part_equilibrium.hpp"
#include "settle_control.hpp"

namespace codend {

struct SettleCost {
  int iterations = 0, factorisations = 0;
  long long force_evaluations = 0;
  long long factor_entries = 0;  // entries of L and U in the largest factorisation
  double seconds_analysis = 0.0, seconds_forces = 0.0, seconds_jacobian = 0.0,
         seconds_linear = 0.0;  // CPU

  void add(const SettleCost& other);
};

struct SettleReport : SettleCost {
  bool converged = false;
  bool stopped = false;  // by SettleControl::watch
  double residual = 0.0;
  double first_residual = 0.0;   // at the start
  double largest_tension = 0.0;  // N
  int wake_renewals = 0;
  int perturbations = 0;
  bool unstable = false;     // the last equilibrium is unstable
  double wake_change = 0.0;  // largest last change of a point's flow speed, over the free flow
  int worst_node = -1;       // node of the largest net force
  double worst_force = 0.0;  // N
  // Parts of the final shape.
  PartResidual parts;
};

// Solves for equilibrium. `x` is the start on entry and the result on return (m, 3 per node). `v`
// are the velocities of fixed nodes in the frame of the gear (m/s, 3 per node), usually zero.
SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x);

// Returns the control of an attempt on the direct path or on the gradual one (PathControl). The
// gradual path gets the remaining iterations.
SettleControl attempt(SettleControl control, bool gradual);
// True if an attempt on the gradual path must follow one on the direct path.
bool needs_gradual_path(const SettleReport& direct, int iterations);

// Calls settle() on the direct path and, if needed, on the gradual one. The cost includes both.
SettleReport settle_from(Assembly& assembly, const SettleControl& control, const double* v,
                         double* x);

}  // namespace codend
