// Implicit steps by Newton's method: backward Euler, BDF2 and generalised alpha.
//
// With h the step, x0 v0 a0 at its start, x1 v1 a1 at its end and x- v- one step before, all rules are
// v1 = p (x1 - x0) + .., a1 = m (x1 - x0) + ..:
//   backward Euler  v1 = (x1 - x0)/h,          a1 = (v1 - v0)/h
//   BDF2            v1 = p (x1 - x0) - q (x0 - x-), a1 = p (v1 - v0) - q (v0 - v-),
//                   p = (1 + 2w)/((1 + w) h), q = w^2/((1 + w) h), w = h over the last step
//   generalised     x1 = x0 + h v0 + h^2 ((1/2 - B) b0 + B b1), v1 = v0 + h ((1 - G) b0 + G b1),
//   alpha           (1 - A) b1 + A b0 = (1 - C) a1 + C a0
// and F(x1, v1) = M(x1) a1 on every free node. BDF2 damps what is too fast for its steps. Generalised
// alpha (Chung and Hulbert, J. Appl. Mech. 60, 1993; for forces at x1 alone Arnold and Bruels,
// Multibody Syst. Dyn. 18, 2007) damps what is slower than its steps less and, in every step, all that
// is much faster by its spectral radius r = 0.4: C = r/(r + 1), A = (2 r - 1)/(r + 1), G = 1/2 + C - A,
// B = (1 + C - A)^2/4. (r = 1 is the trapezoid, which keeps what is left of stiff swings for ever.)
// The first step, and the first after an event, is backward Euler's.
//
// Newton's matrix is m M - p dF/dv - dF/dx with the full nonsymmetric derivative of F (drag turns
// with its line); tensions are unknowns of their own (march/line_tensions.hpp). M is that of the
// present x1; its own change with x1 is not in the matrix. Added mass acts on accelerations of the
// nodes, and of the water in F: no force from a line's turning while it moves. How waves change along x
// and y is not in the matrix either, but for the surface where volumes leave it.
//
// The first guess is x0 + h v0 + h^2/2 (v0 - v-)/h-. Linear equations are solved within a hundredth of
// their right side, each row over what its node may have left (solve/kept_factors.hpp); nodes that are
// held back take no part in them.
//
// A step is found when the forces of the law balance on every node: what is left is a small share of
// the pulls, drags and loads on that very node (balance_share), and Newton's method has next to nothing
// left to move.
//
// The error of a step comes from the difference of velocities over the last two: v[..], the second
// divided difference of v, is half of x''' (Hairer, Norsett, Wanner, Solving Ordinary Differential
// Equations I, III.5):
//   backward Euler h/2 (v1 - v0); generalised alpha 2 (B + (A - C)/2 - 1/6) h^3 v[..];
//   BDF2 h^2 (h + h-)(1 + w)/(3 (1 + 2w)) v[..].
// It is an error d of a step on its own; the forces answer to it at once, so that what stays of it is
// e = d - J^-1 K d, J Newton's matrix and K the stiffness of taut lines (after Hosea and Shampine,
// Appl. Numer. Math. 20, 1996). The error of position is the largest |e|, that of tension what e makes
// of the lines' strains.
#pragma once

#include <vector>

#include "../solve/kept_factors.hpp"
#include "line_tensions.hpp"
#include "stepper.hpp"

namespace codend {

enum class NewtonScheme { backward_euler, bdf2, generalised_alpha };

class NewtonStep : public Stepper {
 public:
  // ordering: 3 per node, m, by which unknowns are eliminated: the same ones give the same bytes.
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
    double error = 0.0;  // of a step, over (v1 - v0)/h - (v0 - v-)/h-, or v1 - v0 where first_order
    bool first_order = false;
  };
  Rule set_rule(const Past& past, double h);
  void follow(const Rule& rule, const Motion& now, Motion& next) const;
  // Largest net force over what a node allows.
  double imbalance(const Rule& rule, const Motion& next, int& worst);
  bool correct(const Rule& rule, bool first, double& share);
  double error(const Rule& rule, const Past& past, const Motion& next, int& worst);

  Assembly& assembly_;
  NewtonScheme scheme_;
  StepAccuracy accuracy_;
  LineTensions tensions_;
  KeptFactors factors_;
  Values v_rest_, a_rest_, b_rest_;
  std::vector<double> force_, mass_, inertia_, values_, right_, solved_, tolerated_, allowed_, dx_,
      answer_;
  std::vector<char> left_out_;
  DualTension pull_;
};

}  // namespace codend
