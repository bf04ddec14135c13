// Explicit steps: cheap, but limited in length by stability (motion/fastest_rates.hpp).
//
//   symplectic Euler  v1 = v0 + h a(x0, v0), x1 = x0 + h v1
//   RK4               the classical Runge-Kutta method of order 4 for (x, v)
#pragma once

#include <algorithm>
#include <cmath>

#include "accelerate.hpp"
#include "stepper.hpp"

namespace codend {

class SymplecticEulerStep : public Stepper {
 public:
  SymplecticEulerStep(Assembly& assembly, const Motion& start)
      : free_(assembly.free_nodes()), acceleration_(assembly, start.x.data(), start.v.data()) {}

  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return 1; }
  // Stability limit (h w)^2 + 2 h g < 4 of an oscillator with frequency w and damping g.
  double longest_step(const FastestRates& rates) const override {
    const double w = rates.oscillation, g = rates.decay;
    return 4.0 / (g + std::sqrt(g * g + 4.0 * w * w));
  }

 private:
  const std::vector<int>& free_;
  Acceleration acceleration_;
  Values a_;
};

class RungeKuttaStep : public Stepper {
 public:
  RungeKuttaStep(Assembly& assembly, const Motion& start)
      : free_(assembly.free_nodes()), acceleration_(assembly, start.x.data(), start.v.data()) {}

  StepOutcome step(const Past& past, double h, Conditions& conditions, Motion& next) override;
  int order() const override { return 4; }
  // Stability limits: 2.78 on the real axis, 2.83 on the imaginary axis.
  double longest_step(const FastestRates& rates) const override {
    return 2.78 / std::max(rates.oscillation, rates.decay);
  }

 private:
  const std::vector<int>& free_;
  Acceleration acceleration_;
  Values a_[4], v_[4];
};

}  // namespace codend
