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
  Values x, v, a;     // m, m/s, m/s2, 3 per node; a is zero if a scheme does not use it
};

// Returns the motion at time 0 of nodes at rest at x (m, 3 each).
inline Motion at_rest(const std::vector<double>& x) {
  const Eigen::Map<const Values> places(x.data(), static_cast<Eigen::Index>(x.size()));
  const Values none = Values::Zero(places.size());
  return {0.0, places, none, none};
}

// Ends of the last step. `before` is invalid if `steps` is 0: at the start, or after a discontinuity.
struct Past {
  Motion now, before;
  int steps = 0;
  int caution = 0;  // remaining steps without growth, after a failed step

  double last_step() const { return now.time - before.time; }
};

// Returns the motion at a time (s) within a step, by linear interpolation.
inline Motion between(const Motion& begin, const Motion& end, double time) {
  const double s = (time - begin.time) / (end.time - begin.time), r = 1.0 - s;
  return {time, r * begin.x + s * end.x, r * begin.v + s * end.v, r * begin.a + s * end.a};
}

}  // namespace codend
