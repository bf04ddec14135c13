// Tensions of lines as extra unknowns of Newton's method in a time step.
//
// An iteration that rotates a stiff line by an angle also stretches it, by the square of this
// angle. The constitutive law turns this artificial stretch into a force EA times as large.
// Newton's method in positions alone then follows stretches that do not exist.
//
// This class gives every line its own tension, which follows the linearised law. An active set
// marks each line as taut or slack. Rotation therefore does not stiffen a line, and lines do not
// alternate between taut and slack:
//
//   right side  T_k of a taut line: EA s + c ds/dt, possibly negative; 0 of a slack line
//   matrix      geometric stiffness of the dual T_k; modulus EA of a taut line, 0 of a slack line
//   after dx    l_k = EA (s + ds_k) + c (ds/dt + p ds_k), taut_k = l_k > 0,
//               T_k += share (max(l_k, 0) - T_k)
//
// The same tensions set the sag of cell twines. Here ds_k includes the change of sag to its
// equilibrium after dx (elements/sag.inl), because linearised sag of nearly slack twines
// oscillates between two states. The step has converged when tensions and sag satisfy the law.
// Ground contacts use their own law.
#pragma once

#include <vector>

#include "../model/assembly.hpp"

namespace codend {

class LineTensions {
 public:
  explicit LineTensions(Assembly& assembly);

  // Starts from the tensions of the constitutive law.
  void begin();
  // Also marks lines as taut that the constitutive law makes taut.
  void tighten();
  // Computes the tensions of the right side and the matrix, and sets the sag of cell twines.
  void prepare();
  const DualTension& right() const { return right_; }
  const DualTension& current() const { return current_; }

  // Updates the tensions after a Newton step. strain_change: first order. p: derivative of velocity
  // by position, 1/s. share: fraction of the step that is taken.
  void advance(const std::vector<double>& strain_change, double p, double share);

  // Returns strain_change (first order) plus the change due to sag. Valid until the next call.
  const std::vector<double>& with_sag(const std::vector<double>& strain_change);

  // Returns the change of tension (N) of line k, linearised at the last prepare().
  double change(std::size_t k, double strain_change, double p) const;

 private:
  Assembly& assembly_;
  std::size_t lines_;
  std::vector<char> taut_;
  DualTension right_, current_;
  std::vector<double> strain_change_, mismatch_;
  std::vector<double> linear_;  // tensions of the unclipped law, N
};

}  // namespace codend
