// A number that changes with time: pieces of cubic polynomials, jumps between them, constant before
// the first and after the last.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace codend {

// Which side of a jump counts at its very time.
enum class Side { before, after };

struct Curve {
  std::vector<double> time;  // growing, s: where pieces begin, and where the last ends
  // Per piece: values at its two ends and their rates of change by time.
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
    // begin + s rise + s (1 - s) (a (1 - s) + b s)
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
