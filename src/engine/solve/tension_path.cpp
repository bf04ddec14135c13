#include "tension_path.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

TensionPath::TensionPath(const Model& model, double load) {
  const std::size_t lines = static_cast<std::size_t>(model.lines());
  stiffness_.resize(lines);
  scale_.resize(lines);
  mismatch_.resize(lines);
  model.each_line([&](const auto& line) {
    stiffness_[line.index] = line.material->axial_stiffness;
    scale_[line.index] = std::min(0.01 * line.material->axial_stiffness, load);
  });
  current_.tension = scale_;
  current_.modulus.resize(lines);
  predicted_ = current_;
}

void TensionPath::prepare(const std::vector<double>& strain) {
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    const double t = current_.tension[k];
    const double mu = parameter_ * scale_[k];
    current_.modulus[k] = 1.0 / (1.0 / stiffness_[k] + mu / (t * t));
    mismatch_[k] = strain[k] - t / stiffness_[k] + mu / t;
    predicted_.tension[k] = t + current_.modulus[k] * mismatch_[k];
  }
}

void TensionPath::advance(const std::vector<double>& strain_change, double share) {
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    double& t = current_.tension[k];
    const double change = current_.modulus[k] * (mismatch_[k] + strain_change[k]);
    t = std::max({t + share * change, 0.02 * t, 1e-12 * scale_[k]});
  }
}

void TensionPath::return_to(const std::vector<double>& strain) {
  for (std::size_t k = 0; k < scale_.size(); ++k) {
    const double mu = parameter_ * scale_[k];
    const double root = std::sqrt(strain[k] * strain[k] + 4.0 * mu / stiffness_[k]);
    // The positive root of T/EA - strain = mu/T, without cancellation on the slack side.
    const double t = strain[k] > 0.0 ? 0.5 * stiffness_[k] * (strain[k] + root)
                                     : 2.0 * mu / (root - strain[k]);
    current_.tension[k] = std::max(t, 1e-12 * scale_[k]);
  }
}

}  // namespace codend
