#include "settle_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stopwatch.hpp"

namespace codend {

SettleIteration::SettleIteration(Assembly& assembly, const SettleControl& control, const double* v,
                                 double* x, SettleReport& report)
    : assembly_(assembly),
      control_(control),
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
      pull_(force_.size()),
      load_(total_load()),
      rounding_(rounding_force()),
      fall_time_(assembly.fall_time(x)),
      pseudo_time_(control.pseudo_time),
      path_(assembly.model(), load_),
      linear_(assembly, control, report, x),
      parts_(assembly, control.part),
      from_x_(force_.size()),
      path_steps_(control.law.steps) {
  path_.keep(before_law_.path);  // avoids allocations during steps
}

void SettleIteration::measure() {
  Stopwatch watch(report_.seconds_forces, control_.timed);
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
  report_.residual = report_.worst_force == 0.0 ? 0.0 : report_.worst_force / scale();
}

// Reference force of the whole gear, N.
double SettleIteration::scale() const {
  double scale = report_.largest_tension;
  if (scale == 0.0) {  // a gear without tension uses its loads
    for (const double load : assembly_.model().load) scale = std::max(scale, std::abs(load));
    if (scale == 0.0) scale = load_;  // a weightless gear with all lines slack
  }
  return scale;
}

void SettleIteration::begin() {
  path_ = TensionPath(assembly_.model(), load_);
  pseudo_time_.begin();
  on_law_ = begun_ = closing_in_ = false;
  steps_to_law_ = 0;
  path_steps_ = control_.law.steps;
}

void SettleIteration::begin_near() {
  follow(TensionPath::near_parameter);
  if (report_.residual < control_.law.near_residual) pseudo_time_.assume_rotation(0.0);
}

void SettleIteration::begin_settled() {
  from_settled_ = closing_in_ = true;
  on_law_ = begun_ = false;
  settled_steps_ = 0;
  follow(TensionPath::settled_parameter);
  pseudo_time_.set_step(control_.pseudo_time.longest);
  pseudo_time_.assume_rotation(0.0);
}

void SettleIteration::resume() {
  assembly_.strain(strain_);
  path_ = TensionPath(assembly_.model(), load_);
  path_.follow(strain_, TensionPath::settled_parameter);
  try_law();
  before_law_.pseudo_step = control_.pseudo_time.longest;
  pseudo_time_.begin(pseudo_time_.step(), control_.pseudo_time.found_rotation);
}

void SettleIteration::follow(double parameter) {
  assembly_.strain(strain_);
  std::copy(control_.strain.begin(), control_.strain.end(), strain_.begin());
  path_.follow(strain_, parameter);
}

bool SettleIteration::balanced() {
  if (report_.worst_force == 0.0) return true;
  if (!pseudo_time_.found() || !(report_.residual <= control_.tolerance || at_rounding())) {
    return false;
  }
  judge_parts();
  return report_.parts.residual <= control_.part_tolerance &&
         report_.parts.rounding <= control_.greatest_rounding;
}

bool SettleIteration::nearly_balanced() const {
  const LawControl& law = control_.law;
  const double most = control_.start == Start::near ? law.near_residual : law.residual;
  return pseudo_time_.found() && report_.residual < most;
}

bool SettleIteration::far_on_path() const {
  return !on_law_ && path_.parameter() >= control_.wake.far_parameter;
}

void SettleIteration::judge_parts() { report_.parts = parts_.worst(force_.data(), scale()); }

// True if the net forces are within the rounding of positions.
bool SettleIteration::at_rounding() const {
  return report_.worst_force <= rounding_ && rounding_ <= control_.greatest_rounding * load_;
}

bool SettleIteration::may_be_unstable() {
  // The solution of a settled start was already tested. Boards are tested again, at little cost.
  const Model& model = assembly_.model();
  const bool boards_alone = model.plates.count() > 0 && model.bends.count() == 0;
  if (from_settled_ && report_.iterations == 0 && !boards_alone) return false;
  // A wall that starts from a tested equilibrium does not pass through itself on its way.
  unstable_size_ = unstable_size(assembly_, !from_settled_);
  return unstable_size_ > 0.0;
}

GrowingMotion SettleIteration::growing_motion() {
  Stopwatch watch(report_.seconds_linear, control_.timed);
  GrowingMotion out = codend::growing_motion(assembly_, fall_time_, linear_.factors());
  report_.factorisations += out.factorisations;
  return out;
}

void SettleIteration::perturb(const GrowingMotion& motion, bool backwards) {
  const PerturbationControl& how = control_.perturbation;
  const double size = (backwards ? -how.size : how.size) * unstable_size_;
  assembly_.strain(strain_);
  path_ = TensionPath(assembly_.model(), load_);
  path_.follow(strain_, TensionPath::near_parameter);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(x_, free_[i]) += size * at(motion.motion.data(), static_cast<int>(i));
  }
  on_law_ = closing_in_ = false;
  begun_ = true;
  steps_to_law_ = how.steps;
  const double pseudo_step = how.pace / motion.rate;
  pseudo_time_.begin(pseudo_step);
  pseudo_time_.hold(pseudo_step, how.steps);
}

bool SettleIteration::wanders() const {
  return closing_in_ && settled_steps_ - contracted_step_ >= control_.settled.contracting_steps;
}

void SettleIteration::relax() {
  const double rotation = pseudo_time_.rotation();
  closing_in_ = begun_ = false;
  assembly_.strain(strain_);
  path_.follow(strain_, control_.settled.relaxed_by_turn * rotation * rotation);
  pseudo_time_.begin(1.0, std::min(1.0, rotation));
}

void SettleIteration::step() {
  choose_law();
  if (!on_law_) {
    const double factor = reduction();
    Stopwatch watch(report_.seconds_forces, control_.timed);
    assembly_.sag_to(path_.current());
    assembly_.strain(strain_);
    path_.prepare(assembly_, strain_, factor, least_parameter());
    assembly_.residual(force_.data(), &path_.predicted());
  }
  {
    Stopwatch watch(report_.seconds_jacobian, control_.timed);
    assembly_.jacobian({1.0, 0.0}, values_.data(), on_law_ ? nullptr : &matrix_tension());
    assembly_.pseudo_damping(fall_time_, damping_.data());
    for (double& d : damping_) d /= pseudo_time_.step();
    assembly_.add_diagonal(damping_.data(), values_.data());
  }
  take_right_side();
  if (linear_.solve(values_, right_, step_)) {
    move();
  } else {
    pseudo_time_.shorten();
  }
}

void SettleIteration::choose_law() {
  const LawControl& law = control_.law;
  const bool tried = law_steps_ >= law.steps;
  if (on_law_ && law_steps_ > 0 &&
      (!pseudo_time_.found() || (tried && !(report_.residual < law.closing * residual_on_law_)))) {
    leave_law();
  } else if (!on_law_ && steps_to_law_ <= 0 && pseudo_time_.found() &&
             report_.residual < law.residual) {
    try_law();
  }
  if (on_law_) {
    if (law_steps_ == 0 || tried) residual_on_law_ = report_.residual;
    ++law_steps_;
  }
  --steps_to_law_;
}

void SettleIteration::try_law() {
  on_law_ = true;
  law_steps_ = 0;
  keep(before_law_);
}

void SettleIteration::leave_law() {
  on_law_ = false;
  steps_to_law_ = path_steps_;
  path_steps_ *= 2;
  return_to(before_law_);
}

void SettleIteration::keep(Place& place) const {
  place.x.assign(x_, x_ + force_.size());
  path_.keep(place.path);
  place.pseudo_step = pseudo_time_.step();
}

void SettleIteration::return_to(const Place& place) {
  std::copy(place.x.begin(), place.x.end(), x_);
  path_.go_back(place.path);
  pseudo_time_.set_step(place.pseudo_step);
  measure();
}

// Returns the factor of mu in this step.
double SettleIteration::reduction() {
  if (!begun_) {
    begun_ = true;
    return 1.0;
  }
  if (control_.gradual) return gradual_reduction();
  return std::clamp(pseudo_time_.rotation(), control_.path.least_factor, 1.0);
}

// Returns to the last converged shape if the present mu was too small.
double SettleIteration::gradual_reduction() {
  const PathControl& path = control_.path;
  const bool found = pseudo_time_.found();
  if (!found && ++waited_ <= path.patience) return 1.0;
  waited_ = 0;
  pseudo_time_.scale_limit(found ? 2.0 : 0.5);
  if (found) {
    keep(converged_);
    gradual_factor_ = gradual_factor_ == 0.0
                          ? path.gradual_factor
                          : std::max(std::pow(gradual_factor_, 1.5), path.least_factor);
  } else if (converged_.x.empty()) {
    return 1.0;
  } else {
    return_to(converged_);
    gradual_factor_ = std::sqrt(gradual_factor_);
  }
  return gradual_factor_;
}

// Lower bound of mu in this step.
double SettleIteration::least_parameter() const {
  if (control_.gradual) return 0.0;
  const double rotation = pseudo_time_.rotation();
  return std::min(control_.path.least_by_turn * rotation * rotation,
                  control_.path.most_rise * path_.parameter());
}

// Returns the tensions of the step's matrix: the path's, plus the stabilisation against rotation.
const DualTension& SettleIteration::matrix_tension() {
  if (drag_across_.empty()) assembly_.drag_across(drag_across_);
  held_ = path_.current();
  const HeldControl& held = control_.held;
  const double share = held.share * std::min(1.0, pseudo_time_.rotation() / held.rotation);
  for (std::size_t k = 0; k < drag_across_.size(); ++k) {
    held_.tension[k] += share * drag_across_[k];
  }
  return held_;
}

void SettleIteration::spread_step() {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(dx_.data(), free_[i]) = at(step_.data(), static_cast<int>(i));
  }
}

void SettleIteration::move() {
  spread_step();
  const LineChange& change = assembly_.line_change(dx_.data());
  const double turns = closing_in_ ? 1.0 : control_.pseudo_time.plate_turns;
  const double rotation = std::max({change.rotation, turns * change.plate_turn, change.surfacing});
  const double share = pseudo_time_.share(rotation);
  const bool found = rotation < control_.pseudo_time.found_rotation;
  const bool judged = !closing_in_ && pseudo_time_.judged();
  const bool corrected = !on_law_ && found && share == 1.0;
  const bool looks_back = corrected || (judged && !found);
  if (looks_back) from_x_.assign(x_, x_ + dx_.size());
  take(change, share);
  const double correction = looks_back ? correction_over_step(share) : 0.0;
  if (corrected && correction < control_.path.most_correction) correct();
  // converged steps need no reduction
  if (judged) pseudo_time_.judge(rotation, found ? 0.0 : correction);
  pseudo_time_.advance(rotation);
  if (closing_in_) count_settled_step();
}

void SettleIteration::count_settled_step() {
  ++settled_steps_;
  const double rotation = pseudo_time_.rotation();
  if (settled_steps_ > 1 && rotation > control_.settled.contraction * contracted_rotation_) return;
  contracted_rotation_ = rotation;
  contracted_step_ = settled_steps_;
}

// Moves by a fraction of dx_, with these changes of lines.
void SettleIteration::take(const LineChange& change, double share) {
  if (!on_law_) path_.advance(assembly_, change.strain, share);
  for (std::size_t k = 0; k < dx_.size(); ++k) x_[k] += share * dx_[k];
}

// Applies the correction from correction_over_step().
void SettleIteration::correct() {
  spread_step();
  take(assembly_.line_change(dx_.data()), 1.0);
}

// Computes the residual after the last step, into force_, as the right side of the step's own
// matrix. It uses the old directions of lines. With new ones, the second-order stretch of a
// rotation would push the nodes of a stiff line aside.
void SettleIteration::take_rest() {
  Stopwatch watch(report_.seconds_forces, control_.timed);
  assembly_.move_to(x_, v_);
  if (on_law_) {
    assembly_.residual(force_.data());
    return;
  }
  assembly_.sag_to(path_.current());
  assembly_.strain(strain_);
  path_.correct(assembly_, strain_);
  assembly_.residual(force_.data(), &path_.current());
  assembly_.move_to(from_x_.data(), v_);
  assembly_.sag_to(path_.current());
  assembly_.pull_of(path_.correction(), pull_.data());
  for (std::size_t k = 0; k < force_.size(); ++k) force_[k] += pull_[k];
}

// Returns the size of the correction of the last step over the step itself, measured by the work
// against the damping. `share` is the fraction of the step that was taken.
double SettleIteration::correction_over_step(double share) {
  take_rest();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(force_.data(), free_[i]) -= damping_[i] * share * at(dx_.data(), free_[i]);
  }
  take_right_side();
  linear_.solve_again(right_, step_);
  double off = 0.0, went = 0.0;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Vector dx = at(dx_.data(), free_[i]);
    const Vector left = (1.0 - share) * dx;  // of a step that was not fully taken
    off += damping_[i] * (at(step_.data(), static_cast<int>(i)) - left).squaredNorm();
    went += damping_[i] * share * share * dx.squaredNorm();
  }
  return went > 0.0 ? std::sqrt(off / went) : 0.0;
}

void SettleIteration::take_right_side() {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    at(right_.data(), static_cast<int>(i)) = at(force_.data(), free_[i]);
  }
}

// Net force (N) of the stiffest line due to rounding of its end positions.
double SettleIteration::rounding_force() const {
  double far = 0.0;
  for (int n = 0; n < assembly_.model().nodes; ++n) far = std::max(far, at(x_, n).norm());
  double stiffest = 0.0;
  assembly_.model().each_line([&](const auto& line) {
    double arm = 0.0;
    for (std::size_t k = 0; k < std::size(line.shape); ++k) {
      arm = std::max(arm, line.pull_at(static_cast<int>(k)));
    }
    stiffest = std::max(stiffest, line.multiplicity * arm * arm *
                                      assembly_.model().material(line).axial_stiffness / line.rest);
  });
  return 4.0 * std::numeric_limits<double>::epsilon() * far * stiffest;
}

// Sum of the magnitudes of all loads except tensions.
double SettleIteration::total_load() {
  DualTension none;
  none.tension.assign(static_cast<std::size_t>(assembly_.model().constraints()), 0.0);
  assembly_.move_to(x_, v_);
  assembly_.residual(force_.data(), &none);
  double total = 0.0;
  for (const int node : free_) total += at(force_.data(), node).norm();
  return total > 0.0 ? total : 1.0;
}

}  // namespace codend
