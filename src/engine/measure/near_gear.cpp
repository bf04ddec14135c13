#include "near_gear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../base/between.hpp"
#include "../base/error.hpp"

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

using Values = std::vector<double>;

// Combines all numbers of two shapes of the same discretisation one by one.
template <class T, class Together>
MeasuredShape<T> joined(const MeasuredShape<double>& from, const MeasuredShape<double>& to,
                        Together together) {
  const auto each = [&](const Values& a, const Values& b) {
    std::vector<T> out;
    out.reserve(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) out.push_back(together(a[k], b[k]));
    return out;
  };
  MeasuredShape<T> out;
  out.position = each(from.position, to.position);
  out.velocity = each(from.velocity, to.velocity);
  out.force = each(from.force, to.force);
  out.bar_tension = each(from.bar_tension, to.bar_tension);
  out.u_tension = each(from.u_tension, to.u_tension);
  out.v_tension = each(from.v_tension, to.v_tension);
  out.straight_tension = each(from.straight_tension, to.straight_tension);
  for (std::size_t k = 0; k < from.forces.size(); ++k) {
    out.forces.push_back(each(from.forces[k], to.forces[k]));
  }
  out.attack = each(from.attack, to.attack);
  out.heel = each(from.heel, to.heel);
  out.trim = each(from.trim, to.trim);
  return out;
}

// Extrapolates from `from` towards `to` by the factor `by`. Tensions and forces that would reverse
// are set to 0.
MeasuredShape<double> beyond(const MeasuredShape<double>& from, const MeasuredShape<double>& to,
                             double by) {
  MeasuredShape<double> out =
      joined<double>(from, to, [by](double a, double b) { return a + by * (b - a); });
  const auto stop = [](const Values& before, Values& after, std::size_t width) {
    for (std::size_t k = 0; k < after.size(); k += width) {
      double along = 0.0;
      for (std::size_t c = k; c < k + width; ++c) along += before[c] * after[c];
      if (!(along > 0)) std::fill_n(after.begin() + static_cast<std::ptrdiff_t>(k), width, 0.0);
    }
  };
  stop(from.bar_tension, out.bar_tension, 1);
  stop(from.u_tension, out.u_tension, 1);
  stop(from.v_tension, out.v_tension, 1);
  stop(from.straight_tension, out.straight_tension, 1);
  for (std::size_t k = 0; k < from.forces.size(); ++k) stop(from.forces[k], out.forces[k], 3);
  return out;
}

enum class Jumps { none, by_cells, by_elements };
Jumps jumps(MeasureKind kind) {
  if (kind == MeasureKind::mouth_blockage) return Jumps::by_cells;
  const bool counts = kind == MeasureKind::slack_netting || kind == MeasureKind::rope_on_ground;
  return counts ? Jumps::by_elements : Jumps::none;
}

// The measures with this kind of jump, and their indices among all.
struct SomeQuestions {
  Questions asked;
  std::vector<std::size_t> place;
  SomeQuestions(const Questions& all, Jumps so) : asked(all) {
    asked.measures.clear();
    for (std::size_t k = 0; k < all.measures.size(); ++k) {
      if (jumps(all.measures[k].kind) != so) continue;
      asked.measures.push_back(all.measures[k]);
      place.push_back(k);
    }
  }
};

template <class T>
std::vector<T> measured(const GearNumbers& numbers, const Questions& questions,
                        const MeasureFrame& frame, const MeasuredGear& of,
                        const MeasuredShape<T>& shape) {
  return measure(frame, of.model, questions, numbers.gear.has_bag ? &of.bag : nullptr, shape);
}

}  // namespace

NearGear::NearGear(const GearNumbers& numbers, const Counts& counts,
                   const std::vector<double>& position, const std::vector<double>& wake)
    : numbers_(numbers), counts_(counts), wake_(wake), position_(position) {
  Fineness fineness;
  fineness.counts = &counts_;
  own_ = measured_gear(numbers_, numbers_.gear, fineness, as_it_is(position_));
  frame_ = measure_frame(numbers_.gear, own_.mesh);
  own_.model.wake = wake_;
  assembly_ = std::make_unique<Assembly>(own_.model);
  tangent_ = std::make_unique<Tangent>(*assembly_, own_.mesh.start.data());
  assembly_->strain(strain_);
  if (assembly_->has_wake()) assembly_->keep_wake();
  if (!tangent_->regular()) return;
  NearControl control;
  control.renewals = 0;
  int factorisations = 0;
  std::vector<double> place = own_.mesh.start;
  if (!balanced(own_, control, false, place, shape_, factorisations)) return;
  std::copy(place.begin(), place.end(), position_.begin());
  measures_ = measured(numbers_, numbers_.questions, frame_, own_, shape_);
  regular_ = true;
}

bool NearGear::divided_equally(const GearNumbers& numbers, MeasuredGear& out) const {
  Fineness fineness;
  fineness.counts = &counts_;
  try {
    out = measured_gear(numbers, numbers.gear, fineness, as_it_is(position_));
  } catch (const InputError& wrong) {
    // Thrown for a different number of parts.
    if (wrong.field() != "counts") throw;
    return false;
  }
  if (out.model.points() == static_cast<int>(wake_.size())) out.model.wake = wake_;
  return out.mesh.bars.node == own_.mesh.bars.node && out.mesh.cells.node == own_.mesh.cells.node;
}

NearMeasures NearGear::settled(const GearNumbers& numbers, SettleControl control) const {
  NearMeasures out;
  MeasuredGear other;
  if (!divided_equally(numbers, other)) return out;
  control.start = Start::settled;
  control.part = line_parts(other.mesh);
  // Initial guess: tensions scale with speed squared.
  const double speed = numbers.questions.speed, own = numbers_.questions.speed;
  control.strain = strain_;
  if (speed > 0 && own > 0) {
    for (double& strain : control.strain) strain *= speed / own * (speed / own);
  }
  Assembly assembly(other.model);
  assembly.keep_wake_of(*assembly_);
  std::vector<double> x = other.mesh.start;
  const std::vector<double> still(x.size(), 0.0);
  const SettleReport report = settle(assembly, control, still.data(), x.data());
  out.factorisations = report.factorisations;
  if (!report.converged) return out;
  out.change = measures_at(numbers, numbers.gear, other, assembly, x);
  for (std::size_t k = 0; k < measures_.size(); ++k) out.change[k] -= measures_[k];
  return out;
}

std::array<NearMeasures, 2> NearGear::towards(const GearNumbers& to, double share,
                                              const NearControl& control) const {
  std::array<NearMeasures, 2> out;
  std::vector<double> first;
  for (int side = 0; side < 2; ++side) {
    const std::optional<GearNumbers> numbers = between(numbers_, to, side == 0 ? share : -share);
    MeasuredGear other;
    if (!numbers || !divided_equally(*numbers, other)) break;
    std::vector<double>& x = other.mesh.start;
    // Without jumps, nodes move by the same distance in the opposite direction. With `closes_in`
    // this initial guess is not used, because it would hide jumps.
    if (control.closes_in) first.clear();
    for (std::size_t k = 0; k < first.size(); ++k) {
      if (!other.mesh.held[k / 3]) x[k] = 2 * x[k] - first[k];
    }
    MeasuredShape<double> shape;
    if (!balanced(other, control, side == 1, x, shape, out[side].factorisations)) break;
    out[side].change = change(*numbers, other, shape, control.reach);
    first = x;
  }
  return out;
}

std::vector<double> NearGear::change(const GearNumbers& numbers, const MeasuredGear& other,
                                     const MeasuredShape<double>& shape, double reach) const {
  std::vector<double> out(measures_.size());
  const MeasureFrame frame = measure_frame(numbers.gear, other.mesh);
  const SomeQuestions plain(numbers.questions, Jumps::none);
  const auto there = measured(numbers, plain.asked, frame, other, shape);
  for (std::size_t k = 0; k < there.size(); ++k) {
    out[plain.place[k]] = there[k] - measures_[plain.place[k]];
  }
  const SomeQuestions seen(numbers.questions, Jumps::by_cells);
  if (!seen.place.empty()) {
    const auto changing =
        joined<Dual>(shape_, shape, [](double a, double b) { return Dual(a, b - a); });
    const auto moved = measured(numbers, seen.asked, frame, other, changing);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      out[seen.place[k]] = moved[k].value - measures_[seen.place[k]] + moved[k].change;
    }
  }
  const SomeQuestions counted(numbers.questions, Jumps::by_elements);
  const auto count = [&](double by) {
    return measured(numbers, counted.asked, frame, other, beyond(shape_, shape, by));
  };
  const auto ahead = count(reach), here = count(0.0), behind = count(-reach);
  for (std::size_t k = 0; k < ahead.size(); ++k) {
    out[counted.place[k]] = here[k] - measures_[counted.place[k]] + (ahead[k] - behind[k]) / reach;
  }
  return out;
}

bool NearGear::balanced(const MeasuredGear& gear, const NearControl& control, bool stepped,
                        std::vector<double>& x, MeasuredShape<double>& shape,
                        int& factorisations) const {
  Assembly assembly(gear.model);
  assembly.keep_wake_of(*assembly_);
  const int enough = control.closes_in ? std::numeric_limits<int>::max() : stepped ? 0 : 1;
  ChordReport report =
      tangent_->balance(assembly, control.tolerance, control.steps, x.data(), enough);
  // Almost slack lines change the matrix with every step: factorise again.
  for (int again = 0; again < control.renewals && !report.converged && all_finite(x); ++again) {
    if (renewed_) {
      renewed_->renew(assembly, x.data());
    } else {
      renewed_ = std::make_unique<Tangent>(assembly, x.data());
    }
    ++factorisations;
    if (!renewed_->regular()) return false;
    report = renewed_->balance(assembly, control.tolerance, control.steps, x.data(), enough);
  }
  if (!report.converged) return false;
  shape = measured_shape(evaluate_here(assembly), x, std::vector<double>(x.size(), 0.0));
  return true;
}

}  // namespace codend
