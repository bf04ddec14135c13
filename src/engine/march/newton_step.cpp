#include "newton_step.hpp"

#include <algorithm>
#include <cmath>

#include "accelerate.hpp"

namespace codend {
namespace {

constexpr int most_iterations = 12;
// A node that a single iteration throws this far (m) will not come back.
constexpr double most_move = 50.0;

}  // namespace

NewtonStep::NewtonStep(Assembly& assembly, NewtonScheme scheme, double tolerance)
    : assembly_(assembly),
      scheme_(scheme),
      tolerance_(tolerance),
      force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
      mass_(3 * force_.size()),
      values_(9 * assembly.pattern().column.size()),
      right_(3 * static_cast<std::size_t>(assembly.unknowns())) {}

void NewtonStep::begin(Motion& motion) {
  motion.a.setZero(motion.x.size());
  if (scheme_ != NewtonScheme::trapezoid) return;
  Acceleration(assembly_, motion.x.data(), motion.v.data())
      .at_motion(motion.x, motion.v, motion.a);
}

NewtonStep::Rule NewtonStep::set_rule(const Past& past, double h) {
  const Motion& now = past.now;
  if (scheme_ == NewtonScheme::trapezoid) {
    v_rest_ = -now.v;
    a_rest_ = -now.a;
    return {2.0 / h, false};
  }
  if (scheme_ == NewtonScheme::backward_euler || past.steps == 0) {
    v_rest_.setZero(now.x.size());
    a_rest_.setZero(now.x.size());
    return {1.0 / h, true};
  }
  const double w = h / past.last_step();
  const double q = w * w / ((1.0 + w) * h);
  v_rest_ = -q * (now.x - past.before.x);
  a_rest_ = -q * (now.v - past.before.v);
  return {(1.0 + 2.0 * w) / ((1.0 + w) * h), false};
}

StepOutcome NewtonStep::step(const Past& past, double h, Conditions& conditions, Motion& next) {
  const Motion& now = past.now;
  const std::vector<int>& free = assembly_.free_nodes();
  next.time = now.time + h;
  conditions.to_time(next.time, Side::before, next);
  const Rule rule = set_rule(past, h);
  const double p = rule.p;
  StepOutcome out;
  for (const int node : free) {
    at(next.x.data(), node) = at(now.x.data(), node) + h * at(now.v.data(), node);
  }
  next.a.setZero(next.x.size());
  auto follow = [&] {
    for (const int node : free) {
      const Vector v1 = p * (at(next.x.data(), node) - at(now.x.data(), node)) +
                        at(v_rest_.data(), node);
      at(next.v.data(), node) = v1;
      at(next.a.data(), node) = p * (v1 - at(now.v.data(), node)) + at(a_rest_.data(), node);
    }
  };
  follow();
  if (free.empty()) {
    out.found = true;
    return out;
  }
  if (!analysed_) {
    std::vector<double> places(right_.size());
    for (std::size_t i = 0; i < free.size(); ++i) {
      at(places.data(), static_cast<int>(i)) = at(now.x.data(), free[i]);
    }
    lu_.analyse(assembly_.pattern(), places.data());
    analysed_ = true;
  }
  double last = 0.0;
  while (out.iterations < most_iterations) {
    ++out.iterations;
    assembly_.move_to(next.x.data(), next.v.data());
    assembly_.residual(force_.data());
    assembly_.mass(mass_.data());
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Eigen::Map<const Block> mass(&mass_[9 * static_cast<std::size_t>(free[i])]);
      at(right_.data(), static_cast<int>(i)) =
          at(force_.data(), free[i]) - mass * at(next.a.data(), free[i]);
    }
    assembly_.jacobian({1.0, p}, values_.data());
    assembly_.add_blocks(mass_.data(), p * p, values_.data());
    ++factorisations_;
    if (!lu_.factorise(values_.data())) return out;
    lu_.solve(right_.data(), right_.data());
    double most = 0.0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Vector dx = at(right_.data(), static_cast<int>(i));
      at(next.x.data(), free[i]) += dx;
      const double size = dx.norm();
      if (!(size <= most)) {
        most = size;
        out.worst_node = free[i];
      }
      if (!(size < most_move)) return out;
    }
    follow();
    // What is left after an iteration that shrinks moves by a factor r is r/(1 - r) of its own.
    const double ratio = out.iterations > 1 ? most / last : 1.0;
    if (most <= tolerance_ || (ratio < 0.5 && ratio / (1.0 - ratio) * most <= tolerance_)) {
      out.found = true;
      out.error = estimate(past, next, out.worst_node);
      return out;
    }
    last = most;
  }
  return out;
}

double NewtonStep::estimate(const Past& past, const Motion& next, int& worst) const {
  const double h = next.time - past.now.time;
  const bool first = past.steps == 0 || scheme_ == NewtonScheme::backward_euler;
  const double h_before = past.last_step(), w = first ? 0.0 : h / h_before;
  const double weight = scheme_ == NewtonScheme::trapezoid
                            ? h * h * h / 6.0
                            : h * h * (h + h_before) * (1.0 + w) / (3.0 * (1.0 + 2.0 * w));
  double most = 0.0;
  for (const int node : assembly_.free_nodes()) {
    const Vector change = at(next.v.data(), node) - at(past.now.v.data(), node);
    double error;
    if (first && scheme_ == NewtonScheme::trapezoid) {
      error = h / 6.0 * (change - h * at(past.now.a.data(), node)).norm();
    } else if (first) {
      error = 0.5 * h * change.norm();
    } else {
      const Vector before = at(past.now.v.data(), node) - at(past.before.v.data(), node);
      error = weight * (change / h - before / h_before).norm() / (h + h_before);
    }
    if (!(error <= most)) {
      most = error;
      worst = node;
    }
  }
  return most;
}

}  // namespace codend
