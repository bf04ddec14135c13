#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assembly_tree.hpp"
#include "ordering.hpp"

namespace codend {

// What a factorisation costs; known once the pattern is analysed.
struct BlockLUFigures {
  int fronts = 0;
  int largest_front = 0;       // rows of the largest front, in scalars
  int64_t factor_entries = 0;  // doubles stored for L and U
  int64_t stack_entries = 0;   // doubles of the stack of update matrices
  double flops = 0;            // multiplications and additions of one factorisation
  int64_t bytes = 0;           // held by the object, all told
};

// Direct solver for A x = b, A sparse, of 3x3 blocks, nonsymmetric in values and symmetric in
// structure: multifrontal LU (Duff and Reid 1983) over a nested dissection of the nodes, pivoting
// only among the rows that a front eliminates. Neither factorise() nor solve() allocates. Equal
// input gives equal bytes on one machine.
class BlockLU {
 public:
  // Orders the nodes and lays out the factors, once per pattern.
  // coordinates: 3n doubles, x y z of each node; they guide the order, and nodes may coincide.
  // Throws std::invalid_argument if the pattern is not sorted, symmetric and full on the diagonal.
  void analyse(const BlockPattern& pattern, const double* coordinates);

  // values: 9 doubles per block, row-major inside a block, in the order of the pattern's columns.
  // Returns false at a pivot that is not finite, or zero, or too small to have a reciprocal; there
  // are then no factors to solve with.
  bool factorise(const double* values);

  // b, x: 3n doubles each; x may be b. Throws std::logic_error without factors. Uses the object's
  // own work space: one call at a time.
  void solve(const double* b, double* x) const;

  const BlockLUFigures& figures() const { return figures_; }

 private:
  // One 3x3 block of the matrix on its way into a front.
  struct Entry {
    int64_t from;  // first of its 9 values
    int64_t to;    // in factor_
  };

  // Doubles that nobody has set: a front clears its own, so that the analysis touches none.
  class Store {
   public:
    void resize(int64_t size) {
      data_.reset();
      data_.reset(new double[size]);
      size_ = size;
    }
    double* data() const { return data_.get(); }
    int64_t size() const { return size_; }

   private:
    std::unique_ptr<double[]> data_;
    int64_t size_ = 0;
  };

  struct Layout {
    int64_t lower;        // in factor_
    int64_t upper;        // in factor_
    int64_t update;       // in stack_
    int64_t first_entry;  // in entry_: first those of A11 and A21, then those of A12
    int64_t first_upper_entry;
  };

  void lay_out_factors();
  void lay_out_stack();
  void map_entries(const BlockPattern& pattern);
  void measure();
  void gather(int front) const;  // its part of ordered_ into local_

  AssemblyTree tree_;
  std::vector<Layout> layout_;
  std::vector<Entry> entry_;
  std::vector<int> exchange_;
  Store factor_, stack_;
  std::vector<double> reciprocal_;
  mutable std::vector<double> ordered_, local_;  // work space of solve()
  bool factorised_ = false;
  BlockLUFigures figures_;
};

}  // namespace codend
