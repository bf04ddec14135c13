// Adds CPU seconds from construction to destruction to a total. Disabled if not `timed`, because
// reading the clock takes longer than a step of a few nodes.
#pragma once

#include <ctime>

namespace codend {

class Stopwatch {
 public:
  explicit Stopwatch(double& total, bool timed = true)
      : total_(timed ? &total : nullptr), start_(timed ? std::clock() : 0) {}
  ~Stopwatch() {
    if (total_) *total_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }
  Stopwatch(const Stopwatch&) = delete;

 private:
  double* total_;
  std::clock_t start_;
};

}  // namespace codend
