// Implicit steps by Newton's method: backward Euler, BDF2 and the trapezoid.
//
// With h the step, x0 v0 a0 at its start, x1 v1 a1 at its end and x- v- one step before:
//   backward Euler  v1 = (x1 - x0)/h,          a1 = (v1 - v0)/h
//   BDF2            v1 = p (x1 - x0) - q (x0 - x-), a1 = p (v1 - v0) - q (v0 - v-),
//                   p = (1 + 2w)/((1 + w) h), q = w^2/((1 + w) h), w = h over the last step
//   trapezoid       v1 = 2 (x1 - x0)/h - v0,   a1 = 2 (v1 - v0)/h - a0
// and F(x1, v1) = M(x1) a1 on every free node. BDF2 damps what is too fast for its steps; the
// trapezoid keeps it ringing. The first step, and the first after an event, is backward Euler's,
// but for the trapezoid, which needs no step before.
//
// Newton's matrix is p^2 M - p dF/dv - dF/dx with the full nonsymmetric derivative of F (drag turns
// with its line). M is that of the present x1; its own change with x1 is not in the matrix. Added
// mass acts on accelerations of the nodes alone: no force from a line's turning while it moves,
// none from accelerations of the water.
//
// The error of a step comes from the difference of velocities over the last two: v[..], the second
// divided difference of v, is half of x''' (Hairer, Norsett, Wanner, Solving Ordinary Differential
// Equations I, III.5):
//   backward Euler h/2 |v1 - v0|; trapezoid h^3/6 |v[..]|;
//   BDF2 h^2 (h + h-)(1 + w)/(3 (1 + 2w)) |v[..]|.
#pragma once

#include <vector>

#include "../solve/block_lu.hpp"
#include "stepper.hpp"

namespace codend {

enum class NewtonScheme { backward_euler, bdf2, trapezoid };

class NewtonStep : public Stepper {
 public:
  // tolerance: a step is found when what Newton's method still has to move is less, m.
  NewtonStep(Assembly& assembly, NewtonScheme scheme, double tolerance);

  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  void begin(Motion& motion) override;
  int order() const override { return scheme_ == NewtonScheme::backward_euler ? 1 : 2; }

  long long factorisations() const { return factorisations_; }

 private:
  // v1 = p (x1 - x0) + v_rest, a1 = p (v1 - v0) + a_rest
  struct Rule {
    double p = 0.0;
    bool first_order = false;
  };
  Rule set_rule(const Past& past, double h);
  double estimate(const Past& past, const Motion& next, int& worst) const;

  Assembly& assembly_;
  NewtonScheme scheme_;
  double tolerance_;
  BlockLU lu_;
  bool analysed_ = false;
  long long factorisations_ = 0;
  Values v_rest_, a_rest_;
  std::vector<double> force_, mass_, values_, right_;
};

}  // namespace codend
