// Tolerances and parameters of the static solution.
//
// The parameters change speed and robustness. The tolerances set the accuracy of the result.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "../model/wake.hpp"

namespace codend {

struct SettleProgress {
  int iteration;
  double residual;  // largest nodal force over largest tension
};

// Type of the initial guess: any shape; near the result, such as a shape from another mesh; or a
// solution for the same mesh with other input values. A settled start takes undamped Newton steps
// with its stored tensions.
enum class Start { crude, near, settled };
constexpr std::array<const char*, 3> names_of(Start) { return {"crude", "near", "settled"}; }

// Damping D/h (pseudo_time.hpp). Rotation is the largest change of a line's vector in one step,
// over its rest length. A linear step does not predict a line that rotates by more than its own
// length, and not the buoyancy of a body that enters or leaves the water. A step is therefore
// reduced to the target rotation, at first 1, and h is multiplied by the target over the rotation.
struct PseudoTimeControl {
  // Weight of a plate's turn compared with a line's rotation, except during convergence from a
  // settled state. Plate forces change within a few degrees, which a linear step does not predict.
  // With 12, some of 300 kites converge to an equilibrium far from their start; with 20, none.
  double plate_turns = 20.0;
  // The shape has converged below this rotation. A rotation t changes strains by t^2/2, which the
  // step neglects: at most 2e-4.
  double found_rotation = 0.02;
  // In fall times: practically undamped; first step from a settled shape.
  double longest = 1e6;
  // Most starts need at most this many steps. Later steps are compared with their correction until
  // convergence. If the correction is larger than the step, the next target rotation is `shorter`
  // times this one. Otherwise it grows up to 1. A singular matrix shortens h by the same factor.
  int free_steps = 10;
  double shorter = 0.7;
};

// Stabilisation of netting parallel to the flow. Its tension is nearly zero, so that steps would
// rotate it beyond the validity of their matrix. The matrix adds `share` of each line's drag across
// the flow to its tension, in proportion to the last rotation up to `rotation`. This resists
// rotation but not translation.
struct HeldControl {
  double share = 0.3, rotation = 0.2;
};

// Interior path (tension_path.hpp). Each step multiplies its parameter mu by the rotation of the
// last step, because small tensions depend on the present shape.
struct PathControl {
  double least_factor = 0.02;
  // Lower bound of mu: `least_by_turn` times the square of the last rotation. mu rises to it by at
  // most `most_rise` per step. While lines rotate, small tensions are meaningless.
  double least_by_turn = 1e-8, most_rise = 10.0;
  // Near convergence, the main error of a step is the product of its changes of tension and slack.
  // The same factorisation corrects it, for corrections below this fraction of the step (Mehrotra
  // 1992, On the implementation of a primal-dual interior point method, SIAM J. Optim. 2, 575-601).
  double most_correction = 0.5;
  // Limit of iterations on this direct path. Without convergence, the solution restarts on the
  // gradual path, where mu falls only when the shape has converged: first by `gradual_factor`, then
  // by the power 3/2 of the last factor. After `patience` steps without convergence, the iteration
  // returns to the last converged shape and takes the square root of the factor. It also halves the
  // limit of rotations, which convergence doubles again.
  static constexpr int direct_iterations = 300;
  double gradual_factor = 0.1;
  int patience = 60;
};

// Trials of the constitutive law. A trial fails if the shape is no longer converged, or if `steps`
// do not reduce the residual below `closing` times its first value. The path then continues from
// its last state. The next trial follows after `steps` path steps, and twice as many after each
// failure. Unsuccessful trials therefore remain a small fraction of all steps.
struct LawControl {
  double residual = 1e-4;  // of the path's shape, below which a trial starts
  // A start with a smaller residual is near the solution.
  double near_residual = 0.1;
  int steps = 3;
  double closing = 0.3;
};

// Linear equations of a step.
struct LinearControl {
  // `tolerance` is the relative residual of linear solves; more accuracy does not improve Newton's
  // method. Above `limit`, later factorisations use double precision.
  double tolerance = 1e-4, limit = 0.1;
};

// Iterations from a settled shape under changed loads. If the smallest rotation does not fall by
// `contraction` in `contracting_steps` steps, slack netting wanders. The iteration then continues
// from its present shape with mu = `relaxed_by_turn` times the square of the last rotation.
struct SettledControl {
  int contracting_steps = 4;
  double contraction = 0.5;
  double relaxed_by_turn = 1e-5;
};

// Wakes. They are updated on every settled shape until no point's flow speed changes by more than
// `tolerance` of the free flow. Upstream netting is searched once near equilibrium, because points
// at the border of a wake would alternate, at the cost of a full solution each time.
struct WakeControl {
  double tolerance = wake_tolerance;
  int renewals = 20;
  // Wakes are also updated before equilibrium, except from a settled state. This requires a
  // converged shape and a residual below LawControl's `residual` (near start: `near_residual`). A
  // near start also updates and searches them while mu is at least this value.
  double far_parameter = 1e-6;
};

// Perturbation of unstable equilibria (stability.hpp). Its size is a fraction of the smallest
// unstable element: small compared with the element, but too large for Newton's method to reverse.
// For `steps` steps, h is at most `pace` over the growth rate, so that steps follow the motion.
struct PerturbationControl {
  double size = 0.1, pace = 0.4;
  int steps = 40;
  int most = 4;  // perturbations, in alternating directions
};

struct SettleControl {
  double tolerance = 1e-8;  // of the residual, or its rounding error if larger
  int iterations = 500;     // limit
  bool gradual = false;     // on the gradual path (PathControl)
  Start start = Start::crude;
  // Strains of all lines in a similar state, which set the first tensions of a near or settled
  // start; empty: strains of x.
  std::vector<double> strain;
  // Part of every line (part_equilibrium.hpp); empty: one part. The residual of each part must be below
  // `part_tolerance` of its own forces.
  std::vector<int> part;
  double part_tolerance = 1e-6;
  bool timed = true;  // the report contains CPU seconds
  // Called once per iteration. Returns false to stop.
  std::function<bool(const SettleProgress&)> watch;
  // Called a few times per second during linear solves. An exception from it ends the solution.
  std::function<void()> pause;

  // Limit of the rounding force of an equilibrium, over the sum of all loads.
  double greatest_rounding = 1e-3;
  PseudoTimeControl pseudo_time;
  HeldControl held;
  PathControl path;
  LawControl law;
  LinearControl linear;
  SettledControl settled;
  WakeControl wake;
  PerturbationControl perturbation;
};

}  // namespace codend
