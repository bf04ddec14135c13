#include "stored_factorisation.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Limit of GMRES iterations, with factors of the same matrix and of an earlier one.
constexpr int most_fresh = 10, most_kept = 8;
// Multiplications and additions of a factorisation that take as long as an iteration per stored
// entry. Dense products are faster than access to memory.
constexpr double flops_per_entry = 40.0;
// Old factors are skipped after failure for 1, 2, 4, .. matrices, up to this number.
constexpr int most_skipped = 16;

}  // namespace

StoredFactorisation::StoredFactorisation(const BlockPattern& pattern,
                                         std::vector<double> coordinates)
    : pattern_(pattern), coordinates_(std::move(coordinates)) {}

void StoredFactorisation::leave_out(const std::vector<char>& node) {
  if (node == left_out_) return;
  left_out_ = node;
  factorised_ = false;
  if (lu_) lu_->leave_out(left_out_);
}

void StoredFactorisation::forget() {
  factorised_ = fresh_ = false;
  patience_[0] = patience_[1] = {};
  if (precision_ == Precision::double_precision) lu_.reset();
  precision_ = Precision::single_precision;
}

void StoredFactorisation::set_matrix(const std::vector<double>& values, bool first) {
  values_ = &values;
  fresh_ = false;
  first_ = first;
}

bool StoredFactorisation::factorise() {
  if (!lu_) {
    lu_ = std::make_unique<BlockLU>(precision_);
    lu_->analyse(pattern_, coordinates_.data());
    lu_->leave_out(left_out_);
    const BlockLUFigures& figures = lu_->figures();
    const double passes =
        figures.flops / (flops_per_entry * static_cast<double>(figures.factor_entries));
    affordable_ = static_cast<int>(std::clamp(passes, 1.0, static_cast<double>(most_kept)));
  }
  ++factorisations_;
  return factorised_ = fresh_ = lu_->factorise(values_->data());
}

bool StoredFactorisation::solve(const std::vector<double>& right, const std::vector<double>& scale,
                                const Tolerance& tolerance, std::vector<double>& x) {
  Patience& patience = patience_[first_ ? 0 : 1];
  if (factorised_ && !fresh_) {
    if (patience.skipped > 0) {
      --patience.skipped;
    } else if (iterate(right, scale, tolerance, affordable_, x)) {
      patience = {};
      return true;
    } else {
      patience.skipped = patience.next;
      patience.next = std::min(2 * patience.next, most_skipped);
    }
  }
  if ((fresh_ || factorise()) && iterate(right, scale, tolerance, most_fresh, x)) return true;
  if (precision_ == Precision::double_precision) return fresh_;  // already the best accuracy
  precision_ = Precision::double_precision;
  lu_.reset();
  if (!factorise()) return false;
  iterate(right, scale, tolerance, most_fresh, x);
  return true;
}

void StoredFactorisation::multiply(const double* x, double* product) const {
  for (int i = 0; i < pattern_.n; ++i) {
    double sum[3] = {};
    for (int64_t e = pattern_.row_start[i]; e < pattern_.row_start[i + 1]; ++e) {
      const double* block = values_->data() + 9 * e;
      const double* y = x + 3 * static_cast<std::ptrdiff_t>(pattern_.column[e]);
      for (int k = 0; k < 3; ++k) {
        sum[k] += block[3 * k] * y[0] + block[3 * k + 1] * y[1] + block[3 * k + 2] * y[2];
      }
    }
    std::copy(sum, sum + 3, product + 3 * static_cast<std::ptrdiff_t>(i));
  }
}

// GMRES from zero. Returns false without convergence in `most` iterations, or if it is too slow.
bool StoredFactorisation::iterate(const std::vector<double>& right,
                                  const std::vector<double>& scale, const Tolerance& tolerance,
                                  int most, std::vector<double>& x) {
  const std::size_t rows = right.size();
  weight_.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) weight_[i] = scale[i / 3] > 0.0 ? 1.0 / scale[i / 3] : 1.0;
  basis_.resize(most_fresh + 1);
  direction_.resize(most_fresh);
  std::vector<double>& start = basis_[0];
  start.resize(rows);
  double size = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    start[i] = weight_[i] * right[i];
    size += start[i] * start[i];
  }
  size = std::sqrt(size);
  std::fill(x.begin(), x.end(), 0.0);
  if (size <= tolerance.allowed || size == 0.0) return true;
  if (!std::isfinite(size)) return false;
  for (double& v : start) v /= size;
  const double wanted = std::max(tolerance.share * size, tolerance.allowed);
  // Columns of the rotated Hessenberg matrix, which is upper triangular, and its right side.
  double triangle[most_fresh][most_fresh + 1] = {}, cosine[most_fresh] = {}, sine[most_fresh] = {};
  double side[most_fresh + 1] = {size};
  double left = size;
  int used = 0;
  std::vector<double> unscaled(rows);
  while (used < most && left > wanted) {
    const int j = used++;
    std::vector<double>&z = direction_[j], &next = basis_[j + 1];
    z.resize(rows);
    next.resize(rows);
    for (std::size_t i = 0; i < rows; ++i) unscaled[i] = basis_[j][i] / weight_[i];
    lu_->solve(unscaled.data(), z.data());
    multiply(z.data(), next.data());
    for (std::size_t i = 0; i < rows; ++i) next[i] *= weight_[i];
    double* h = triangle[j];
    for (int k = 0; k <= j; ++k) {
      double product = 0.0;
      for (std::size_t i = 0; i < rows; ++i) product += next[i] * basis_[k][i];
      h[k] = product;
      for (std::size_t i = 0; i < rows; ++i) next[i] -= product * basis_[k][i];
    }
    double norm = 0.0;
    for (const double v : next) norm += v * v;
    norm = std::sqrt(norm);
    if (!std::isfinite(norm)) return false;
    for (int k = 0; k < j; ++k) {
      const double upper = h[k];
      h[k] = cosine[k] * upper + sine[k] * h[k + 1];
      h[k + 1] = cosine[k] * h[k + 1] - sine[k] * upper;
    }
    const double length = std::hypot(h[j], norm);
    if (length == 0.0) return false;
    cosine[j] = h[j] / length;
    sine[j] = norm / length;
    h[j] = length;
    side[j + 1] = -sine[j] * side[j];
    side[j] *= cosine[j];
    left = std::abs(side[j + 1]);
    if (norm > 0.0) {
      for (double& v : next) v /= norm;
    }
    // The present rate is too slow for convergence.
    if (left > wanted && used > 1 && used < most &&
        std::log(left / wanted) * used > (most - used) * std::log(size / left)) {
      return false;
    }
  }
  for (int j = used - 1; j >= 0; --j) {
    double sum = side[j];
    for (int k = j + 1; k < used; ++k) sum -= triangle[k][j] * side[k];
    side[j] = sum / triangle[j][j];
  }
  for (int j = 0; j < used; ++j) {
    for (std::size_t i = 0; i < rows; ++i) x[i] += side[j] * direction_[j][i];
  }
  // Rounding errors reach excluded nodes that share a front with others.
  for (std::size_t i = 0; i < 3 * left_out_.size(); ++i) {
    if (left_out_[i / 3]) x[i] = 0.0;
  }
  return left <= wanted;
}

}  // namespace codend
