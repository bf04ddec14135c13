#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "allocation_count.hpp"
#include "base/pi.hpp"
#include "node_graph.hpp"
#include "solve/block_lu.hpp"
#include "solve/flushed_denormals.hpp"

namespace {

using codend::BlockLU;
using codend::BlockPattern;
using codend::each_block;
using codend::NodeGraph;
using codend::pi;
using codend::Precision;
using codend::random_vector;

// Backward error |b - A x| / (|A| |x|) in maximum norms. Gaussian elimination leaves about (rows of
// a front) x (growth of the pivots) x 1.1e-16. Fronts here have at most 300 rows and the growth is
// below 20 on these matrices, which gives 1e-12, rounded up.
constexpr double backward_error = 1e-12;

NodeGraph chain(int n) { return codend::grid(1, n); }

// Triangles that are not level.
NodeGraph sheet(int rows, int columns) {
  NodeGraph mesh = codend::grid(rows, columns);
  for (int k = 0; k < mesh.nodes(); ++k) {
    const int i = k / columns, j = k % columns;
    mesh.places[3 * k + 2] = std::sin(0.3 * i + 0.2 * j);
    if (i > 0 && j > 0) mesh.join(k, k - columns - 1);
  }
  return mesh;
}

NodeGraph tube(int rows, int around) {
  NodeGraph mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * pi * j / around;
      const int k = mesh.add(i, 3 * std::cos(angle), 3 * std::sin(angle));
      if (j > 0) mesh.join(k, k - 1);
      if (j == around - 1) mesh.join(k, k - j);
      if (i > 0) mesh.join(k, k - around);
    }
  return mesh;
}

// A warp with bridles that branch again, their ends joined to the edge of a sheet.
NodeGraph ropes_and_sheet() {
  NodeGraph mesh = sheet(20, 17);
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

// A ring tied to every node of one end of a tube: one dense row, as at a codend's ring.
NodeGraph tube_with_ring() {
  NodeGraph mesh = tube(12, 50);
  const int ring = mesh.add(-1, 0, 0);
  for (int j = 0; j < 50; ++j) mesh.join(ring, j);
  return mesh;
}

NodeGraph complete(int n) {
  NodeGraph mesh;
  for (int i = 0; i < n; ++i) {
    mesh.add(i % 2, i % 3, 0);
    for (int j = 0; j < i; ++j) mesh.join(i, j);
  }
  return mesh;
}

NodeGraph apart(const NodeGraph& a, const NodeGraph& b) {
  NodeGraph mesh = a;
  const int shift = a.nodes();
  mesh.places.insert(mesh.places.end(), b.places.begin(), b.places.end());
  for (std::vector<int> row : b.neighbours) {
    for (int& j : row) j += shift;
    mesh.neighbours.push_back(row);
  }
  return mesh;
}

// Random blocks. Diagonal blocks have their large entries off the diagonal, so that a solver
// without pivoting fails.
std::vector<double> random_values(const BlockPattern& pattern, unsigned seed) {
  std::vector<double> values = random_vector(9 * pattern.column.size(), seed);
  each_block(pattern, values, [](int i, int j, double* block) {
    if (i != j) return;
    block[0] = block[4] = block[8] = 0;
    for (int a = 0; a < 3; ++a) block[3 * a + (a + 1) % 3] += 6;
  });
  return values;
}

Eigen::SparseMatrix<double> to_eigen(const BlockPattern& pattern,
                                     const std::vector<double>& values) {
  std::vector<Eigen::Triplet<double>> entries;
  each_block(pattern, values, [&](int i, int j, const double* block) {
    for (int q = 0; q < 9; ++q) entries.emplace_back(3 * i + q / 3, 3 * j + q % 3, block[q]);
  });
  Eigen::SparseMatrix<double> matrix(3 * pattern.n, 3 * pattern.n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// A matrix on a mesh, and a right side.
struct Problem {
  NodeGraph mesh;
  BlockPattern pattern = mesh.pattern();
  std::vector<double> values, b = random_vector(3 * pattern.n, 4), x = b;

  explicit Problem(NodeGraph of) : mesh(std::move(of)), values(random_values(pattern, 7)) {}
  void analyse(BlockLU& lu) const { lu.analyse(pattern, mesh.places.data()); }
  std::vector<double> solution(BlockLU& lu) const {
    REQUIRE(lu.factorise(values.data()));
    std::vector<double> out(b.size());
    lu.solve(b.data(), out.data());
    return out;
  }
};

void empty_row(const BlockPattern& pattern, std::vector<double>& values, int node) {
  each_block(pattern, values, [&](int i, int, double* block) {
    if (i == node) std::fill(block + 3, block + 6, 0.0);
  });
}

double greatest_row_sum(const Eigen::SparseMatrix<double>& matrix) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(matrix.rows());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      sums[it.row()] += std::abs(it.value());
  return sums.maxCoeff();
}

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

void check_against_sparse_lu(const Problem& of) {
  const Eigen::SparseMatrix<double> matrix = to_eigen(of.pattern, of.values);
  const auto b = as_vector(of.b);
  BlockLU lu;
  of.analyse(lu);
  const std::vector<double> solved = of.solution(lu);
  const auto x = as_vector(solved);

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

  std::vector<double> in_place = of.b;
  lu.solve(in_place.data(), in_place.data());
  CHECK(in_place == solved);
}

void check_against_sparse_lu(const NodeGraph& mesh) { check_against_sparse_lu(Problem(mesh)); }

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

TEST_CASE("block LU solves meshes whose nodes coincide") {
  SUBCASE("all nodes coincide") {
    NodeGraph mesh = sheet(24, 25);
    std::fill(mesh.places.begin(), mesh.places.end(), 1.5);
    check_against_sparse_lu(mesh);
  }
  SUBCASE("some nodes coincide") {
    NodeGraph mesh = apart(sheet(15, 14), sheet(15, 14));
    for (int i = 0; i < 14; ++i) mesh.join(i, 15 * 14 + i);
    check_against_sparse_lu(mesh);
  }
  SUBCASE("scattered at random") {
    NodeGraph mesh = tube(25, 20);
    mesh.places = random_vector(mesh.places.size(), 3);
    check_against_sparse_lu(mesh);
  }
}

namespace {

// Every edge is a spring, like rope next to slack twine, with a non-symmetric part of 10 %.
Problem springs_seven_decades_apart() {
  Problem out(ropes_and_sheet());
  const auto stiffness = [](int i, int j) { return std::max(i, j) >= 20 * 17 ? 1e7 : 1.0; };
  out.values = codend::springs(out.pattern, stiffness, 0.1 / 3, 1.0, 5);
  return out;
}

}  // namespace

TEST_CASE("block LU solves stiffnesses seven decades apart") {
  check_against_sparse_lu(springs_seven_decades_apart());
}

TEST_CASE("block LU in single precision refines to the requested residual") {
  Problem of(ropes_and_sheet());
  SUBCASE("random blocks") {}
  SUBCASE("stiffnesses seven decades apart") { of = springs_seven_decades_apart(); }
  BlockLU lu(Precision::single_precision);
  of.analyse(lu);
  REQUIRE(lu.factorise(of.values.data()));
  const Eigen::SparseMatrix<double> matrix = to_eigen(of.pattern, of.values);
  const auto b = as_vector(of.b), x = as_vector(of.x);
  const auto residual = [&] {
    return (b - matrix * x).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  };
  for (const double tolerance : {1e-4, 1e-8, 1e-11}) {
    const double reached =
        lu.solve_refined(of.pattern, of.values.data(), of.b.data(), tolerance, of.x.data());
    CHECK(reached <= tolerance);
    // The two sum rows in different orders: about ten terms of at most |A| |x|.
    const double rounding = 10 * 1.1e-16 * greatest_row_sum(matrix) * x.lpNorm<Eigen::Infinity>() /
                            b.lpNorm<Eigen::Infinity>();
    CHECK(std::abs(residual() - reached) <= rounding);
  }
  lu.solve(of.b.data(), of.x.data());
  CHECK(residual() > 1e-11);  // otherwise refinement was not tested
}

TEST_CASE("refinement ends when the residual stops falling") {
  Problem of(sheet(9, 8));
  BlockLU lu;
  of.analyse(lu);
  REQUIRE(lu.factorise(of.values.data()));
  const auto reached = [&](const std::vector<double>& matrix, const std::vector<double>& right,
                           double tolerance) {
    return lu.solve_refined(of.pattern, matrix.data(), right.data(), tolerance, of.x.data());
  };
  SUBCASE("at the rounding of numbers") {
    const double least = reached(of.values, of.b, 0);
    CHECK(least > 0);
    CHECK(least < 1e-12);
  }
  SUBCASE("with the factors of another matrix") {
    CHECK(reached(random_values(of.pattern, 3), of.b, 1e-10) > 1e-2);
  }
  SUBCASE("without a right side") {
    const std::vector<double> none(of.b.size(), 0.0);
    CHECK(reached(of.values, none, 1e-10) == 0);
    CHECK(of.x == none);
  }
}

TEST_CASE("block LU gives identical bytes with one and two threads") {
  // large enough for two threads; the last part has a separate front in both
  Problem of(apart(sheet(150, 140), tube_with_ring()));
  SUBCASE("of common numbers") {}
  SUBCASE("of couplings whose products are denormal in single precision") {
    each_block(of.pattern, of.values, [](int i, int j, double* block) {
      for (int k = 0; i != j && k < 9; ++k) block[k] *= 1e-20;
    });
  }
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    BlockLU alone(precision, 1), shared(precision, 2);
    of.analyse(alone);
    of.analyse(shared);
    for (int round = 0; round < 2; ++round) REQUIRE(shared.factorise(of.values.data()));
    CHECK(of.solution(alone) == of.solution(shared));
  }
}

TEST_CASE("single-precision factorisation rounds denormal numbers to zero, double does not") {
  const NodeGraph mesh = chain(2);
  const BlockPattern pattern = mesh.pattern();  // blocks 11, 12, 21, 22
  std::vector<double> values(36, 0);
  for (const int block : {0, 3})
    for (int k = 0; k < 3; ++k) values[9 * block + 4 * k] = 1;
  values[9] = values[18] = 1e-40;  // the smallest normal float is 1.2e-38
  const std::vector<double> b = {1e10, 0, 0, 0, 0, 0};
  const auto second = [&](Precision precision) {
    BlockLU lu(precision);
    lu.analyse(pattern, mesh.places.data());
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

TEST_CASE("definiteness test changes at the smallest eigenvalue of a symmetric matrix") {
  for (const NodeGraph& mesh : {tube(5, 8), sheet(9, 7), tube_with_ring()}) {
    const Problem of(mesh);
    const Eigen::MatrixXd dense(to_eigen(of.pattern, of.values));
    const Eigen::MatrixXd symmetric = 0.5 * (dense + dense.transpose());
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues()[0];
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      BlockLU lu(precision);
      of.analyse(lu);
      for (const double off : {1e-3, -1e-3}) {
        std::vector<double> values(of.values.size());
        each_block(of.pattern, values, [&](int i, int j, double* block) {
          for (int q = 0; q < 9; ++q) {
            const int row = 3 * i + q / 3, column = 3 * j + q % 3;
            block[q] = symmetric(row, column) + (row == column ? off - least : 0.0);
          }
        });
        CHECK(lu.factorise_definite(values.data()) == (off > 0.0));
      }
    }
  }
}

TEST_CASE("block LU with two threads reports a singular matrix") {
  const Problem of(sheet(150, 140));
  BlockLU lu(Precision::double_precision, 2);
  of.analyse(lu);
  for (int node : {0, 10500, 20999}) {  // in both threads' subtrees and near the first separator
    std::vector<double> values = of.values;
    empty_row(of.pattern, values, node);
    CHECK_FALSE(lu.factorise(values.data()));
  }
  CHECK(lu.factorise(of.values.data()));
}

TEST_CASE("block LU calls the pause and stops when it throws") {
  const Problem of(sheet(220, 200));
  std::vector<double> x = of.b;
  BlockLU plain(Precision::single_precision);
  of.analyse(plain);
  const std::vector<double> expected = of.solution(plain);
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    int pauses = 0, stop_at = 1;
    const std::thread::id here = std::this_thread::get_id();
    BlockLU lu(Precision::single_precision, threads, [&] {
      CHECK(std::this_thread::get_id() == here);
      if (++pauses == stop_at) throw std::runtime_error("stopped");
    });
    CHECK_THROWS_WITH(of.analyse(lu), "stopped");
    pauses = stop_at = 0;
    of.analyse(lu);
    CHECK(pauses >= 2);  // before the first cut of 44,000 nodes and before the cuts of both halves
    pauses = 0;
    REQUIRE(lu.factorise(of.values.data()));
    const int all = pauses;
    REQUIRE(all >= 2);
    for (const int at : {1, all}) {
      pauses = 0;
      stop_at = at;
      CHECK_THROWS_WITH(lu.factorise(of.values.data()), "stopped");
      CHECK(pauses == at);
      CHECK_THROWS_AS(lu.solve(x.data(), x.data()), std::logic_error);
    }
    stop_at = 0;
    CHECK(of.solution(lu) == expected);
  }
}

TEST_CASE("block LU throws unless threads is one or two") {
  for (int threads : {-1, 0, 3})
    CHECK_THROWS_WITH_AS(
        BlockLU(Precision::double_precision, threads),
        ("block LU: threads is " + std::to_string(threads) + "; it must be 1 or 2").c_str(),
        std::invalid_argument);
}

TEST_CASE("block LU gives identical bytes on repeated runs") {
  const Problem of(ropes_and_sheet()), small(chain(9));
  BlockLU lu, anew;
  of.analyse(lu);
  const std::vector<double> first = of.solution(lu);
  // no data of another matrix or pattern may remain
  REQUIRE(lu.factorise(random_values(of.pattern, 12).data()));
  CHECK(of.solution(lu) == first);
  small.analyse(anew);
  of.analyse(anew);
  CHECK(of.solution(anew) == first);
}

TEST_CASE("block LU reports a singular matrix") {
  const Problem of(apart(sheet(10, 10), chain(5)));
  std::vector<double> values = of.values, x = of.b;
  BlockLU lu;
  of.analyse(lu);
  CHECK_THROWS_AS(lu.solve(x.data(), x.data()), std::logic_error);
  REQUIRE(lu.factorise(values.data()));
  const int node = 37;
  double& within = values[9 * of.pattern.row_start[node] + 4];
  SUBCASE("empty row") { empty_row(of.pattern, values, node); }
  SUBCASE("empty column") {
    each_block(of.pattern, values, [&](int, int j, double* block) {
      if (j == node) block[2] = block[5] = block[8] = 0;
    });
  }
  SUBCASE("a part that floats freely") {
    // an unsupported chain of equal springs; integers make the last pivot exactly zero
    each_block(of.pattern, values, [](int i, int j, double* block) {
      const bool end = i == 100 || i == 104;
      for (int q = 0; i >= 100 && q < 9; ++q) block[q] = q % 4 != 0 ? 0 : j != i ? -1 : end ? 1 : 2;
    });
  }
  SUBCASE("not a number") { within = std::numeric_limits<double>::quiet_NaN(); }
  SUBCASE("infinity") { within = std::numeric_limits<double>::infinity(); }
  CHECK_FALSE(lu.factorise(values.data()));
  CHECK_THROWS_AS(lu.solve(x.data(), x.data()), std::logic_error);
  CHECK(lu.factorise(of.values.data()));
}

TEST_CASE("block LU allocates only during analysis") {
  Problem of(apart(tube_with_ring(), sheet(140, 145)));
  const auto check = [&](Precision precision, int threads) {
    BlockLU lu(precision, threads);
    const long before_analysis = codend::allocation_count();
    of.analyse(lu);
    REQUIRE(codend::allocation_count() > before_analysis);
    const long before = codend::allocation_count();
    const bool sound = lu.factorise(of.values.data());
    lu.solve(of.b.data(), of.x.data());
    lu.solve_refined(of.pattern, of.values.data(), of.b.data(), 1e-12, of.x.data());
    CHECK(codend::allocation_count() == before);
    CHECK(sound);
  };
  check(Precision::double_precision, 1);
  check(Precision::single_precision, 2);
}

TEST_CASE("block LU accepts an empty matrix") {
  BlockPattern pattern;
  pattern.row_start.push_back(0);
  BlockLU lu;
  lu.analyse(pattern, nullptr);
  CHECK(lu.factorise(nullptr));
  lu.solve(nullptr, nullptr);
  CHECK(lu.figures().fronts == 0);
}

TEST_CASE("block LU rejects an invalid pattern") {
  const NodeGraph mesh = sheet(4, 4);
  BlockPattern pattern = mesh.pattern();
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
    // row 0 has an entry for node 15, but row 15 has none for node 0
    pattern.column[pattern.row_start[1] - 1] = 15;
    fault = "block pattern: row 0 has an entry without its mirror image";
  }
  SUBCASE("diagonal") {
    pattern.column.erase(pattern.column.begin());
    for (size_t i = 1; i < pattern.row_start.size(); ++i) --pattern.row_start[i];
    fault = "block pattern: row 0 has no diagonal entry";
  }
  BlockLU lu;
  CHECK_THROWS_WITH_AS(lu.analyse(pattern, mesh.places.data()), fault, std::invalid_argument);
}

TEST_CASE("block LU figures count the stored entries") {
  // one front: 3n pivots without boundary, so L and U fill a square and the stack is empty
  const NodeGraph mesh = complete(4);
  BlockLU lu;
  lu.analyse(mesh.pattern(), mesh.places.data());
  CHECK(lu.figures().fronts == 1);
  CHECK(lu.figures().largest_front == 12);
  CHECK(lu.figures().factor_entries == 144);
  CHECK(lu.figures().stack_entries == 0);
  CHECK(lu.figures().flops == doctest::Approx(2.0 / 3 * 12 * 12 * 12));
}
