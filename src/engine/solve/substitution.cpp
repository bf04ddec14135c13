#include "substitution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace codend {
namespace {

using Values = Eigen::VectorXd;

// Positions and velocities, or their rates: 3 per node each.
struct Phase {
  Values x, v;
};

class March {
 public:
  March(Assembly& assembly, double step, double tolerance, const double* x, const double* v)
      : assembly_(assembly),
        step_(step),
        tolerance_(tolerance),
        force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
        mass_(3 * force_.size()) {
    const Eigen::Index size = static_cast<Eigen::Index>(force_.size());
    now_ = {Eigen::Map<const Values>(x, size), Eigen::Map<const Values>(v, size)};
    rate_ = next_rate_ = {Values::Zero(size), Values::Zero(size)};
    measure(now_, rate_);
    for (const int node : assembly_.free_nodes()) {
      if (!(block(node).determinant() > 0.0)) {
        throw std::invalid_argument("node " + std::to_string(node) + " has no mass to move");
      }
    }
  }

  // One step; false where substitution does not converge in `most` rounds.
  bool advance(int most, long long& substitutions) {
    if (has_before_) {
      next_ = {before_.x + 2.0 * step_ * rate_.x, before_.v + 2.0 * step_ * rate_.v};
    } else {
      next_ = {now_.x + step_ * rate_.x, now_.v + step_ * rate_.v};
    }
    for (int round = 0; round < most; ++round) {
      ++substitutions;
      measure(next_, next_rate_);
      better_.x = now_.x + 0.5 * step_ * (rate_.x + next_rate_.x);
      better_.v = now_.v + 0.5 * step_ * (rate_.v + next_rate_.v);
      const double change = std::max((better_.v - next_.v).cwiseAbs().maxCoeff(),
                                     (better_.x - next_.x).cwiseAbs().maxCoeff() / step_);
      std::swap(next_, better_);
      if (!std::isfinite(change)) return false;
      if (change <= tolerance_) {
        std::swap(before_, now_);
        std::swap(now_, next_);
        has_before_ = true;
        measure(now_, rate_);
        return true;
      }
    }
    return false;
  }

  const Phase& now() const { return now_; }

 private:
  Eigen::Map<const Block> block(int node) const {
    return Eigen::Map<const Block>(&mass_[9 * static_cast<std::size_t>(node)]);
  }

  void measure(const Phase& y, Phase& rate) {
    rate.x = y.v;
    assembly_.move_to(y.x.data(), y.v.data());
    assembly_.residual(force_.data());
    assembly_.mass(mass_.data());
    for (const int node : assembly_.free_nodes()) {
      at(rate.v.data(), node) = block(node).inverse() * at(force_.data(), node);
    }
  }

  Assembly& assembly_;
  double step_, tolerance_;
  std::vector<double> force_, mass_;
  Phase before_, now_, next_, better_, rate_, next_rate_;
  bool has_before_ = false;
};

}  // namespace

SubstitutionReport march_by_substitution(Assembly& assembly, double step, int steps,
                                         double tolerance, int substitutions, double* x,
                                         double* v) {
  SubstitutionReport report;
  March march(assembly, step, tolerance, x, v);
  while (report.steps < steps) {
    report.converged = march.advance(substitutions, report.substitutions);
    if (!report.converged) break;
    ++report.steps;
  }
  report.time = report.steps * step;
  std::copy(march.now().x.data(), march.now().x.data() + march.now().x.size(), x);
  std::copy(march.now().v.data(), march.now().v.data() + march.now().v.size(), v);
  return report;
}

}  // namespace codend
