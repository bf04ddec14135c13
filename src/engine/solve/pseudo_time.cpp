#include "pseudo_time.hpp"

#include <algorithm>

namespace codend {

void PseudoTime::begin(double step, double rotation) {
  step_ = step;
  rotation_ = rotation;
  aim_ = limit_;
  steps_ = 0;
}

void PseudoTime::hold(double step, int steps) {
  held_step_ = step;
  held_steps_ = steps;
}

double PseudoTime::share(double rotation) const { return std::min(1.0, aim_ / rotation); }

void PseudoTime::judge(double rotation, double correction) {
  aim_ = correction > 1.0 ? control_.shorter * std::min(aim_, rotation)
                          : std::min(limit_, aim_ / control_.shorter);
}

void PseudoTime::scale_limit(double factor) {
  limit_ = std::min(1.0, factor * limit_);
  aim_ = std::min(aim_, limit_);
}

void PseudoTime::advance(double rotation) {
  ++steps_;
  rotation_ = rotation;
  step_ = std::min(step_ * aim_ / rotation_, control_.longest);
  if (held_steps_ > 0) {
    --held_steps_;
    step_ = std::min(step_, held_step_);
  }
}

}  // namespace codend
