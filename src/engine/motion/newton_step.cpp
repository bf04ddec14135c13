#include "newton_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace codend {
namespace {

constexpr int most_iterations = 12;
// Allowed residual of a node, as a fraction of all forces on it.
constexpr double balance_share = 1e-3;
// Tolerances of the linear solves in Newton steps and in the error estimate. In the latter, a
// residual of one per cent of the forces on a node is negligible.
constexpr StoredFactorisation::Tolerance newton_tolerance{1e-2, 0.0}, error_tolerance{0.0, 10.0};
constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
// Convergence tolerance of a stage, as a fraction of the allowed error of the step.
constexpr double found_share = 0.05;
// g, c and k of the header.
const double stage_share = 2.0 - std::sqrt(2.0);
const double by_stage = 1.0 / (stage_share * (2.0 - stage_share));
const double error_constant =
    (-3.0 * stage_share * stage_share + 4.0 * stage_share - 2.0) / (12.0 * (2.0 - stage_share));

// Returns the positions of the free nodes, 3 per node.
std::vector<double> places(const Assembly& assembly, const Values& nodes) {
  const std::vector<int>& free = assembly.free_nodes();
  std::vector<double> out(3 * free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(out.data(), static_cast<int>(i)) = at(nodes.data(), free[i]);
  }
  return out;
}

}  // namespace

NewtonStep::NewtonStep(Assembly& assembly, const StepAccuracy& accuracy, const Values& ordering)
    : assembly_(assembly),
      accuracy_(accuracy),
      tensions_(assembly),
      factors_(assembly.pattern(), places(assembly, ordering)),
      force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
      mass_(3 * force_.size()),
      inertia_(force_.size()),
      values_(9 * assembly.pattern().column.size()),
      right_(3 * static_cast<std::size_t>(assembly.unknowns())),
      solved_(right_.size()),
      tolerated_(static_cast<std::size_t>(assembly.unknowns())),
      allowed_(static_cast<std::size_t>(assembly.model().nodes)),
      dx_(force_.size(), 0.0),
      answer_(force_.size()) {
  pull_.tension.resize(static_cast<std::size_t>(assembly.model().constraints()));
}

void NewtonStep::follow(const Motion& now, Motion& next) const {
  for (const int node : assembly_.free_nodes()) {
    const Vector moved = at(next.x.data(), node) - at(now.x.data(), node);
    at(next.v.data(), node) = p_ * moved + at(v_rest_.data(), node);
    at(next.a.data(), node) = p_ * p_ * moved + at(a_rest_.data(), node);
  }
}

double NewtonStep::allowed_error(const Values& moved) const {
  if (accuracy_.rate == 0.0) return accuracy_.position;
  const double farthest = largest_distance_from_mean(moved.data(), assembly_.model().nodes);
  return std::max(accuracy_.position, accuracy_.rate * farthest);
}

double NewtonStep::imbalance(const Motion& next, int& worst) {
  assembly_.move_to(next.x.data(), next.v.data());
  assembly_.residual(force_.data());
  assembly_.mass(mass_.data());
  assembly_.inertia(mass_.data(), next.a.data(), inertia_.data());
  assembly_.balance(balance_share, allowed_.data());
  double most = 0.0;
  const double heaviest_body = assembly_.heaviest_body();
  const std::vector<int>& free = assembly_.free_nodes();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const int node = free[i];
    const Eigen::Map<const Block> mass(&mass_[9 * static_cast<std::size_t>(node)]);
    const double heavy = mass.norm() + (assembly_.in_body(node) ? heaviest_body : 0.0);
    const Vector inertia = at(inertia_.data(), node);
    const double left = (at(force_.data(), node) - inertia).norm();
    // Effect of rounding errors in positions and velocities on accelerations.
    const double rounded =
        rounding * (p_ * p_ * at(next.x.data(), node).norm() + p_ * at(next.v.data(), node).norm());
    tolerated_[i] =
        allowed_[static_cast<std::size_t>(node)] + balance_share * inertia.norm() + heavy * rounded;
    const double ratio = left / tolerated_[i];
    if (left > 0.0 && !(ratio <= most)) {
      most = ratio;
      worst = node;
    }
  }
  return most;
}

// Computes one Newton step into dx_. `share` is the fraction that rotates lines by at most their
// own length. Returns false for a singular matrix.
bool NewtonStep::correct(bool first, double& share) {
  const std::vector<int>& free = assembly_.free_nodes();
  tensions_.prepare();
  assembly_.residual(force_.data(), &tensions_.right());
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) =
        at(force_.data(), free[i]) - at(inertia_.data(), free[i]);
  }
  assembly_.jacobian({1.0, p_}, values_.data(), &tensions_.current());
  assembly_.add_mass(mass_.data(), p_ * p_, values_.data());
  factors_.set_matrix(values_, first);
  if (!factors_.solve(right_, tolerated_, newton_tolerance, solved_)) return false;
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(dx_.data(), free[i]) = at(solved_.data(), static_cast<int>(i));
  }
  const LineChange& change = assembly_.line_change(dx_.data());
  share = change.rotation > 1.0 ? 1.0 / change.rotation : 1.0;
  tensions_.advance(change.strain, p_, share);
  return true;
}

void NewtonStep::guess(const Motion& begin, const Values& change, Motion& next) {
  const std::vector<int>& free = assembly_.free_nodes();
  left_out_.assign(free.size(), 0);
  for (std::size_t i = 0; i < free.size(); ++i) {
    left_out_[i] = assembly_.held_back(free[i]) && !assembly_.in_body(free[i]);
  }
  factors_.leave_out(left_out_);
  const double h = next.time - begin.time;
  for (const int node : free) {
    at(next.x.data(), node) = at(begin.x.data(), node) + h * at(begin.v.data(), node) +
                              0.5 * h * h * at(change.data(), node);
  }
  next.a.setZero(next.x.size());
}

StepOutcome NewtonStep::step(const Past& past, double h, Conditions& conditions, Motion& next) {
  const Motion& now = past.now;
  const double found = std::min(accuracy_.found, found_share * allowed_error(h * now.v));
  conditions.to_time(now.time, Side::after, next);
  assembly_.move_to(now.x.data(), now.v.data());
  next.time = now.time + h;
  StepOutcome out;
  if (past.steps == 0) {
    tensions_.begin();
    conditions.to_time(next.time, Side::before, next);
    p_ = 1.0 / h;
    v_rest_.setZero(now.x.size());
    a_rest_ = -p_ * now.v;
    guess(now, v_rest_, next);
    out = solve_stage(now, found, true, next);
    if (!out.found) return out;
    for (const int node : assembly_.free_nodes()) {
      at(dx_.data(), node) = 0.5 * h * (at(next.v.data(), node) - at(now.v.data(), node));
    }
  } else {
    tensions_.begin();
    stage_ = next;
    stage_.time = now.time + stage_share * h;
    conditions.to_time(stage_.time, Side::before, stage_);
    p_ = 2.0 / (stage_share * h);
    v_rest_ = -now.v;
    a_rest_ = -2.0 * p_ * now.v - now.a;
    guess(now, (now.v - past.before.v) / past.last_step(), stage_);
    out = solve_stage(now, found, true, stage_);
    if (!out.found) return out;
    tensions_.begin();
    conditions.to_time(next.time, Side::before, next);
    v_rest_ = -p_ * by_stage * (stage_.x - now.x);
    a_rest_ = p_ * (v_rest_ - by_stage * stage_.v + (by_stage - 1.0) * now.v);
    guess(stage_, (stage_.v - now.v) / (stage_share * h), next);
    const int iterations = out.iterations;
    out = solve_stage(now, found, false, next);
    out.iterations += iterations;
    if (!out.found) return out;
    const double b = 1.0 / stage_share, e = 1.0 / (1.0 - stage_share);
    for (const int node : assembly_.free_nodes()) {
      at(dx_.data(), node) = 2.0 * error_constant * h *
                             (b * at(now.v.data(), node) - b * e * at(stage_.v.data(), node) +
                              e * at(next.v.data(), node));
    }
  }
  filter_error(allowed_error(next.x - now.x), out);
  return out;
}

StepOutcome NewtonStep::solve_stage(const Motion& now, double found, bool first, Motion& end) {
  const std::vector<int>& free = assembly_.free_nodes();
  follow(now, end);
  StepOutcome out;
  double moved = 0.0, moved_before = 0.0;
  for (;; ++out.iterations) {
    const bool balanced = imbalance(end, out.worst_node) <= 1.0;
    if (out.iterations > 0 && balanced) {
      // Geometric series: r/(1 - r) times the last correction remains, with contraction rate r.
      const double ratio = out.iterations > 1 ? moved / moved_before : 1.0;
      out.found = moved <= found || (ratio < 0.5 && ratio / (1.0 - ratio) * moved <= found);
    }
    out.found = out.found || free.empty();
    if (out.found || out.iterations == most_iterations) return out;
    if (out.iterations == 0) tensions_.tighten();
    double share;
    if (!correct(first && out.iterations == 0, share)) return out;
    moved_before = moved;
    moved = 0.0;
    for (const int node : free) {
      const Vector dx = share * at(dx_.data(), node);
      at(end.x.data(), node) += dx;
      const double size = dx.norm();
      if (!(size <= moved)) {
        moved = size;
        out.worst_node = node;
      }
      if (!std::isfinite(size)) return out;
    }
    follow(now, end);
  }
}

void NewtonStep::filter_error(double allowed, StepOutcome& out) {
  const std::vector<int>& free = assembly_.free_nodes();
  if (free.empty() || (!std::isfinite(allowed) && !std::isfinite(accuracy_.tension))) return;
  const std::vector<double>& change = tensions_.with_sag(assembly_.line_change(dx_.data()).strain);
  const std::size_t lines = static_cast<std::size_t>(assembly_.model().lines());
  const std::vector<double>& modulus = tensions_.current().modulus;
  std::fill(pull_.tension.begin(), pull_.tension.end(), 0.0);
  assembly_.residual(force_.data(), &pull_);
  for (std::size_t k = 0; k < lines; ++k) pull_.tension[k] = modulus[k] * change[k];
  assembly_.residual(answer_.data(), &pull_);
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) =
        at(answer_.data(), free[i]) - at(force_.data(), free[i]);
  }
  factors_.solve(right_, tolerated_, error_tolerance, solved_);
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(dx_.data(), free[i]) += at(solved_.data(), static_cast<int>(i));
    const double size = at(dx_.data(), free[i]).norm();
    if (!(size <= out.place_error)) {
      out.place_error = size;
      out.worst_node = free[i];
    }
  }
  out.error = out.place_error / allowed;
  if (!std::isfinite(accuracy_.tension)) return;
  // Errors of bars are relative to the largest pull of a bar, of netting to the largest of a twine.
  const std::vector<double>& left = tensions_.with_sag(assembly_.line_change(dx_.data()).strain);
  const LineArrays& arrays = assembly_.lines();
  const std::size_t bars = static_cast<std::size_t>(assembly_.model().bars.count());
  double bar_error = 0.0, twine_error = 0.0, bar_pull = 0.0, twine_pull = 0.0;
  for (std::size_t k = 0; k < lines; ++k) {
    const double tension = arrays.tension[k];
    const double off = modulus[k] > 0.0 ? std::abs(tensions_.change(k, left[k], p_)) : 0.0;
    if (k < bars) {
      bar_error = std::max(bar_error, arrays.multiplicity[k] * off);
      bar_pull = std::max(bar_pull, arrays.multiplicity[k] * std::abs(tension));
    } else {
      twine_error = std::max(twine_error, off);
      twine_pull = std::max(twine_pull, std::abs(tension));
    }
  }
  const double most = accuracy_.tension;
  if (bar_pull > 0.0) out.error = std::max(out.error, bar_error / (most * bar_pull));
  if (twine_pull > 0.0) out.error = std::max(out.error, twine_error / (most * twine_pull));
}

}  // namespace codend
