#include "substitution.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

SubstitutionStep::SubstitutionStep(Assembly& assembly, double tolerance, int most,
                                   const Motion& start)
    : free_(assembly.free_nodes()),
      tolerance_(tolerance),
      most_(most),
      acceleration_(assembly, start.x.data(), start.v.data()) {}

StepOutcome SubstitutionStep::step(const Past& past, double h, Conditions& conditions,
                                   Motion& next) {
  const Motion &now = past.now, &before = past.before;
  next.x = now.x;
  next.v = now.v;
  conditions.to_time(now.time, Side::after, next);
  acceleration_.at_motion(now.x, now.v, a_);
  const bool heun = past.steps > 0 && std::abs(past.last_step() - h) < 1e-6 * h;
  const Motion& from = heun ? before : now;
  const double span = heun ? 2.0 * h : h;
  for (const int node : free_) {
    at(next.x.data(), node) = at(from.x.data(), node) + span * at(now.v.data(), node);
    at(next.v.data(), node) = at(from.v.data(), node) + span * at(a_.data(), node);
  }
  next.time = now.time + h;
  conditions.to_time(next.time, Side::before, next);
  StepOutcome out;
  while (out.iterations < most_) {
    ++out.iterations;
    acceleration_.at_motion(next.x, next.v, next_a_);
    double most = 0.0;
    for (const int node : free_) {
      const Vector x =
          at(now.x.data(), node) + 0.5 * h * (at(now.v.data(), node) + at(next.v.data(), node));
      const Vector v =
          at(now.v.data(), node) + 0.5 * h * (at(a_.data(), node) + at(next_a_.data(), node));
      const double change = std::max((v - at(next.v.data(), node)).cwiseAbs().maxCoeff(),
                                     (x - at(next.x.data(), node)).cwiseAbs().maxCoeff() / h);
      at(next.x.data(), node) = x;
      at(next.v.data(), node) = v;
      if (!(change <= most)) {
        most = change;
        out.worst_node = node;
      }
      if (!std::isfinite(change)) return out;
    }
    if (most <= tolerance_) {
      out.found = true;
      return out;
    }
  }
  return out;
}

SubstitutionReport integrate_by_substitution(Assembly& assembly, double step, int steps,
                                             double tolerance, int substitutions, double* x,
                                             double* v, const std::function<bool()>& watch) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(assembly.model().nodes);
  Past past;
  past.now.x = Eigen::Map<const Values>(x, size);
  past.now.v = Eigen::Map<const Values>(v, size);
  SteadyConditions conditions(assembly.model().held, past.now);
  SubstitutionStep scheme(assembly, tolerance, substitutions, past.now);
  SubstitutionReport report;
  Motion next = past.now;
  while (report.steps < steps) {
    if (watch && !watch()) break;
    const StepOutcome outcome = scheme.step(past, step, conditions, next);
    report.substitutions += outcome.iterations;
    report.converged = outcome.found;
    if (!outcome.found) break;
    std::swap(past.before, past.now);
    std::swap(past.now, next);
    if (past.steps == 0) next = past.now;
    ++past.steps;
    ++report.steps;
  }
  report.time = report.steps * step;
  std::copy(past.now.x.data(), past.now.x.data() + size, x);
  std::copy(past.now.v.data(), past.now.v.data() + size, v);
  return report;
}

}  // namespace codend
