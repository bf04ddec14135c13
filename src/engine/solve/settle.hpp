// Equilibrium of a model: positions of the free nodes with zero net force.
//
// Pseudo-transient Newton: (D/h - dF/dx) dx = F(x, v), with the full nonsymmetric derivative (drag
// turns with its line; without that part Newton does not converge), D a drag-like damping per node
// and h a pseudo time step that grows while lines turn little per step. Near the end h grows
// without bound and the step is plain Newton's.
#pragma once

#include <functional>
#include <vector>

#include "../assembly.hpp"

namespace codend {

struct SettleProgress {
  int iteration;
  double residual;  // largest nodal force over largest tension
  double movement;  // largest displacement of the last step, m
};

struct SettleControl {
  double tolerance = 1e-8;   // on residual
  int iterations = 500;      // at most
  // Called once an iteration; returns false to stop.
  std::function<bool(const SettleProgress&)> watch;
};

struct SettleReport {
  bool converged = false;
  bool stopped = false;       // by watch
  int iterations = 0;
  int factorisations = 0;
  double residual = 0.0;
  double largest_tension = 0.0;  // N
  int worst_node = -1;        // where the largest net force acts
  double worst_force = 0.0;   // N
  double seconds_forces = 0.0, seconds_jacobian = 0.0, seconds_linear = 0.0;  // CPU
  double seconds_analysis = 0.0;
};

// x: 3 per node (m), the start on entry and the result on return; held nodes stay. v: 3 per node
// (m/s), how the held nodes move in the frame of the gear; usually zero.
SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x);

}  // namespace codend
