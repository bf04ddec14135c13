#include "accelerate.hpp"

#include <Eigen/LU>

namespace codend {

Acceleration::Acceleration(Assembly& assembly, const double* x, const double* v)
    : assembly_(assembly),
      joined_(assembly),
      force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
      mass_(3 * force_.size()) {
  assembly_.move_to(x, v);
  assembly_.mass(mass_.data());
  joined_.update(mass_.data());
  auto check = [&](int node, bool has_mass) {
    if (has_mass) return;
    throw std::invalid_argument("node " + std::to_string(node) + " has no mass to move");
  };
  for (int i = 0; i < assembly_.unknowns(); ++i) {
    if (joined_.joins(i)) continue;
    const int node = assembly_.free_nodes()[i];
    const Eigen::Map<const Block> block(&mass_[9 * static_cast<std::size_t>(node)]);
    check(node, block.determinant() > 0.0);
  }
  for (const JoinedMass::Group& group : joined_.groups()) {
    check(assembly_.free_nodes()[group.unknown[0]], group.has_mass);
  }
}

void Acceleration::at_motion(const Values& x, const Values& v, Values& a) {
  assembly_.move_to(x.data(), v.data());
  assembly_.residual(force_.data());
  assembly_.mass(mass_.data());
  a.setZero(x.size());
  joined_.update(mass_.data());
  joined_.solve(force_.data(), a.data());
  for (int i = 0; i < assembly_.unknowns(); ++i) {
    if (joined_.joins(i)) continue;
    const int node = assembly_.free_nodes()[i];
    const Eigen::Map<const Block> block(&mass_[9 * static_cast<std::size_t>(node)]);
    at(a.data(), node) = block.inverse() * at(force_.data(), node);
  }
}

}  // namespace codend
