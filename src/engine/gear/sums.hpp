// Sums in extended precision (long double), rounded to double.
#pragma once

#include <numeric>
#include <vector>

namespace codend {

inline double exact_sum(const std::vector<double>& x) {
  return static_cast<double>(std::accumulate(x.begin(), x.end(), 0.0L));
}

// Returns all partial sums, each rounded to double.
inline std::vector<double> exact_running_sum(const std::vector<double>& x) {
  std::vector<double> out;
  out.reserve(x.size());
  long double sum = 0.0L;
  for (const double value : x) out.push_back(static_cast<double>(sum += value));
  return out;
}

}  // namespace codend
