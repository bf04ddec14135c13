#include "explicit_step.hpp"

#include <cmath>

namespace codend {
namespace {

// Returns false at the first node with an infinite or undefined value, and sets `worst` to it.
bool finite(const std::vector<int>& free, const Motion& motion, int& worst) {
  for (const int node : free) {
    if (std::isfinite(at(motion.x.data(), node).sum() + at(motion.v.data(), node).sum())) continue;
    worst = node;
    return false;
  }
  return true;
}

}  // namespace

StepOutcome SymplecticEulerStep::step(const Past& past, double h, Conditions& conditions,
                                      Motion& next) {
  const Motion& now = past.now;
  next.x = now.x;
  next.v = now.v;
  conditions.to_time(now.time, Side::after, next);
  acceleration_.at_motion(now.x, now.v, a_);
  next.time = now.time + h;
  for (const int node : free_) {
    at(next.v.data(), node) += h * at(a_.data(), node);
    at(next.x.data(), node) += h * at(next.v.data(), node);
  }
  conditions.to_time(next.time, Side::before, next);
  StepOutcome out;
  out.iterations = 1;
  out.found = finite(free_, next, out.worst_node);
  return out;
}

StepOutcome RungeKuttaStep::step(const Past& past, double h, Conditions& conditions, Motion& next) {
  constexpr double share[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
  const Motion& now = past.now;
  next.x = now.x;
  next.v = now.v;
  for (int k = 0; k < 4; ++k) {
    const double part = share[k] * h;
    if (k > 0) {
      for (const int node : free_) {
        at(next.x.data(), node) = at(now.x.data(), node) + part * at(v_[k - 1].data(), node);
        at(next.v.data(), node) = at(now.v.data(), node) + part * at(a_[k - 1].data(), node);
      }
    }
    conditions.to_time(now.time + part, k == 0 ? Side::after : Side::before, next);
    v_[k] = next.v;
    acceleration_.at_motion(next.x, next.v, a_[k]);
  }
  next.time = now.time + h;
  for (const int node : free_) {
    Vector dx = Vector::Zero(), dv = Vector::Zero();
    for (int k = 0; k < 4; ++k) {
      dx += weight[k] * at(v_[k].data(), node);
      dv += weight[k] * at(a_[k].data(), node);
    }
    at(next.x.data(), node) = at(now.x.data(), node) + h / 6.0 * dx;
    at(next.v.data(), node) = at(now.v.data(), node) + h / 6.0 * dv;
  }
  conditions.to_time(next.time, Side::before, next);
  StepOutcome out;
  out.iterations = 4;
  out.found = finite(free_, next, out.worst_node);
  return out;
}

}  // namespace codend
