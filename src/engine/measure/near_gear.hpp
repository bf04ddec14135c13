// Measures of gears that differ a little from one that is settled: on its lattice, with the factors of
// its matrix (solve/tangent.hpp).
#pragma once

#include <memory>

#include "../solve/tangent.hpp"
#include "measured_gear.hpp"

namespace codend {

// How steps of one matrix end, and how often the matrix is made again where they do not close in.
struct NearControl {
  double tolerance = 1e-10;  // net force over the largest tension
  int steps = 20, renewals = 3;
  bool closes_in = true;  // whether steps must end by themselves; else the tolerance is enough
};

struct NearMeasures {
  bool found = false;
  int factorisations = 0;
  std::vector<double> measures;  // of the questions, SI; empty where steps lead to no balance
};

class NearGear {
 public:
  // counts: of the settled lattice; position, m: of its points, 3 each; wake: of these, or none.
  // Throws InputError where they are not of this gear.
  NearGear(const GearNumbers& numbers, const Counts& counts, const std::vector<double>& position,
           const std::vector<double>& wake);
  NearGear(const NearGear&) = delete;

  // False where the matrix is singular or the gear itself is not brought to balance; nothing below
  // may be called then.
  bool regular() const { return regular_; }
  // Of the gear itself, in balance to rounding.
  const std::vector<double>& measures() const { return measures_; }

  // Of a gear with other numbers; not found where its lattice has other nodes.
  NearMeasures measure(const GearNumbers& numbers, const NearControl& control) const;

 private:
  NearMeasures balanced(const GearNumbers& numbers, const NearControl& control,
                        std::vector<double>* place) const;

  const Counts counts_;
  const std::vector<double> wake_;
  std::vector<double> position_;  // of points; nodes in balance
  std::vector<int> bars_, cells_;
  std::unique_ptr<Tangent> tangent_;
  bool regular_ = false;
  std::vector<double> measures_;
};

}  // namespace codend
