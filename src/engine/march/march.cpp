#include "march.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Explicit steps are held against the gear's present rates this often.
constexpr int steps_between_limits = 200;
constexpr double share_of_limit = 0.9;
// BDF2 is stable while steps grow by less than 2.4 (Grigorieff 1983).
constexpr double most_growth = 2.0;
constexpr double most_shrinking = 0.2;
// Steps that could grow by less keep their length: a change costs accuracy of its own.
constexpr double least_growth = 1.2;
// Where Newton's method was slow, or did not end at all, steps do not grow for a while.
constexpr int many_iterations = 6;
constexpr int steps_of_caution = 4;
// Share of the last step with which a motion begins anew.
constexpr double share_anew = 0.1;

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
}

void March::begin_anew() {
  past_.steps = 0;
  conditions_.to_time(past_.now.time, Side::after, past_.now);
  stepper_.begin(past_.now);
  if (control_.accuracy > 0.0) step_ = std::max(share_anew * step_, control_.least_step);
}

void March::limit_step() {
  if (since_limited_-- > 0) return;
  since_limited_ = steps_between_limits;
  const double longest = stepper_.longest_step({1.0, 1.0});
  if (!std::isfinite(longest)) return;
  step_ = std::min(step_,
                   share_of_limit * stepper_.longest_step(fastest_rates(assembly_, past_.now)));
}

MarchReport::End March::to(double time) {
  const bool adaptive = control_.accuracy > 0.0;
  since_limited_ = 0;  // a march that is taken up again at such a time then goes the same way
  while (time - past_.now.time > 1e-9 * std::max(1.0, std::abs(time))) {
    limit_step();
    const double left = time - past_.now.time;
    const double longest = std::min(step_, conditions_.longest_step());
    double h = std::min(longest, left);
    // The last two steps before a time are of one length.
    if (adaptive && h < left && 2.0 * h > left) h = 0.5 * left;
    if (!adaptive && left < (1.0 + 1e-6) * h) h = left;
    const StepOutcome outcome = stepper_.step(past_, h, conditions_, next_);
    report_.iterations += outcome.iterations;
    if (!outcome.found) {
      ++report_.not_found;
      report_.worst_node = outcome.worst_node;
      step_ = 0.5 * h;
      past_.caution = steps_of_caution;
      if (step_ < control_.least_step) return report_.end = MarchReport::End::stuck;
      continue;
    }
    double factor = 1.0;
    if (adaptive) {
      const double order = past_.steps == 0 ? 1.0 : stepper_.order();
      const double ratio = outcome.error / control_.accuracy;
      factor = std::clamp(0.9 * std::pow(std::max(ratio, 1e-12), -1.0 / (order + 1.0)),
                          most_shrinking, most_growth);
      if (ratio > 1.0 && 0.5 * h > control_.least_step) {
        ++report_.repeated;
        report_.worst_node = outcome.worst_node;
        step_ = h * std::min(factor, 0.9);
        continue;
      }
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
