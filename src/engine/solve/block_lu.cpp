#include "block_lu.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "flushed_denormals.hpp"

namespace codend {

namespace {

// Minimum multiplications and additions of a factorisation for a second thread (some milliseconds).
constexpr double flops_for_two = 1e8;
constexpr int most_refinements = 10;

double largest(const double* x, size_t size) {
  double most = 0;
  for (size_t i = 0; i < size; ++i) most = std::max(most, std::fabs(x[i]));
  return most;
}

template <class Real>
void solve_ordered(const FrontFactors<Real>& factors, const std::vector<int>& order,
                   bool transposed, const double* b, std::vector<Real>& work, double* x) {
  Real* y = work.data();
  for (const int node : order)
    for (int k = 0; k < 3; ++k) *y++ = static_cast<Real>(b[3 * static_cast<int64_t>(node) + k]);
  if (transposed) {
    factors.solve_transposed(work.data());
  } else {
    factors.solve(work.data());
  }
  y = work.data();
  for (const int node : order)
    for (int k = 0; k < 3; ++k) x[3 * static_cast<int64_t>(node) + k] = *y++;
}

}  // namespace

BlockLU::BlockLU(Precision precision, int threads, std::function<void()> pause)
    : precision_(precision), threads_(threads), pause_(std::move(pause)) {
  if (threads < 1 || threads > 2)
    throw std::invalid_argument("block LU: threads is " + std::to_string(threads) +
                                "; it must be 1 or 2");
}

void BlockLU::analyse(const BlockPattern& pattern, const double* coordinates) {
  check_pattern(pattern);
  factorised_ = false;
  factors_ = {};  // frees memory for the new factors
  tree_ = assembly_tree(pattern, nested_dissection(pattern, coordinates, pause_));
  double flops = 0;
  for (int f = 0; f < tree_.fronts(); ++f) flops += tree_.flops(f);
  const int threads = flops < flops_for_two ? 1 : threads_;
  shared_ = threads == 2;
  if (!shared_)
    second_.reset();
  else if (!second_)
    second_ = std::make_unique<SecondThread>();
  const size_t rows = 3 * static_cast<size_t>(pattern.n);
  if (precision_ == Precision::double_precision) {
    factors_ = std::make_unique<FrontFactors<double>>(pattern, tree_, threads);
    in_double_.assign(rows, 0);
  } else {
    factors_ = std::make_unique<FrontFactors<float>>(pattern, tree_, threads);
    in_single_.assign(rows, 0);
  }
  residual_.assign(rows, 0);
  correction_.assign(rows, 0);
  measure();
}

void BlockLU::leave_out(const std::vector<char>& nodes) {
  factorised_ = false;
  std::visit([&](const auto& factors) { factors->leave_out(nodes); }, factors_);
}

void BlockLU::measure() {
  figures_ = {};
  figures_.fronts = tree_.fronts();
  for (int f = 0; f < tree_.fronts(); ++f) {
    const double k = 3.0 * tree_.pivots(f), b = 3.0 * tree_.boundary_nodes(f);
    figures_.factor_entries += static_cast<int64_t>(k * (k + 2 * b));
    figures_.flops += tree_.flops(f);
  }
  std::visit(
      [&](const auto& factors) {
        figures_.largest_front = factors->largest_front();
        figures_.stack_entries = factors->stack_entries();
        figures_.bytes = factors->bytes();
      },
      factors_);
  figures_.bytes += bytes_of(in_double_) + bytes_of(in_single_) + bytes_of(residual_) +
                    bytes_of(correction_) + bytes_of(tree_.order) + bytes_of(tree_.position) +
                    bytes_of(tree_.first_pivot) + bytes_of(tree_.parent) +
                    bytes_of(tree_.first_boundary) + bytes_of(tree_.boundary) +
                    bytes_of(tree_.first_child) + bytes_of(tree_.child) +
                    bytes_of(tree_.first_run) + bytes_of(tree_.run);
}

bool BlockLU::factorise(const double* values) { return factorise(values, false); }

bool BlockLU::factorise_definite(const double* values) { return factorise(values, true); }

bool BlockLU::factorise(const double* values, bool definite) {
  factorised_ = false;
  if (shared_ && !second_) second_ = std::make_unique<SecondThread>();
  if (const auto* factors = std::get_if<0>(&factors_)) {
    factorised_ = (*factors)->factorise(values, definite, second_.get(), pause_);
  } else {
    const FlushedDenormals flushed;
    factorised_ = std::get<1>(factors_)->factorise(values, definite, second_.get(), pause_);
  }
  return factorised_;
}

void BlockLU::solve(const double* b, double* x) const { solve(false, b, x); }

void BlockLU::solve_transposed(const double* b, double* x) const { solve(true, b, x); }

void BlockLU::solve(bool transposed, const double* b, double* x) const {
  if (!factorised_) throw std::logic_error("block LU: no factors to solve with");
  if (const auto* factors = std::get_if<0>(&factors_)) {
    solve_ordered(**factors, tree_.order, transposed, b, in_double_, x);
  } else {
    const FlushedDenormals flushed;
    solve_ordered(*std::get<1>(factors_), tree_.order, transposed, b, in_single_, x);
  }
}

double BlockLU::solve_refined(const BlockPattern& pattern, const double* values, const double* b,
                              double tolerance, double* x) const {
  const size_t rows = residual_.size();
  const double scale = largest(b, rows);
  solve(b, x);
  double reached = -1;
  for (int round = 0;; ++round) {
    for (int i = 0; i < pattern.n; ++i) {
      const size_t at = 3 * static_cast<size_t>(i);
      double r[3] = {b[at], b[at + 1], b[at + 2]};
      for (int64_t e = pattern.row_start[i]; e < pattern.row_start[i + 1]; ++e) {
        const double* block = values + 9 * e;
        const double* y = x + 3 * static_cast<size_t>(pattern.column[e]);
        for (int k = 0; k < 3; ++k)
          r[k] -= block[3 * k] * y[0] + block[3 * k + 1] * y[1] + block[3 * k + 2] * y[2];
      }
      std::copy(r, r + 3, &residual_[at]);
    }
    const double now = scale > 0 ? largest(residual_.data(), rows) / scale : 0;
    if (round > 0 && !(now < reached)) {  // the last correction increased the residual
      for (size_t i = 0; i < rows; ++i) x[i] -= correction_[i];
      return reached;
    }
    const bool slow = round > 0 && now > 0.5 * reached;
    reached = now;
    if (now <= tolerance || slow || round == most_refinements) return reached;
    solve(residual_.data(), correction_.data());
    for (size_t i = 0; i < rows; ++i) x[i] += correction_[i];
  }
}

}  // namespace codend
