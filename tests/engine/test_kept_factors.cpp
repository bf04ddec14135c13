#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "solve/kept_factors.hpp"

namespace {

using codend::BlockPattern;
using codend::KeptFactors;

// Nodes of a sheet of rows x columns, each joined to the four next to it.
struct Sheet {
  int rows, columns;
  BlockPattern pattern;
  std::vector<double> places;

  Sheet(int rows_, int columns_) : rows(rows_), columns(columns_) {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(rows * columns));
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) {
        const int k = i * columns + j;
        places.insert(places.end(), {1.0 * i, 1.0 * j, 0.0});
        if (i > 0) join(neighbours, k, k - columns);
        if (j > 0) join(neighbours, k, k - 1);
      }
    }
    pattern = codend::block_pattern(neighbours);
  }

  static void join(std::vector<std::vector<int>>& to, int a, int b) {
    to[static_cast<std::size_t>(a)].push_back(b);
    to[static_cast<std::size_t>(b)].push_back(a);
  }

  // Springs of a stiffness between all neighbours, a mass on every node, and what is not symmetric.
  std::vector<double> matrix(double stiffness, unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    std::vector<double> values(9 * pattern.column.size(), 0.0);
    for (int i = 0; i < pattern.n; ++i) {
      const auto own = static_cast<std::size_t>(9 * codend::find_block(pattern, i, i));
      for (auto e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
        const auto at = static_cast<std::size_t>(9 * e);
        if (at == own) continue;
        for (std::size_t k = 0; k < 9; ++k) values[at + k] += 0.1 * some(random);
        for (std::size_t k = 0; k < 3; ++k) {
          values[at + 4 * k] -= stiffness;
          values[own + 4 * k] += stiffness;
        }
      }
      for (std::size_t k = 0; k < 3; ++k) values[own + 4 * k] += 2.0;
    }
    return values;
  }

  Eigen::MatrixXd dense(const std::vector<double>& values) const {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * pattern.n, 3 * pattern.n);
    for (int i = 0; i < pattern.n; ++i) {
      for (auto e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
        for (int k = 0; k < 9; ++k) {
          out(3 * i + k / 3, 3 * pattern.column[static_cast<std::size_t>(e)] + k % 3) =
              values[static_cast<std::size_t>(9 * e + k)];
        }
      }
    }
    return out;
  }

  std::vector<double> right(unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    std::vector<double> out(3 * static_cast<std::size_t>(pattern.n));
    for (double& v : out) v = some(random);
    return out;
  }
};

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

struct Case {
  Sheet sheet{12, 9};
  KeptFactors factors{sheet.pattern, sheet.places};
  std::vector<double> scale = std::vector<double>(12 * 9, 1.0), b = sheet.right(1), x = b;

  // What is left of the right side, over what may be left.
  double left(const std::vector<double>& values, double share) {
    REQUIRE(factors.solve(b, scale, {share, 0.0}, x));
    return (as_vector(b) - sheet.dense(values) * as_vector(x)).norm() /
           (share * as_vector(b).norm());
  }
};

}  // namespace

TEST_CASE("kept factors solve what follows, and make way where they cost more") {
  Case c;
  const std::vector<double> first = c.sheet.matrix(100.0, 1);
  c.factors.set_matrix(first, true);
  // Residuals come from the same recurrence in rounded numbers: hence a hundredth above.
  CHECK(c.left(first, 1e-6) <= 1.01);
  CHECK(c.factors.factorisations() == 1);
  const std::vector<double> alike = c.sheet.matrix(100.001, 1);
  // So small a sheet is worth one iteration with old factors.
  c.factors.set_matrix(alike, false);
  CHECK(c.left(alike, 1e-3) <= 1.01);
  CHECK(c.factors.factorisations() == 1);
  const std::vector<double> other = c.sheet.matrix(1e4, 2);
  c.factors.set_matrix(other, false);
  CHECK(c.left(other, 1e-6) <= 1.01);
  CHECK(c.factors.factorisations() == 2);
}

TEST_CASE("kept factors solve what single precision cannot") {
  // Condition about 1e12: the residual in double precision is 1e-16 of that at best.
  Case c;
  const std::vector<double> stiff = c.sheet.matrix(1e11, 1);
  c.factors.set_matrix(stiff, true);
  REQUIRE(c.factors.solve(c.b, c.scale, {1e-3, 0.0}, c.x));
  const Eigen::VectorXd exact = c.sheet.dense(stiff).fullPivLu().solve(as_vector(c.b));
  CHECK((as_vector(c.x) - exact).norm() < 1e-2 * exact.norm());
}

TEST_CASE("what is allowed is judged row by row") {
  Case c;
  const std::vector<double> values = c.sheet.matrix(100.0, 1);
  // Half of the rows have forces a million times larger, and as much is allowed there.
  for (std::size_t i = 0; i < c.scale.size() / 2; ++i) {
    c.scale[i] = 1e6;
    for (std::size_t k = 0; k < 3; ++k) c.b[3 * i + k] *= 1e6;
  }
  c.factors.set_matrix(values, true);
  REQUIRE(c.factors.solve(c.b, c.scale, {0.0, 1e-3}, c.x));
  const Eigen::VectorXd left = as_vector(c.b) - c.sheet.dense(values) * as_vector(c.x);
  for (std::size_t i = 0; i < c.b.size(); ++i) {
    CHECK(std::abs(left[static_cast<Eigen::Index>(i)]) <= 1.01e-3 * c.scale[i / 3]);
  }
}

TEST_CASE("nodes that are left out stay, and all others move as without them") {
  Case c;
  std::vector<double> values = c.sheet.matrix(100.0, 1);
  std::vector<char> out(static_cast<std::size_t>(c.sheet.pattern.n), 0);
  for (int i = 0; i < c.sheet.pattern.n; ++i) {
    if (i % 12 > 1 && i < 60) continue;
    out[static_cast<std::size_t>(i)] = 1;
    for (auto e = c.sheet.pattern.row_start[i]; e < c.sheet.pattern.row_start[i + 1]; ++e) {
      const bool own = c.sheet.pattern.column[static_cast<std::size_t>(e)] == i;
      for (int k = 0; k < 9; ++k) {
        values[static_cast<std::size_t>(9 * e + k)] = own && k % 4 == 0 ? 1.0 : 0.0;
      }
    }
    for (int k = 0; k < 3; ++k) c.b[static_cast<std::size_t>(3 * i + k)] = 0.0;
  }
  c.factors.leave_out(out);
  c.factors.set_matrix(values, true);
  CHECK(c.left(values, 1e-8) <= 1.01);
  for (std::size_t i = 0; i < c.b.size(); ++i) {
    if (out[i / 3]) CHECK(c.x[i] == 0.0);
  }
  // and all take part again
  const std::vector<double> all = c.sheet.matrix(100.0, 1);
  c.b = c.sheet.right(2);
  c.factors.leave_out({});
  c.factors.set_matrix(all, true);
  CHECK(c.left(all, 1e-8) <= 1.01);
}

TEST_CASE("factors that forget give the bytes of new ones") {
  Case used, fresh;
  const std::vector<double> before = used.sheet.matrix(90.0, 3), now = used.sheet.matrix(100.0, 1);
  used.factors.set_matrix(before, true);
  REQUIRE(used.factors.solve(used.b, used.scale, {1e-3, 0.0}, used.x));
  used.factors.forget();
  for (Case* c : {&used, &fresh}) {
    c->factors.set_matrix(now, false);
    REQUIRE(c->factors.solve(c->b, c->scale, {1e-3, 0.0}, c->x));
  }
  CHECK(used.x == fresh.x);
}
