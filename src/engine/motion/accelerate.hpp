// Accelerations of free nodes from M a = F. M is mass and added mass: a 3x3 block per node, and a
// dense matrix over the nodes of a body.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "../model/joined_mass.hpp"
#include "motion.hpp"

namespace codend {

class Acceleration {
 public:
  // Throws std::invalid_argument if a free node has no mass at x, v.
  Acceleration(Assembly& assembly, const double* x, const double* v);

  // Computes a (m/s2, 3 per node) at x, v. Fixed nodes get zero.
  void at_motion(const Values& x, const Values& v, Values& a);

 private:
  Assembly& assembly_;
  JoinedMass joined_;
  std::vector<double> force_, mass_;
};

}  // namespace codend
