#include "time_integration.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Number of steps between comparisons of explicit steps with the present stability limit.
constexpr int steps_between_limits = 200;
constexpr double share_of_limit = 0.9;
// Errors exceed their order when slack lines become taut.
constexpr double most_growth = 2.0;
// First step over the gear's fall time, if its length is not given.
constexpr double first_share = 2e-3;
// The error of the first step, whose length is arbitrary, allows larger growth.
constexpr double first_growth = 30.0;
constexpr double most_shrinking = 0.2;
// Steps with less possible growth are not changed, because each change costs a factorisation.
constexpr double least_growth = 1.2;
// Steps do not grow for a while after slow or failed convergence, or after a rejected step.
constexpr int many_iterations = 10;
constexpr int steps_of_caution = 4;
constexpr int steps_of_caution_after_error = 3;
// Length of a repeated step, as a fraction of the rejected one.
constexpr double least_repeated = 0.1, most_repeated = 0.9;
// Safety factor for the length of a repeated step, to avoid a third attempt.
constexpr double aimed_again = 0.8;
// Exponent of the error in the step length: assumed, and limits of the estimate from two attempts.
constexpr double assumed_exponent = 2.0, least_exponent = 1.0, most_exponent = 3.0;
// States closer to the start of a step, as a fraction of its length, are interpolated.
constexpr double least_share = 1e-6;
// Fraction of the last step length used after a restart.
constexpr double distribute_again = 0.1;

// Length and error of the last rejected attempt.
struct Rejected {
  double h = 0.0, error = 0.0;

  // Returns the next length as a fraction of `tried`. found: error of `tried` over the allowance.
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

TimeIntegration::TimeIntegration(Assembly& assembly, Stepper& stepper, Conditions& conditions,
                                 const IntegrationControl& control, Past past)
    : assembly_(assembly),
      stepper_(stepper),
      conditions_(conditions),
      control_(control),
      past_(std::move(past)),
      step_(control.step) {
  if (step_ == 0.0) step_ = first_share * assembly.fall_time(past_.now.x.data());
  if (past_.steps == 0) {
    conditions_.to_time(past_.now.time, Side::after, past_.now);
    stepper_.begin(past_.now);
    past_.before = past_.now;
  }
  next_ = past_.now;
  if (control_.account) account_ = std::make_unique<EnergyAccount>(assembly_);
}

void TimeIntegration::begin_account() {
  if (!account_) return;
  next_ = past_.now;
  conditions_.to_time(next_.time, Side::after, next_);
  account_->begin(next_);
}

// True if the imbalance of the step exceeds its allowance.
bool TimeIntegration::too_unbalanced(const EnergyTotals& totals) const {
  const double change = totals.imbalance() - energy_.imbalance();
  const double through = totals.put_through - energy_.put_through;
  return std::abs(change) >
         control_.energy_share * (account_->present() + through) + control_.energy_floor;
}

void TimeIntegration::restart_iteration() {
  past_.steps = 0;
  conditions_.to_time(past_.now.time, Side::after, past_.now);
  stepper_.begin(past_.now);
  if (control_.adaptive) step_ = std::max(distribute_again * step_, control_.least_step);
  begin_account();
}

Motion TimeIntegration::at(double time, Stepper& stepper) {
  const Motion &begin = past_.before, &end = past_.now;
  const double h = time - begin.time;
  if (h > least_share * past_.last_step() && time < end.time) {
    // The change of velocity in the last step is the best guess of acceleration.
    const Past from{begin, end, past_.steps > 1 ? 1 : 0, 0};
    Motion out = begin;
    if (stepper.step(from, h, conditions_, out).found) return out;
  }
  return between(begin, end, time);
}

void TimeIntegration::limit_step() {
  if (since_limited_-- > 0) return;
  since_limited_ = steps_between_limits;
  const double longest = stepper_.longest_step({1.0, 1.0});
  if (!std::isfinite(longest)) return;
  step_ =
      std::min(step_, share_of_limit * stepper_.longest_step(fastest_rates(assembly_, past_.now)));
}

IntegrationReport::End TimeIntegration::to(double time) {
  const bool adaptive = control_.adaptive;
  Rejected rejected;
  begin_account();
  // An integration that is continued from this time then takes the same steps.
  since_limited_ = 0;
  stepper_.forget();
  while (time - past_.now.time > 1e-9 * std::max(1.0, std::abs(time))) {
    limit_step();
    const double left = time - past_.now.time;
    double h = std::min({step_, conditions_.longest_step(), left});
    // The last two steps before the requested time have equal length.
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
      if (step_ < control_.least_step) return report_.end = IntegrationReport::End::stuck;
      continue;
    }
    if (account_) {
      const EnergyTotals totals = account_->after(next_, energy_);
      if (adaptive && too_unbalanced(totals)) {
        ++report_.unbalanced;
        report_.worst_node = outcome.worst_node;
        step_ = 0.5 * h;
        past_.caution = steps_of_caution;
        if (step_ < control_.least_step) {
          return report_.end = IntegrationReport::End::unbalanced;
        }
        continue;
      }
      account_->take();
      energy_before_ = energy_;
      energy_ = totals;
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
    report_.largest_error = std::max(report_.largest_error, outcome.place_error);
    if (adaptive) {
      // The error of a step shortened for a requested time does not predict the next error.
      if (past_.caution > 0 || outcome.iterations > many_iterations) factor = std::min(factor, 1.0);
      past_.caution = std::max(past_.caution - 1, 0);
      if (factor >= least_growth || factor < 1.0) {
        step_ = std::clamp(factor < 1.0 ? h * factor : std::max(step_, h * factor),
                           control_.least_step, control_.most_step);
      }
    }
    if (control_.passed) control_.passed(past_);
    if (conditions_.broken_at(past_.now)) restart_iteration();
    if (control_.watch && !control_.watch(past_.now)) {
      return report_.end = IntegrationReport::End::stopped;
    }
  }
  return report_.end = IntegrationReport::End::reached;
}

}  // namespace codend
