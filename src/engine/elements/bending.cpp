#include "bending.hpp"

#include <algorithm>

namespace codend {
namespace {

// A shorter bar (m) counts as this long, because a bar without length has no direction.
constexpr double least_length = 1e-9;

}  // namespace

Bends::Bend Bends::bend(int e, const Field& field) const {
  const int* at_bend = &node[3 * static_cast<std::size_t>(e)];
  Bend b;
  b.u = at(field.position, at_bend[1]) - at(field.position, at_bend[0]);
  b.v = at(field.position, at_bend[2]) - at(field.position, at_bend[1]);
  b.length_u = std::max(b.u.norm(), least_length);
  b.length_v = std::max(b.v.norm(), least_length);
  b.u /= b.length_u;
  b.v /= b.length_v;
  b.cosine = b.u.dot(b.v);
  return b;
}

double Bends::element_energy(int e, const Field& field) const {
  return couple[static_cast<std::size_t>(e)] * (1.0 - bend(e, field).cosine);
}

void Bends::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    const Bend b = bend(e, field);
    const std::size_t k = static_cast<std::size_t>(e);
    // Negative derivatives of the energy by the bar vectors.
    const Vector by_u = couple[k] / b.length_u * (b.v - b.cosine * b.u);
    const Vector by_v = couple[k] / b.length_v * (b.u - b.cosine * b.v);
    at(force, node[3 * k]) -= by_u;
    at(force, node[3 * k + 1]) += by_u - by_v;
    at(force, node[3 * k + 2]) += by_v;
  }
}

void Bends::add_jacobian(const Field& field, const JacobianRequest& request,
                         const BlockSink& sink) const {
  if (request.stiffness == 0.0) return;
  // Derivatives of the two bar vectors by the position of each point.
  constexpr double of_u[3] = {-1.0, 1.0, 0.0}, of_v[3] = {0.0, -1.0, 1.0};
  for (int e = 0; e < count(); ++e) {
    const Bend b = bend(e, field);
    const double k = b.cosine, scale = couple[static_cast<std::size_t>(e)];
    const Matrix identity = Matrix::Identity();
    const Matrix uu_unit = b.u * b.u.transpose(), vv_unit = b.v * b.v.transpose(),
                 cross = b.u * b.v.transpose();
    const Matrix uu = scale / (b.length_u * b.length_u) *
                      (cross + cross.transpose() + k * identity - 3.0 * k * uu_unit);
    const Matrix vv = scale / (b.length_v * b.length_v) *
                      (cross + cross.transpose() + k * identity - 3.0 * k * vv_unit);
    const Matrix uv =
        -scale / (b.length_u * b.length_v) * (identity - uu_unit - vv_unit + k * cross);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Matrix block =
            request.stiffness * (of_u[i] * of_u[j] * uu + of_v[i] * of_v[j] * vv +
                                 of_u[i] * of_v[j] * uv + of_v[i] * of_u[j] * uv.transpose());
        sink.add(e, i, j, block);
      }
    }
  }
}

double Bends::unstable_size(const Field& field) const {
  constexpr double rounding = 1e-9;
  double least = 0.0;
  for (int e = 0; e < count(); ++e) {
    const Bend b = bend(e, field);
    const double rest = length[static_cast<std::size_t>(e)];
    if (b.length_u + b.length_v >= 2.0 * rest * (1.0 - rounding)) continue;
    least = least > 0.0 ? std::min(least, rest) : rest;
  }
  return least;
}

double Bends::unstable_stiffness() const {
  // A bend is stiffest against lateral motion of its middle node.
  double most = 0.0;
  for (std::size_t e = 0; e < couple.size(); ++e) {
    most = std::max(most, 4.0 * couple[e] / (length[e] * length[e]));
  }
  return most;
}

}  // namespace codend
