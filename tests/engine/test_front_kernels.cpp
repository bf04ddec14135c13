#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <vector>

#include "solve/front_kernels.hpp"

namespace {

using codend::Front;
using codend::FrontKernels;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct StoredFront {
  int k, b;
  MatrixXd lower, upper, update;
  VectorXd reciprocal;
  std::vector<int> exchange;

  StoredFront(const MatrixXd& whole, int pivots)
      : k(pivots),
        b(static_cast<int>(whole.rows()) - k),
        lower(MatrixXd::Zero(k + codend::padded(b), k)),
        upper(MatrixXd::Zero(codend::padded(b), k)),
        update(MatrixXd::Zero(codend::padded(b), b)),
        reciprocal(k),
        exchange(k) {
    lower.topRows(k + b) = whole.leftCols(k);
    upper.topRows(b) = whole.topRightCorner(k, b).transpose();
    update.topRows(b) = whole.bottomRightCorner(b, b);
  }

  Front view() {
    return {k, b, lower.data(), upper.data(), update.data(), reciprocal.data(), exchange.data()};
  }
};

// Partial pivoting on random matrices of up to 1140 rows: 1140 x 1.1e-16, and a factor 100 for the
// growth of pivots and for the condition of A11 in the Schur complement.
constexpr double tolerance = 1e-11;

void check_front(const FrontKernels& kernels, int k, int b) {
  CAPTURE(k);
  CAPTURE(b);
  // heavy above the diagonal, so that rows must be exchanged
  MatrixXd whole = MatrixXd::Random(k + b, k + b);
  for (int i = 0; i < k; ++i) whole(i, (i + 1) % k) += k;
  StoredFront front(whole, k);
  REQUIRE(kernels.factorise(front.view()));

  const MatrixXd a11 = whole.topLeftCorner(k, k), a12 = whole.topRightCorner(k, b);
  const MatrixXd a21 = whole.bottomLeftCorner(b, k), a22 = whole.bottomRightCorner(b, b);
  MatrixXd product = front.lower.topRows(k).triangularView<Eigen::UnitLower>() *
                     MatrixXd(front.lower.topRows(k).triangularView<Eigen::Upper>());
  for (int p = k; p-- > 0;) product.row(p).swap(product.row(front.exchange[p]));
  CHECK((product - a11).cwiseAbs().maxCoeff() <= tolerance * k);
  CHECK(front.lower.topRows(k).triangularView<Eigen::StrictlyLower>().toDenseMatrix()
            .cwiseAbs().maxCoeff() <= 1);
  if (b > 0) {
    const MatrixXd schur = a22 - a21 * a11.partialPivLu().solve(a12);
    CHECK((front.update.topRows(b) - schur).cwiseAbs().maxCoeff() <= tolerance * k);
  }

  // the two substitutions and the Schur complement between them solve the whole
  const VectorXd rhs = VectorXd::Random(k + b);
  VectorXd x = rhs;
  kernels.forward(k, b, front.lower.data(), front.exchange.data(), x.data());
  if (b > 0) x.tail(b) = front.update.topRows(b).partialPivLu().solve(x.tail(b).eval());
  kernels.backward(k, b, front.lower.data(), front.upper.data(), front.reciprocal.data(), x.data());
  CHECK((whole * x - rhs).cwiseAbs().maxCoeff() <= tolerance * k * x.cwiseAbs().maxCoeff());
}

void check_kernels(const FrontKernels& kernels) {
  // around each change of path: tiles of 6 and 12 rows, 12 columns, blocks of 96 and 192
  for (int k : {3, 6, 9, 12, 15, 24, 27, 93, 96, 99, 195})
    for (int b : {0, 3, 6, 9, 12, 15, 33, 105}) check_front(kernels, k, b);
  check_front(kernels, 12, 393);
  check_front(kernels, 105, 1035);  // rows of U far enough apart to be packed

  // a zero matrix is singular, and so is one whose last pivot vanishes
  StoredFront zero(MatrixXd::Zero(9, 9), 6);
  CHECK_FALSE(kernels.factorise(zero.view()));
  MatrixXd identity = MatrixXd::Identity(33, 33);
  identity(29, 29) = 0;
  StoredFront last(identity, 30);
  CHECK_FALSE(kernels.factorise(last.view()));

  // a child of 5 nodes whose boundary meets the parent's 3 pivots at 0 and 2 and its boundary of 4
  // nodes at 0, 1 and 3
  const std::vector<codend::Run> run{{0, 0, 1}, {1, 2, 1}, {2, 3, 2}, {4, 6, 1}};
  const int place[] = {0, 2, 3, 4, 6};
  const MatrixXd child = MatrixXd::Random(codend::padded(15), 15);
  MatrixXd whole = MatrixXd::Random(21, 21);
  StoredFront parent(whole, 9);
  kernels.extend_add(child.data(), 15, run.data(), run.data() + run.size(), parent.view());
  for (int i = 0; i < 15; ++i)
    for (int j = 0; j < 15; ++j)
      whole(3 * place[i / 3] + i % 3, 3 * place[j / 3] + j % 3) += child(i, j);
  const StoredFront expected(whole, 9);
  CHECK(parent.lower == expected.lower);
  CHECK(parent.upper == expected.upper);
  CHECK(parent.update == expected.update);
}

}  // namespace

TEST_CASE("portable front kernels agree with dense algebra") {
  check_kernels(codend::portable_front_kernels());
}

TEST_CASE("AVX2 front kernels agree with dense algebra") {
  if (codend::avx2_front_kernels()) check_kernels(*codend::avx2_front_kernels());
}
