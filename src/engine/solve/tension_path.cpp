#include "tension_path.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

constexpr double first_parameter = 1e-2;
constexpr double least_parameter = 1e-24;
// Initial tension over a line's scale. It is high, so that the first steps find the global shape.
constexpr double first_tension = 10.0;
// Initial penetration of contacts over their onset; the corresponding normal force is their scale.
constexpr double first_penetration = 0.05;
// Unit of the slack of contacts over their onset.
constexpr double slack_onsets = 50.0;
// Lower limit of a tension or slack variable after a step, as a fraction of its value before.
constexpr double least_rest = 0.02;
constexpr double least_tension = 1e-27;                  // over a line's scale
constexpr double least_slack = 1e-26, most_slack = 1e3;  // in units of slack_unit()
// Lower limit of T s over mu, so that all lines follow the path.
constexpr double least_product = 1e-2;

}  // namespace

TensionPath::TensionPath(const Model& model, double load)
    : lines_(static_cast<std::size_t>(model.lines())),
      ground_(model.ground),
      parameter_(first_parameter) {
  const std::size_t lines = static_cast<std::size_t>(model.constraints());
  stiffness_.resize(lines);
  scale_.resize(lines);
  strut_.assign(lines, 0);
  table_.assign(lines, nullptr);
  slack_.resize(lines);
  ratio_.resize(lines);
  centring_.resize(lines);
  mismatch_.resize(lines);
  sag_.resize(lines);
  model.each_line([&](const auto& line) {
    stiffness_[line.index] = model.material(line).axial_stiffness;
    strut_[line.index] = model.material(line).strut;
    if (!model.material(line).loads.empty()) table_[line.index] = &model.material(line);
    scale_[line.index] = model.material(line).strut
                             ? 0.0
                             : std::min(0.01 * model.material(line).axial_stiffness, load);
  });
  for (int e = 0; e < model.contacts.count(); ++e) {
    const std::size_t k = lines_ + static_cast<std::size_t>(e);
    stiffness_[k] = ground_.stiffness * model.contacts.area[e];
    scale_[k] = std::min(first_penetration * ground_.onset * stiffness_[k], load);
  }
  current_.tension.resize(lines);
  for (std::size_t k = 0; k < lines; ++k) {
    current_.tension[k] = first_tension * scale_[k];
    slack_[k] = first_parameter / first_tension * slack_unit(k);
  }
  current_.modulus.resize(lines);
  predicted_.tension = current_.tension;
}

double TensionPath::slack_unit(std::size_t k) const {
  return k < lines_ ? 1.0 : slack_onsets * ground_.onset;
}

double TensionPath::product(std::size_t k) const { return parameter_ * scale_[k] * slack_unit(k); }

void TensionPath::keep(Place& place) const {
  place.tension = current_.tension;
  place.slack = slack_;
  place.parameter = parameter_;
}

void TensionPath::go_back(const Place& place) {
  current_.tension = place.tension;
  slack_ = place.slack;
  parameter_ = place.parameter;
}

void TensionPath::follow(const std::vector<double>& strain, double parameter) {
  parameter_ = parameter;
  begun_ = true;
  for (std::size_t k = 0; k < scale_.size(); ++k) follow(k, strain[k]);
}

void TensionPath::follow(std::size_t k, double strain) {
  if (stiffness_[k] == 0.0) return;
  if (strut_[k]) {
    current_.tension[k] = stiffness_[k] * strain;
    return;
  }
  // T s = mu scale and strain = T/EA - s
  const double root = std::sqrt(strain * strain + 4.0 * product(k) / stiffness_[k]);
  const double t =
      strain > 0.0 ? 0.5 * stiffness_[k] * (strain + root) : 2.0 * product(k) / (root - strain);
  current_.tension[k] = std::min(t, first_tension * scale_[k]);
  slack_[k] = product(k) / current_.tension[k];
}

void TensionPath::stretch(std::size_t k, double tension, double& strain, double& slope) const {
  if (table_[k]) {
    twine_stretch(*table_[k], tension, strain, slope);
  } else if (k < lines_) {
    strain = tension / stiffness_[k];
    slope = 1.0 / stiffness_[k];
  } else {
    ground_.give(tension, stiffness_[k], strain, slope);
  }
}

// Starts a contact on the path at its distance from the ground.
void TensionPath::rest_contact(std::size_t k, double penetration) {
  slack_[k] = std::max(parameter_ * slack_unit(k), -penetration);
  current_.tension[k] = product(k) / slack_[k];
}

void TensionPath::prepare(const Assembly& assembly, const std::vector<double>& strain,
                          double reduction, double least) {
  parameter_ = std::max({parameter_ * reduction, least, least_parameter});
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    if (stiffness_[k] == 0.0) continue;  // a line without stiffness never has tension
    if (strut_[k]) {                     // no path for struts, because both signs are allowed
      current_.modulus[k] = stiffness_[k];
      mismatch_[k] = strain[k] - current_.tension[k] / stiffness_[k];
      predicted_.tension[k] = stiffness_[k] * strain[k];
      continue;
    }
    if (!begun_ && k >= lines_) rest_contact(k, strain[k]);
    const double t = current_.tension[k];
    double stretched, slope;
    stretch(k, t, stretched, slope);
    ratio_[k] = slack_[k] / t;
    current_.modulus[k] = 1.0 / (slope + ratio_[k]);
    mismatch(k, strain[k], stretched);
    predicted_.tension[k] = t + current_.modulus[k] * mismatch_[k];
  }
  begun_ = true;
  add_sag(assembly);
}

void TensionPath::distribute_sag(const Assembly& assembly, const double* change) {
  std::fill(sag_.begin(), sag_.end(), 0.0);
  assembly.distribute_sag(current_, mismatch_.data(), change, sag_.data());
}

// Adds the effect of sag on the missing strains to the tensions of the right side.
void TensionPath::add_sag(const Assembly& assembly) {
  distribute_sag(assembly, nullptr);
  assembly.add_sag_tensions(current_, sag_.data(), predicted_.tension.data());
}

void TensionPath::mismatch(std::size_t k, double strain, double stretched) {
  const double s = slack_[k];
  centring_[k] = product(k) / current_.tension[k] - s;
  mismatch_[k] = strain - stretched + s + centring_[k];
}

void TensionPath::correct(const Assembly& assembly, const std::vector<double>& strain) {
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    predicted_.tension[k] = 0.0;
    if (stiffness_[k] == 0.0) continue;
    if (strut_[k]) {
      mismatch_[k] = strain[k] - current_.tension[k] / stiffness_[k];
    } else {
      double stretched, slope;
      stretch(k, current_.tension[k], stretched, slope);
      mismatch(k, strain[k], stretched);
    }
    predicted_.tension[k] = current_.modulus[k] * mismatch_[k];
  }
  add_sag(assembly);
}

void TensionPath::advance(const Assembly& assembly, const std::vector<double>& strain_change,
                          double share) {
  distribute_sag(assembly, strain_change.data());
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    if (stiffness_[k] == 0.0) continue;
    double& t = current_.tension[k];
    double& s = slack_[k];
    const double t_change = current_.modulus[k] * (mismatch_[k] + strain_change[k] + sag_[k]);
    if (strut_[k]) {
      t += share * t_change;
      continue;
    }
    const double s_change = centring_[k] - ratio_[k] * t_change;
    t = std::max({t + share * t_change, least_rest * t, least_tension * scale_[k]});
    s = std::clamp(std::max(s + share * s_change, least_rest * s), least_slack * slack_unit(k),
                   most_slack * slack_unit(k));
    s = std::max(s, least_product * product(k) / t);
  }
}

}  // namespace codend
