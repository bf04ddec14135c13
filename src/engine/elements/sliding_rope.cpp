#include "sliding_rope.hpp"

#include <cmath>

namespace codend {

void SlidingRope::prepare(const Bars& bars) {
  node_.clear();
  for (const int b : bar) node_.push_back(bars.node[2 * static_cast<std::size_t>(b)]);
  if (!bar.empty()) node_.push_back(bars.node[2 * static_cast<std::size_t>(bar.back()) + 1]);
}

Vector SlidingRope::direction(std::size_t k, const Field& field, double& length) const {
  const Vector d = at(field.position, node_[k + 1]) - at(field.position, node_[k]);
  length = std::sqrt(d.squaredNorm() + bend * bend);
  return d / length;
}

SlidingRope::Pull SlidingRope::pull(const Field& field) const {
  Pull p;
  bool whole = true;
  for (std::size_t k = 0; k < bar.size(); ++k) {
    const std::size_t b = static_cast<std::size_t>(bar[k]);
    double length;
    direction(k, field, length);
    p.length += length;
    p.rest += field.bars->rest[b];
    whole = whole && field.bars->multiplicity[b] > 0.0;
  }
  if (whole && p.length > p.rest) p.tension = axial_stiffness * (p.length / p.rest - 1.0);
  return p;
}

double SlidingRope::energy(const Field& field) const {
  const Pull p = pull(field);
  return 0.5 * p.tension * (p.length - p.rest);
}

void SlidingRope::add_force(const Field& field, double* force) const {
  const double tension = pull(field).tension;
  if (tension == 0.0) return;
  for (std::size_t k = 0; k < bar.size(); ++k) {
    double length;
    const Vector f = tension * direction(k, field, length);
    at(force, node_[k]) += f;
    at(force, node_[k + 1]) -= f;
  }
}

void SlidingRope::add_jacobian(const Field& field, const JacobianRequest& request,
                               const BlockSink& sink) const {
  const Pull p = pull(field);
  if (request.stiffness == 0.0 || p.tension == 0.0) return;
  // Derivatives by each point's position: length, then the directions on both sides.
  std::vector<Vector> slope(node_.size(), Vector::Zero());
  for (std::size_t k = 0; k < bar.size(); ++k) {
    double length;
    const Vector u = direction(k, field, length);
    slope[k] -= u;
    slope[k + 1] += u;
    const Matrix turn =
        request.stiffness * p.tension / length * (Matrix::Identity() - u * u.transpose());
    const int first = static_cast<int>(k);
    sink.add(0, first, first, turn);
    sink.add(0, first + 1, first + 1, turn);
    sink.add(0, first, first + 1, (-turn).eval());
    sink.add(0, first + 1, first, (-turn).eval());
  }
  const double stiffness = request.stiffness * axial_stiffness / p.rest;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const Vector pulled = stiffness * slope[i];
    for (std::size_t j = 0; j < slope.size(); ++j) {
      sink.add(0, static_cast<int>(i), static_cast<int>(j), (pulled * slope[j].transpose()).eval());
    }
  }
}

}  // namespace codend
