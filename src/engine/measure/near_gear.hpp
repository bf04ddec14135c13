// Measures of gears near a solved one, on its mesh. Small differences use the factorised matrix
// (solve/tangent.hpp), others a new equilibrium that starts from the solved one.
#pragma once

#include <array>
#include <memory>

#include "../solve/settle.hpp"
#include "../solve/tangent.hpp"
#include "measured_gear.hpp"

namespace codend {

// Termination of steps with one matrix, and number of new factorisations if they do not converge.
struct NearControl {
  double tolerance = 1e-10;  // largest residual over the largest tension
  int steps = 20, renewals = 3;
  bool closes_in = true;  // steps must converge; else they end at the tolerance
  double reach = 1.0;     // for counting measures, see NearGear::towards()
};

// Measures of another gear minus measures of the gear itself (SI). Empty if there is no convergence
// or if the other gear has different nodes.
struct NearMeasures {
  int factorisations = 0;
  std::vector<double> change;
};

class NearGear {
 public:
  // counts: of the solved discretisation; position: of its points, 3 each, m; wake: of the points,
  // or empty. Throws InputError if these do not match the gear.
  NearGear(const GearNumbers& numbers, const Counts& counts, const std::vector<double>& position,
           const std::vector<double>& wake);
  NearGear(const NearGear&) = delete;

  // False if the matrix is singular or the gear itself does not converge. Then no other function
  // may be called.
  bool regular() const { return regular_; }
  // Measures of the gear itself, in equilibrium to rounding.
  const std::vector<double>& measures() const { return measures_; }

  // Changes of measures for two gears: with numbers at the small fraction `share` of the way to
  // `numbers`, and at the opposite distance. Jumps are removed. The second is computed only if the
  // first converges. Both are empty if the gears differ in more than numbers.
  //
  // Measures from a grid (mouth blockage) change by their exact derivative. Counting measures
  // (slack netting, rope on ground) change by a difference quotient: the count at `reach` times the
  // change minus the count at -`reach` times, divided by `reach`. It assumes equal density of
  // elements on both sides of zero.
  std::array<NearMeasures, 2> towards(const GearNumbers& numbers, double share,
                                      const NearControl& control) const;

  // Changes for another gear in a new equilibrium, starting from this gear. control: tolerances and
  // limits.
  NearMeasures settled(const GearNumbers& numbers, SettleControl control) const;

 private:
  // Creates a gear with other numbers on the same mesh; false if its nodes differ.
  bool divided_equally(const GearNumbers& numbers, MeasuredGear& out) const;
  // Moves nodes at x (m, 3 each) to equilibrium; false without convergence. stepped: x is already
  // extrapolated. Otherwise at least one step is required, because small forces do not prove
  // equilibrium.
  bool balanced(const MeasuredGear& gear, const NearControl& control, bool stepped,
                std::vector<double>& x, MeasuredShape<double>& shape, int& factorisations) const;
  // Measures of another gear in equilibrium minus this gear's, without jumps.
  std::vector<double> change(const GearNumbers& numbers, const MeasuredGear& other,
                             const MeasuredShape<double>& shape, double reach) const;

  const GearNumbers numbers_;
  const Counts counts_;
  const std::vector<double> wake_;
  std::vector<double> position_;  // of points; nodes in equilibrium
  std::vector<double> strain_;    // of every line
  MeasuredGear own_;
  std::unique_ptr<Assembly> assembly_;  // of own_; all other gears use its upstream netting
  std::unique_ptr<Tangent> tangent_;
  mutable std::unique_ptr<Tangent> renewed_;  // if tangent_ does not converge
  bool regular_ = false;
  MeasureFrame frame_;
  MeasuredShape<double> shape_;
  std::vector<double> measures_;
};

}  // namespace codend
