#include <doctest/doctest.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "allocation_count.hpp"
#include "solve/block_lu.hpp"
#include "solve/flushed_denormals.hpp"

namespace {

using codend::BlockLU;
using codend::BlockPattern;
using codend::Precision;

// Backward error |b - A x| / (|A| |x|), greatest norms. Gaussian elimination leaves about
// (rows of a front) x (growth of the pivots) x 1.1e-16; fronts here have at most 300 rows and
// growth stays below 20 on these matrices, which gives 1e-12 rounded up.
constexpr double backward_error = 1e-12;

struct Mesh {
  std::vector<double> coordinates;
  std::vector<std::pair<int, int>> edges;

  int nodes() const { return static_cast<int>(coordinates.size() / 3); }
  int add(double x, double y, double z) {
    coordinates.insert(coordinates.end(), {x, y, z});
    return nodes() - 1;
  }
  void join(int a, int b) { edges.push_back({a, b}); }
};

Mesh chain(int n) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    mesh.add(0.5 * i, 0, 0);
    if (i > 0) mesh.join(i - 1, i);
  }
  return mesh;
}

Mesh sheet(int rows, int columns) {
  Mesh mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int k = mesh.add(j, i, std::sin(0.3 * i + 0.2 * j));
      if (j > 0) mesh.join(k, k - 1);
      if (i > 0) mesh.join(k, k - columns);
      if (i > 0 && j > 0) mesh.join(k, k - columns - 1);
    }
  return mesh;
}

Mesh tube(int rows, int around) {
  Mesh mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * M_PI * j / around;
      const int k = mesh.add(i, 3 * std::cos(angle), 3 * std::sin(angle));
      if (j > 0) mesh.join(k, k - 1);
      if (j == around - 1) mesh.join(k, k - j);
      if (i > 0) mesh.join(k, k - around);
    }
  return mesh;
}

// A warp that branches into bridles, each branching again, the tips hung to the edge of a sheet.
Mesh ropes_and_sheet() {
  Mesh mesh = sheet(20, 17);
  const auto rope = [&](int from, int nodes) {
    for (int i = 0; i < nodes; ++i) {
      const int next = mesh.add(-i, 0.1 * from, 0);
      mesh.join(from, next);
      from = next;
    }
    return from;
  };
  const int vessel = mesh.add(-300, 8, 50);
  const int board = rope(vessel, 200);
  const int upper = rope(board, 30), lower = rope(board, 25);
  int corner = 0;
  for (int end : {upper, upper, lower, lower}) {
    mesh.join(rope(end, 9), corner);
    corner += 5;
  }
  return mesh;
}

// A ring tied to every node of one end of a tube: one dense row, as at a cod-end's ring.
Mesh tube_with_ring() {
  Mesh mesh = tube(12, 50);
  const int ring = mesh.add(-1, 0, 0);
  for (int j = 0; j < 50; ++j) mesh.join(ring, j);
  return mesh;
}

Mesh complete(int n) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    mesh.add(i % 2, i % 3, 0);
    for (int j = 0; j < i; ++j) mesh.join(i, j);
  }
  return mesh;
}

Mesh apart(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  const int shift = a.nodes();
  mesh.coordinates.insert(mesh.coordinates.end(), b.coordinates.begin(), b.coordinates.end());
  for (const auto& [i, j] : b.edges) mesh.join(i + shift, j + shift);
  return mesh;
}

BlockPattern pattern_of(const Mesh& mesh) {
  std::vector<std::set<int>> rows(mesh.nodes());
  for (int i = 0; i < mesh.nodes(); ++i) rows[i].insert(i);
  for (const auto& [i, j] : mesh.edges) {
    rows[i].insert(j);
    rows[j].insert(i);
  }
  BlockPattern pattern;
  pattern.n = mesh.nodes();
  pattern.row_start.push_back(0);
  for (const auto& row : rows) {
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<int64_t>(pattern.column.size()));
  }
  return pattern;
}

std::vector<double> random_vector(size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<double> v(size);
  for (double& x : v) x = generator() / 2147483648.0 - 1;
  return v;
}

// Random blocks. Each diagonal block has its heavy entries off its own diagonal, so that a solver
// without pivoting breaks down.
std::vector<double> random_values(const BlockPattern& pattern, unsigned seed) {
  std::vector<double> values = random_vector(9 * pattern.column.size(), seed);
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      if (pattern.column[e] == i) {
        values[9 * e] = values[9 * e + 4] = values[9 * e + 8] = 0;
        for (int a = 0; a < 3; ++a) values[9 * e + 3 * a + (a + 1) % 3] += 6;
      }
  return values;
}

Eigen::SparseMatrix<double> to_eigen(const BlockPattern& pattern,
                                     const std::vector<double>& values) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          entries.emplace_back(3 * i + a, 3 * pattern.column[e] + b, values[9 * e + 3 * a + b]);
  Eigen::SparseMatrix<double> matrix(3 * pattern.n, 3 * pattern.n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double greatest_row_sum(const Eigen::SparseMatrix<double>& matrix) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(matrix.rows());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      sums[it.row()] += std::abs(it.value());
  return sums.maxCoeff();
}

void check_against_sparse_lu(const Mesh& mesh, const std::vector<double>& values) {
  const BlockPattern pattern = pattern_of(mesh);
  const Eigen::SparseMatrix<double> matrix = to_eigen(pattern, values);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(3 * pattern.n);
  BlockLU lu;
  lu.analyse(pattern, mesh.coordinates.data());
  REQUIRE(lu.factorise(values.data()));
  Eigen::VectorXd x(b.size());
  lu.solve(b.data(), x.data());

  const double norm = greatest_row_sum(matrix);
  const double scale = norm * x.lpNorm<Eigen::Infinity>();
  CHECK((b - matrix * x).lpNorm<Eigen::Infinity>() <= backward_error * scale);

  Eigen::VectorXd back(b.size());
  lu.solve_transposed(b.data(), back.data());
  const double scale_back = greatest_row_sum(matrix.transpose()) * back.lpNorm<Eigen::Infinity>();
  CHECK((b - matrix.transpose() * back).lpNorm<Eigen::Infinity>() <= backward_error * scale_back);

  Eigen::SparseLU<Eigen::SparseMatrix<double>> reference(matrix);
  REQUIRE(reference.info() == Eigen::Success);
  const Eigen::VectorXd y = reference.solve(b);
  // Two backward-stable solutions differ by the condition number times the backward error. Its
  // lower bound |A| |x| / |b| is within a factor 1000 for a random right side.
  const double condition = 1000 * scale / b.lpNorm<Eigen::Infinity>();
  CHECK((x - y).lpNorm<Eigen::Infinity>() <=
        2 * backward_error * condition * y.lpNorm<Eigen::Infinity>());
}

void check_against_sparse_lu(const Mesh& mesh) {
  check_against_sparse_lu(mesh, random_values(pattern_of(mesh), 7));
}

}  // namespace

TEST_CASE("block LU agrees with Eigen::SparseLU") {
  SUBCASE("one, two and three nodes") {
    for (int n : {1, 2, 3}) check_against_sparse_lu(chain(n));
  }
  SUBCASE("chain") { check_against_sparse_lu(chain(200)); }
  SUBCASE("sheet") { check_against_sparse_lu(sheet(31, 26)); }
  SUBCASE("long narrow sheet") { check_against_sparse_lu(sheet(150, 5)); }
  SUBCASE("tube") { check_against_sparse_lu(tube(30, 24)); }
  SUBCASE("ropes joined to a sheet") { check_against_sparse_lu(ropes_and_sheet()); }
  SUBCASE("dense row") { check_against_sparse_lu(tube_with_ring()); }
  SUBCASE("full matrix") { check_against_sparse_lu(complete(40)); }
  SUBCASE("disconnected") {
    check_against_sparse_lu(apart(apart(sheet(12, 9), chain(40)), apart(tube(8, 12), chain(1))));
  }
}

TEST_CASE("block LU needs no help from coordinates") {
  SUBCASE("all nodes coincide") {
    Mesh mesh = sheet(24, 25);
    std::fill(mesh.coordinates.begin(), mesh.coordinates.end(), 1.5);
    check_against_sparse_lu(mesh);
  }
  SUBCASE("some nodes coincide") {
    Mesh mesh = apart(sheet(15, 14), sheet(15, 14));
    for (int i = 0; i < 14; ++i) mesh.join(i, 15 * 14 + i);
    check_against_sparse_lu(mesh);
  }
  SUBCASE("scattered at random") {
    Mesh mesh = tube(25, 20);
    mesh.coordinates = random_vector(mesh.coordinates.size(), 3);
    check_against_sparse_lu(mesh);
  }
}

namespace {

// Every edge a spring, as rope against slack twine, with a nonsymmetric part of a tenth.
std::vector<double> springs_seven_decades_apart(const BlockPattern& pattern) {
  std::vector<double> values(9 * pattern.column.size(), 0);
  std::vector<int64_t> diagonal(pattern.n);
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
      if (pattern.column[e] == i) diagonal[i] = e;
  const std::vector<double> noise = random_vector(values.size(), 5);
  for (int i = 0; i < pattern.n; ++i)
    for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
      const int j = pattern.column[e];
      const double stiffness = std::max(i, j) >= 20 * 17 ? 1e7 : 1.0;
      for (int a = 0; a < 3; ++a) {
        if (j == i) values[9 * e + 4 * a] += 1;
        if (j == i) continue;
        values[9 * e + 4 * a] -= stiffness;
        values[9 * diagonal[i] + 4 * a] += stiffness;
        for (int b = 0; b < 3; ++b)
          values[9 * e + 3 * a + b] += 0.1 * stiffness * noise[9 * e + 3 * a + b] / 3;
      }
    }
  return values;
}

}  // namespace

TEST_CASE("block LU bears stiffnesses seven decades apart") {
  const Mesh mesh = ropes_and_sheet();
  check_against_sparse_lu(mesh, springs_seven_decades_apart(pattern_of(mesh)));
}

TEST_CASE("block LU in single precision refines to the residual asked for") {
  const Mesh mesh = ropes_and_sheet();
  const BlockPattern pattern = pattern_of(mesh);
  std::vector<double> values;
  SUBCASE("random blocks") { values = random_values(pattern, 7); }
  SUBCASE("stiffnesses seven decades apart") { values = springs_seven_decades_apart(pattern); }
  BlockLU lu(Precision::single_precision);
  lu.analyse(pattern, mesh.coordinates.data());
  REQUIRE(lu.factorise(values.data()));
  const Eigen::SparseMatrix<double> matrix = to_eigen(pattern, values);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(3 * pattern.n);
  Eigen::VectorXd x(b.size());
  const auto residual = [&] {
    return (b - matrix * x).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  };
  for (const double tolerance : {1e-4, 1e-8, 1e-11}) {
    const double reached = lu.solve_refined(pattern, values.data(), b.data(), tolerance, x.data());
    CHECK(reached <= tolerance);
    // the two sum up rows in different orders: some ten terms, each as large as |A| |x| at most
    const double rounding = 10 * 1.1e-16 * greatest_row_sum(matrix) * x.lpNorm<Eigen::Infinity>() /
                            b.lpNorm<Eigen::Infinity>();
    CHECK(std::abs(residual() - reached) <= rounding);
  }
  lu.solve(b.data(), x.data());
  CHECK(residual() > 1e-11);  // so that refinement had something to do
}

TEST_CASE("refinement ends where it gains no more") {
  const Mesh mesh = sheet(9, 8);
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> values = random_values(pattern, 2), other = random_values(pattern, 3);
  const std::vector<double> b = random_vector(3 * pattern.n, 4);
  std::vector<double> x(b.size());
  BlockLU lu;
  lu.analyse(pattern, mesh.coordinates.data());
  REQUIRE(lu.factorise(values.data()));
  SUBCASE("at the rounding of numbers") {
    const double reached = lu.solve_refined(pattern, values.data(), b.data(), 0, x.data());
    CHECK(reached > 0);
    CHECK(reached < 1e-12);
  }
  SUBCASE("with the factors of another matrix") {
    CHECK(lu.solve_refined(pattern, other.data(), b.data(), 1e-10, x.data()) > 1e-2);
  }
  SUBCASE("without a right side") {
    const std::vector<double> none(b.size(), 0.0);
    CHECK(lu.solve_refined(pattern, values.data(), none.data(), 1e-10, x.data()) == 0);
    CHECK(x == none);
  }
}

TEST_CASE("block LU gives equal bytes with one thread and two") {
  // large enough for two threads, and the last part for a front of its own in both
  const Mesh mesh = apart(sheet(150, 140), tube_with_ring());
  const BlockPattern pattern = pattern_of(mesh);
  std::vector<double> values = random_values(pattern, 17);
  SUBCASE("of common numbers") {}
  SUBCASE("of couplings whose products are denormal in single precision") {
    for (int i = 0; i < pattern.n; ++i)
      for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
        for (int k = 0; k < 9; ++k)
          if (pattern.column[e] != i) values[9 * e + k] *= 1e-20;
  }
  const std::vector<double> b = random_vector(3 * pattern.n, 18);
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    std::vector<double> one(b.size()), two(b.size());
    BlockLU alone(precision, 1), shared(precision, 2);
    alone.analyse(pattern, mesh.coordinates.data());
    shared.analyse(pattern, mesh.coordinates.data());
    REQUIRE(alone.factorise(values.data()));
    for (int round = 0; round < 3; ++round) REQUIRE(shared.factorise(values.data()));
    alone.solve(b.data(), one.data());
    shared.solve(b.data(), two.data());
    CHECK(one == two);
  }
}

TEST_CASE("denormal numbers in single-precision factors count as zero, and nowhere else") {
  const Mesh mesh = chain(2);
  const BlockPattern pattern = pattern_of(mesh);  // blocks 11, 12, 21, 22
  std::vector<double> values(36, 0);
  for (const int block : {0, 3})
    for (int k = 0; k < 3; ++k) values[9 * block + 4 * k] = 1;
  values[9] = values[18] = 1e-40;  // the least float of full precision is 1.2e-38
  const std::vector<double> b = {1e10, 0, 0, 0, 0, 0};
  const auto second = [&](Precision precision) {
    BlockLU lu(precision);
    lu.analyse(pattern, mesh.coordinates.data());
    const auto before = codend::floating_point_control();
    REQUIRE(lu.factorise(values.data()));
    std::vector<double> x(6);
    lu.solve(b.data(), x.data());
    CHECK(codend::floating_point_control() == before);
    return x[3];
  };
  CHECK(second(Precision::double_precision) == doctest::Approx(-1e-30));
#if defined(__SSE2__) || defined(__aarch64__)
  CHECK(second(Precision::single_precision) == 0.0);
#endif
}

TEST_CASE("two threads report a singular matrix") {
  const Mesh mesh = sheet(150, 140);
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> sound = random_values(pattern, 21);
  BlockLU lu(Precision::double_precision, 2);
  lu.analyse(pattern, mesh.coordinates.data());
  for (int node : {0, 10500, 20999}) {  // in both threads' subtrees and about the first separator
    std::vector<double> values = sound;
    for (int64_t e = pattern.row_start[node]; e < pattern.row_start[node + 1]; ++e)
      for (int b = 0; b < 3; ++b) values[9 * e + 3 + b] = 0;
    CHECK_FALSE(lu.factorise(values.data()));
  }
  CHECK(lu.factorise(sound.data()));
}

TEST_CASE("block LU pauses, and stops where the pause throws") {
  const Mesh mesh = sheet(220, 200);
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> values = random_values(pattern, 22);
  const std::vector<double> b = random_vector(3 * pattern.n, 23);
  std::vector<double> expected(b.size()), found(b.size());
  BlockLU plain(Precision::single_precision);
  plain.analyse(pattern, mesh.coordinates.data());
  REQUIRE(plain.factorise(values.data()));
  plain.solve(b.data(), expected.data());
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    int pauses = 0, stop_at = 1;
    const std::thread::id here = std::this_thread::get_id();
    BlockLU lu(Precision::single_precision, threads, [&] {
      CHECK(std::this_thread::get_id() == here);
      if (++pauses == stop_at) throw std::runtime_error("stopped");
    });
    CHECK_THROWS_WITH(lu.analyse(pattern, mesh.coordinates.data()), "stopped");
    pauses = stop_at = 0;
    lu.analyse(pattern, mesh.coordinates.data());
    CHECK(pauses >= 2);  // before the first cut of 44,000 nodes and those of its halves
    pauses = 0;
    REQUIRE(lu.factorise(values.data()));
    const int all = pauses;
    REQUIRE(all >= 2);
    for (const int at : {1, all}) {
      pauses = 0;
      stop_at = at;
      CHECK_THROWS_WITH(lu.factorise(values.data()), "stopped");
      CHECK(pauses == at);
      CHECK_THROWS_AS(lu.solve(b.data(), found.data()), std::logic_error);
    }
    stop_at = 0;
    REQUIRE(lu.factorise(values.data()));
    lu.solve(b.data(), found.data());
    CHECK(found == expected);
  }
}

TEST_CASE("block LU takes one thread or two") {
  for (int threads : {-1, 0, 3})
    CHECK_THROWS_WITH_AS(
        BlockLU(Precision::double_precision, threads),
        ("block LU: threads is " + std::to_string(threads) + "; it must be 1 or 2").c_str(),
        std::invalid_argument);
}

TEST_CASE("block LU gives equal bytes on repeated runs") {
  const Mesh mesh = ropes_and_sheet();
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> values = random_values(pattern, 11);
  const std::vector<double> other = random_values(pattern, 12);
  const std::vector<double> b = random_vector(3 * pattern.n, 13);
  std::vector<double> first(b.size()), second(b.size()), fresh(b.size());
  BlockLU lu;
  lu.analyse(pattern, mesh.coordinates.data());
  REQUIRE(lu.factorise(values.data()));
  lu.solve(b.data(), first.data());
  // nothing may be left over from another matrix, nor from another pattern
  REQUIRE(lu.factorise(other.data()));
  REQUIRE(lu.factorise(values.data()));
  lu.solve(b.data(), second.data());
  BlockLU anew;
  anew.analyse(pattern_of(chain(9)), chain(9).coordinates.data());
  anew.analyse(pattern, mesh.coordinates.data());
  REQUIRE(anew.factorise(values.data()));
  anew.solve(b.data(), fresh.data());
  CHECK(first == second);
  CHECK(first == fresh);
}

TEST_CASE("block LU solves in place") {
  const Mesh mesh = sheet(9, 8);
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> values = random_values(pattern, 2);
  const std::vector<double> b = random_vector(3 * pattern.n, 4);
  std::vector<double> x(b.size()), in_place = b;
  BlockLU lu;
  lu.analyse(pattern, mesh.coordinates.data());
  REQUIRE(lu.factorise(values.data()));
  lu.solve(b.data(), x.data());
  lu.solve(in_place.data(), in_place.data());
  CHECK(x == in_place);
}

TEST_CASE("block LU reports a singular matrix") {
  const Mesh mesh = apart(sheet(10, 10), chain(5));
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> sound = random_values(pattern, 21);
  std::vector<double> values = sound;
  std::vector<double> x(3 * pattern.n, 1);
  BlockLU lu;
  lu.analyse(pattern, mesh.coordinates.data());
  CHECK_THROWS_AS(lu.solve(x.data(), x.data()), std::logic_error);
  REQUIRE(lu.factorise(values.data()));
  const int node = 37;
  SUBCASE("empty row") {
    for (int64_t e = pattern.row_start[node]; e < pattern.row_start[node + 1]; ++e)
      for (int b = 0; b < 3; ++b) values[9 * e + 3 + b] = 0;
  }
  SUBCASE("empty column") {
    for (int i = 0; i < pattern.n; ++i)
      for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e)
        if (pattern.column[e] == node)
          for (int a = 0; a < 3; ++a) values[9 * e + 3 * a + 2] = 0;
  }
  SUBCASE("a part that floats freely") {
    // a chain of equal springs without support; whole numbers, so the last pivot is exactly zero
    for (int i = 100; i < 105; ++i)
      for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
        const bool end = i == 100 || i == 104;
        for (int q = 0; q < 9; ++q)
          values[9 * e + q] = q % 4 != 0 ? 0 : pattern.column[e] != i ? -1 : end ? 1 : 2;
      }
  }
  SUBCASE("not a number") {
    values[9 * pattern.row_start[node] + 4] = std::numeric_limits<double>::quiet_NaN();
  }
  SUBCASE("infinity") {
    values[9 * pattern.row_start[node] + 4] = std::numeric_limits<double>::infinity();
  }
  CHECK_FALSE(lu.factorise(values.data()));
  CHECK_THROWS_AS(lu.solve(x.data(), x.data()), std::logic_error);
  CHECK(lu.factorise(sound.data()));
}

TEST_CASE("block LU allocates only when it analyses") {
  const Mesh mesh = apart(tube_with_ring(), sheet(140, 145));
  const BlockPattern pattern = pattern_of(mesh);
  const std::vector<double> values = random_values(pattern, 31);
  const std::vector<double> b = random_vector(3 * pattern.n, 32);
  std::vector<double> x(b.size());
  const auto check = [&](Precision precision, int threads) {
    BlockLU lu(precision, threads);
    const long before_analysis = codend::allocation_count();
    lu.analyse(pattern, mesh.coordinates.data());
    REQUIRE(codend::allocation_count() > before_analysis);
    const long before = codend::allocation_count();
    const bool sound = lu.factorise(values.data());
    lu.solve(b.data(), x.data());
    lu.solve_refined(pattern, values.data(), b.data(), 1e-12, x.data());
    CHECK(codend::allocation_count() == before);
    CHECK(sound);
  };
  check(Precision::double_precision, 1);
  check(Precision::single_precision, 2);
}

TEST_CASE("block LU takes an empty matrix") {
  BlockPattern pattern;
  pattern.row_start.push_back(0);
  BlockLU lu;
  lu.analyse(pattern, nullptr);
  CHECK(lu.factorise(nullptr));
  lu.solve(nullptr, nullptr);
  CHECK(lu.figures().fronts == 0);
}

TEST_CASE("block LU refuses a pattern that breaks its description") {
  const Mesh mesh = sheet(4, 4);
  BlockPattern pattern = pattern_of(mesh);
  const char* fault = "";
  SUBCASE("offsets") {
    pattern.row_start.pop_back();
    fault = "block pattern: row_start must hold n + 1 offsets into column";
  }
  SUBCASE("order") {
    std::swap(pattern.column[0], pattern.column[1]);
    fault = "block pattern: row 0 is not sorted";
  }
  SUBCASE("range") {
    pattern.column.back() = 16;
    fault = "block pattern: row 15 has a column outside the matrix";
  }
  SUBCASE("mirror") {
    // row 0 reaches node 15, which does not answer
    pattern.column[pattern.row_start[1] - 1] = 15;
    fault = "block pattern: row 0 has an entry without its mirror image";
  }
  SUBCASE("diagonal") {
    pattern.column.erase(pattern.column.begin());
    for (size_t i = 1; i < pattern.row_start.size(); ++i) --pattern.row_start[i];
    fault = "block pattern: row 0 has no diagonal entry";
  }
  BlockLU lu;
  CHECK_THROWS_WITH_AS(lu.analyse(pattern, mesh.coordinates.data()), fault, std::invalid_argument);
}

TEST_CASE("figures of block LU count what is stored") {
  // one front: 3n pivots and no boundary, so L and U fill a square and nothing is stacked
  const Mesh mesh = complete(4);
  BlockLU lu;
  lu.analyse(pattern_of(mesh), mesh.coordinates.data());
  CHECK(lu.figures().fronts == 1);
  CHECK(lu.figures().largest_front == 12);
  CHECK(lu.figures().factor_entries == 144);
  CHECK(lu.figures().stack_entries == 0);
  CHECK(lu.figures().flops == doctest::Approx(2.0 / 3 * 12 * 12 * 12));
}
