#include "mesh_opening.hpp"

#include <cmath>

namespace codend {
namespace {

constexpr double rounding = 0.02;

// Squared ratio of length to rest length for use in the angle, and its derivatives. It is the true
// value for taut twines. Below 1 it levels off at 3/4 at a ratio of 0.5. Without this bound, slack
// twines of zero length would have an undefined angle.
struct Held {
  double value, slope, curve;
};
Held held_square(double x) {
  constexpr double level = 0.5;
  if (x >= 1.0) return {x, 1.0, 0.0};
  if (x <= level) return {0.5 * (1.0 + level), 0.0, 0.0};
  const double below = 1.0 - x;
  return {x + 0.5 * below * below / (1.0 - level), 1.0 - below / (1.0 - level),
          1.0 / (1.0 - level)};
}

}  // namespace

void MeshOpenings::prepare() {
  shape_.clear();
  for (std::size_t e = 0; e < couple.size(); ++e) shape_.push_back(cell_shape(&twine[8 * e]));
}

MeshOpenings::Opening MeshOpenings::opening(int e, const Field& field) const {
  Opening o;
  const std::size_t t = static_cast<std::size_t>(e);
  const CellShape& shape = shape_[t];
  o.u.setZero();
  o.v.setZero();
  const Vector first = at(field.position, node[4 * t]);
  for (std::size_t k = 1; k < 4; ++k) {
    const Vector side = at(field.position, node[4 * t + k]) - first;
    o.u += shape.along[0][k] * side;
    o.v += shape.along[1][k] * side;
  }
  const double knots = shape.bars * multiplicity[t];
  const Held a = held_square(o.u.squaredNorm()), b = held_square(o.v.squaredNorm());
  const double inverse = 1.0 / std::sqrt(a.value * b.value);
  const double k = o.u.dot(o.v) * inverse;
  const double sine = std::sqrt(1.0 - k * k + rounding * rounding);
  const double off = std::atan2(sine, k) - angle[t];
  o.energy = 0.5 * knots * couple[t] * off * off;
  // Derivatives of the energy by k, and of k by the two squares and the product.
  const double h1 = -knots * couple[t] * off / sine;
  const double h2 = knots * couple[t] * (1.0 / (sine * sine) - off * k / (sine * sine * sine));
  const double by_a = a.slope / a.value, by_b = b.slope / b.value;
  const double k1[3] = {-0.5 * k * by_a, -0.5 * k * by_b, inverse};
  const double aa = k * (0.75 * by_a * by_a - 0.5 * a.curve / a.value);
  const double bb = k * (0.75 * by_b * by_b - 0.5 * b.curve / b.value);
  const double ab = 0.25 * k * by_a * by_b;
  const double ac = -0.5 * inverse * by_a, bc = -0.5 * inverse * by_b;
  const double k2[3][3] = {{aa, ab, ac}, {ab, bb, bc}, {ac, bc, 0.0}};
  for (int i = 0; i < 3; ++i) {
    o.slope[i] = h1 * k1[i];
    for (int j = 0; j < 3; ++j) o.curve[i][j] = h2 * k1[i] * k1[j] + h1 * k2[i][j];
  }
  return o;
}

double MeshOpenings::element_energy(int e, const Field& field) const {
  return opening(e, field).energy;
}

void MeshOpenings::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    const Opening o = opening(e, field);
    const Vector by_u = 2.0 * o.slope[0] * o.u + o.slope[2] * o.v;
    const Vector by_v = 2.0 * o.slope[1] * o.v + o.slope[2] * o.u;
    const std::size_t t = static_cast<std::size_t>(e);
    for (std::size_t k = 0; k < 4; ++k) {
      at(force, node[4 * t + k]) -= shape_[t].along[0][k] * by_u + shape_[t].along[1][k] * by_v;
    }
  }
}

void MeshOpenings::add_jacobian(const Field& field, const JacobianRequest& request,
                                const BlockSink& sink) const {
  if (request.stiffness == 0.0) return;
  for (int e = 0; e < count(); ++e) {
    const Opening o = opening(e, field);
    // Gradients of the two squares and the product by u and by v.
    const Vector of_u[3] = {2.0 * o.u, Vector::Zero(), o.v};
    const Vector of_v[3] = {Vector::Zero(), 2.0 * o.v, o.u};
    Matrix uu = 2.0 * o.slope[0] * Matrix::Identity();
    Matrix vv = 2.0 * o.slope[1] * Matrix::Identity();
    Matrix uv = o.slope[2] * Matrix::Identity();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        uu += o.curve[i][j] * of_u[i] * of_u[j].transpose();
        vv += o.curve[i][j] * of_v[i] * of_v[j].transpose();
        uv += o.curve[i][j] * of_u[i] * of_v[j].transpose();
      }
    }
    const double *a = shape_[static_cast<std::size_t>(e)].along[0],
                 *b = shape_[static_cast<std::size_t>(e)].along[1];
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) {
        const Matrix block = request.stiffness * (a[k] * a[l] * uu + b[k] * b[l] * vv +
                                                  a[k] * b[l] * uv + b[k] * a[l] * uv.transpose());
        sink.add(e, k, l, block);
      }
    }
  }
}

}  // namespace codend
