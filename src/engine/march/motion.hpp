// Where all nodes are and how they move, at one time, and what a scheme remembers of times before.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <vector>

namespace codend {

using Values = Eigen::VectorXd;

struct Motion {
  double time = 0.0;  // s
  // m, m/s, m/s2, 3 per node; zero where a scheme has no use for it: a, and b, the algorithmic
  // acceleration of generalised alpha (Arnold and Bruels 2007).
  Values x, v, a, b;
};

// At time 0, of nodes at rest at x (m, 3 each).
inline Motion at_rest(const std::vector<double>& x) {
  const Eigen::Map<const Values> places(x.data(), static_cast<Eigen::Index>(x.size()));
  const Values none = Values::Zero(places.size());
  return {0.0, places, none, none, none};
}

// The last two steps. Where `steps` is 0 there is none before: at the start, or where an event
// broke the motion.
struct Past {
  Motion now, before;
  int steps = 0;
  int caution = 0;  // steps that may not grow yet, after one that was not found

  double last_step() const { return now.time - before.time; }
};

}  // namespace codend
