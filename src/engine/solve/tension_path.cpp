#include "tension_path.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

constexpr double first_parameter = 1e-2;
// The same of a start that is nearly settled.
constexpr double near_parameter = 1e-3;
constexpr double least_parameter = 1e-16;
// First tensions over the lines' scales: taut enough that the first steps find the global shape.
constexpr double first_tension = 10.0;
// A step leaves at least this share of a tension or a shortfall.
constexpr double least_share = 0.02;
constexpr double least_tension = 1e-14;  // over a line's scale
constexpr double least_shortfall = 1e-18, most_shortfall = 1e3;
// T s is kept above this share of mu, so that no line leaves the path behind.
constexpr double least_product = 1e-2;

}  // namespace

TensionPath::TensionPath(const Model& model, double load) : parameter_(first_parameter) {
  const std::size_t lines = static_cast<std::size_t>(model.lines());
  stiffness_.resize(lines);
  scale_.resize(lines);
  shortfall_.assign(lines, first_parameter / first_tension);
  centring_.resize(lines);
  mismatch_.resize(lines);
  model.each_line([&](const auto& line) {
    stiffness_[line.index] = line.material->axial_stiffness;
    scale_[line.index] = std::min(0.01 * line.material->axial_stiffness, load);
  });
  current_.tension.resize(lines);
  for (std::size_t k = 0; k < lines; ++k) current_.tension[k] = first_tension * scale_[k];
  current_.modulus.resize(lines);
  predicted_ = current_;
}

void TensionPath::follow(const std::vector<double>& strain) {
  parameter_ = near_parameter;
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    // T s = mu scale and strain = T/EA - s
    const double product = parameter_ * scale_[k];
    const double root = std::sqrt(strain[k] * strain[k] + 4.0 * product / stiffness_[k]);
    const double t = strain[k] > 0.0 ? 0.5 * stiffness_[k] * (strain[k] + root)
                                     : 2.0 * product / (root - strain[k]);
    current_.tension[k] = std::min(t, first_tension * scale_[k]);
    shortfall_[k] = product / current_.tension[k];
  }
}

void TensionPath::prepare(const std::vector<double>& strain, double reduction) {
  parameter_ = std::max(parameter_ * reduction, least_parameter);
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    const double t = current_.tension[k];
    const double s = shortfall_[k];
    current_.modulus[k] = 1.0 / (1.0 / stiffness_[k] + s / t);
    centring_[k] = parameter_ * scale_[k] / t - s;
    mismatch_[k] = strain[k] - t / stiffness_[k] + s + centring_[k];
    predicted_.tension[k] = t + current_.modulus[k] * mismatch_[k];
  }
}

void TensionPath::advance(const std::vector<double>& strain_change, double share) {
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    double& t = current_.tension[k];
    double& s = shortfall_[k];
    const double t_change = current_.modulus[k] * (mismatch_[k] + strain_change[k]);
    const double s_change = centring_[k] - s / t * t_change;
    t = std::max({t + share * t_change, least_share * t, least_tension * scale_[k]});
    s = std::clamp(std::max(s + share * s_change, least_share * s), least_shortfall,
                   most_shortfall);
    s = std::max(s, least_product * parameter_ * scale_[k] / t);
  }
}

}  // namespace codend
