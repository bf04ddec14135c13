// Tension-only lines for a Newton method: an interior path to them.
//
// A line is taut or slack: T >= 0, s = T/EA - strain >= 0, T s = 0. Newton's method on T(strain)
// itself cycles, because a line that a step makes taut answers with its whole EA only afterwards.
// Here tensions are unknowns beside the positions and T s = mu: every line keeps a little tension,
// and mu goes to zero while the shape is found (a primal-dual interior-point method; S. J. Wright,
// Primal-Dual Interior-Point Methods, SIAM 1997). What is left at the end is the law itself.
#pragma once

#include <vector>

#include "../assembly.hpp"

namespace codend {

class TensionPath {
 public:
  // load: the sum of the loads on the gear, N, which bounds the first guess of tensions.
  TensionPath(const Model& model, double load);

  // Before a Newton step at strains: after it `current()` holds T and the modulus of the step's
  // matrix, `predicted()` the tensions that its right side uses.
  void prepare(const std::vector<double>& strain);
  const CarriedTension& current() const { return current_; }
  const CarriedTension& predicted() const { return predicted_; }

  // After the step: tensions follow the strains' first-order changes, taken `share` of the way,
  // and stay positive.
  void advance(const std::vector<double>& strain_change, double share);

  // Tensions on the path at given strains: after steps taken without the path.
  void return_to(const std::vector<double>& strain);

  // mu, as a share of its scale in every line.
  double parameter() const { return parameter_; }
  void reduce(double factor) { parameter_ *= factor; }
  void restart(double parameter) { parameter_ = parameter; }

 private:
  std::vector<double> stiffness_, scale_, mismatch_;
  CarriedTension current_, predicted_;
  double parameter_ = 0.1;
};

}  // namespace codend
