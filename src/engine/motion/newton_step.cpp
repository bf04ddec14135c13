#include "newton_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace codend {
namespace {

constexpr int most_iterations = 12;
// An iteration with a larger node displacement (m) is rejected as divergent.
constexpr double most_move = 50.0;
// Allowed residual of a node, as a fraction of all forces on it.
constexpr double balance_share = 1e-3;
// Tolerances of the linear solves in Newton steps and in the error estimate. In the latter, a
// residual of one per cent of the forces on a node is negligible.
constexpr StoredFactorisation::Tolerance newton_tolerance{1e-2, 0.0}, error_tolerance{0.0, 10.0};
constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
// Spectral radius of generalised alpha at infinite frequency, and its coefficients. With 0.6,
// remaining stiff oscillations switch slack lines of large nets on and off permanently (40 x 40
// knots: half of the tension).
constexpr double radius = 0.4;
constexpr double alpha_force = radius / (radius + 1.0);
constexpr double alpha_mass = (2.0 * radius - 1.0) / (radius + 1.0);
constexpr double gamma = 0.5 + alpha_force - alpha_mass;
constexpr double beta = 0.25 * (1.0 + alpha_force - alpha_mass) * (1.0 + alpha_force - alpha_mass);

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

NewtonStep::NewtonStep(Assembly& assembly, NewtonScheme scheme, const StepAccuracy& accuracy,
                       const Values& ordering)
    : assembly_(assembly),
      scheme_(scheme),
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

NewtonStep::Rule NewtonStep::set_rule(const Past& past, double h) {
  const Motion& now = past.now;
  b_rest_.setZero(now.x.size());
  if (scheme_ == NewtonScheme::backward_euler || past.steps == 0) {
    v_rest_.setZero(now.x.size());
    a_rest_ = -now.v / h;
    return {1.0 / h, 1.0 / (h * h), 1.0, 0.5 * h, true};
  }
  const double h_before = past.last_step();
  if (scheme_ == NewtonScheme::generalised_alpha) {
    const double b = 1.0 / (beta * h * h);
    // b1 = b (x1 - x0) + b1_rest
    const Values b1_rest = -b * (h * now.v + (h * h * (0.5 - beta)) * now.b);
    v_rest_ = now.v + h * ((1.0 - gamma) * now.b + gamma * b1_rest);
    const double share = (1.0 - alpha_mass) / (1.0 - alpha_force);
    a_rest_ = share * b1_rest + (alpha_mass * now.b - alpha_force * now.a) / (1.0 - alpha_force);
    b_rest_ = (alpha_force * now.a - alpha_mass * now.b) / (1.0 - alpha_mass);
    return {
        gamma / (beta * h), share * b, 1.0 / share,
        2.0 * (beta + 0.5 * (alpha_mass - alpha_force) - 1.0 / 6.0) * h * h * h / (h + h_before),
        false};
  }
  const double w = h / h_before;
  const double p = (1.0 + 2.0 * w) / ((1.0 + w) * h), q = w * w / ((1.0 + w) * h);
  v_rest_ = -q * (now.x - past.before.x);
  a_rest_ = p * (v_rest_ - now.v) - q * (now.v - past.before.v);
  return {p, p * p, 1.0, h * h * (1.0 + w) / (3.0 * (1.0 + 2.0 * w)), false};
}

void NewtonStep::follow(const Rule& rule, const Motion& now, Motion& next) const {
  for (const int node : assembly_.free_nodes()) {
    const Vector moved = at(next.x.data(), node) - at(now.x.data(), node);
    at(next.v.data(), node) = rule.p * moved + at(v_rest_.data(), node);
    at(next.a.data(), node) = rule.m * moved + at(a_rest_.data(), node);
    at(next.b.data(), node) = rule.b_by_a * at(next.a.data(), node) + at(b_rest_.data(), node);
  }
}

double NewtonStep::imbalance(const Rule& rule, const Motion& next, int& worst) {
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
    const double rounded = rounding * (rule.m * at(next.x.data(), node).norm() +
                                       rule.p * at(next.v.data(), node).norm());
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
bool NewtonStep::correct(const Rule& rule, bool first, double& share) {
  const std::vector<int>& free = assembly_.free_nodes();
  tensions_.prepare();
  assembly_.residual(force_.data(), &tensions_.right());
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) =
        at(force_.data(), free[i]) - at(inertia_.data(), free[i]);
  }
  assembly_.jacobian({1.0, rule.p}, values_.data(), &tensions_.current());
  assembly_.add_mass(mass_.data(), rule.m, values_.data());
  factors_.set_matrix(values_, first);
  if (!factors_.solve(right_, tolerated_, newton_tolerance, solved_)) return false;
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(dx_.data(), free[i]) = at(solved_.data(), static_cast<int>(i));
  }
  const LineChange& change = assembly_.line_change(dx_.data());
  share = change.rotation > 1.0 ? 1.0 / change.rotation : 1.0;
  tensions_.advance(change.strain, rule.p, share);
  return true;
}

StepOutcome NewtonStep::step(const Past& past, double h, Conditions& conditions, Motion& next) {
  const Motion& now = past.now;
  const std::vector<int>& free = assembly_.free_nodes();
  conditions.to_time(now.time, Side::after, next);
  assembly_.move_to(now.x.data(), now.v.data());
  tensions_.begin();
  next.time = now.time + h;
  conditions.to_time(next.time, Side::before, next);
  const Rule rule = set_rule(past, h);
  left_out_.assign(free.size(), 0);
  for (std::size_t i = 0; i < free.size(); ++i) {
    left_out_[i] = assembly_.held_back(free[i]) && !assembly_.in_body(free[i]);
  }
  factors_.leave_out(left_out_);
  for (const int node : free) {
    at(next.x.data(), node) = at(now.x.data(), node) + h * at(now.v.data(), node);
    if (past.steps == 0) continue;
    const Vector change = at(now.v.data(), node) - at(past.before.v.data(), node);
    at(next.x.data(), node) += 0.5 * h * h / past.last_step() * change;
  }
  next.a.setZero(next.x.size());
  next.b.setZero(next.x.size());
  follow(rule, now, next);
  StepOutcome out;
  double moved = 0.0, moved_before = 0.0;
  for (;; ++out.iterations) {
    const bool balanced = imbalance(rule, next, out.worst_node) <= 1.0;
    if (out.iterations > 0 && balanced) {
      // Geometric series: r/(1 - r) times the last correction remains, with contraction rate r.
      const double ratio = out.iterations > 1 ? moved / moved_before : 1.0;
      if (moved <= accuracy_.found ||
          (ratio < 0.5 && ratio / (1.0 - ratio) * moved <= accuracy_.found)) {
        out.found = true;
        out.error = error(rule, past, next, out.worst_node);
        return out;
      }
    }
    if (free.empty()) {
      out.found = true;
      return out;
    }
    if (out.iterations == most_iterations) return out;
    if (out.iterations == 0) tensions_.tighten();
    double share;
    if (!correct(rule, out.iterations == 0, share)) return out;
    moved_before = moved;
    moved = 0.0;
    for (const int node : free) {
      const Vector dx = share * at(dx_.data(), node);
      at(next.x.data(), node) += dx;
      const double size = dx.norm();
      if (!(size <= moved)) {
        moved = size;
        out.worst_node = node;
      }
      if (!(size < most_move)) return out;
    }
    follow(rule, now, next);
  }
}

// Returns the error of the step over the allowance.
double NewtonStep::error(const Rule& rule, const Past& past, const Motion& next, int& worst) {
  if (!std::isfinite(accuracy_.position) && !std::isfinite(accuracy_.tension)) return 0.0;
  const double h = next.time - past.now.time, h_before = past.last_step();
  const std::vector<int>& free = assembly_.free_nodes();
  for (const int node : free) {
    const Vector change = at(next.v.data(), node) - at(past.now.v.data(), node);
    if (rule.first_order) {
      at(dx_.data(), node) = rule.error * change;
    } else {
      const Vector before = at(past.now.v.data(), node) - at(past.before.v.data(), node);
      at(dx_.data(), node) = rule.error * (change / h - before / h_before);
    }
  }
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
  double most = 0.0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    at(dx_.data(), free[i]) += at(solved_.data(), static_cast<int>(i));
    const double size = at(dx_.data(), free[i]).norm() / accuracy_.position;
    if (!(size <= most)) {
      most = size;
      worst = free[i];
    }
  }
  if (!std::isfinite(accuracy_.tension)) return most;
  // Errors of bars are relative to the largest pull of a bar, of netting to the largest of a twine.
  const std::vector<double>& left = tensions_.with_sag(assembly_.line_change(dx_.data()).strain);
  const LineArrays& arrays = assembly_.lines();
  const std::size_t bars = static_cast<std::size_t>(assembly_.model().bars.count());
  double bar_error = 0.0, twine_error = 0.0, bar_pull = 0.0, twine_pull = 0.0;
  for (std::size_t k = 0; k < lines; ++k) {
    const double tension = arrays.tension[k];
    const double off = modulus[k] > 0.0 ? std::abs(tensions_.change(k, left[k], rule.p)) : 0.0;
    if (k < bars) {
      bar_error = std::max(bar_error, arrays.multiplicity[k] * off);
      bar_pull = std::max(bar_pull, arrays.multiplicity[k] * std::abs(tension));
    } else {
      twine_error = std::max(twine_error, off);
      twine_pull = std::max(twine_pull, std::abs(tension));
    }
  }
  if (bar_pull > 0.0) most = std::max(most, bar_error / (accuracy_.tension * bar_pull));
  if (twine_pull > 0.0) most = std::max(most, twine_error / (accuracy_.tension * twine_pull));
  return most;
}

}  // namespace codend
