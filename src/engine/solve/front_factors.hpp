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

template <class T>
std::int64_t bytes_of(const std::vector<T>& v) {
  return static_cast<std::int64_t>(v.capacity() * sizeof(T));
}

// Distribution of fronts to two threads, each list in order. Each thread factorises complete
// subtrees; then both share the fronts above. With one thread, all fronts are in `above`.
struct Shares {
  std::array<std::vector<int>, 2> subtrees;
  std::vector<int> above;
  std::vector<char> handed_over;  // per front: 1 for a subtree's root with its parent in `above`
};

Shares share_fronts(const AssemblyTree& tree, int threads);

// L and U of the fronts of a tree in Real (double or float): the numeric part of BlockLU.
template <class Real>
class FrontFactors {
 public:
  // The tree must outlive the factors.
  FrontFactors(const BlockPattern& pattern, const AssemblyTree& tree, int threads);

  // See BlockLU::leave_out().
  void leave_out(const std::vector<char>& nodes);
  // See BlockLU::factorise(). second: null for one thread.
  bool factorise(const double* values, bool definite, SecondThread* second,
                 const std::function<void()>& pause);
  // x: right side and solution in the order of elimination, 3 per node.
  void solve(Real* x) const;
  void solve_transposed(Real* x) const;

  int64_t stack_entries() const { return stack_.size(); }
  int largest_front() const { return static_cast<int>(local_.size()); }
  int64_t bytes() const;

 private:
  // Destination of one 3x3 block in a front.
  struct Entry {
    int from;  // index in the pattern
    int to;    // offset in the front's A11 and A21, or in A12
  };

  struct Layout {
    int64_t lower;        // in factor_
    int64_t upper;        // in factor_
    int64_t update;       // in stack_
    int64_t first_entry;  // in entry_: entries of A11 and A21, then of A12
    int64_t first_upper_entry;
  };

  struct Work;

  void lay_out_factors();
  void lay_out_stack();
  void map_entries(const BlockPattern& pattern);
  bool factorise_front(int front, const double* values, bool definite, const Sharing* sharing);
  void gather(const Real* x, int front) const;  // copies the front's part of x into local_
  void scatter(Real* x, int front) const;       // and back

  const AssemblyTree& tree_;
  Shares shares_;
  std::vector<Layout> layout_;
  std::vector<Entry> entry_;
  std::vector<int> exchange_;
  std::vector<char> idle_;  // per front: 1 if its subtree has only excluded nodes
  // Not initialised here: each front clears its own part.
  LargeStore<Real> factor_, stack_;
  std::vector<Real> reciprocal_;
  mutable std::vector<Real> local_;  // work space of solve()
};

}  // namespace codend
