#include "near_gear.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

FromShape as_it_is(const std::vector<double>& position) {
  FromShape from;
  from.given = from.alike = true;
  from.position = position;
  return from;
}

bool all_finite(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [](double one) { return std::isfinite(one); });
}

}  // namespace

NearGear::NearGear(const GearNumbers& numbers, const Counts& counts,
                   const std::vector<double>& position, const std::vector<double>& wake)
    : counts_(counts), wake_(wake), position_(position) {
  Fineness fineness;
  fineness.counts = &counts_;
  MeasuredGear own = measured_gear(numbers, numbers.gear, fineness, as_it_is(position));
  bars_ = own.lattice.bars.node;
  cells_ = own.lattice.cells.node;
  own.model.wake = wake_;
  Assembly assembly(own.model);
  tangent_ = std::make_unique<Tangent>(assembly, own.lattice.start.data());
  if (!tangent_->regular()) return;
  NearControl control;
  control.renewals = 0;
  std::vector<double> place;
  const NearMeasures found = balanced(numbers, control, &place);
  if (!found.found) return;
  std::copy(place.begin(), place.end(), position_.begin());
  measures_ = found.measures;
  regular_ = true;
}

NearMeasures NearGear::measure(const GearNumbers& numbers, const NearControl& control) const {
  return balanced(numbers, control, nullptr);
}

NearMeasures NearGear::balanced(const GearNumbers& numbers, const NearControl& control,
                                std::vector<double>* place) const {
  NearMeasures out;
  Fineness fineness;
  fineness.counts = &counts_;
  MeasuredGear other = measured_gear(numbers, numbers.gear, fineness, as_it_is(position_));
  if (other.lattice.bars.node != bars_ || other.lattice.cells.node != cells_) return out;
  if (other.model.points() == static_cast<int>(wake_.size())) other.model.wake = wake_;
  Assembly assembly(other.model);
  std::vector<double> x = other.lattice.start;
  ChordReport report = tangent_->balance(assembly, control.tolerance, control.steps, x.data());
  const auto enough = [&] {
    return report.converged || (!control.closes_in && report.residual <= control.tolerance);
  };
  // Lines that are all but slack turn the matrix with every step: it is made again.
  for (int again = 0; again < control.renewals && !enough() && all_finite(x); ++again) {
    Assembly here(other.model);
    const Tangent renewed(here, x.data());
    ++out.factorisations;
    if (!renewed.regular()) break;
    report = renewed.balance(assembly, control.tolerance, control.steps, x.data());
  }
  if (!enough()) return out;
  out.found = true;
  out.measures = measures_at(numbers, numbers.gear, other, assembly, x);
  if (place) *place = x;
  return out;
}

}  // namespace codend
