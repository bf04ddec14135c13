// Implicit steps by Newton's method: backward Euler, BDF2 and generalised alpha.
//
// Notation: step h; x0 v0 a0 at its start, x1 v1 a1 at its end, x- v- one step before. All rules
// are linear, v1 = p (x1 - x0) + .., a1 = m (x1 - x0) + ..:
//
//   backward Euler  v1 = (x1 - x0)/h,          a1 = (v1 - v0)/h
//   BDF2            v1 = p (x1 - x0) - q (x0 - x-), a1 = p (v1 - v0) - q (v0 - v-),
//                   p = (1 + 2w)/((1 + w) h), q = w^2/((1 + w) h), w = h over the last step
//   generalised     x1 = x0 + h v0 + h^2 ((1/2 - B) b0 + B b1), v1 = v0 + h ((1 - G) b0 + G b1),
//   alpha           (1 - A) b1 + A b0 = (1 - C) a1 + C a0
//
// They are solved with F(x1, v1) = M(x1) a1 on every free node. The first step, and the first step
// after a discontinuity, is backward Euler.
//
// BDF2 damps oscillations that are too fast for the step. Generalised alpha (Chung and Hulbert, J.
// Appl. Mech. 60, 1993; for forces at x1 only: Arnold and Bruels, Multibody Syst. Dyn. 18, 2007)
// damps slow oscillations less. Each step reduces fast ones by the spectral radius, r = 0.4:
//
//   C = r/(r + 1), A = (2 r - 1)/(r + 1), G = 1/2 + C - A, B = (1 + C - A)^2/4.
//
// The value r = 1 is the trapezoidal rule, which never damps stiff oscillations.
//
// Newton's matrix is m M - p dF/dv - dF/dx with the full nonsymmetric derivative of F, because drag
// rotates with its line. Tensions are separate unknowns (motion/line_tensions.hpp). The matrix
// neglects the derivative of M(x1). It also neglects changes of waves along x and y, except at the
// surface where volumes leave the water. Added mass acts on the accelerations of nodes and of the
// water. No force arises from the rotation of a moving line.
//
// The initial guess is x0 + h v0 + h^2/2 (v0 - v-)/h-. Linear equations are solved to a hundredth
// of their right side, with rows scaled by the allowed residual of the node
// (solve/stored_factorisation.hpp). They exclude nodes fixed by Assembly::hold().
//
// A step has converged when the residual of every node is a small fraction of the tensions, drags
// and loads on this node (balance_share), and the remaining correction is negligible.
//
// The error of a step follows from the velocities of the last two steps. The second divided
// difference of v, v[..], is half of x''' (Hairer, Norsett, Wanner, Solving Ordinary Differential
// Equations I, III.5):
//
//   backward Euler     h/2 (v1 - v0)
//   generalised alpha  2 (B + (A - C)/2 - 1/6) h^3 v[..]
//   BDF2               h^2 (h + h-)(1 + w)/(3 (1 + 2w)) v[..]
//
// This is the local error d. Forces respond to it immediately, so e = d - J^-1 K d remains, with J
// Newton's matrix and K the stiffness of taut lines (after Hosea and Shampine, Appl. Numer. Math.
// 20, 1996). The position error is the largest |e|; its strains of lines give the tension error.
#pragma once

#include <vector>

#include "../solve/stored_factorisation.hpp"
#include "line_tensions.hpp"
#include "stepper.hpp"

namespace codend {

enum class NewtonScheme { backward_euler, bdf2, generalised_alpha };

class NewtonStep : public Stepper {
 public:
  // ordering: positions (m, 3 per node) for the elimination order; equal ones give equal results.
  NewtonStep(Assembly& assembly, NewtonScheme scheme, const StepAccuracy& accuracy,
             const Values& ordering);

  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return scheme_ == NewtonScheme::backward_euler ? 1 : 2; }

  void forget() override { factors_.forget(); }

  long long factorisations() const override { return factors_.factorisations(); }
  long long factor_entries() const override { return factors_.entries(); }

 private:
  // v1 = p (x1 - x0) + v_rest, a1 = m (x1 - x0) + a_rest; b1 = b_by_a a1 + b_rest
  struct Rule {
    double p = 0.0, m = 0.0, b_by_a = 1.0;
    double error = 0.0;  // factor of (v1 - v0)/h - (v0 - v-)/h-, or of v1 - v0 if first_order
    bool first_order = false;
  };
  Rule set_rule(const Past& past, double h);
  void follow(const Rule& rule, const Motion& now, Motion& next) const;
  // Returns the largest net force over the allowed residual of its node.
  double imbalance(const Rule& rule, const Motion& next, int& worst);
  bool correct(const Rule& rule, bool first, double& share);
  double error(const Rule& rule, const Past& past, const Motion& next, int& worst);

  Assembly& assembly_;
  NewtonScheme scheme_;
  StepAccuracy accuracy_;
  LineTensions tensions_;
  StoredFactorisation factors_;
  Values v_rest_, a_rest_, b_rest_;
  std::vector<double> force_, mass_, inertia_, values_, right_, solved_, tolerated_, allowed_, dx_,
      answer_;
  std::vector<char> left_out_;
  DualTension pull_;
};

}  // namespace codend
