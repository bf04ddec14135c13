// State of all nodes at one time, and the previous states that a scheme needs.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <vector>

namespace codend {

using Values = Eigen::VectorXd;

struct Motion {
  double time = 0.0;  // s
  // m, m/s, m/s2, 3 per node. a, and b, the algorithmic acceleration of generalised alpha (Arnold
  // and Bruels 2007), are zero if a scheme does not use them.
  Values x, v, a, b;
};

// Returns the motion at time 0 of nodes at rest at x (m, 3 each).
inline Motion at_rest(const std::vector<double>& x) {
  const Eigen::Map<const Values> places(x.data(), static_cast<Eigen::Index>(x.size()));
  const Values none = Values::Zero(places.size());
  return {0.0, places, none, none, none};
}

// The last two states. `before` is invalid if `steps` is 0: at the start, or after a discontinuity.
struct Past {
  Motion now, before;
  int steps = 0;
  int caution = 0;  // remaining steps without growth, after a failed step

  double last_step() const { return now.time - before.time; }
};

}  // namespace codend
