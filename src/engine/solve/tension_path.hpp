// Interior path to tension-only lines for Newton's method.
//
// A line is taut or slack. With the slack variable s = T/EA - strain, this means T >= 0, s >= 0 and
// T s = 0. Newton's method on T(strain) alternates between states, because a line that a step makes
// taut responds with its full EA only afterwards.
//
// Here tensions and slack variables are both unknowns, in addition to the positions, with T s = mu
// times a scale. Every line keeps a small tension, and mu decreases to zero during convergence (a
// primal-dual interior-point method; S. J. Wright, Primal-Dual Interior-Point Methods, SIAM 1997).
// The limit is the constitutive law. Separate unknowns s and T allow mu to fall by large factors.
// With s = mu/T eliminated, a step is valid only while T changes by less than its own value.
//
// Ground contacts use the same path, with normal force and penetration instead of tension and
// strain. Struts, which also carry compression, have a tension as unknown but no slack variable.
// Overstretch by the rotation of a linear step then does not stiffen the next step.
#pragma once

#include <algorithm>
#include <vector>

#include "../model/assembly.hpp"

namespace codend {

class TensionPath {
 public:
  // `load` is the sum of the loads on the gear, N. It limits the initial tensions.
  TensionPath(const Model& model, double load);

  // Starts from tensions and slack variables that match these strains at this mu, instead of making
  // every line taut. `near_parameter` is for positions near the solution, `settled_parameter` for a
  // solution under other loads.
  static constexpr double near_parameter = 1e-4, settled_parameter = 1e-9;
  double parameter() const { return parameter_; }
  void follow(const std::vector<double>& strain, double parameter);

  // Prepares a Newton step at these strains, with mu reduced by a factor to at least `least`. Sets
  // current() to T and the moduli of the matrix, predicted() to the tensions of the right side.
  void prepare(const Assembly& assembly, const std::vector<double>& strain, double reduction,
               double least);
  const DualTension& current() const { return current_; }
  const DualTension& predicted() const { return predicted_; }

  // Prepares a correction with the same matrix and mu, at the strains after the step. Then
  // correction() holds the tensions due to the missing strains.
  void correct(const Assembly& assembly, const std::vector<double>& strain);
  const DualTension& correction() const { return predicted_; }

  // Updates tensions and slack variables after the step by first-order changes of strain. `share`
  // is the fraction of the step that is taken. All values stay positive.
  void advance(const Assembly& assembly, const std::vector<double>& strain_change, double share);

  // State of the path, to restore it before a step.
  struct Place {
    std::vector<double> tension, slack;
    double parameter = 0.0;
  };
  void keep(Place& place) const;
  void go_back(const Place& place);

 private:
  // Computes the effect of sag on missing strains and a change of strains (or null), into sag_.
  void distribute_sag(const Assembly& assembly, const double* change);
  void add_sag(const Assembly& assembly);
  // ratio_: slack over tension in the step's matrix.
  std::vector<double> stiffness_, scale_, slack_, ratio_, centring_, mismatch_, sag_;
  // Unit of the slack variable: 1 for lines, a length (m) for contacts.
  double slack_unit(std::size_t k) const;
  // mu times the scale of T s.
  double product(std::size_t k) const;
  void follow(std::size_t k, double strain);
  void rest_contact(std::size_t k, double penetration);
  // Computes the difference between a line's strain and the strain of its tension and slack.
  void mismatch(std::size_t k, double strain, double stretched);
  void stretch(std::size_t k, double tension, double& strain, double& slope) const;

  std::vector<char> strut_;  // lines that also carry compression
  // Materials with measured load curves; null for other lines.
  std::vector<const TwineMaterial*> table_;
  std::size_t lines_;  // number of lines, before the contacts
  Ground ground_;
  bool begun_ = false;
  DualTension current_, predicted_;
  double parameter_;  // mu
};

}  // namespace codend
