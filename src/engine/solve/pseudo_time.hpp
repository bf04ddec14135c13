// The pseudo time step h of settling: nodes are held back by a drag-like damping D/h, and h grows while
// lines turn little, until the step is Newton's own.
#pragma once

#include "settle_control.hpp"

namespace codend {

class PseudoTime {
 public:
  explicit PseudoTime(const PseudoTimeControl& control) : control_(control) {}

  // Anew with this h (s), as if lines had last turned by `rotation`.
  void begin(double step = 1.0, double rotation = 1.0);
  // For so many steps h stays no longer than this (s).
  void hold(double step, int steps);
  void set_step(double step) { step_ = step; }
  // Takes the shape as turning by this much, before any step.
  void assume_rotation(double rotation) { rotation_ = rotation; }

  double step() const { return step_; }
  double rotation() const { return rotation_; }
  // Whether the shape is found.
  bool found() const { return rotation_ < control_.found_rotation && held_steps_ == 0; }

  // The share to be taken of a step that turns lines by this much.
  double share(double rotation) const;
  // After a step that turns lines by `rotation`.
  void advance(double rotation);
  // Whether the next step is to be judged.
  bool judged() const { return steps_ >= control_.free_steps; }
  // The judgement of a step that turns lines by `rotation`: what would correct it, over the step.
  void judge(double rotation, double correction);
  // After none, as the matrix was singular.
  void shorten() { step_ *= control_.shorter; }

 private:
  const PseudoTimeControl& control_;
  double step_ = 1.0;
  double rotation_ = 1.0;
  double aim_ = 1.0;  // rotation that is aimed at
  int steps_ = 0;     // since begun
  int held_steps_ = 0;
  double held_step_ = 0.0;
};

}  // namespace codend
