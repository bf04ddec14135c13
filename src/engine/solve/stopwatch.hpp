// CPU seconds into a total, from construction to destruction.
#pragma once

#include <ctime>

namespace codend {

class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(std::clock()) {}
  ~Stopwatch() { total_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }
  Stopwatch(const Stopwatch&) = delete;

 private:
  double& total_;
  std::clock_t start_;
};

}  // namespace codend
