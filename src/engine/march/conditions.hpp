// What changes with time from outside: where held nodes are, and all of the model that may change.
#pragma once

#include <limits>
#include <vector>

#include "curve.hpp"
#include "motion.hpp"

namespace codend {

class Conditions {
 public:
  virtual ~Conditions() = default;
  // Puts the model, and the assembly over it, into the conditions of a time (s), and sets positions
  // and velocities of the held nodes in `motion`.
  virtual void to_time(double time, Side side, Motion& motion) = 0;
  // Called after every step taken: what answers to the motion may do so here. Returns whether
  // something broke, so that the motion begins anew.
  virtual bool broken_at(const Motion&) { return false; }
  // The longest step (s) after which what answers to the motion must be asked again.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }
};

// Nothing changes but that held nodes go on as they move.
class SteadyConditions : public Conditions {
 public:
  SteadyConditions(const std::vector<char>& held, const Motion& start)
      : held_(held), start_(start) {}

  void to_time(double time, Side, Motion& motion) override {
    for (std::size_t n = 0; n < held_.size(); ++n) {
      if (!held_[n]) continue;
      const Eigen::Index k = 3 * static_cast<Eigen::Index>(n);
      motion.v.segment<3>(k) = start_.v.segment<3>(k);
      motion.x.segment<3>(k) =
          start_.x.segment<3>(k) + (time - start_.time) * start_.v.segment<3>(k);
    }
  }

 private:
  const std::vector<char>& held_;
  const Motion start_;
};

}  // namespace codend
