#include "waves.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Beyond this product of wave number and depth, wave motion is negligible: exp(-40).
constexpr double too_deep = 40.0;

}  // namespace

double wave_number(double frequency, double depth) {
  const double deep = frequency * frequency / gravity;
  if (!(deep * depth < too_deep)) return deep;
  // Newton's method for y tanh y = c, with y = k d. The initial guess is the larger limit: c in
  // deep water, sqrt(c) in shallow water.
  const double c = deep * depth;
  double y = std::max(std::sqrt(c), c);
  for (int k = 0; k < 50; ++k) {
    const double t = std::tanh(y);
    const double step = (y * t - c) / (t + y * (1.0 - t * t));
    y -= step;
    if (std::abs(step) <= 1e-15 * y) break;
  }
  return y / depth;
}

void Waves::prepare() {
  const std::size_t n = amplitude.size();
  number_.resize(n);
  x_.resize(n);
  y_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    number_[k] = wave_number(frequency[k], depth > 0.0 ? depth : INFINITY);
    x_[k] = std::cos(toward[k]);
    y_[k] = std::sin(toward[k]);
  }
}

void Waves::risen(double& share, double& rate) const {
  const double s = time / rising;
  share = s <= 0.0 ? 0.0 : s >= 1.0 ? 1.0 : s * s * (3.0 - 2.0 * s);
  rate = s <= 0.0 || s >= 1.0 ? 0.0 : 6.0 * s * (1.0 - s) / rising;
}

WavePoint Waves::at(const Vector& place) const {
  WavePoint out;
  double share, rate;
  risen(share, rate);
  const std::size_t n = amplitude.size();
  auto angle = [&](std::size_t k) {
    return number_[k] * (x_[k] * place.x() + y_[k] * place.y()) - frequency[k] * time + phase[k];
  };
  // No wave reaches this depth, at any elevation of the surface.
  double least = number_.empty() ? 0.0 : number_[0];
  for (const double k : number_) least = std::min(least, k);
  if (-place.z() * least > 2.0 * too_deep) return out;
  for (std::size_t k = 0; k < n; ++k) {
    const double q = angle(k), high = share * amplitude[k];
    out.elevation += high * std::cos(q);
    const double falling = -high * number_[k] * std::sin(q);
    out.slope_x += falling * x_[k];
    out.slope_y += falling * y_[k];
  }
  const bool shallow = depth > 0.0;
  const double squeeze = shallow ? depth / std::max(depth + out.elevation, 1e-3 * depth) : 1.0;
  const double stretched = squeeze * (place.z() - out.elevation);
  const double z = std::clamp(stretched, shallow ? -depth : stretched, 0.0);
  const double by_z = z == stretched ? squeeze : 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double number = number_[k], w = frequency[k];
    if (-z * number > too_deep) continue;
    double down = std::exp(number * z), up = 0.0, all = 1.0;
    if (shallow && number * depth < too_deep) {
      up = std::exp(-number * (z + 2.0 * depth));
      all = 1.0 / (1.0 - std::exp(-2.0 * number * depth));
    }
    const double q = angle(k), c = std::cos(q), s = std::sin(q);
    const double even = (down + up) * all, odd = (down - up) * all;
    const double speed = amplitude[k] * w;
    const double forth = speed * even * c, rise = speed * odd * s;
    const double forth_rate = w * speed * even * s, rise_rate = -w * speed * odd * c;
    const Vector along(x_[k], y_[k], 0.0);
    out.velocity += forth * along + rise * Vector::UnitZ();
    out.acceleration += forth_rate * along + rise_rate * Vector::UnitZ();
    out.velocity_slope += number * speed * (odd * c * along + even * s * Vector::UnitZ());
  }
  out.acceleration = share * out.acceleration + rate * out.velocity;
  out.velocity *= share;
  out.velocity_slope *= share * by_z;
  return out;
}

void Waves::respond(const Vector& place, const Vector& velocity, const std::vector<double>& even,
                    const std::vector<double>& odd, double value[6], double rate[6]) const {
  double share, rising_rate;
  risen(share, rising_rate);
  std::fill(value, value + 6, 0.0);
  std::fill(rate, rate + 6, 0.0);
  for (std::size_t k = 0; k < amplitude.size(); ++k) {
    const double along = x_[k] * place.x() + y_[k] * place.y();
    const double q = number_[k] * along - frequency[k] * time + phase[k];
    const double q_rate = number_[k] * (x_[k] * velocity.x() + y_[k] * velocity.y()) - frequency[k];
    const double c = amplitude[k] * std::cos(q), s = amplitude[k] * std::sin(q);
    for (std::size_t j = 0; j < 6; ++j) {
      const double e = even[6 * k + j], o = odd[6 * k + j];
      const double swing = e * c + o * s;
      value[j] += share * swing;
      rate[j] += share * q_rate * (o * c - e * s) + rising_rate * swing;
    }
  }
}

}  // namespace codend
