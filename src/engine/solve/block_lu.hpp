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

// What a factorisation costs; known once the pattern is analysed.
struct BlockLUFigures {
  int fronts = 0;
  int largest_front = 0;       // rows of the largest front, in scalars
  int64_t factor_entries = 0;  // numbers stored for L and U
  int64_t stack_entries = 0;   // numbers of the stack of update matrices
  double flops = 0;            // multiplications and additions of one factorisation
  int64_t bytes = 0;           // held by the object, all told
};

enum class Precision { double_precision, single_precision };

// Direct solver for A x = b, A sparse, of 3x3 blocks, nonsymmetric in values and symmetric in
// structure: multifrontal LU (Duff and Reid 1983) over a nested dissection of the nodes, pivoting
// only among the rows that a front eliminates. Neither factorise() nor a solve allocates. Equal
// input gives equal bytes on one machine, whatever the number of threads.
class BlockLU {
 public:
  // precision: of the factors. In single precision they take half the memory and about 0.6 of the
  // time; use solve_refined() then. Denormal numbers in them count as zero.
  // threads: 1 or 2. Patterns of little work get one thread, since they gain nothing from two.
  // Throws std::invalid_argument for other numbers.
  // pause: called on the calling thread by analyse() and factorise(), a few times in every second
  // that they take. What it throws ends them and leaves no factors.
  explicit BlockLU(Precision precision = Precision::double_precision, int threads = 1,
                   std::function<void()> pause = {});

  // Orders the nodes and lays out the factors, once per pattern.
  // coordinates: 3n doubles, x y z of each node; they guide the order, and nodes may coincide.
  // Throws std::invalid_argument if the pattern is not sorted, symmetric and full on the diagonal.
  void analyse(const BlockPattern& pattern, const double* coordinates);

  // Nodes to be left out, 1 each, or none: their rows must have no entries but on the diagonal block and
  // right sides must be zero there; so is then the solution. Fronts that have no other nodes cost
  // nothing. Drops the factors.
  void leave_out(const std::vector<char>& nodes);

  // values: 9 doubles per block, row-major inside a block, in the order of the pattern's columns.
  // Returns false at a pivot that is not finite, or zero, or too small to have a reciprocal; there
  // are then no factors to solve with.
  bool factorise(const double* values);
  // The same without exchanging rows, for a symmetric matrix: false also where it is not positive
  // definite, but for what rounding hides. Factors of values that are not symmetric may be poor.
  bool factorise_definite(const double* values);

  // Ends the second thread; factorise() starts another. For objects that are kept after a call: a
  // process that is forked has a copy of the object, but no such thread to wait for.
  void end_second_thread() { second_.reset(); }

  // b, x: 3n doubles each; x may be b. Throws std::logic_error without factors. Uses the object's
  // own work space: one call at a time.
  void solve(const double* b, double* x) const;
  // The same for the transposed matrix.
  void solve_transposed(const double* b, double* x) const;

  // solve(), then iterative refinement (Wilkinson 1963) in double precision until the residual is
  // at most `tolerance` times b, both by their largest entry, or no longer halves. pattern, values:
  // those of the factors. x may not be b. Returns the residual reached, relative to b.
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
