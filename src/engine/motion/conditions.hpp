// External conditions of a motion over time: positions of fixed nodes and changes of the model.
#pragma once

#include <limits>
#include <vector>

#include "curve.hpp"
#include "motion.hpp"

namespace codend {

class Conditions {
 public:
  virtual ~Conditions() = default;
  // Sets the model, its assembly, and the fixed nodes in `motion` to the conditions at a time (s).
  virtual void to_time(double time, Side side, Motion& motion) = 0;
  // Called after every accepted step, to respond to the motion. Returns true after a rupture.
  virtual bool broken_at(const Motion&) { return false; }
  // Longest step (s) before broken_at() must be called again.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }
};

// Constant conditions: fixed nodes continue at their initial velocity.
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
