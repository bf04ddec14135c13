#include "body_modes.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "../model/joined_mass.hpp"
#include "block_lu.hpp"

namespace codend {
namespace {

// Rates (1/s) of the projection: boards and kites oscillate with periods from a second to minutes.
constexpr double shifts[] = {0.1, 0.5, 2.0, 8.0};
// Faster motions of a body are oscillations of its struts.
constexpr double fastest = 10.0;
// Minimum remaining fraction of a vector after orthogonalisation, for a new basis vector.
constexpr double independent = 1e-9;
// Residual limit for a mode of the small problem to be a mode of the gear.
constexpr double most_residual = 0.02;
// Minimum displacement of a body in its mode, as a fraction of the largest nodal displacement.
constexpr double least_movement = 0.1;
// Fraction of critical damping above which unresolved modes are not refined.
constexpr double well_damped = 0.5;
// Number of refinements of the projection with unresolved modes, its limit for growing modes, and
// the number of modes per refinement.
constexpr int rounds = 2, most_rounds = 6;
constexpr int most_at_once = 10;

using Columns = Eigen::MatrixXd;

template <class Numbers>
Numbers times(const BlockPattern& pattern, const std::vector<double>& values, const Numbers& x) {
  Numbers y = Numbers::Zero(x.rows(), x.cols());
  for (int row = 0; row < pattern.n; ++row) {
    for (std::int64_t k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      const auto b = static_cast<std::size_t>(k);
      y.template middleRows<3>(3 * row) +=
          Eigen::Map<const Block>(&values[9 * b]).template cast<typename Numbers::Scalar>() *
          x.template middleRows<3>(3 * pattern.column[b]);
    }
  }
  return y;
}

// Adds linearly independent columns to an orthonormal basis (Gram-Schmidt, twice).
void extend(Columns& basis, const Columns& by) {
  for (Eigen::Index k = 0; k < by.cols(); ++k) {
    Eigen::VectorXd column = by.col(k);
    const double size = column.norm();
    for (int twice = 0; twice < 2; ++twice) column -= basis * (basis.transpose() * column);
    if (!(column.norm() > independent * size)) continue;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = column.normalized();
  }
}

// Returns translations and rotations of every body, 1 m or 1 rad, six columns per body.
Columns rigid_motions(const Assembly& assembly, const JoinedMass& joined, const double* x) {
  Columns motions =
      Columns::Zero(3 * assembly.unknowns(), 6 * static_cast<Eigen::Index>(joined.groups().size()));
  Eigen::Index first = 0;
  for (const JoinedMass::Group& group : joined.groups()) {
    Vector middle = Vector::Zero();
    for (const int i : group.unknown) middle += at(x, assembly.free_nodes()[i]);
    middle /= static_cast<double>(group.unknown.size());
    for (const int i : group.unknown) {
      const Vector arm = at(x, assembly.free_nodes()[i]) - middle;
      for (int c = 0; c < 3; ++c) {
        motions.col(first + c).segment<3>(3 * i) = Vector::Unit(c);
        motions.col(first + 3 + c).segment<3>(3 * i) = Vector::Unit(c).cross(arm);
      }
    }
    first += 6;
  }
  return motions;
}

bool faster_growing(const BodyMode& a, const BodyMode& b) { return a.rate.real() > b.rate.real(); }

// Solves (K + l D + l^2 M) z = b for complex l, with two real nodes for each node.
class ComplexSolver {
 public:
  ComplexSolver(const BlockPattern& pattern, const std::vector<double>& places)
      : pattern_(pattern) {
    doubled_.n = 2 * pattern.n;
    doubled_.row_start.assign(1, 0);
    std::vector<double> twice;
    for (int row = 0; row < pattern.n; ++row) {
      for (int part = 0; part < 2; ++part) {
        for (std::int64_t k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
          doubled_.column.push_back(2 * pattern.column[k]);
          doubled_.column.push_back(2 * pattern.column[k] + 1);
        }
        doubled_.row_start.push_back(static_cast<std::int64_t>(doubled_.column.size()));
        for (int c = 0; c < 3; ++c) twice.push_back(places[3 * row + c]);
      }
    }
    values_.resize(9 * doubled_.column.size());
    lu_.analyse(doubled_, twice.data());
  }

  bool factorise(std::complex<double> l, const std::vector<double>& mass,
                 const std::vector<double>& damping, const std::vector<double>& stiffness) {
    const std::complex<double> square = l * l;
    std::size_t at = 0;
    for (int row = 0; row < pattern_.n; ++row) {
      for (int part = 0; part < 2; ++part) {
        for (std::int64_t k = pattern_.row_start[row]; k < pattern_.row_start[row + 1]; ++k) {
          for (std::size_t c = 0; c < 9; ++c) {
            const std::size_t b = 9 * static_cast<std::size_t>(k) + c;
            const double real = stiffness[b] + l.real() * damping[b] + square.real() * mass[b];
            const double imaginary = l.imag() * damping[b] + square.imag() * mass[b];
            values_[at + c] = part ? imaginary : real;
            values_[at + 9 + c] = part ? real : -imaginary;
          }
          at += 18;
        }
      }
    }
    return lu_.factorise(values_.data());
  }

  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const {
    std::vector<double> x(2 * static_cast<std::size_t>(b.size()));
    auto place = [](Eigen::Index i) { return static_cast<std::size_t>(6 * (i / 3) + i % 3); };
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      x[place(i)] = b[i].real();
      x[place(i) + 3] = b[i].imag();
    }
    lu_.solve(x.data(), x.data());
    Eigen::VectorXcd z(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i) z[i] = {x[place(i)], x[place(i) + 3]};
    return z;
  }

 private:
  const BlockPattern& pattern_;
  BlockPattern doubled_;
  std::vector<double> values_;
  BlockLU lu_;
};

}  // namespace

std::vector<BodyMode> body_modes(Assembly& assembly, const double* x, const double* v) {
  std::vector<BodyMode> modes;
  assembly.move_to(x, v);
  JoinedMass joined(assembly);
  if (joined.groups().empty()) return modes;
  const BlockPattern& pattern = assembly.pattern();
  const std::size_t size = 9 * pattern.column.size();
  std::vector<double> nodes(9 * static_cast<std::size_t>(assembly.model().nodes));
  std::vector<double> mass(size, 0.0), damping(size), stiffness(size), values(size);
  assembly.mass(nodes.data());
  assembly.add_mass(nodes.data(), 1.0, mass.data());
  assembly.jacobian({0.0, 1.0}, damping.data());
  assembly.jacobian({1.0, 0.0}, stiffness.data());

  std::vector<double> places;
  for (const int node : assembly.free_nodes()) {
    for (int c = 0; c < 3; ++c) places.push_back(at(x, node)[c]);
  }
  BlockLU lu;
  lu.analyse(pattern, places.data());
  const Columns on_bodies = rigid_motions(assembly, joined, x);
  Columns basis(on_bodies.rows(), 0);
  for (const double s : shifts) {
    for (std::size_t k = 0; k < size; ++k) {
      values[k] = stiffness[k] + s * (damping[k] + s * mass[k]);
    }
    if (!lu.factorise(values.data())) continue;
    Columns answer(on_bodies.rows(), on_bodies.cols());
    auto solve = [&](const Columns& right) {
      for (Eigen::Index k = 0; k < right.cols(); ++k) {
        const Eigen::VectorXd column = right.col(k);
        Eigen::VectorXd found(column.size());
        lu.solve(column.data(), found.data());
        answer.col(k) = found;
      }
    };
    solve(on_bodies);
    extend(basis, answer);
    const Columns by_rate =
        times(pattern, damping, answer) + 2.0 * s * times(pattern, mass, answer);
    solve(by_rate);
    extend(basis, answer);
  }

  ComplexSolver at_rate(pattern, places);
  for (int round = 0; round <= most_rounds; ++round) {
    modes.clear();
    std::vector<BodyMode> open;
    const Eigen::Index n = basis.cols();
    const Columns mass_there = times(pattern, mass, basis),
                  damping_there = times(pattern, damping, basis),
                  stiffness_there = times(pattern, stiffness, basis);
    const Eigen::LDLT<Columns> small_mass(basis.transpose() * mass_there);
    Columns companion = Columns::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n).setIdentity();
    companion.bottomLeftCorner(n, n) = -small_mass.solve(basis.transpose() * stiffness_there);
    companion.bottomRightCorner(n, n) = -small_mass.solve(basis.transpose() * damping_there);
    const Eigen::EigenSolver<Columns> found(companion);
    if (found.info() != Eigen::Success) return modes;
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
      BodyMode mode;
      mode.rate = found.eigenvalues()[k];
      if (mode.rate.imag() < 0.0 || !(std::abs(mode.rate) <= fastest)) continue;
      const Eigen::VectorXcd shares = found.eigenvectors().col(k).head(n);
      const Eigen::VectorXcd inertia = mode.rate * mode.rate * (mass_there * shares),
                             drag = mode.rate * (damping_there * shares),
                             spring = stiffness_there * shares;
      mode.residual =
          (inertia + drag + spring).norm() / (inertia.norm() + drag.norm() + spring.norm());
      const Eigen::VectorXcd motion = basis * shares;
      double most = 0.0, most_of_bodies = 0.0;
      for (int i = 0; i < assembly.unknowns(); ++i) {
        const double way = motion.segment<3>(3 * i).norm();
        most = std::max(most, way);
        if (!joined.joins(i) || way <= most_of_bodies) continue;
        most_of_bodies = way;
        mode.node = assembly.free_nodes()[i];
      }
      if (!(most_of_bodies > least_movement * most)) continue;
      mode.motion.resize(static_cast<std::size_t>(motion.size()));
      for (Eigen::Index i = 0; i < motion.size(); ++i) {
        mode.motion[static_cast<std::size_t>(i)] = motion[i] / most;
      }
      mode.certain = mode.residual < most_residual;
      (mode.certain ? modes : open).push_back(mode);
    }
    open.erase(std::remove_if(open.begin(), open.end(),
                              [](const BodyMode& mode) {
                                return mode.rate.real() < -well_damped * std::abs(mode.rate);
                              }),
               open.end());
    std::sort(open.begin(), open.end(), faster_growing);
    const bool grows = !open.empty() && open.front().rate.real() > 0.0;
    if (open.empty() || round == most_rounds || (round >= rounds && !grows)) {
      for (const BodyMode& mode : open) {
        if (mode.rate.real() > 0.0) modes.push_back(mode);
      }
      break;
    }
    int done = 0;
    for (const BodyMode& mode : open) {
      if (done == most_at_once) break;
      if (!at_rate.factorise(mode.rate, mass, damping, stiffness)) continue;
      const Eigen::VectorXcd z =
          Eigen::Map<const Eigen::VectorXcd>(mode.motion.data(), on_bodies.rows());
      Eigen::VectorXcd push =
          times(pattern, damping, z) + 2.0 * mode.rate * times(pattern, mass, z);
      for (int i = 0; i < assembly.unknowns(); ++i) {
        if (!joined.joins(i)) push.segment<3>(3 * i).setZero();
      }
      const Eigen::VectorXcd answer = at_rate.solve(push);
      Columns both(answer.size(), 2);
      both << answer.real(), answer.imag();
      extend(basis, both);
      ++done;
    }
  }
  std::sort(modes.begin(), modes.end(), faster_growing);
  return modes;
}

}  // namespace codend
