#include "accelerate.hpp"

#include <Eigen/LU>

namespace codend {

Acceleration::Acceleration(Assembly& assembly, const double* x, const double* v)
    : assembly_(assembly),
      force_(3 * static_cast<std::size_t>(assembly.model().nodes)),
      mass_(3 * force_.size()) {
  assembly_.move_to(x, v);
  assembly_.mass(mass_.data());
  for (const int node : assembly_.free_nodes()) {
    const Eigen::Map<const Block> block(&mass_[9 * static_cast<std::size_t>(node)]);
    if (!(block.determinant() > 0.0)) {
      throw std::invalid_argument("node " + std::to_string(node) + " has no mass to move");
    }
  }
}

void Acceleration::at_motion(const Values& x, const Values& v, Values& a) {
  assembly_.move_to(x.data(), v.data());
  assembly_.residual(force_.data());
  assembly_.mass(mass_.data());
  a.setZero(x.size());
  for (const int node : assembly_.free_nodes()) {
    const Eigen::Map<const Block> block(&mass_[9 * static_cast<std::size_t>(node)]);
    at(a.data(), node) = block.inverse() * at(force_.data(), node);
  }
}

}  // namespace codend
