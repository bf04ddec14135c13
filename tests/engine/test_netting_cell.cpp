// The shape of netting cells against integrals of bilinear places, and cells against what is known of
// uniform netting.
#include <doctest/doctest.h>

#include <cmath>

#include "elements/cell_shape.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

constexpr double signs[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};

// Mean square over the cell of the derivative by u (0) or v (1) of bilinear places x of its corners,
// over a parallelogram in twine coordinates: by Gauss's rule of two by two points, exact of squares.
double mean_square(const double* twine, const Vector* x, int family) {
  const double at = 1.0 / std::sqrt(3.0);
  double sum = 0.0;
  for (const auto& place : signs) {
    const double s = at * place[0], t = at * place[1];
    Eigen::Matrix2d twine_by = Eigen::Matrix2d::Zero();  // (u, v) by (s, t)
    Eigen::Matrix<double, 3, 2> x_by = Eigen::Matrix<double, 3, 2>::Zero();
    for (int k = 0; k < 4; ++k) {
      const Eigen::RowVector2d by(0.25 * signs[k][0] * (1.0 + signs[k][1] * t),
                                  0.25 * signs[k][1] * (1.0 + signs[k][0] * s));
      twine_by += Eigen::Vector2d(twine[2 * k], twine[2 * k + 1]) * by;
      x_by += x[k] * by;
    }
    sum += 0.25 * (x_by * twine_by.inverse()).col(family).squaredNorm();
  }
  return sum;
}

double square_length(const CellShape& shape, const Vector* x, int family) {
  Vector e = Vector::Zero(), q = Vector::Zero();
  for (int k = 0; k < 4; ++k) {
    e += shape.along[family][k] * x[k];
    q += shape.twist[k] * x[k];
  }
  return e.squaredNorm() + shape.twist_weight[family] * q.squaredNorm();
}

}  // namespace

TEST_CASE("a cell's length is the root mean square of bilinear bars over a parallelogram") {
  Random random(20260501);
  for (int repeat = 0; repeat < 50; ++repeat) {
    const Vector a = random.vector(3.0), b = random.vector(3.0);
    if (std::abs(a.x() * b.y() - a.y() * b.x()) < 0.5) continue;
    double twine[8];
    Vector x[4];
    for (int k = 0; k < 4; ++k) {
      const Vector place = signs[k][0] * a + signs[k][1] * b;
      twine[2 * k] = place.x() + 0.7;
      twine[2 * k + 1] = place.y() - 1.9;
      x[k] = random.vector(2.0);
    }
    const CellShape shape = cell_shape(twine);
    for (int family = 0; family < 2; ++family) {
      // sums of some dozen terms
      CHECK(square_length(shape, x, family) ==
            doctest::Approx(mean_square(twine, x, family)).epsilon(1e-12));
    }
  }
}

TEST_CASE("a rectangle's twist weighs as its sides say, and all corners share alike") {
  const double p = 4.0, q = 1.5;
  auto check = [](const double* twine, double bars, double of_u, double of_v) {
    const CellShape shape = cell_shape(twine);
    CHECK(shape.bars == doctest::Approx(bars));
    CHECK(shape.twist_weight[0] == doctest::Approx(of_u));
    CHECK(shape.twist_weight[1] == doctest::Approx(of_v));
    for (int k = 0; k < 4; ++k) CHECK(shape.share[k] == doctest::Approx(0.25));
  };
  // Sides along the twines, of p and q bars: u twines differ from one v to the next only.
  const double along[8] = {0.0, 0.0, p, 0.0, p, q, 0.0, q};
  check(along, p * q, 4.0 / (3.0 * p * p), 4.0 / (3.0 * q * q));
  // Sides across meshes, of p and q bars of each family: both differ along both.
  const double both = (1.0 / (p * p) + 1.0 / (q * q)) / 3.0;
  const double across[8] = {0.0, 0.0, p, p, p + q, p - q, q, -q};
  check(across, 2.0 * p * q, both, both);
}

TEST_CASE("cells of any shape know uniform netting exactly") {
  Random random(20260502);
  for (int repeat = 0; repeat < 50; ++repeat) {
    double twine[8];
    const double turn = random.between(0.0, 6.28);
    const bool pointed = repeat % 5 == 0;
    for (int k = 0; k < 4; ++k) {
      const double angle = turn + 1.57 * (pointed && k == 3 ? 2 : k) +
                           (pointed && k > 1 ? 0.0 : random.between(-0.3, 0.3));
      const double far = pointed && k > 1 ? 2.0 : random.between(1.0, 3.0);
      twine[2 * k] = far * std::cos(angle);
      twine[2 * k + 1] = far * std::sin(angle);
    }
    const CellShape shape = cell_shape(twine);
    const Vector of[2] = {random.vector(1.0), random.vector(1.0)};
    Vector x[4], sum[3] = {Vector::Zero(), Vector::Zero(), Vector::Zero()};
    double all = 0.0;
    for (int k = 0; k < 4; ++k) {
      x[k] = twine[2 * k] * of[0] + twine[2 * k + 1] * of[1];
      for (int f = 0; f < 2; ++f) sum[f] += shape.along[f][k] * x[k];
      sum[2] += shape.twist[k] * x[k];
      all += shape.share[k];
    }
    // some ten roundings of numbers up to 10
    for (int f = 0; f < 2; ++f) CHECK((sum[f] - of[f]).norm() < 1e-13);
    CHECK(sum[2].norm() < 1e-13);
    CHECK(all == doctest::Approx(1.0).epsilon(1e-13));
    if (pointed) {
      // of a triangle every corner takes a third
      CHECK(shape.share[0] == doctest::Approx(1.0 / 3.0));
      CHECK(shape.share[2] + shape.share[3] == doctest::Approx(1.0 / 3.0));
      CHECK(shape.twist_weight[0] == 0.0);
    }
  }
}
