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
  double reach = 1.0;     // of counts, see NearMeasures
};

struct NearMeasures {
  int factorisations = 0;
  // Of the questions, SI, from the gear itself, without jumps; empty where steps lead to no balance.
  // What is seen in cells of a picture changes by its exact derivative. What counts elements (slack
  // twines, rope on the ground) changes by those that `reach` times the change takes to zero, less
  // those that as much the other way does: as many are taken for just beyond zero as before it.
  std::vector<double> change;
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

  // Of a gear with other numbers; empty too where its lattice has other nodes.
  NearMeasures measure(const GearNumbers& numbers, const NearControl& control) const;

 private:
  // Brings nodes at x (m, 3 each) to balance; false where steps do not.
  bool balanced(const MeasuredGear& gear, const NearControl& control, std::vector<double>& x,
                MeasuredShape<double>& shape, int& factorisations) const;

  const GearNumbers numbers_;
  const Counts counts_;
  const std::vector<double> wake_;
  std::vector<double> position_;  // of points; nodes in balance
  MeasuredGear own_;
  std::unique_ptr<Tangent> tangent_;
  mutable std::unique_ptr<Tangent> renewed_;  // where steps of the first do not close in
  bool regular_ = false;
  MeasureFrame frame_;
  MeasuredShape<double> shape_;
  std::vector<double> measures_;
};

}  // namespace codend
