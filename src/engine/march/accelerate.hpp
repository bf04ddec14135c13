// Accelerations of free nodes, M a = F with mass and added mass as a 3x3 block per node, and a full
// matrix over the nodes of a body.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "../model/joined_mass.hpp"
#include "motion.hpp"

namespace codend {

class Acceleration {
 public:
  // Throws std::invalid_argument where a free node has no mass at x, v.
  Acceleration(Assembly& assembly, const double* x, const double* v);

  // a (3 per node, m/s2) at x, v; zero on held nodes.
  void at_motion(const Values& x, const Values& v, Values& a);

 private:
  Assembly& assembly_;
  JoinedMass joined_;
  std::vector<double> force_, mass_;
};

}  // namespace codend
