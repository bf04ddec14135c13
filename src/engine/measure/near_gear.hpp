// Measures of gears that differ from one that is settled, on its lattice: of those that differ a little
// with the factors of its matrix (solve/tangent.hpp), of others settled from it.
#pragma once

#include <array>
#include <memory>

#include "../solve/settle.hpp"
#include "../solve/tangent.hpp"
#include "measured_gear.hpp"

namespace codend {

// How steps of one matrix end, and how often the matrix is made again where they do not close in.
struct NearControl {
  double tolerance = 1e-10;  // net force over the largest tension
  int steps = 20, renewals = 3;
  bool closes_in = true;  // whether steps must end by themselves; else the tolerance ends them
  double reach = 1.0;     // of counts, see NearMeasures
};

// How much measures of another gear (SI, of its questions) are more than those of the gear itself; empty
// where no balance is found, or where its lattice has other nodes.
struct NearMeasures {
  int factorisations = 0;
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

  // Of the gears with numbers `share` of the way to others', a little, and as much the other way, without
  // jumps; the second where there is the first. Nothing where these differ in more than numbers.
  //
  // What is seen in cells of a picture changes by its exact derivative. What counts elements (slack
  // twines, rope on the ground) changes by those that `reach` times the change takes to zero, less
  // those that as much the other way does: as many are taken for just beyond zero as before it.
  std::array<NearMeasures, 2> towards(const GearNumbers& numbers, double share,
                                      const NearControl& control) const;

  // Of a gear with other numbers, settled from the gear itself. control: its tolerances and bounds.
  NearMeasures settled(const GearNumbers& numbers, SettleControl control) const;

 private:
  // The gear with other numbers on the same lattice; false where that has other nodes.
  bool divided_alike(const GearNumbers& numbers, MeasuredGear& out) const;
  // Takes nodes at x (m, 3 each) to balance; false where steps do not. stepped: whether x is more than
  // where the gear itself is, which small forces alone do not tell from balance.
  bool balanced(const MeasuredGear& gear, const NearControl& control, bool stepped,
                std::vector<double>& x, MeasuredShape<double>& shape, int& factorisations) const;
  // Measures without jumps of such a gear in balance, less the gear's own.
  std::vector<double> change(const GearNumbers& numbers, const MeasuredGear& other,
                             const MeasuredShape<double>& shape, double reach) const;

  const GearNumbers numbers_;
  const Counts counts_;
  const std::vector<double> wake_;
  std::vector<double> position_;  // of points; nodes in balance
  std::vector<double> strain_;    // of every line
  MeasuredGear own_;
  std::unique_ptr<Assembly> assembly_;  // of it, with the netting upstream that all others keep to
  std::unique_ptr<Tangent> tangent_;
  mutable std::unique_ptr<Tangent> renewed_;  // where steps of the first do not close in
  bool regular_ = false;
  MeasureFrame frame_;
  MeasuredShape<double> shape_;
  std::vector<double> measures_;
};

}  // namespace codend
