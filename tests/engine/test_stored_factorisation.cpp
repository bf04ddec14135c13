#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "node_graph.hpp"
#include "solve/stored_factorisation.hpp"

namespace {

using codend::StoredFactorisation;

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

struct Case {
  codend::NodeGraph mesh = codend::grid(12, 9);
  codend::BlockPattern pattern = mesh.pattern();
  StoredFactorisation factors{pattern, mesh.places};
  std::vector<double> scale = std::vector<double>(12 * 9, 1.0);
  std::vector<double> b = codend::random_vector(3 * 12 * 9, 1), x = b;

  // Equal springs, a mass on every node, and a non-symmetric part of up to 0.1.
  std::vector<double> matrix(double stiffness, unsigned seed) const {
    const auto same = [&](int, int) { return stiffness; };
    return codend::springs(pattern, same, 0.1 / stiffness, 2.0, seed);
  }

  // Residual.
  Eigen::VectorXd left(const std::vector<double>& values) const {
    return as_vector(b) - codend::dense(pattern, values) * as_vector(x);
  }

  // Ratio of the residual to the allowed residual after a solution.
  double left(const std::vector<double>& values, double share) {
    REQUIRE(factors.solve(b, scale, {share, 0.0}, x));
    return left(values).norm() / (share * as_vector(b).norm());
  }
};

}  // namespace

TEST_CASE("stored factorisation solves similar matrices and is renewed when costly") {
  Case c;
  const std::vector<double> first = c.matrix(100.0, 1);
  c.factors.set_matrix(first, true);
  // The residual follows from the same recurrence with rounding, hence 1 % above.
  CHECK(c.left(first, 1e-6) <= 1.01);
  CHECK(c.factors.factorisations() == 1);
  const std::vector<double> alike = c.matrix(100.001, 1);
  // One iteration with the old factorisation is cheaper than a new factorisation.
  c.factors.set_matrix(alike, false);
  CHECK(c.left(alike, 1e-3) <= 1.01);
  CHECK(c.factors.factorisations() == 1);
  const std::vector<double> other = c.matrix(1e4, 2);
  c.factors.set_matrix(other, false);
  CHECK(c.left(other, 1e-6) <= 1.01);
  CHECK(c.factors.factorisations() == 2);
}

TEST_CASE("stored factorisation solves beyond single precision") {
  // Condition about 1e12: the residual in double precision is 1e-16 times that at best.
  Case c;
  const std::vector<double> stiff = c.matrix(1e11, 1);
  c.factors.set_matrix(stiff, true);
  REQUIRE(c.factors.solve(c.b, c.scale, {1e-3, 0.0}, c.x));
  const Eigen::VectorXd exact = codend::dense(c.pattern, stiff).fullPivLu().solve(as_vector(c.b));
  CHECK((as_vector(c.x) - exact).norm() < 1e-2 * exact.norm());
}

TEST_CASE("stored factorisation applies the allowed residual row by row") {
  Case c;
  const std::vector<double> values = c.matrix(100.0, 1);
  // Half of the rows have forces a million times larger, and the allowed residual there is larger
  // too.
  for (std::size_t i = 0; i < c.scale.size() / 2; ++i) {
    c.scale[i] = 1e6;
    for (std::size_t k = 0; k < 3; ++k) c.b[3 * i + k] *= 1e6;
  }
  c.factors.set_matrix(values, true);
  REQUIRE(c.factors.solve(c.b, c.scale, {0.0, 1e-3}, c.x));
  const Eigen::VectorXd left = c.left(values);
  for (std::size_t i = 0; i < c.b.size(); ++i) {
    CHECK(std::abs(left[static_cast<Eigen::Index>(i)]) <= 1.01e-3 * c.scale[i / 3]);
  }
}

TEST_CASE("omitted nodes stay and the other nodes move as without them") {
  Case c;
  std::vector<double> values = c.matrix(100.0, 1);
  std::vector<char> out(c.scale.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = i % 12 <= 1 || i >= 60;
    for (std::size_t k = 0; out[i] && k < 3; ++k) c.b[3 * i + k] = 0.0;
  }
  codend::each_block(c.pattern, values, [&](int i, int j, double* block) {
    for (int k = 0; out[static_cast<std::size_t>(i)] && k < 9; ++k) block[k] = i == j && k % 4 == 0;
  });
  c.factors.leave_out(out);
  c.factors.set_matrix(values, true);
  CHECK(c.left(values, 1e-8) <= 1.01);
  for (std::size_t i = 0; i < c.b.size(); ++i) {
    if (out[i / 3]) CHECK(c.x[i] == 0.0);
  }
  // all nodes take part again
  const std::vector<double> all = c.matrix(100.0, 1);
  c.b = codend::random_vector(c.b.size(), 2);
  c.factors.leave_out({});
  c.factors.set_matrix(all, true);
  CHECK(c.left(all, 1e-8) <= 1.01);
}

TEST_CASE("stored factorisation after forget() gives the bytes of a new one") {
  Case used, fresh;
  const std::vector<double> before = used.matrix(90.0, 3), now = used.matrix(100.0, 1);
  used.factors.set_matrix(before, true);
  REQUIRE(used.factors.solve(used.b, used.scale, {1e-3, 0.0}, used.x));
  used.factors.forget();
  for (Case* c : {&used, &fresh}) {
    c->factors.set_matrix(now, false);
    REQUIRE(c->factors.solve(c->b, c->scale, {1e-3, 0.0}, c->x));
  }
  CHECK(used.x == fresh.x);
}
