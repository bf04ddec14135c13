#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "assembly_tree.hpp"
#include "front_factors.hpp"
#include "ordering.hpp"
#include "second_thread.hpp"

namespace codend {

// Cost of a factorisation, known after analyse().
struct BlockLUFigures {
  int fronts = 0;
  int largest_front = 0;       // rows of the largest front, in scalars
  int64_t factor_entries = 0;  // stored entries of L and U
  int64_t stack_entries = 0;   // entries of the stack of update matrices
  double flops = 0;            // multiplications and additions of one factorisation
  int64_t bytes = 0;           // total memory of the object
};

enum class Precision { double_precision, single_precision };

// Direct solver for sparse A x = b with 3x3 blocks, nonsymmetric values and a symmetric pattern. It
// is a multifrontal LU factorisation (Duff and Reid 1983) with nested dissection of the nodes.
// Pivoting is restricted to the rows that a front eliminates.
//
// factorise() and the solves allocate no memory. On one machine, equal input gives identical bytes,
// with 1 and 2 threads.
class BlockLU {
 public:
  // Factors in single precision need half the memory and about 0.6 of the time, but require
  // solve_refined(). Their denormal numbers count as zero.
  //
  // `threads` is 1 or 2; other numbers throw std::invalid_argument. Small patterns use one thread,
  // because a second one gains nothing.
  //
  // analyse() and factorise() call `pause` on the calling thread, a few times per second. If
  // `pause` throws, they end without factors.
  explicit BlockLU(Precision precision = Precision::double_precision, int threads = 1,
                   std::function<void()> pause = {});

  // Orders the nodes and lays out the factors, once per pattern. coordinates: 3n, x y z per node;
  // they guide the order, and nodes may coincide. Throws std::invalid_argument if the pattern is
  // not sorted, not symmetric, or lacks a diagonal entry.
  void analyse(const BlockPattern& pattern, const double* coordinates);

  // Excludes nodes (1 per excluded node; may be empty) and drops the factors. Rows of excluded
  // nodes must have entries only in the diagonal block. Their right side must be zero, and so is
  // their solution. Fronts with only excluded nodes cost nothing.
  void leave_out(const std::vector<char>& nodes);

  // values: 9 per block, row-major, in the order of the pattern's columns. Returns false, without
  // factors, if a pivot is zero, not finite, or too small for a reciprocal.
  bool factorise(const double* values);
  // Factorises a symmetric matrix without row exchanges. Also returns false if the matrix is not
  // positive definite, within rounding. Asymmetric values may give inaccurate factors.
  bool factorise_definite(const double* values);

  // Ends the second thread; factorise() starts another. Required for objects that are stored after
  // a call, because a forked process copies the object without the thread.
  void end_second_thread() { second_.reset(); }

  // b, x: 3n each; x may be b. Throws std::logic_error without factors. Uses a work space of the
  // object, so calls must not overlap.
  void solve(const double* b, double* x) const;
  void solve_transposed(const double* b, double* x) const;

  // Solves with iterative refinement (Wilkinson 1963) in double precision. It stops when the
  // residual is at most `tolerance` times b (largest entries), or no longer halves. pattern,
  // values: as factorised. x must not be b. Returns the relative residual.
  double solve_refined(const BlockPattern& pattern, const double* values, const double* b,
                       double tolerance, double* x) const;

  const BlockLUFigures& figures() const { return figures_; }

 private:
  using Factors =
      std::variant<std::unique_ptr<FrontFactors<double>>, std::unique_ptr<FrontFactors<float>>>;

  void measure();
  bool factorise(const double* values, bool definite);
  void solve(bool transposed, const double* b, double* x) const;

  Precision precision_;
  int threads_;
  std::function<void()> pause_;
  AssemblyTree tree_;
  Factors factors_;
  bool shared_ = false;  // between two threads
  std::unique_ptr<SecondThread> second_;
  // work space of the solves
  mutable std::vector<double> in_double_;
  mutable std::vector<float> in_single_;
  mutable std::vector<double> residual_, correction_;
  bool factorised_ = false;
  BlockLUFigures figures_;
};

}  // namespace codend
