#include "march.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Explicit steps are held against the gear's present rates this often.
constexpr int steps_between_limits = 200;
constexpr double share_of_limit = 0.9;
// BDF2 is stable while steps grow by less than 2.4 (Grigorieff 1983).
// Less than that, since errors grow faster than their order says where slack lines come taut.
constexpr double most_growth = 1.5;
// After the first step, whose length is that of no motion: its error tells how long the next may be.
constexpr double first_growth = 30.0;
constexpr double most_shrinking = 0.2;
// Steps that could grow by less keep their length: a change costs accuracy of its own.
constexpr double least_growth = 1.2;
// Where Newton's method was slow, or did not end at all, or a step was too long, steps do not grow for a
// while.
constexpr int many_iterations = 6;
constexpr int steps_of_caution = 4;
constexpr int steps_of_caution_after_error = 3;
// A step that was too long is repeated at these shares of its length.
constexpr double least_repeated = 0.1, most_repeated = 0.9;
// Of the length at which a repeated step's error would be what it may be: it is not to be tried thrice.
constexpr double aimed_again = 0.8;
// Exponents of the error by the length of a step: assumed, and what a second try may find.
constexpr double assumed_exponent = 2.0, least_exponent = 1.0, most_exponent = 3.0;
// Halvings of one step for the sake of its energy, and the share of what is allowed that a step must
// add to be worth one.
constexpr int most_halvings = 10;
constexpr double least_drift = 0.01;
// Longest adaptive step as a ratio of the interval between two requested times. Errors of single
// steps over the interval would add up, because such a step does not resolve the curve within it.
constexpr double most_of_interval = 0.5;
// Share of the last step with which a motion begins anew.
constexpr double share_anew = 0.1;

// The last try of a step that was too long.
struct Rejected {
  double h = 0.0, error = 0.0;

  // The share of its length with which the step is tried next.
  double shorter(double tried, double found) {
    double exponent = assumed_exponent;
    if (h > 0.0 && found < error) {
      exponent =
          std::clamp(std::log(error / found) / std::log(h / tried), least_exponent, most_exponent);
    } else if (h > 0.0) {
      exponent = least_exponent;
    }
    h = tried;
    error = found;
    return std::clamp(aimed_again * std::pow(found, -1.0 / exponent), least_repeated,
                      most_repeated);
  }
};

}  // namespace

March::March(Assembly& assembly, Stepper& stepper, Conditions& conditions,
             const MarchControl& control, Past past)
    : assembly_(assembly),
      stepper_(stepper),
      conditions_(conditions),
      control_(control),
      past_(std::move(past)),
      step_(control.step) {
  if (past_.steps == 0) {
    conditions_.to_time(past_.now.time, Side::after, past_.now);
    stepper_.begin(past_.now);
    past_.before = past_.now;
  }
  next_ = past_.now;
  if (control_.account) account_ = std::make_unique<EnergyAccount>(assembly_);
}

// Anew at every time that is asked for, so that a march that is taken up there books the same.
void March::begin_account() {
  if (!account_) return;
  next_ = past_.now;
  conditions_.to_time(next_.time, Side::after, next_);
  account_->begin(next_);
}

// Whether a step makes a balance worse that is out of bounds.
bool March::too_unbalanced(const EnergyTotals& totals) const {
  const double now = totals.imbalance(), change = now - energy_.imbalance();
  const double through = totals.put_through - energy_.put_through;
  const double allowed = control_.energy_share * totals.put_through + control_.energy_floor;
  return std::abs(now) > allowed && change * now > 0.0 &&
         std::abs(change) > std::max(control_.energy_share * through, least_drift * allowed);
}

void March::begin_anew() {
  past_.steps = 0;
  conditions_.to_time(past_.now.time, Side::after, past_.now);
  stepper_.begin(past_.now);
  if (control_.adaptive) step_ = std::max(share_anew * step_, control_.least_step);
  begin_account();
}

void March::limit_step() {
  if (since_limited_-- > 0) return;
  since_limited_ = steps_between_limits;
  const double longest = stepper_.longest_step({1.0, 1.0});
  if (!std::isfinite(longest)) return;
  step_ =
      std::min(step_, share_of_limit * stepper_.longest_step(fastest_rates(assembly_, past_.now)));
}

MarchReport::End March::to(double time) {
  const bool adaptive = control_.adaptive;
  Rejected rejected;
  int halvings = 0;
  begin_account();
  // A march that is taken up again at such a time then goes the same way.
  since_limited_ = 0;
  stepper_.forget();
  const double most = (adaptive ? most_of_interval : 1.0) * (time - past_.now.time);
  while (time - past_.now.time > 1e-9 * std::max(1.0, std::abs(time))) {
    limit_step();
    const double left = time - past_.now.time;
    double h = std::min({step_, conditions_.longest_step(), most, left});
    // The last two steps before a time are of one length.
    if (adaptive && h < left && 2.0 * h > left) h = 0.5 * left;
    if (!adaptive && left < (1.0 + 1e-6) * h) h = left;
    const StepOutcome outcome = stepper_.step(past_, h, conditions_, next_);
    report_.iterations += outcome.iterations;
    const bool too_long = adaptive && outcome.error > 1.0;
    if (!outcome.found || too_long) {
      ++(too_long ? report_.repeated : report_.not_found);
      report_.worst_node = outcome.worst_node;
      if (too_long) {
        step_ = h * rejected.shorter(h, outcome.error);
        past_.caution = std::max(past_.caution, steps_of_caution_after_error);
      } else {
        step_ = 0.5 * h;
        past_.caution = steps_of_caution;
        rejected = {};
      }
      if (step_ < control_.least_step) return report_.end = MarchReport::End::stuck;
      continue;
    }
    if (account_) {
      const EnergyTotals totals = account_->after(next_, energy_);
      if (adaptive && too_unbalanced(totals)) {
        ++report_.unbalanced;
        report_.worst_node = outcome.worst_node;
        step_ = 0.5 * h;
        past_.caution = steps_of_caution;
        if (++halvings > most_halvings || step_ < control_.least_step) {
          return report_.end = MarchReport::End::unbalanced;
        }
        continue;
      }
      account_->take();
      energy_ = totals;
      halvings = 0;
    }
    rejected = {};
    double factor = 1.0;
    if (adaptive) {
      const double order = past_.steps == 0 ? 1.0 : stepper_.order();
      factor = std::clamp(0.9 * std::pow(std::max(outcome.error, 1e-12), -1.0 / (order + 1.0)),
                          most_shrinking, past_.steps == 0 ? first_growth : most_growth);
    }
    std::swap(past_.before, past_.now);
    std::swap(past_.now, next_);
    ++past_.steps;
    ++report_.steps;
    report_.shortest_step = report_.steps == 1 ? h : std::min(report_.shortest_step, h);
    report_.longest_step = std::max(report_.longest_step, h);
    if (adaptive) {
      // A step cut short to end at a time says little of those that may follow.
      if (past_.caution > 0 || outcome.iterations > many_iterations) factor = std::min(factor, 1.0);
      past_.caution = std::max(past_.caution - 1, 0);
      if (factor >= least_growth || factor < 1.0) {
        step_ = std::clamp(factor < 1.0 ? h * factor : std::max(step_, h * factor),
                           control_.least_step, control_.most_step);
      }
    }
    if (conditions_.broken_at(past_.now)) begin_anew();
    if (control_.watch && !control_.watch(past_.now)) {
      return report_.end = MarchReport::End::stopped;
    }
  }
  return report_.end = MarchReport::End::reached;
}

}  // namespace codend
