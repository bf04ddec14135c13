// Newton steps towards equilibrium, on the interior path of dual tensions (tension_path.hpp) or,
// near convergence, on the constitutive law.
//
// A failed trial of the law returns to its start, and the path continues from there. A path step
// with small rotations is corrected once with the same factorisation.
#pragma once

#include <vector>

#include "linear_step.hpp"
#include "pseudo_time.hpp"
#include "settle.hpp"
#include "stability.hpp"
#include "tension_path.hpp"

namespace codend {

class SettleIteration {
 public:
  // v, x: see settle(). `report` receives the state of the present positions.
  SettleIteration(Assembly& assembly, const SettleControl& control, const double* v, double* x,
                  SettleReport& report);

  // Computes the net forces of the constitutive law.
  void measure();

  // Restarts from a crude start in x.
  void begin();
  // Starts from the present measured positions as nearly settled. Strains: of the control, or x.
  void begin_near();
  // Starts from the present measured positions as settled under other loads, with equal strains.
  void begin_settled();
  // Continues from a settled shape, measured, under changed loads. Tries the constitutive law
  // first, then the path from this shape's tensions.
  void resume();

  // True if the shape has converged and its net forces are within the tolerance or rounding.
  bool balanced();
  // True if the shape is near enough to equilibrium for an update of the wake.
  bool nearly_balanced() const;
  // True if tensions are far from the constitutive law, so that lines yield to changed loads.
  bool far_on_path() const;
  // Reports the residual of every part, as measured.
  void judge_parts();
  // True if steps from a settled shape do not contract.
  bool wanders() const;
  // Continues from the present shape with new tensions at a larger mu, and damped.
  void relax();
  // Takes one Newton step. After a singular matrix it only increases the damping of the next step.
  void step();

  // True if the equilibrium may be unstable.
  bool may_be_unstable();
  bool only_walls_may_be_unstable() const { return unstable_size(assembly_, false) == 0.0; }
  // Returns the fastest growing motion of the equilibrium.
  GrowingMotion growing_motion();
  // Moves along the growing motion, or against it if `backwards`, and restarts the path.
  void perturb(const GrowingMotion& motion, bool backwards);

 private:
  void follow(double parameter);
  void choose_law();
  void leave_law();
  void count_settled_step();
  void try_law();
  double reduction();
  double gradual_reduction();
  double least_parameter() const;
  const DualTension& matrix_tension();
  void spread_step();
  void move();
  void take(const LineChange& change, double share);
  void correct();
  void take_rest();
  double correction_over_step(double share);
  void take_right_side();
  bool at_rounding() const;
  double rounding_force() const;
  double total_load();
  double scale() const;

  Assembly& assembly_;
  const SettleControl& control_;
  SettleReport& report_;
  const std::vector<int>& free_;
  const double* v_;
  double* x_;
  std::vector<double> force_, dx_, right_, step_, damping_, values_, pull_, strain_;
  const double load_;       // N
  const double rounding_;   // N
  const double fall_time_;  // of the start; unit of pseudo time, s
  bool from_settled_ = false;
  double unstable_size_ = 0.0;  // m
  PseudoTime pseudo_time_;
  TensionPath path_;
  LinearStep linear_;
  PartBalance parts_;
  bool begun_ = false;               // a step has been taken
  bool closing_in_ = false;          // converging from a settled state with its tensions
  std::vector<double> from_x_;       // start of the last compared or corrected step
  std::vector<double> drag_across_;  // of lines, computed at the first step
  DualTension held_;                 // tensions of the matrix
  // Steps with the settled tensions, and the last one that reduced the smallest rotation enough.
  int settled_steps_ = 0, contracted_step_ = 0;
  double contracted_rotation_ = 0.0;
  // State of the trials of the law.
  bool on_law_ = false;
  int law_steps_ = 0, steps_to_law_ = 0;
  int path_steps_;
  double residual_on_law_ = 0.0;
  // State of the path, to return to it: before a trial, and where the gradual path last converged.
  struct Place {
    std::vector<double> x;
    TensionPath::Place path;
    double pseudo_step = 1.0;
  };
  void keep(Place& place) const;
  void return_to(const Place& place);
  Place before_law_, converged_;
  double gradual_factor_ = 0.0;  // the last factor of mu; 0: none
  int waited_ = 0;               // steps at this mu
};

}  // namespace codend
