#include "settle.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "block_lu.hpp"
#include "tension_path.hpp"

namespace codend {
namespace {

// Turning (change of a line's vector over its length) of one step: at most, and below which the
// shape counts as found.
constexpr double most_turning = 1.0;
constexpr double found_turning = 0.02;
// Parameter of the tension path below which the law itself takes over once the shape is found;
// where it is not found by path_least, the path starts again at path_again, and slower.
constexpr double path_end = 1e-7;
constexpr double path_least = 1e-13;
constexpr double path_again = 1e-8;
constexpr double path_slower = 0.7;
// Slack netting makes the way to the shape chaotic: most starts are through in a hundred steps, a
// few wander for ever. A wandering one begins again at another pace, a pseudo time step in s.
constexpr int attempt_steps = 400;
constexpr int attempts = 8;
constexpr double first_pseudo_steps[attempts] = {1.0, 0.25, 4.0, 0.1, 0.5, 2.0, 0.15, 0.7};

// CPU seconds into a total, from construction to destruction.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(std::clock()) {}
  ~Stopwatch() { total_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  double& total_;
  std::clock_t start_;
};

class Settling {
 public:
  Settling(Assembly& assembly, const double* v, double* x, SettleReport& report)
      : assembly_(assembly),
        report_(report),
        free_(assembly.free_nodes()),
        v_(v),
        x_(x),
        force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
        dx_(force_.size(), 0.0),
        right_(3 * free_.size()),
        damping_(free_.size()),
        values_(9 * assembly.pattern().column.size()),
        reach_(0.02 * extent() + 1e-3),
        load_(total_load()),
        path_(assembly.model(), load_) {
    Stopwatch watch(report_.seconds_analysis);
    std::vector<double> coordinates(3 * free_.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(coordinates.data(), static_cast<int>(i)) = at(x_, free_[i]);
    }
    lu_.analyse(assembly.pattern(), coordinates.data());
  }

  // Back to a start that the caller has put into x.
  void begin(double pseudo_step) {
    path_ = TensionPath(assembly_.model(), load_);
    pseudo_step_ = pseudo_step;
    turning_ = pace_ = 1.0;
    left_path_ = false;
  }

  // Net forces of the law itself.
  void measure() {
    Stopwatch watch(report_.seconds_forces);
    assembly_.move_to(x_, v_);
    assembly_.residual(force_.data());
    report_.worst_force = 0.0;
    for (const int node : free_) {
      const double f = at(force_.data(), node).norm();
      if (!(f <= report_.worst_force)) {
        report_.worst_force = f;
        report_.worst_node = node;
      }
    }
    report_.largest_tension = assembly_.largest_tension();
    double scale = report_.largest_tension;
    if (scale == 0.0) {  // a gear without any tension is measured by its loads
      for (const double load : assembly_.model().load) scale = std::max(scale, std::abs(load));
      if (scale == 0.0) scale = load_;  // a weightless gear, all slack at the moment
    }
    report_.residual = report_.worst_force == 0.0 ? 0.0 : report_.worst_force / scale;
  }

  bool found() const { return turning_ < found_turning; }

  // Whether the net forces are no more than what rounding of the positions makes.
  bool at_rounding() const { return report_.worst_force <= rounding_; }

  // One Newton step; where its matrix is singular none, and the next one is held back more.
  void step() {
    const bool on_path = path_.parameter() > path_end || !found();
    if (on_path) {
      Stopwatch watch(report_.seconds_forces);
      assembly_.strain(strain_);
      if (left_path_) path_.return_to(strain_);
      path_.prepare(strain_);
      assembly_.residual(force_.data(), &path_.predicted());
    }
    left_path_ = !on_path;
    {
      Stopwatch watch(report_.seconds_jacobian);
      assembly_.jacobian({1.0, 0.0}, values_.data(), on_path ? &path_.current() : nullptr);
      assembly_.pseudo_damping(damping_.data());
      for (double& d : damping_) d /= pseudo_step_;
      assembly_.add_diagonal(damping_.data(), values_.data());
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(right_.data(), static_cast<int>(i)) = at(force_.data(), free_[i]);
    }
    {
      Stopwatch watch(report_.seconds_linear);
      ++report_.factorisations;
      if (!lu_.factorise(values_.data())) {
        pseudo_step_ *= 0.1;
        return;
      }
      lu_.solve(right_.data(), right_.data());
    }
    move(on_path);
  }

 private:
  void move(bool on_path) {
    double movement = 0.0;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(dx_.data(), free_[i]) = at(right_.data(), static_cast<int>(i));
      movement = std::max(movement, at(right_.data(), static_cast<int>(i)).norm());
    }
    const LineChange& change = assembly_.line_change(dx_.data());
    turning_ = change.rotation;
    const double share = std::min({1.0, reach_ / movement, most_turning / turning_});
    if (on_path) {
      path_.advance(change.strain, share);
      if (share > 0.3) path_.reduce(std::pow(turning_ < 0.1 ? 0.4 : 0.7, pace_));
      if (path_.parameter() < path_least && !found()) {
        path_.restart(path_again);
        pace_ *= path_slower;
        left_path_ = true;
        pseudo_step_ = std::min(pseudo_step_, 1.0);
      }
    }
    for (std::size_t k = 0; k < dx_.size(); ++k) x_[k] += share * dx_[k];
    pseudo_step_ = std::min(pseudo_step_ * std::clamp(1.0 / turning_, 0.3, 3.0), 1e12);
  }

  // Net force (N) that a stiff line shows when its ends move by their rounding.
  double rounding_force() const {
    double far = 0.0;
    for (int n = 0; n < assembly_.model().nodes; ++n) far = std::max(far, at(x_, n).norm());
    double stiffest = 0.0;
    assembly_.model().each_line([&](const auto& line) {
      double arm = 0.0;
      for (const double a : line.shape) arm = std::max(arm, std::abs(a));
      stiffest = std::max(stiffest, line.multiplicity * arm * arm *
                                        line.material->axial_stiffness / line.rest);
    });
    return 4.0 * std::numeric_limits<double>::epsilon() * far * stiffest;
  }

  double extent() const {
    Vector low = Vector::Constant(1e300), high = Vector::Constant(-1e300);
    for (int n = 0; n < assembly_.model().nodes; ++n) {
      low = low.cwiseMin(at(x_, n));
      high = high.cwiseMax(at(x_, n));
    }
    return (high - low).norm();
  }

  // Sum of the sizes of all loads that are not tensions.
  double total_load() {
    CarriedTension none;
    none.tension.assign(static_cast<std::size_t>(assembly_.model().lines()), 0.0);
    assembly_.move_to(x_, v_);
    assembly_.residual(force_.data(), &none);
    double total = 0.0;
    for (const int node : free_) total += at(force_.data(), node).norm();
    return total > 0.0 ? total : 1.0;
  }

  Assembly& assembly_;
  SettleReport& report_;
  const std::vector<int>& free_;
  const double* v_;
  double* x_;
  std::vector<double> force_, dx_, right_, damping_, values_, strain_;
  double reach_;
  double load_;  // N
  double rounding_ = rounding_force();  // N
  TensionPath path_;
  BlockLU lu_;
  double pseudo_step_ = 1.0;  // s
  double turning_ = 1.0;
  double pace_ = 1.0;         // power of the path's reductions
  bool left_path_ = false;    // tensions must be made anew from the strains
};

}  // namespace

SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x) {
  SettleReport report;
  if (assembly.unknowns() == 0) {
    report.converged = true;
    return report;
  }
  const std::vector<double> start(x, x + 3 * static_cast<std::ptrdiff_t>(assembly.model().nodes));
  Settling settling(assembly, v, x, report);
  for (int attempt = 0, steps = 0;; ++report.iterations, ++steps) {
    settling.measure();
    if (control.watch && !control.watch({report.iterations, report.residual})) return report;
    report.converged =
        (settling.found() && (report.residual <= control.tolerance || settling.at_rounding())) ||
        report.worst_force == 0.0;
    if (report.converged || report.iterations >= control.iterations) return report;
    if (steps == attempt_steps || !std::isfinite(report.residual)) {
      if (++attempt == attempts) return report;
      std::copy(start.begin(), start.end(), x);
      settling.begin(first_pseudo_steps[attempt]);
      settling.measure();
      steps = 0;
    }
    settling.step();
  }
}

}  // namespace codend
