#include "settle.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>

#include "block_lu.hpp"
#include "second_thread.hpp"
#include "stability.hpp"
#include "tension_path.hpp"

namespace codend {
namespace {

// Turning (change of a line's vector over its length) of one step: at most, and below which the
// shape counts as found.
constexpr double most_turning = 1.0;
constexpr double found_turning = 0.02;
// The law itself is tried once the shape is found and its residual is below law_residual; where it
// does not close in within law_steps, or goes law_excess times further off, the path goes on from
// where it was left, for path_steps, and after every failed trial for twice as many.
constexpr double law_residual = 0.1;
constexpr double law_turning = 0.05;
constexpr int law_steps = 6;
constexpr double law_excess = 100.0;
constexpr int path_steps = 3, most_path_steps = 48;
// Steps are solved to this residual over the right side, a measure that more than this makes useless.
constexpr double solve_tolerance = 1e-4, solve_limit = 0.1;
// Steps with double-precision factors where single ones were not enough.
constexpr int first_double_steps = 2, most_double_steps = 64;
// Below this pseudo time step (s) lines turn little because they are held back, not for want of a
// way to go: the path goes on slowly.
constexpr double short_pseudo_step = 1.0;
// Undamped steps may go round for ever between shapes: this many in a row that turn lines by more
// than cycle_turning, without closing in, are damped again at the pace of their own stiffness.
constexpr int cycle_steps = 3;
constexpr double cycle_turning = 0.1;
// Slack netting makes the way to the shape chaotic: most starts are through in a hundred steps, a
// few wander for ever. A wandering one begins again at another pace, a pseudo time step in s.
constexpr int attempt_steps = 400;
constexpr int attempts = 8;
// From a settled shape under other loads: pseudo time step (s), steps after which this counts as
// failed, and the residual below which the law itself is tried before any step.
constexpr double settled_pseudo_step = 1e6;
constexpr int settled_steps = 30;
constexpr double settled_law_residual = 1e-3;
// Wakes are renewed on every settled shape until no point's share of the speed changes by more; from
// the fifth time on the netting upstream of every point stays the same.
constexpr int shadings = 20, searches = 4;
// Of all loads together, the most that rounding may leave.
constexpr double greatest_rounding = 1e-3;
// An unstable equilibrium is perturbed by this share of the least unstable element's size, and the
// pseudo time step stays below this share of the time in which the motion grows, for so many steps.
// Tried so often.
constexpr double perturbation_share = 0.1, perturbed_pace = 0.4;
constexpr int perturbed_steps = 40, perturbations = 4;
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
        step_(right_.size()),
        damping_(free_.size()),
        values_(9 * assembly.pattern().column.size()),
        load_(total_load()),
        path_(assembly.model(), load_) {
    analyse(Precision::single_precision);
  }

  // Back to a start that the caller has put into x.
  void begin(double pseudo_step) {
    path_ = TensionPath(assembly_.model(), load_);
    pseudo_step_ = pseudo_step;
    turning_ = last_turning_ = 1.0;
    on_law_ = begun_ = false;
    steps_to_law_ = cycle_ = 0;
    path_steps_ = path_steps;
  }

  // From a settled shape under loads that have changed: the law itself, and where that does not
  // close in the path from that shape's tensions.
  void resume() {
    on_law_ = true;
    law_steps_done_ = 0;
    residual_on_law_ = report_.residual;
    residual_before_law_ = std::max(report_.residual, settled_law_residual);
    left_x_.assign(x_, x_ + force_.size());
    assembly_.strain(strain_);
    left_path_ = TensionPath(assembly_.model(), load_);
    left_path_.follow(strain_, TensionPath::settled_parameter);
    left_pseudo_step_ = settled_pseudo_step;
    turning_ = last_turning_ = found_turning;
    cycle_ = 0;
  }

  // Of the shape that was found.
  GrowingMotion growing_motion() {
    Stopwatch watch(report_.seconds_linear);
    return codend::growing_motion(assembly_, *lu_);
  }

  // Whether an equilibrium may be unstable.
  bool may_be_unstable() {
    // What settles from its own state was tried there. (Boards cost little: they are tried again.)
    if (from_settled_ && report_.iterations == 0 && assembly_.model().bends.count() > 0)
      return false;
    unstable_size_ = unstable_size(assembly_);
    return unstable_size_ > 0.0;
  }

  // On from an unstable shape, along the motion that leaves it or, backwards, against it.
  void leave(const GrowingMotion& from, bool backwards) {
    const double size = (backwards ? -perturbation_share : perturbation_share) * unstable_size_;
    assembly_.strain(strain_);
    path_ = TensionPath(assembly_.model(), load_);
    path_.follow(strain_, TensionPath::near_parameter);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(x_, free_[i]) += size * at(from.motion.data(), static_cast<int>(i));
    }
    turning_ = last_turning_ = 1.0;
    on_law_ = false;
    begun_ = true;
    steps_to_law_ = perturbed_steps;
    cycle_ = 0;
    held_steps_ = perturbed_steps;
    held_pseudo_step_ = pseudo_step_ = perturbed_pace / from.rate;
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

  // Takes the present positions, measured, as nearly settled, with these strains or its own.
  void stay_near(const std::vector<double>& strain) {
    follow(strain, TensionPath::near_parameter);
    // worth a try of the law at once
    if (report_.residual < law_residual) turning_ = 0.0;
  }

  // Takes the present positions, measured, as settled under other loads with these strains.
  void stay_settled(const std::vector<double>& strain) {
    from_settled_ = true;
    follow(strain, TensionPath::settled_parameter);
    pseudo_step_ = settled_pseudo_step;
    if (report_.residual < settled_law_residual) turning_ = 0.0;
  }

  bool found() const { return turning_ < found_turning && held_steps_ == 0; }

  // Whether the net forces are no more than what rounding of the positions makes.
  // What rounds to a force beside which the loads are little is no balance.
  bool at_rounding() const {
    return report_.worst_force <= rounding_ && rounding_ <= greatest_rounding * load_;
  }

  // One Newton step; where its matrix is singular none, and the next one is held back more.
  void step() {
    choose_law();
    {
      Stopwatch watch(report_.seconds_forces);
      if (!on_law_) {
        assembly_.strain(strain_);
        path_.prepare(strain_, reduction());
        assembly_.residual(force_.data(), &path_.predicted());
      }
    }
    {
      Stopwatch watch(report_.seconds_jacobian);
      assembly_.jacobian({1.0, 0.0}, values_.data(), on_law_ ? nullptr : &path_.current());
      assembly_.pseudo_damping(damping_.data());
      for (double& d : damping_) d /= pseudo_step_;
      assembly_.add_diagonal(damping_.data(), values_.data());
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(right_.data(), static_cast<int>(i)) = at(force_.data(), free_[i]);
    }
    if (solve()) {
      move();
    } else {
      pseudo_step_ *= 0.1;
    }
  }

 private:
  void follow(const std::vector<double>& strain, double parameter) {
    assembly_.strain(strain_);
    std::copy(strain.begin(), strain.end(), strain_.begin());
    path_.follow(strain_, parameter);
  }

  // Whether the next step is the law's own or the path's.
  void choose_law() {
    const bool tried = law_steps_done_ >= law_steps;
    if (on_law_ &&
        (turning_ > law_turning || report_.residual > law_excess * residual_before_law_ ||
         (tried && !(report_.residual < 0.3 * residual_on_law_)))) {
      on_law_ = false;
      steps_to_law_ = path_steps_;
      path_steps_ = std::min(2 * path_steps_, most_path_steps);
      std::copy(left_x_.begin(), left_x_.end(), x_);
      path_ = left_path_;
      pseudo_step_ = left_pseudo_step_;
      measure();
    } else if (!on_law_ && steps_to_law_ <= 0 && found() && report_.residual < law_residual) {
      on_law_ = true;
      law_steps_done_ = 0;
      residual_before_law_ = report_.residual;
      left_x_.assign(x_, x_ + force_.size());
      left_path_ = path_;
      left_pseudo_step_ = pseudo_step_;
    }
    if (on_law_) {
      if (law_steps_done_ == 0 || tried) residual_on_law_ = report_.residual;
      ++law_steps_done_;
    }
    --steps_to_law_;
  }

  // How far the path goes on in this step: far only while lines turn little.
  double reduction() {
    if (!begun_) {
      begun_ = true;
      return 1.0;
    }
    if (turning_ < 1.0 && pseudo_step_ < short_pseudo_step) return 0.85;
    if (turning_ < 0.1) return 0.05;
    if (turning_ < 0.5) return 0.5;
    return turning_ < 1.0 ? 0.7 : 1.0;
  }

  void analyse(Precision precision) {
    Stopwatch watch(report_.seconds_analysis);
    std::vector<double> coordinates(right_.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      at(coordinates.data(), static_cast<int>(i)) = at(x_, free_[i]);
    }
    precision_ = precision;
    lu_.reset();  // its memory is needed for the new one
    lu_ = std::make_unique<BlockLU>(precision, usable_threads());
    lu_->analyse(assembly_.pattern(), coordinates.data());
  }

  // The step of the present matrix and right side; false where the matrix is singular. Factors are
  // in single precision where refinement makes up for it; where it does not they are double for a
  // few steps, and for twice as many each time.
  bool solve() {
    if (precision_ == Precision::double_precision && double_left_-- == 0) {
      analyse(Precision::single_precision);
    }
    if (precision_ == Precision::single_precision) {
      Stopwatch watch(report_.seconds_linear);
      ++report_.factorisations;
      if (lu_->factorise(values_.data()) &&
          lu_->solve_refined(assembly_.pattern(), values_.data(), right_.data(), solve_tolerance,
                             step_.data()) < solve_limit) {
        return true;
      }
    }
    if (precision_ == Precision::single_precision) {
      analyse(Precision::double_precision);
      double_left_ = double_steps_ - 1;
      double_steps_ = std::min(2 * double_steps_, most_double_steps);
    }
    Stopwatch watch(report_.seconds_linear);
    ++report_.factorisations;
    if (!lu_->factorise(values_.data())) return false;
    lu_->solve(right_.data(), step_.data());
    return true;
  }

  void move() {
    double damped = 0.0, driven = 0.0;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const Vector dx = at(step_.data(), static_cast<int>(i));
      at(dx_.data(), free_[i]) = dx;
      damped += damping_[i] * dx.squaredNorm();
      driven += dx.dot(at(force_.data(), free_[i]));
    }
    const LineChange& change = assembly_.line_change(dx_.data());
    turning_ = change.rotation;
    const double share = std::min(1.0, most_turning / turning_);
    if (!on_law_) path_.advance(change.strain, share);
    for (std::size_t k = 0; k < dx_.size(); ++k) x_[k] += share * dx_[k];

    // Pseudo time in which the step's stiffness alone would make it.
    const double own = driven > damped ? pseudo_step_ * damped / (driven - damped) : 1e12;
    const bool around =
        turning_ > cycle_turning && turning_ > 0.6 * last_turning_ && pseudo_step_ > 10.0 * own;
    cycle_ = around ? cycle_ + 1 : 0;
    last_turning_ = turning_;
    pseudo_step_ = std::min(pseudo_step_ * std::clamp(1.0 / turning_, 0.3, 3.0), 1e12);
    if (cycle_ == cycle_steps) {
      pseudo_step_ = std::max(3.0 * own, 1e-3);
      cycle_ = 0;
    }
    if (held_steps_ > 0) {
      --held_steps_;
      pseudo_step_ = std::min(pseudo_step_, held_pseudo_step_);
    }
  }

  // Net force (N) that a stiff line shows when its ends move by their rounding.
  double rounding_force() const {
    double far = 0.0;
    for (int n = 0; n < assembly_.model().nodes; ++n) far = std::max(far, at(x_, n).norm());
    double stiffest = 0.0;
    assembly_.model().each_line([&](const auto& line) {
      double arm = 0.0;
      for (std::size_t k = 0; k < std::size(line.shape); ++k) {
        arm = std::max(arm, line.pull_at(static_cast<int>(k)));
      }
      stiffest =
          std::max(stiffest, line.multiplicity * arm * arm *
                                 assembly_.model().material(line).axial_stiffness / line.rest);
    });
    return 4.0 * std::numeric_limits<double>::epsilon() * far * stiffest;
  }

  // Sum of the sizes of all loads that are not tensions.
  double total_load() {
    CarriedTension none;
    none.tension.assign(static_cast<std::size_t>(assembly_.model().carriers()), 0.0);
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
  std::vector<double> force_, dx_, right_, step_, damping_, values_, strain_;
  bool from_settled_ = false;           // the start is a settled state
  double unstable_size_ = 0.0;          // m
  double load_;                         // N
  double rounding_ = rounding_force();  // N
  TensionPath path_;
  Precision precision_ = Precision::single_precision;
  int double_left_ = 0, double_steps_ = first_double_steps;
  std::unique_ptr<BlockLU> lu_;
  double pseudo_step_ = 1.0;  // s
  double turning_ = 1.0, last_turning_ = 1.0;
  bool begun_ = false;             // a step has been taken
  int held_steps_ = 0;             // steps for which the pseudo time step stays short
  double held_pseudo_step_ = 0.0;  // s
  int cycle_ = 0;                  // undamped steps in a row that do not close in
  bool on_law_ = false;
  int law_steps_done_ = 0, steps_to_law_ = 0;
  int path_steps_ = path_steps;
  double residual_before_law_ = 0.0, residual_on_law_ = 0.0;
  // Where the path was left for the law.
  std::vector<double> left_x_;
  TensionPath left_path_ = path_;
  double left_pseudo_step_ = 1.0;  // s
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
  // The last settled shape, while steps go on from there under other loads or wakes.
  bool closing_in = control.start == Start::settled;
  std::vector<double> settled = start;
  for (int attempt = 0, steps = 0;; ++report.iterations, ++steps) {
    settling.measure();
    if (report.iterations == 0) {
      if (control.start == Start::near) settling.stay_near(control.strain);
      if (control.start == Start::settled) settling.stay_settled(control.strain);
    } else if (closing_in && (steps == settled_steps || !std::isfinite(report.residual))) {
      std::copy(settled.begin(), settled.end(), x);
      settling.begin(first_pseudo_steps[attempt]);
      settling.measure();
      if (report.shadings == 0) settling.stay_near(control.strain);
      closing_in = false;
      steps = 0;
    }
    if (control.watch && !control.watch({report.iterations, report.residual})) return report;
    report.converged =
        (settling.found() && (report.residual <= control.tolerance || settling.at_rounding())) ||
        report.worst_force == 0.0;
    // What needs no step from where it was settled was shaded so then.
    const bool shaded =
        control.start == Start::settled && report.iterations == 0 && !assembly.model().wake.empty();
    if (report.converged && assembly.shades() && !shaded) {
      report.shading_change = assembly.shade(report.shadings < searches, shading_tolerance);
      ++report.shadings;
      if (report.shading_change > shading_tolerance) {
        report.converged = false;
        settling.measure();
        if (report.shadings == shadings) return report;
        settling.resume();
        closing_in = true;
        settled.assign(x, x + start.size());
        steps = 0;
      }
    }
    if (report.converged && settling.may_be_unstable()) {
      const GrowingMotion growing = settling.growing_motion();
      report.upset_at_last = growing.found;
      if (growing.found && report.upsets < perturbations) {
        settling.leave(growing, report.upsets % 2 == 1);
        closing_in = false;
        ++report.upsets;
        report.converged = false;
        settling.measure();
        steps = 0;
      }
    }
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
