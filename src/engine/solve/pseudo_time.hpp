// Pseudo time step h of the static solution, in units of the gear's fall time
// (Assembly::fall_time()). A drag-like damping D/h restrains the nodes. The step h grows while lines
// rotate little, until the iteration is Newton's method.
#pragma once

#include "settle_control.hpp"

namespace codend {

class PseudoTime {
 public:
  explicit PseudoTime(const PseudoTimeControl& control) : control_(control) {}

  // Restarts with a step, as if lines had last rotated by `rotation`.
  void begin(double step = 1.0, double rotation = 1.0);
  // Limits the step to `step` for the next `steps` steps.
  void hold(double step, int steps);
  void set_step(double step) { step_ = step; }
  void assume_rotation(double rotation) { rotation_ = rotation; }

  double step() const { return step_; }
  double rotation() const { return rotation_; }
  // True if the shape has converged.
  bool found() const { return rotation_ < control_.found_rotation && held_steps_ == 0; }

  // Returns the fraction of a step to take, if the full step rotates lines by `rotation`.
  double share(double rotation) const;
  // Updates h after a step that rotated lines by `rotation`.
  void advance(double rotation);
  // True if judge() must be called for the next step.
  bool judged() const { return steps_ >= control_.free_steps; }
  // Adapts the target rotation. `correction` is the size of the step's correction over the step.
  void judge(double rotation, double correction);
  // Scales the largest target rotation, which is at first 1 and never more.
  void scale_limit(double factor);
  // Shortens the step after a singular matrix.
  void shorten() { step_ *= control_.shorter; }

 private:
  const PseudoTimeControl& control_;
  double step_ = 1.0;
  double rotation_ = 1.0;
  double limit_ = 1.0;  // of the target rotation
  double aim_ = 1.0;    // target rotation
  int steps_ = 0;       // since begin()
  int held_steps_ = 0;
  double held_step_ = 0.0;
};

}  // namespace codend
