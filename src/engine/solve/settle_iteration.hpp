// One Newton step after another towards equilibrium: on the interior path of dual tensions
// (tension_path.hpp), or on the constitutive law itself where the shape is found.
//
// A trial of the law that fails ends where it began, and the path goes on from there. On the path a step
// that turns lines little is corrected once by its own factors.
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
  // v, x: as settle()'s. What is known of the present positions is told in `report`.
  SettleIteration(Assembly& assembly, const SettleControl& control, const double* v, double* x,
                  SettleReport& report);

  // Net forces of the law itself.
  void measure();

  // Anew from a crude start that the caller has put into x.
  void begin();
  // Takes the present positions, measured, as nearly settled, with the control's strains or their own.
  void begin_near();
  // Takes the present positions, measured, as settled under other loads, likewise.
  void begin_settled();
  // From a settled shape, measured, under loads that have changed: the law itself, and where that does
  // not close in the path from that shape's tensions.
  void resume();

  // Whether the shape is found and its net forces are no more than is allowed, or than rounding makes.
  bool balanced();
  // Whether it is so near to that that its wake is worth following.
  bool nearly_balanced() const;
  // Whether tensions are still so far from the law that lines give way to other loads.
  bool far_on_path() const;
  // Tells of every part's balance, as measured.
  void judge_parts();
  // Whether steps from a settled shape do not close in.
  bool lost() const;
  // One Newton step; where its matrix is singular none, and the next one is held back more.
  void step();

  // Whether the shape that was found may be an unstable equilibrium.
  bool may_be_unstable();
  // Whether only walls of it may be so.
  bool only_walls_may_be_unstable() const { return unstable_size(assembly_, false) == 0.0; }
  // How it grows.
  GrowingMotion growing_motion();
  // On from there, along the motion that leaves it or, backwards, against it.
  void perturb(const GrowingMotion& motion, bool backwards);

 private:
  void follow(double parameter);
  void choose_law();
  void leave_law();
  void try_law();
  double reduction();
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
  const double load_;           // N
  const double rounding_;       // N
  bool from_settled_ = false;   // the start is a settled state
  double unstable_size_ = 0.0;  // m
  PseudoTime pseudo_time_;
  TensionPath path_;
  LinearStep linear_;
  PartBalance parts_;
  bool begun_ = false;               // a step has been taken
  bool closing_in_ = false;          // from a settled state, by its tensions
  std::vector<double> from_x_;       // where the last step began that was judged or corrected
  std::vector<double> drag_across_;  // of lines, made at the first step
  DualTension held_;                 // of matrix_tension()
  int settled_steps_ = 0;            // of that state's tensions
  // Of the trials of the law.
  bool on_law_ = false;
  int law_steps_ = 0, steps_to_law_ = 0;
  int path_steps_;
  double residual_on_law_ = 0.0;
  // Where the path was left for the law.
  std::vector<double> left_x_;
  TensionPath::Place left_path_;
  double left_pseudo_step_ = 1.0;  // s
};

}  // namespace codend
