// Tension-only lines for a Newton method: an interior path to them.
//
// A line is taut or slack: with the slack variable s = T/EA - strain, T >= 0, s >= 0 and T s = 0.
// Newton's method on T(strain) itself cycles, because a line that a step makes taut answers with
// its whole EA only afterwards. Here tensions and slack variables are both unknowns beside the
// positions, and T s = mu times a scale: every line keeps a little tension, and mu goes to zero
// while the shape is found (a primal-dual interior-point method; S. J. Wright, Primal-Dual
// Interior-Point Methods, SIAM 1997). Contacts with the ground are the same: what is said of
// tension and strain here holds of their normal force and penetration. Struts, which also push,
// carry their tension as an unknown too, without a slack variable: a turn that a linear step
// overstretches does not stiffen the next one. What is left at the end is the law itself.
// Carrying s as well as T lets mu fall by large factors: with s = mu/T eliminated, a step is good
// only while T changes by less than itself.
#pragma once

#include <algorithm>
#include <vector>

#include "../model/assembly.hpp"

namespace codend {

class TensionPath {
 public:
  // load: the sum of the loads on the gear, N, which bounds the first guess of tensions.
  TensionPath(const Model& model, double load);

  // Starts from tensions and slack variables that agree with these strains at this mu, for positions that
  // are nearly settled (near_parameter) or were under other loads (settled_parameter), instead of
  // pulling every line taut.
  static constexpr double near_parameter = 1e-4, settled_parameter = 1e-9;
  double parameter() const { return parameter_; }
  void follow(const std::vector<double>& strain, double parameter);

  // Before a Newton step at strains towards `reduction` times the present mu, or `least`: after it `current()`
  // holds T and the modulus of the step's matrix, `predicted()` the tensions of its right side.
  void prepare(const Assembly& assembly, const std::vector<double>& strain, double reduction,
               double least);
  const DualTension& current() const { return current_; }
  const DualTension& predicted() const { return predicted_; }

  // The same at the strains that a step with this matrix has led to, for another one with it and the same
  // mu: correction() holds the tensions that answer to what strains miss, current() the others.
  void correct(const Assembly& assembly, const std::vector<double>& strain);
  const DualTension& correction() const { return predicted_; }

  // After the step: tensions and slack variables follow the strains' first-order changes, taken `share`
  // of the way, and stay positive.
  void advance(const Assembly& assembly, const std::vector<double>& strain_change, double share);

  // Where it is, to come back to before a step.
  struct Place {
    std::vector<double> tension, slack;
    double parameter = 0.0;
  };
  void keep(Place& place) const;
  void go_back(const Place& place);

 private:
  // What bows make of the strains that are missed, and of a change of strains (or null), into bow_.
  void share_bows(const Assembly& assembly, const double* change);
  void add_bows(const Assembly& assembly);
  // ratio_: of slack to tension, in the step's matrix.
  std::vector<double> stiffness_, scale_, slack_, ratio_, centring_, mismatch_, bow_;
  // follow() of one line or contact at the present mu.
  void follow(std::size_t k, double strain);
  void rest_contact(std::size_t k, double penetration);
  // What a line's strain misses of that of its tension and slack variable, on the way to mu.
  void mismatch(std::size_t k, double strain, double stretched);
  // Strain that a tension makes, and its derivative.
  void stretch(std::size_t k, double tension, double& strain, double& slope) const;

  std::vector<char> strut_;  // lines that also push
  // Materials of lines whose loads are given by strain, null for others.
  std::vector<const TwineMaterial*> table_;
  std::size_t lines_;  // before the contacts
  Ground ground_;
  bool begun_ = false;
  DualTension current_, predicted_;
  double parameter_;  // mu
};

}  // namespace codend
