#include "netting_twist.hpp"

namespace codend {
namespace {

constexpr double sign[4] = {1.0, -1.0, 1.0, -1.0};

}  // namespace

void NettingTwists::prepare(const std::vector<TwineMaterial>& materials, const Water& water) {
  stiffness_.clear();
  for (std::size_t e = 0; e < weight.size(); ++e) {
    const TwineMaterial& twine = materials[static_cast<std::size_t>(material[e])];
    stiffness_.push_back(weight[e] * twist_stiffness(twine, water));
  }
}

Vector NettingTwists::twist(int e, const Field& field) const {
  Vector w = Vector::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    w += sign[k] * at(field.position, node[4 * static_cast<std::size_t>(e) + k]);
  }
  return w;
}

double NettingTwists::element_energy(int e, const Field& field) const {
  return 0.5 * stiffness_[static_cast<std::size_t>(e)] * twist(e, field).squaredNorm();
}

void NettingTwists::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    const std::size_t t = static_cast<std::size_t>(e);
    const Vector pull = stiffness_[t] * twist(e, field);
    for (std::size_t k = 0; k < 4; ++k) at(force, node[4 * t + k]) -= sign[k] * pull;
  }
}

void NettingTwists::add_jacobian(const Field&, const JacobianRequest& request,
                                 const BlockSink& sink) const {
  if (request.stiffness == 0.0) return;
  for (int e = 0; e < count(); ++e) {
    const double stiffness = request.stiffness * stiffness_[static_cast<std::size_t>(e)];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        sink.add(e, i, j, stiffness * sign[i] * sign[j] * Matrix::Identity());
      }
    }
  }
}

}  // namespace codend
