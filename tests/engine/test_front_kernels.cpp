#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <limits>
#include <vector>

#include "solve/front_kernels.hpp"

namespace {

using codend::Front;
using codend::FrontKernels;
using codend::FrontKernelSet;
using codend::Sharing;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <class Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
template <class Real>
using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

template <class Real>
struct StoredFront {
  int k, b;
  Matrix<Real> lower, upper, update;
  Column<Real> reciprocal;
  std::vector<int> exchange;
  bool fresh = false;

  StoredFront(const Matrix<Real>& whole, int pivots)
      : k(pivots),
        b(static_cast<int>(whole.rows()) - k),
        lower(Matrix<Real>::Zero(k + codend::padded<Real>(b), k)),
        upper(Matrix<Real>::Zero(codend::padded<Real>(b), k)),
        update(Matrix<Real>::Zero(codend::padded<Real>(b), b)),
        reciprocal(k),
        exchange(k) {
    lower.topRows(k + b) = whole.leftCols(k);
    upper.topRows(b) = whole.topRightCorner(k, b).transpose();
    update.topRows(b) = whole.bottomRightCorner(b, b);
  }

  Front<Real> view() {
    return {
        k,     b,    lower.data(), upper.data(), update.data(), reciprocal.data(), exchange.data(),
        fresh, false};
  }
};

// Partial pivoting on random matrices: rows times the rounding of one operation, times 100 for the
// growth of pivots and the condition of A11 in the Schur complement.
template <class Real>
double tolerance(int rows) {
  return 100.0 * rows * std::numeric_limits<Real>::epsilon() / 2;
}

// Runs both halves of a job in sequence, as two threads would if the halves are independent.
const Sharing halves{[](void*, void (*job)(void*, int), void* data) {
                       job(data, 1);
                       job(data, 0);
                     },
                     nullptr};

template <class Real>
void check_front(const FrontKernels<Real>& kernels, int k, int b) {
  CAPTURE(k);
  CAPTURE(b);
  // large entries above the diagonal force row exchanges
  Matrix<Real> given = Matrix<Real>::Random(k + b, k + b);
  for (int i = 0; i < k; ++i) given(i, (i + 1) % k) += static_cast<Real>(k);
  StoredFront<Real> front(given, k);
  REQUIRE(kernels.factorise(front.view(), nullptr));

  const MatrixXd whole = given.template cast<double>();
  const MatrixXd lower = front.lower.template cast<double>();
  const MatrixXd update = front.update.template cast<double>();
  const MatrixXd a11 = whole.topLeftCorner(k, k), a12 = whole.topRightCorner(k, b);
  const MatrixXd a21 = whole.bottomLeftCorner(b, k), a22 = whole.bottomRightCorner(b, b);
  const double allowed = tolerance<Real>(k + b) * k;
  MatrixXd product = lower.topRows(k).triangularView<Eigen::UnitLower>() *
                     MatrixXd(lower.topRows(k).triangularView<Eigen::Upper>());
  for (int p = k; p-- > 0;) product.row(p).swap(product.row(front.exchange[p]));
  CHECK((product - a11).cwiseAbs().maxCoeff() <= allowed);
  CHECK(lower.topRows(k)
            .triangularView<Eigen::StrictlyLower>()
            .toDenseMatrix()
            .cwiseAbs()
            .maxCoeff() <= 1 + std::numeric_limits<Real>::epsilon());
  if (b > 0) {
    const MatrixXd schur = a22 - a21 * a11.partialPivLu().solve(a12);
    CHECK((update.topRows(b) - schur).cwiseAbs().maxCoeff() <= allowed);
  }

  // the two substitutions and the Schur complement between them solve the whole system
  const VectorXd rhs = VectorXd::Random(k + b).cast<Real>().template cast<double>();
  Column<Real> x = rhs.cast<Real>();
  kernels.forward(k, b, front.lower.data(), front.exchange.data(), x.data());
  if (b > 0) {
    const VectorXd y = update.topRows(b).partialPivLu().solve(x.tail(b).template cast<double>());
    x.tail(b) = y.cast<Real>();
  }
  kernels.backward(k, b, front.lower.data(), front.upper.data(), front.reciprocal.data(), x.data());
  const VectorXd solved = x.template cast<double>();
  CHECK((whole * solved - rhs).cwiseAbs().maxCoeff() <= allowed * solved.cwiseAbs().maxCoeff());

  // the transposed substitutions solve the transposed system
  x = rhs.cast<Real>();
  kernels.forward_transposed(k, b, front.lower.data(), front.upper.data(), front.reciprocal.data(),
                             x.data());
  if (b > 0) {
    const MatrixXd schur = update.topRows(b).transpose();
    x.tail(b) = VectorXd(schur.partialPivLu().solve(x.tail(b).template cast<double>()))
                    .template cast<Real>();
  }
  kernels.backward_transposed(k, b, front.lower.data(), front.exchange.data(), x.data());
  const VectorXd back = x.template cast<double>();
  CHECK((whole.transpose() * back - rhs).cwiseAbs().maxCoeff() <=
        allowed * back.cwiseAbs().maxCoeff());

  // identical bytes if the work is shared
  StoredFront<Real> shared(given, k);
  REQUIRE(kernels.factorise(shared.view(), &halves));
  CHECK(shared.lower == front.lower);
  CHECK(shared.upper == front.upper);
  CHECK(shared.update == front.update);

  // identical numbers if A22 is zero, whether it is set before or not
  given.bottomRightCorner(b, b).setZero();
  StoredFront<Real> cleared(given, k), fresh(given, k);
  fresh.fresh = true;
  fresh.update.setConstant(std::numeric_limits<Real>::quiet_NaN());
  REQUIRE(kernels.factorise(cleared.view(), nullptr));
  REQUIRE(kernels.factorise(fresh.view(), &halves));
  CHECK(fresh.update == cleared.update);
}

template <class Real>
void check_kernels(const FrontKernels<Real>& kernels) {
  // around each change of path: tiles of 1, 2 and 3 registers, 12 columns, blocks of 96 and 192
  for (int k : {3, 6, 9, 12, 15, 24, 27, 93, 96, 99, 195})
    for (int b : {0, 3, 6, 9, 12, 15, 33, 105}) check_front(kernels, k, b);
  check_front(kernels, 12, 393);
  check_front(kernels, 105,
              1035);             // rows of U far enough apart to be packed; large enough to share
  check_front(kernels, 402, 6);  // a right side large enough to share

  // a zero matrix is singular, also one with a zero last pivot
  StoredFront<Real> zero(Matrix<Real>::Zero(9, 9), 6);
  CHECK_FALSE(kernels.factorise(zero.view(), nullptr));
  Matrix<Real> identity = Matrix<Real>::Identity(33, 33);
  identity(29, 29) = 0;
  StoredFront<Real> last(identity, 30);
  CHECK_FALSE(kernels.factorise(last.view(), nullptr));

  // a child of 5 nodes. Its boundary meets the parent's 3 pivots at 0 and 2, and its boundary of 4
  // nodes at 0, 1 and 3.
  const std::vector<codend::Run> run{{0, 0, 1}, {1, 2, 1}, {2, 3, 2}, {4, 6, 1}};
  const int place[] = {0, 2, 3, 4, 6};
  const Matrix<Real> child = Matrix<Real>::Random(codend::padded<Real>(15), 15);
  Matrix<Real> whole = Matrix<Real>::Random(21, 21);
  StoredFront<Real> parent(whole, 9);
  kernels.extend_add(child.data(), 15, run.data(), run.data() + run.size(), parent.view());
  for (int i = 0; i < 15; ++i)
    for (int j = 0; j < 15; ++j)
      whole(3 * place[i / 3] + i % 3, 3 * place[j / 3] + j % 3) += child(i, j);
  const StoredFront<Real> expected(whole, 9);
  CHECK(parent.lower == expected.lower);
  CHECK(parent.upper == expected.upper);
  CHECK(parent.update == expected.update);
}

}  // namespace

TEST_CASE("front kernels agree with dense algebra") {
  auto check = [](const FrontKernelSet* set) {
    if (!set) return;
    check_kernels(set->in_double);
    check_kernels(set->in_single);
  };
  SUBCASE("portable") { check(&codend::portable_front_kernels()); }
  SUBCASE("AVX2") { check(codend::avx2_front_kernels()); }
  SUBCASE("AVX-512") { check(codend::avx512_front_kernels()); }
}

namespace {

// Factorisation of a random front and both solutions with it.
template <class Real>
std::vector<Real> all_bytes(const FrontKernels<Real>& kernels, int pivots, int boundary) {
  std::srand(7);
  const Matrix<Real> whole = Matrix<Real>::Random(pivots + boundary, pivots + boundary);
  StoredFront<Real> front(whole, pivots);
  REQUIRE(kernels.factorise(front.view(), nullptr));
  Column<Real> x = Column<Real>::Random(pivots + boundary), y = x;
  const Real* lower = front.lower.data();
  const Real* upper = front.upper.data();
  const Real* reciprocal = front.reciprocal.data();
  kernels.forward(pivots, boundary, lower, front.exchange.data(), x.data());
  kernels.backward(pivots, boundary, lower, upper, reciprocal, x.data());
  kernels.forward_transposed(pivots, boundary, lower, upper, reciprocal, y.data());
  kernels.backward_transposed(pivots, boundary, lower, front.exchange.data(), y.data());
  std::vector<Real> bytes(lower, lower + front.lower.size());
  bytes.insert(bytes.end(), upper, upper + front.upper.size());
  bytes.insert(bytes.end(), front.update.data(), front.update.data() + front.update.size());
  bytes.insert(bytes.end(), x.data(), x.data() + x.size());
  bytes.insert(bytes.end(), y.data(), y.data() + y.size());
  return bytes;
}

template <class Real>
void check_equal_bytes(const FrontKernels<Real>& some, const FrontKernels<Real>& others) {
  // sizes near whole tiles, below one and beyond the packed range
  for (const int pivots : {3, 24, 48, 51, 150})
    for (const int boundary : {0, 3, 45, 48, 99, 600}) {
      INFO(pivots, " pivots, boundary ", boundary);
      CHECK(all_bytes(some, pivots, boundary) == all_bytes(others, pivots, boundary));
    }
}

}  // namespace

TEST_CASE("front kernels of AVX-512 and AVX2 give identical bytes") {
  const FrontKernelSet *wide = codend::avx512_front_kernels(), *half = codend::avx2_front_kernels();
  if (!wide || !half) return;
  SUBCASE("double precision") { check_equal_bytes(wide->in_double, half->in_double); }
  SUBCASE("single precision") { check_equal_bytes(wide->in_single, half->in_single); }
}
