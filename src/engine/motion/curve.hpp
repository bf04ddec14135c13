// A function of time in pieces of cubic polynomials. Jumps between pieces are allowed. The value is
// constant before the first and after the last piece.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace codend {

// Selects the value before or after a jump, at the exact time of the jump.
enum class Side { before, after };

struct Curve {
  std::vector<double> time;  // s, increasing: start of each piece, and end of the last
  // Per piece: values at both ends and their time derivatives.
  std::vector<double> begin, end, begin_rate, end_rate;

  template <class Visit>
  void fields(Visit& visit) {
    visit("time", time);
    visit("begin", begin);
    visit("end", end);
    visit("begin_rate", begin_rate);
    visit("end_rate", end_rate);
  }

  void at(double t, Side side, double& value, double& rate) const {
    rate = 0.0;
    const bool after = side == Side::after;
    if (after ? t < time.front() : t <= time.front()) {
      value = begin.front();
      return;
    }
    if (after ? t >= time.back() : t > time.back()) {
      value = end.back();
      return;
    }
    const auto next = after ? std::upper_bound(time.begin(), time.end(), t)
                            : std::lower_bound(time.begin(), time.end(), t);
    const std::size_t k = static_cast<std::size_t>(next - time.begin()) - 1;
    const double h = time[k + 1] - time[k], s = (t - time[k]) / h;
    const double rise = end[k] - begin[k], a = h * begin_rate[k] - rise, b = rise - h * end_rate[k];
    // Cubic Hermite polynomial: begin + s rise + s (1 - s) (a (1 - s) + b s)
    value = begin[k] + s * rise + s * (1.0 - s) * (a * (1.0 - s) + b * s);
    rate = (rise + (1.0 - 2.0 * s) * (a * (1.0 - s) + b * s) + s * (1.0 - s) * (b - a)) / h;
  }
  double at(double t, Side side = Side::before) const {
    double value, rate;
    at(t, side, value, rate);
    return value;
  }
};

}  // namespace codend
