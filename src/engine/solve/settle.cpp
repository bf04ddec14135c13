#include "settle.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace codend {
namespace {

// CPU seconds into a total, from construction to destruction.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(std::clock()) {}
  ~Stopwatch() { total_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  double& total_;
  std::clock_t start_;
};

double extent(const std::vector<int>& free, const double* x) {
  Vector low = Vector::Constant(1e300), high = Vector::Constant(-1e300);
  for (int n : free) {
    low = low.cwiseMin(at(x, n));
    high = high.cwiseMax(at(x, n));
  }
  return free.empty() ? 0.0 : (high - low).norm();
}

}  // namespace

SettleReport settle(Assembly& assembly, const SettleControl& control, const double* v, double* x) {
  SettleReport report;
  const std::vector<int>& free = assembly.free_nodes();
  const std::size_t n = free.size();
  const std::size_t nodes = static_cast<std::size_t>(assembly.model().nodes);
  std::vector<double> force(3 * nodes), right(3 * n), dx(3 * nodes, 0.0), damping(n);
  std::vector<double> values(9 * assembly.pattern().column.size());
  std::vector<double> coordinates(3 * n);
  for (std::size_t i = 0; i < n; ++i) at(coordinates.data(), i) = at(x, free[i]);
  BlockLU lu;
  if (n > 0) {
    Stopwatch watch(report.seconds_analysis);
    lu.analyse(assembly.pattern(), coordinates.data());
  }
  std::vector<int64_t> diagonal(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& p = assembly.pattern();
    diagonal[i] = std::lower_bound(p.column.begin() + p.row_start[i],
                                   p.column.begin() + p.row_start[i + 1], static_cast<int>(i)) -
                  p.column.begin();
  }

  const double reach = 0.02 * extent(free, x) + 1e-3;
  double step = 1.0, movement = reach, rotation = 1.0;
  for (;; ++report.iterations) {
    {
      Stopwatch watch(report.seconds_forces);
      assembly.residual(x, v, force.data());
      report.worst_force = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        const double f = at(force.data(), free[i]).norm();
        if (!(f <= report.worst_force)) {
          report.worst_force = f;
          report.worst_node = free[i];
        }
      }
      report.largest_tension = assembly.largest_tension(x);
    }
    // A gear without any tension is measured by its loads.
    double scale = report.largest_tension;
    if (scale == 0.0) {
      for (double load : assembly.model().load) scale = std::max(scale, std::abs(load));
    }
    report.residual = report.worst_force == 0.0 ? 0.0 : report.worst_force / scale;
    if (!std::isfinite(report.residual)) return report;
    if (control.watch && !control.watch({report.iterations, report.residual, movement})) {
      report.stopped = true;
      return report;
    }
    if (report.residual <= control.tolerance && (rotation < 0.02 || report.worst_force == 0.0)) {
      report.converged = true;
      return report;
    }
    if (report.iterations >= control.iterations) return report;

    JacobianRequest request;
    if (rotation >= 0.02) {
      request.floor.tension = 1e-4 * report.largest_tension * std::min(1.0, movement / reach);
      request.floor.stiffness = 1e-4;
    }
    {
      Stopwatch watch(report.seconds_jacobian);
      assembly.jacobian(x, v, request, values.data());
      assembly.pseudo_damping(x, v, damping.data());
    }
    for (std::size_t i = 0; i < n; ++i) {
      double* block = &values[9 * static_cast<std::size_t>(diagonal[i])];
      for (int k = 0; k < 3; ++k) block[4 * k] += damping[i] / step;
      for (int k = 0; k < 3; ++k) right[3 * i + k] = force[3 * static_cast<std::size_t>(free[i]) + k];
    }
    {
      Stopwatch watch(report.seconds_linear);
      ++report.factorisations;
      if (!lu.factorise(values.data())) {
        step *= 0.1;
        if (step < 1e-12) return report;
        continue;
      }
      lu.solve(right.data(), right.data());
    }
    movement = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      at(dx.data(), free[i]) = at(right.data(), i);
      movement = std::max(movement, at(right.data(), i).norm());
    }
    rotation = assembly.largest_rotation(dx.data());
    const double s = std::min({1.0, reach / movement, 3.0 / rotation});
    for (std::size_t k = 0; k < 3 * nodes; ++k) x[k] += s * dx[k];
    step *= std::clamp(1.0 / rotation, 0.3, 2.0);
    step = std::min(step, 1e12);
  }
}

}  // namespace codend
