// Implicit steps of the scheme TR-BDF2, solved by Newton's method.
//
// A step h from x0 v0 a0 has two stages: the trapezoidal rule to the time g h, and the backward
// difference of second order through its start, this stage (xg vg) and its end x1 v1 a1. With
// g = 2 - sqrt(2) both stages have the same coefficient p = 2/(g h):
//
//   stage 1  vg = p (xg - x0) - v0,            ag = p (vg - v0) - a0
//   stage 2  v1 = p (x1 - c xg + (c - 1) x0),  a1 = p (v1 - c vg + (c - 1) v0),  c = 1/(g (2 - g))
//
// They are solved with F(x, v) = M(x) a on every free node. The scheme is of second order and
// L-stable: it removes oscillations that are too fast for the step. A slow oscillation w loses the
// fraction 0.0037 (w h)^4 of its amplitude in a step and gains 0.0404 (w h)^3 of phase. Analysis:
// Bank, Coughran, Fichtner, Grosse, Rose and Smith, IEEE Trans. Electron Devices 32 (1985); Hosea
// and Shampine, Appl. Numer. Math. 20 (1996). Generalised alpha and BDF2 need one solution for a
// step, but have at least 3.5 times the error constant, and BDF2 needs equal steps.
//
// The first step, and the first step after a discontinuity, is backward Euler, because a0 is then
// unknown: v1 = (x1 - x0)/h, a1 = (v1 - v0)/h.
//
// Newton's matrix is p^2 M - p dF/dv - dF/dx with the full nonsymmetric derivative of F, because
// drag rotates with its line. Tensions are separate unknowns (motion/line_tensions.hpp). The matrix
// neglects the derivative of M(x1). It also neglects changes of waves along x and y, except at the
// surface where volumes leave the water. Added mass acts on the accelerations of nodes and of the
// water. No force arises from the rotation of a moving line.
//
// The initial guess of a stage is quadratic in time, with the last change of velocity. Linear
// equations are solved to a hundredth of their right side, with rows scaled by the allowed residual
// of the node (solve/stored_factorisation.hpp). They exclude nodes fixed by Assembly::hold().
//
// A stage has converged when the residual of every node is a small fraction of the tensions, drags
// and loads on this node (balance_share), and the remaining correction is negligible.
//
// The error of a step follows from the velocities at its start, stage and end. Their second divided
// difference is half of the third derivative of x (Hosea and Shampine, loc. cit.):
//
//   TR-BDF2         2 k h (v0/g - vg/(g (1 - g)) + v1/(1 - g)),  k = (-3 g^2 + 4 g - 2)/(12 (2 - g))
//   backward Euler  h/2 (v1 - v0)
//
// This is the local error d. Forces respond to it immediately, so e = d - J^-1 K d remains, with J
// Newton's matrix and K the stiffness of taut lines (Hosea and Shampine). The position error is the
// largest |e|; its strains of lines give the tension error.
#pragma once

#include <vector>

#include "../solve/stored_factorisation.hpp"
#include "line_tensions.hpp"
#include "stepper.hpp"

namespace codend {

class NewtonStep : public Stepper {
 public:
  // ordering: positions (m, 3 per node) for the elimination order; equal ones give equal results.
  NewtonStep(Assembly& assembly, const StepAccuracy& accuracy, const Values& ordering);

  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return 2; }

  void forget() override { factors_.forget(); }

  long long factorisations() const override { return factors_.factorisations(); }
  long long factor_entries() const override { return factors_.entries(); }

 private:
  // v = p (x - x0) + v_rest_, a = p^2 (x - x0) + a_rest_
  void follow(const Motion& now, Motion& next) const;
  // Returns the allowed position error (m) of a step with these displacements (m, 3 per node).
  double allowed_error(const Values& moved) const;
  // Guesses the positions of the free nodes at the end of a stage from `begin`, at which velocities
  // changed by `change` (m/s2). Excludes nodes that are held back.
  void guess(const Motion& begin, const Values& change, Motion& next);
  // Solves one stage, from the guess in `end`.
  StepOutcome solve_stage(const Motion& now, double found, bool first, Motion& end);
  // Returns the largest net force over the allowed residual of its node.
  double imbalance(const Motion& next, int& worst);
  bool correct(bool first, double& share);
  // Sets the error of a step in `out` from the local error of the free nodes (m) in dx_.
  void filter_error(double allowed, StepOutcome& out);

  Assembly& assembly_;
  StepAccuracy accuracy_;
  LineTensions tensions_;
  StoredFactorisation factors_;
  double p_ = 0.0;  // 1/s
  Values v_rest_, a_rest_;
  Motion stage_;
  std::vector<double> force_, mass_, inertia_, values_, right_, solved_, tolerated_, allowed_, dx_,
      answer_;
  std::vector<char> left_out_;
  DualTension pull_;
};

}  // namespace codend
