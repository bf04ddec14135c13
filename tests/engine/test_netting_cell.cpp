// Tests the shape functions of netting cells against integrals of bilinear positions, cells against
// uniform netting, and the sag of twines against the minimum of energy.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "elements/cell_shape.hpp"
#include "model/assembly.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

constexpr double signs[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};

// Returns the mean square over the cell of the derivative by u (0) or v (1) of bilinear positions x
// of its corners. The cell is a parallelogram in twine coordinates. The 2 x 2 Gauss rule is exact
// for squares. sag: mean square of the part that changes along the family's twines.
double mean_square(const double* twine, const Vector* x, int family, double& sag) {
  const double at = 1.0 / std::sqrt(3.0);
  double sum = 0.0;
  sag = 0.0;
  Vector warp = Vector::Zero();  // d2x/(ds dt)
  for (int k = 0; k < 4; ++k) warp += 0.25 * signs[k][0] * signs[k][1] * x[k];
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
    const Eigen::Matrix2d place_by = twine_by.inverse();  // (s, t) by (u, v)
    sum += 0.25 * (x_by * place_by).col(family).squaredNorm();
    const double along = twine_by(family, 0) * s + twine_by(family, 1) * t;
    sag += 0.25 * (2.0 * place_by(0, family) * place_by(1, family) * along * warp).squaredNorm();
  }
  return sum;
}

struct SquareLength {
  double straight, twisted, bowed;  // |e|^2, kappa |q|^2, b |q|^2
};
SquareLength square_length(const CellShape& shape, const Vector* x, int family) {
  Vector e = Vector::Zero(), q = Vector::Zero();
  for (int k = 0; k < 4; ++k) {
    e += shape.along[family][k] * x[k];
    q += shape.twist[k] * x[k];
  }
  return {e.squaredNorm(), shape.twist_weight[family] * q.squaredNorm(),
          shape.sag_weight[family] * q.squaredNorm()};
}

// Cells without other elements, and their state.
struct Cells {
  explicit Cells(Random& random)
      : specimen(random,
                 [] {
                   Ingredients wanted;
                   wanted.cells = 8;
                   wanted.axial_stiffness = 30.0;
                   return wanted;
                 }()),
        assembly(specimen.model) {
    assembly.move_to(specimen.x.data(), specimen.v.data());
  }
  int lines() const { return 2 * specimen.model.cells.count(); }
  CellShape shape(int cell) const { return cell_shape(&specimen.model.cells.twine[8 * cell]); }
  SquareLength square(int cell, int family) const {
    Vector x[4];
    for (int k = 0; k < 4; ++k) {
      x[k] = at(assembly.field().position,
                specimen.model.cells.node[4 * static_cast<std::size_t>(cell) + k]);
    }
    return square_length(shape(cell), x, family);
  }
  // Weight of a line's twist in the engine: 1 - s of u, 1 + s of v, squared.
  double side(int cell, int family) const {
    const CellShape s = shape(cell);
    const int line = family * specimen.model.cells.count() + cell;
    return (assembly.lines().twist_weight[line] - s.twist_weight[family]) / s.sag_weight[family] +
           1.0;
  }
  bool sag(int cell) const { return shape(cell).sag_weight[0] > 0.01; }

  Specimen specimen;
  Assembly assembly;
};

}  // namespace

TEST_CASE("cell length is the root mean square of bilinear bars") {
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
      double sag;
      const double square = mean_square(twine, x, family, sag);
      const SquareLength found = square_length(shape, x, family);
      // sums of about a dozen terms
      CHECK(found.straight + found.twisted == doctest::Approx(square).epsilon(1e-12));
      // in a skew cell, sag is limited by the total change
      CHECK(found.bowed == doctest::Approx(std::min(sag, square - found.straight)).epsilon(1e-9));
    }
  }
}

TEST_CASE("rectangle has twist weights by its sides and equal corner fractions") {
  const double p = 4.0, q = 1.5;
  auto check = [](const double* twine, double bars, double of_u, double of_v) {
    const CellShape shape = cell_shape(twine);
    CHECK(shape.bars == doctest::Approx(bars));
    CHECK(shape.twist_weight[0] == doctest::Approx(of_u));
    CHECK(shape.twist_weight[1] == doctest::Approx(of_v));
    for (int k = 0; k < 4; ++k) CHECK(shape.share[k] == doctest::Approx(0.25));
  };
  // Sides along the twines, of p and q bars: u twines differ only from one v to the next.
  const double along[8] = {0.0, 0.0, p, 0.0, p, q, 0.0, q};
  check(along, p * q, 4.0 / (3.0 * p * p), 4.0 / (3.0 * q * q));
  // Sides across meshes, of p and q bars of each family: both families vary along both sides.
  const double both = (1.0 / (p * p) + 1.0 / (q * q)) / 3.0;
  const double across[8] = {0.0, 0.0, p, p, p + q, p - q, q, -q};
  check(across, 2.0 * p * q, both, both);
}

TEST_CASE("cells of any shape reproduce uniform netting exactly") {
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
    // about ten roundings of numbers up to 10
    for (int f = 0; f < 2; ++f) CHECK((sum[f] - of[f]).norm() < 1e-13);
    CHECK(sum[2].norm() < 1e-13);
    CHECK(all == doctest::Approx(1.0).epsilon(1e-13));
    if (pointed) {
      // each corner of a triangle has a third
      CHECK(shape.share[0] == doctest::Approx(1.0 / 3.0));
      CHECK(shape.share[2] + shape.share[3] == doctest::Approx(1.0 / 3.0));
      CHECK(shape.twist_weight[0] == 0.0);
    }
  }
}

TEST_CASE("cell twines sag to the minimum of their energy") {
  Random random(20261123);
  int taut = 0, slack = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    const Cells net(random);
    const NettingCells& cells = net.specimen.model.cells;
    const double stiffness = net.specimen.model.materials[0].axial_stiffness;
    for (int e = 0; e < cells.count(); ++e) {
      if (!net.sag(e)) continue;
      const SquareLength square[2] = {net.square(e, 0), net.square(e, 1)};
      const double held = net.assembly.lines().held_pull[e];
      auto energy = [&](double s) {
        double sum = 0.0;
        for (int f = 0; f < 2; ++f) {
          const double side = f == 0 ? 1.0 - s : 1.0 + s;
          const double sag = square[f].bowed * (side * side - 1.0);
          const double length = std::sqrt(square[f].straight + square[f].twisted + sag);
          const double stretch = std::max(length - cells.rest[e], 0.0);
          sum += 0.5 * stiffness / cells.rest[e] * stretch * stretch +
                 0.5 * held * (square[f].twisted + sag);
        }
        return sum;
      };
      const double s = 1.0 - std::sqrt(std::max(net.side(e, 0), 0.0));
      CHECK(net.side(e, 1) == doctest::Approx((1.0 + s) * (1.0 + s)).epsilon(1e-6).scale(1.0));
      double least = energy(-1.0);
      for (int k = 1; k <= 400; ++k) least = std::min(least, energy(-1.0 + k / 200.0));
      // rounding of the energy, and of s as it is computed back
      CHECK(energy(s) <= least + 1e-9 * (std::abs(least) + energy(0.0)));
      for (int f = 0; f < 2; ++f) {
        (net.assembly.lines().tension[f * cells.count() + e] > 0.0 ? taut : slack) += 1;
      }
    }
  }
  CHECK(taut > 50);
  CHECK(slack > 50);
}

TEST_CASE("twines of equal tension sag equally; slack twines keep the others straight") {
  Random random(20261124);
  Cells net(random);
  const int cells = net.specimen.model.cells.count();
  DualTension given;
  auto pull = [&](double u, double v) {
    given.tension.assign(static_cast<std::size_t>(net.lines()), u);
    std::fill(given.tension.begin() + cells, given.tension.end(), v);
    net.assembly.move_to(net.specimen.x.data(), net.specimen.v.data());
    net.assembly.sag_to(given);
  };
  for (int e = 0; e < cells; ++e) {
    if (!net.sag(e)) continue;
    const CellShape shape = net.shape(e);
    // so taut that other twist stiffness, of some N/m, is negligible
    pull(1e9, 0.0);
    CHECK(net.side(e, 0) == doctest::Approx(0.0).scale(1.0).epsilon(1e-5));
    pull(0.0, 1e9);
    CHECK(net.side(e, 1) == doctest::Approx(0.0).scale(1.0).epsilon(1e-5));
    // Relative to length both have equal tension; with five times as much in u, 4 5/6 of 6 remains.
    pull(1e9, 1e9);
    const LineArrays& lines = net.assembly.lines();
    for (const double ratio : {1.0, 5.0}) {
      for (int round = 0; round < 100; ++round) {
        given.tension[e] = 1e9 * ratio / (lines.inverse_length[e] * shape.sag_weight[0]);
        given.tension[cells + e] = 1e9 / (lines.inverse_length[cells + e] * shape.sag_weight[1]);
        net.assembly.sag_to(given);
      }
      const double cost = ratio * net.side(e, 0) + net.side(e, 1);
      CHECK(cost == doctest::Approx(4.0 * ratio / (1.0 + ratio)).epsilon(1e-5));
    }
  }
}

// netting_twist.hpp: the stiffness is m times a cell's, less the part of the m lines at midpoints
// of equal parts.
TEST_CASE("twist of an equivalent mesh is held like a cell of slack twines") {
  constexpr double m = 5.0;
  const double x[12] = {0.0, 0.0, 0.3, 2.0, 0.1, 0.0, 2.1, 1.8, 0.5, -0.1, 2.0, 0.0};
  const double still[12] = {};
  Model model;
  model.nodes = 4;
  model.held.assign(4, 0);
  model.load.assign(12, 0.0);
  model.mass.assign(4, 0.0);
  model.water.density = 1025.0;
  model.water.speed = 1.5;
  model.materials.emplace_back();
  model.materials[0].axial_stiffness = 1e4;
  model.materials[0].diameter = 0.003;
  const auto force = [&] {
    Model ready = model;
    ready.prepare();
    Assembly assembly(ready);
    std::vector<double> out(12);
    assembly.move_to(x, still);
    assembly.residual(out.data());
    return out;
  };
  model.twists.node = {0, 1, 2, 3};
  model.twists.weight = {(m - 1.0 / m) / 6.0};
  model.twists.material = {0};
  const std::vector<double> mesh = force();
  model.twists = {};
  model.cells.node = {0, 1, 2, 3};
  model.cells.twine = {0.0, 0.0, m, 0.0, m, m, 0.0, m};
  model.cells.rest = {1.0};
  model.cells.multiplicity = {1.0};
  model.cells.height = {1.0};
  model.cells.material = {0};
  const std::vector<double> cell = force();
  for (std::size_t k = 0; k < 12; ++k) {
    CAPTURE(k);
    REQUIRE(std::abs(cell[k]) > 0.1);
    // a dozen roundings
    CHECK(mesh[k] == doctest::Approx((m - 1.0 / m) * cell[k]).epsilon(1e-14));
  }
}
