#include "pseudo_time.hpp"

#include <algorithm>

namespace codend {

void PseudoTime::begin(double step, double rotation) {
  step_ = step;
  rotation_ = last_rotation_ = rotation;
  cycle_ = 0;
  aim_ = 1.0;
  steps_ = 0;
}

void PseudoTime::hold(double step, int steps) {
  held_step_ = step;
  held_steps_ = steps;
}

double PseudoTime::share(double rotation) const {
  return std::min(1.0, aim_ * control_.most_rotation / rotation);
}

void PseudoTime::judge(double rotation, double correction) {
  if (correction > control_.poor) {
    aim_ = std::max(control_.least_aim, control_.shorter * std::min(aim_, rotation));
  } else if (correction < control_.good) {
    aim_ = std::min(1.0, aim_ / control_.shorter);
  }
}

void PseudoTime::advance(double rotation, double damped, double driven) {
  ++steps_;
  rotation_ = rotation;
  // In which the step's stiffness alone would make it.
  const double own = driven > damped ? step_ * damped / (driven - damped) : control_.longest;
  const bool around = rotation_ > control_.cycle_rotation &&
                      rotation_ > control_.cycle_share * last_rotation_ &&
                      step_ > control_.cycle_excess * own;
  cycle_ = around ? cycle_ + 1 : 0;
  last_rotation_ = rotation_;
  const double factor = std::clamp(aim_ / rotation_, control_.least_factor, control_.most_factor);
  step_ = std::min(step_ * factor, control_.longest);
  if (cycle_ == control_.cycle_steps) {
    step_ = std::max(control_.cycle_return * own, control_.cycle_least);
    cycle_ = 0;
  }
  if (held_steps_ > 0) {
    --held_steps_;
    step_ = std::min(step_, held_step_);
  }
}

}  // namespace codend
