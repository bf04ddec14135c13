// The tensions of lines as unknowns beside the positions, for Newton's method on a time step.
//
// A stiff line that an iteration turns by an angle is stretched by its square, and the law then
// answers with all of EA times that: Newton's method on positions alone follows stretches that no
// motion has. Here every line carries a tension that follows the law's linear change, and is taut or
// slack as that change says (an active set), so that a line neither stiffens by its own turning nor
// swings between taut and slack:
//
//   right side  T_k of a taut line EA s + c ds/dt, not clipped: it may push meanwhile; 0 of a slack one
//   matrix      geometric stiffness of the dual T_k, modulus EA of a taut line, 0 of a slack one
//   after dx    l_k = EA (s + ds_k) + c (ds/dt + p ds_k), taut_k = l_k > 0,
//               T_k += share (max(l_k, 0) - T_k)
//
// Bows of cells' twines are led by these tensions too, and ds_k is that of bows that follow the law to
// where it balances them after dx (elements/bows.hpp): linear bows of twines that are about to go slack
// swing between two states for ever. Where both agree with the law the step is found. Contacts with
// the ground keep their own law.
#pragma once

#include <vector>

#include "../model/assembly.hpp"

namespace codend {

class LineTensions {
 public:
  explicit LineTensions(Assembly& assembly);

  // All of the following speak of the assembly's last positions.
  // Starts from the law's tensions.
  void begin();
  // Lines that the law has taut are taut.
  void tighten();
  // Before a step of Newton's method: the tensions of its right side and those of its matrix, at
  // bows that these lead until the assembly moves.
  void prepare();
  const DualTension& right() const { return right_; }
  const DualTension& current() const { return current_; }

  // After the step, of which `share` is taken: changes of strain, to first order, and what a change
  // of position makes of velocity, 1/s.
  void advance(const std::vector<double>& strain_change, double p, double share);

  // Changes of strain, to first order, with what bows of cells' twines add; valid until the next call.
  const std::vector<double>& with_bows(const std::vector<double>& strain_change);

  // Change of the tension (N) of line k of the last prepare() by a change of its strain.
  double change(std::size_t k, double strain_change, double p) const;

 private:
  Assembly& assembly_;
  std::size_t lines_;
  std::vector<char> taut_;
  DualTension right_, current_;
  std::vector<double> strain_change_, mismatch_;
  std::vector<double> linear_;  // tensions of the law before it is clipped, N
};

}  // namespace codend
