// Mass matrix of nodes that bodies couple: one small dense matrix per group of coupled nodes. All
// other nodes have a 3x3 block each.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <vector>

#include "assembly.hpp"

namespace codend {

class JoinedMass {
 public:
  // The assembly must outlive this object.
  explicit JoinedMass(const Assembly& assembly);

  struct Group {
    std::vector<int> unknown;                            // indices of unknowns
    Eigen::MatrixXd mass;                                // kg, 3 rows per node
    std::optional<Eigen::LLT<Eigen::MatrixXd>> factors;  // set by update()
    bool has_mass = false;                               // true if the matrix is positive definite
  };

  // Updates the matrices at the assembly's present state. mass: from Assembly::mass() there.
  void update(const double* mass);
  const std::vector<Group>& groups() const { return groups_; }
  bool joins(int unknown) const { return joins_[static_cast<std::size_t>(unknown)]; }
  // Computes the accelerations (m/s2) of all grouped nodes from net forces (N), both 3 per node.
  void solve(const double* force, double* acceleration) const;

 private:
  const Assembly& assembly_;
  std::vector<const ElementKind*> bodies_;
  BlockPattern pattern_;
  std::vector<BlockPlaces> places_;
  std::vector<Group> groups_;
  std::vector<char> joins_;
  std::vector<double> values_;
};

}  // namespace codend
