#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "../base/block_pattern.hpp"
#include "assembly_tree.hpp"
#include "front_kernels.hpp"
#include "large_store.hpp"
#include "second_thread.hpp"

namespace codend {

// Memory that a vector holds.
template <class T>
std::int64_t bytes_of(const std::vector<T>& v) {
  return static_cast<std::int64_t>(v.capacity() * sizeof(T));
}

// Which fronts are worked off by which of two threads, each list in turn: whole subtrees by one or
// the other, then what lies above them by both together. One thread has it all above.
struct Shares {
  std::array<std::vector<int>, 2> subtrees;
  std::vector<int> above;
  std::vector<char> handed_over;  // per front: the root of a subtree, its parent above
};

Shares share_fronts(const AssemblyTree& tree, int threads);

// L and U of the fronts of a tree, in Real (double or float): the numeric part of BlockLU.
template <class Real>
class FrontFactors {
 public:
  // The tree must outlive the factors.
  FrontFactors(const BlockPattern& pattern, const AssemblyTree& tree, int threads);

  // As BlockLU::leave_out().
  void leave_out(const std::vector<char>& nodes);
  // As BlockLU::factorise(). second: null for one thread.
  bool factorise(const double* values, bool definite, SecondThread* second,
                 const std::function<void()>& pause);
  // Right side and solution in the order of elimination, 3 per node, in place.
  void solve(Real* x) const;
  // With the transposed matrix.
  void solve_transposed(Real* x) const;

  int64_t stack_entries() const { return stack_.size(); }
  int largest_front() const { return static_cast<int>(local_.size()); }
  int64_t bytes() const;

 private:
  // One 3x3 block of the matrix on its way into a front.
  struct Entry {
    int from;  // its place in the pattern
    int to;    // from where the front's A11 and A21 begin, or A12
  };

  struct Layout {
    int64_t lower;        // in factor_
    int64_t upper;        // in factor_
    int64_t update;       // in stack_
    int64_t first_entry;  // in entry_: first those of A11 and A21, then those of A12
    int64_t first_upper_entry;
  };

  struct Work;

  void lay_out_factors();
  void lay_out_stack();
  void map_entries(const BlockPattern& pattern);
  bool factorise_front(int front, const double* values, bool definite, const Sharing* sharing);
  void gather(const Real* x, int front) const;  // its part of x into local_
  void scatter(Real* x, int front) const;       // and back

  const AssemblyTree& tree_;
  Shares shares_;
  std::vector<Layout> layout_;
  std::vector<Entry> entry_;
  std::vector<int> exchange_;
  std::vector<char> idle_;  // per front: it and all below it have only nodes that are left out
  // A front clears its own, so that the analysis touches none.
  LargeStore<Real> factor_, stack_;
  std::vector<Real> reciprocal_;
  mutable std::vector<Real> local_;  // work space of solve()
};

}  // namespace codend
