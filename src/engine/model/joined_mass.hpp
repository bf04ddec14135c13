// The mass of nodes that bodies join: a small full matrix per group of them, where all other nodes have
// a 3x3 block each.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <vector>

#include "assembly.hpp"

namespace codend {

class JoinedMass {
 public:
  // The assembly must outlive this.
  explicit JoinedMass(const Assembly& assembly);

  struct Group {
    std::vector<int> unknown;  // free nodes by their number among the free ones
    Eigen::MatrixXd mass;      // kg, 3 rows per node
    std::optional<Eigen::LLT<Eigen::MatrixXd>> factors;  // once updated
    bool has_mass = false;                               // in every direction
  };

  // Takes the assembly where it was last moved to; mass: what Assembly::mass() gives there.
  void update(const double* mass);
  const std::vector<Group>& groups() const { return groups_; }
  // Whether a free node is in a group.
  bool joins(int unknown) const { return joins_[static_cast<std::size_t>(unknown)]; }
  // Accelerations (m/s2) of the nodes of all groups by net forces (N), both 3 per node of the model.
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
