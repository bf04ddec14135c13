#include "fastest_rates.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "../model/assembly.hpp"

namespace codend {
namespace {

double largest_row(const Assembly& assembly, const std::vector<double>& mass,
                   const std::vector<double>& values) {
  const BlockPattern& pattern = assembly.pattern();
  double largest = 0.0;
  for (int i = 0; i < pattern.n; ++i) {
    const std::size_t node = static_cast<std::size_t>(assembly.free_nodes()[i]);
    const Matrix inverse = Eigen::Map<const Block>(&mass[9 * node]).inverse();
    double sum = 0.0;
    for (int64_t k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k) {
      sum += (inverse * Eigen::Map<const Block>(&values[9 * static_cast<std::size_t>(k)])).norm();
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

FastestRates fastest_rates(Assembly& assembly, const Motion& motion) {
  std::vector<double> mass(9 * static_cast<std::size_t>(assembly.model().nodes));
  std::vector<double> values(9 * assembly.pattern().column.size());
  assembly.move_to(motion.x.data(), motion.v.data());
  assembly.mass(mass.data());
  DualTension taut;
  const LineArrays& lines = assembly.lines();
  const int count = assembly.model().lines();
  taut.tension.assign(lines.tension, lines.tension + count);
  taut.modulus.assign(lines.stiffness, lines.stiffness + count);
  for (int e = 0; e < assembly.model().contacts.count(); ++e) {
    taut.tension.push_back(0.0);
    taut.modulus.push_back(assembly.model().ground.stiffness * assembly.model().contacts.area[e]);
  }
  FastestRates rates;
  assembly.jacobian({1.0, 0.0}, values.data(), &taut);
  rates.oscillation = std::sqrt(largest_row(assembly, mass, values));
  assembly.jacobian({0.0, 1.0}, values.data());
  rates.decay = largest_row(assembly, mass, values);
  return rates;
}

}  // namespace codend
