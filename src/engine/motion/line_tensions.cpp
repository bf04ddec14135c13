#include "line_tensions.hpp"

#include <algorithm>

namespace codend {

LineTensions::LineTensions(Assembly& assembly)
    : assembly_(assembly),
      lines_(static_cast<std::size_t>(assembly.model().lines())),
      taut_(lines_),
      linear_(lines_) {
  const std::size_t all = static_cast<std::size_t>(assembly.model().constraints());
  right_.tension.resize(all);
  right_.modulus.resize(all);
  strain_change_.resize(all);
  mismatch_.resize(lines_);
  current_ = right_;
}

void LineTensions::begin() {
  const LineArrays& lines = assembly_.lines();
  for (std::size_t k = 0; k < lines_; ++k) {
    current_.tension[k] = lines.tension[k];
    taut_[k] = lines.tension[k] > lines.least_tension[k];
  }
}

void LineTensions::tighten() {
  const LineArrays& lines = assembly_.lines();
  for (std::size_t k = 0; k < lines_; ++k) {
    taut_[k] = taut_[k] || lines.tension[k] > lines.least_tension[k];
  }
}

void LineTensions::prepare() {
  assembly_.sag_to(current_);
  const LineArrays& lines = assembly_.lines();
  for (std::size_t k = 0; k < lines_; ++k) {
    double tension = lines.stiffness[k] * lines.strain[k];
    if (lines.load_law) tension += lines.offset[k];
    if (lines.damping) {
      double stretching = 0.0;
      for (int c = 0; c < 3; ++c) {
        stretching += lines.e[c][k] * lines.e_rate[c][k];
        if (lines.twist_weight) {
          stretching += lines.twist_weight[k] * lines.twist[c][k] * lines.twist_rate[c][k];
        }
      }
      tension += lines.damping[k] * (lines.inverse_length[k] * lines.inverse_rest[k] * stretching -
                                     (lines.strain[k] + 1.0) * lines.rest_rate[k]);
    }
    linear_[k] = tension;
    right_.tension[k] = taut_[k] ? tension : 0.0;
    current_.modulus[k] = taut_[k] ? lines.stiffness[k] : 0.0;
    mismatch_[k] = taut_[k] ? (tension - current_.tension[k]) / lines.stiffness[k] : 0.0;
  }
  std::fill(strain_change_.begin(), strain_change_.end(), 0.0);
  assembly_.distribute_sag(current_, mismatch_.data(), nullptr, strain_change_.data());
  assembly_.add_sag_tensions(current_, strain_change_.data(), right_.tension.data());
  const GroundContacts& contacts = assembly_.model().contacts;
  for (int e = 0; e < contacts.count(); ++e) {
    const std::size_t k = lines_ + static_cast<std::size_t>(e);
    assembly_.model().ground.press(contacts.penetration(e, assembly_.field()), contacts.area[e],
                                   current_.tension[k], current_.modulus[k]);
    right_.tension[k] = current_.tension[k];
  }
}

const std::vector<double>& LineTensions::with_sag(const std::vector<double>& strain_change) {
  strain_change_ = strain_change;
  assembly_.distribute_sag(current_, nullptr, strain_change.data(), strain_change_.data());
  return strain_change_;
}

double LineTensions::change(std::size_t k, double strain_change, double p) const {
  const LineArrays& lines = assembly_.lines();
  const double damping = lines.damping ? lines.damping[k] * (p - lines.rest_rate[k]) : 0.0;
  return (lines.stiffness[k] + damping) * strain_change;
}

void LineTensions::advance(const std::vector<double>& strain_change, double p, double share) {
  strain_change_ = strain_change;
  assembly_.change_sag(strain_change_.data());
  const LineArrays& lines = assembly_.lines();
  for (std::size_t k = 0; k < lines_; ++k) {
    const double tension = linear_[k] + change(k, strain_change_[k], p);
    const double least = lines.least_tension[k];
    taut_[k] = tension > least;
    current_.tension[k] += share * (std::max(tension, least) - current_.tension[k]);
  }
}

}  // namespace codend
