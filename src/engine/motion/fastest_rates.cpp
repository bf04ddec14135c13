#include "fastest_rates.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "../model/joined_mass.hpp"

namespace codend {
namespace {

double largest_row(const Assembly& assembly, const std::vector<double>& mass,
                   const JoinedMass& joined, const std::vector<double>& values) {
  const BlockPattern& pattern = assembly.pattern();
  double largest = 0.0;
  for (int i = 0; i < pattern.n; ++i) {
    if (joined.joins(i)) continue;
    const std::size_t node = static_cast<std::size_t>(assembly.free_nodes()[i]);
    const Matrix inverse = Eigen::Map<const Block>(&mass[9 * node]).inverse();
    double sum = 0.0;
    for (int64_t k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k) {
      sum += (inverse * Eigen::Map<const Block>(&values[9 * static_cast<std::size_t>(k)])).norm();
    }
    largest = std::max(largest, sum);
  }
  for (const JoinedMass::Group& group : joined.groups()) {
    // Rows of the group and all columns in which they have blocks.
    const Eigen::Index size = group.mass.rows();
    std::map<int, Eigen::MatrixXd> columns;
    for (Eigen::Index i = 0; i < size / 3; ++i) {
      const auto row = static_cast<std::size_t>(group.unknown[static_cast<std::size_t>(i)]);
      for (int64_t k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
        Eigen::MatrixXd& column = columns[pattern.column[static_cast<std::size_t>(k)]];
        if (column.size() == 0) column.setZero(size, 3);
        column.block<3, 3>(3 * i, 0) =
            Eigen::Map<const Block>(&values[9 * static_cast<std::size_t>(k)]);
      }
    }
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(size / 3);
    for (const auto& [number, column] : columns) {
      const Eigen::MatrixXd rates = group.factors->solve(column);
      for (Eigen::Index i = 0; i < size / 3; ++i) sum[i] += rates.block<3, 3>(3 * i, 0).norm();
    }
    largest = std::max(largest, sum.maxCoeff());
  }
  return largest;
}

}  // namespace

FastestRates fastest_rates(Assembly& assembly, const Motion& motion) {
  std::vector<double> mass(9 * static_cast<std::size_t>(assembly.model().nodes));
  std::vector<double> values(9 * assembly.pattern().column.size());
  assembly.move_to(motion.x.data(), motion.v.data());
  assembly.mass(mass.data());
  JoinedMass joined(assembly);
  joined.update(mass.data());
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
  rates.oscillation = std::sqrt(largest_row(assembly, mass, joined, values));
  assembly.jacobian({0.0, 1.0}, values.data());
  rates.decay = largest_row(assembly, mass, joined, values);
  return rates;
}

}  // namespace codend
