#include "front_factors.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <numeric>

namespace codend {

namespace {

// Aligns the columns of each front to cache lines.
template <class Real>
int64_t aligned(int64_t numbers) {
  constexpr int64_t line = 64 / sizeof(Real);
  return (numbers + line - 1) / line * line;
}

// Balanced load of two threads: the difference is at most this fraction of the subtrees' work.
constexpr double even_enough = 0.03;
// Multiplications and additions between two pauses: some hundredths of a second.
constexpr double flops_to_pause = 1e9;
// Subtrees are not split below this fraction of all work.
constexpr double least_subtree = 0.01;

}  // namespace

Shares share_fronts(const AssemblyTree& tree, int threads) {
  const int fronts = tree.fronts();
  Shares shares;
  shares.handed_over.assign(fronts, 0);
  std::vector<signed char> by(fronts, -1);  // thread, or -1 above
  if (threads > 1) {
    std::vector<double> work(fronts, 0);
    double total = 0;
    for (int f = 0; f < fronts; ++f) {
      work[f] += tree.flops(f);
      (tree.parent[f] >= 0 ? work[tree.parent[f]] : total) += work[f];
    }
    const auto less = [&](int a, int b) {
      return work[a] < work[b] || (work[a] == work[b] && a < b);
    };
    std::vector<int> subtree;  // a heap, the largest first
    for (int f = 0; f < fronts; ++f)
      if (tree.parent[f] < 0) subtree.push_back(f);
    std::make_heap(subtree.begin(), subtree.end(), less);
    const auto deal = [&] {
      std::vector<int> sorted = subtree;
      std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return less(b, a); });
      std::array<double, 2> load{0, 0};
      for (const int f : sorted) {
        const int thread = load[1] < load[0];
        by[f] = static_cast<signed char>(thread);
        load[thread] += work[f];
      }
      return std::max(load[0], load[1]) - std::min(load[0], load[1]) <=
             even_enough * (load[0] + load[1]);
    };
    while (!deal() && !subtree.empty() && work[subtree.front()] > least_subtree * total) {
      std::pop_heap(subtree.begin(), subtree.end(), less);
      const int split = subtree.back();
      subtree.pop_back();
      by[split] = -1;
      for (int c = tree.first_child[split]; c < tree.first_child[split + 1]; ++c) {
        subtree.push_back(tree.child[c]);
        std::push_heap(subtree.begin(), subtree.end(), less);
      }
    }
    for (const int f : subtree) shares.handed_over[f] = 1;
    for (int f = fronts - 1; f >= 0; --f)
      if (by[f] < 0 && tree.parent[f] >= 0) by[f] = by[tree.parent[f]];
  }
  for (int f = 0; f < fronts; ++f) (by[f] < 0 ? shares.above : shares.subtrees[by[f]]).push_back(f);
  return shares;
}

template <class Real>
FrontFactors<Real>::FrontFactors(const BlockPattern& pattern, const AssemblyTree& tree, int threads)
    : tree_(tree), shares_(share_fronts(tree, threads)) {
  lay_out_factors();
  lay_out_stack();
  map_entries(pattern);
}

template <class Real>
void FrontFactors<Real>::leave_out(const std::vector<char>& nodes) {
  std::fill(idle_.begin(), idle_.end(), 0);
  if (nodes.empty()) return;
  for (int f = 0; f < tree_.fronts(); ++f) {
    bool idle = true;
    for (int p = tree_.first_pivot[f]; p < tree_.first_pivot[f + 1]; ++p) {
      idle = idle && nodes[tree_.order[p]];
    }
    for (int c = tree_.first_child[f]; c < tree_.first_child[f + 1]; ++c) {
      idle = idle && idle_[tree_.child[c]];
    }
    idle_[f] = idle;
  }
}

template <class Real>
void FrontFactors<Real>::lay_out_factors() {
  layout_.assign(tree_.fronts(), {});
  idle_.assign(tree_.fronts(), 0);
  int64_t size = 0;
  for (int f = 0; f < tree_.fronts(); ++f) {
    const int64_t k = 3 * tree_.pivots(f), rows = padded<Real>(3 * tree_.boundary_nodes(f));
    layout_[f].lower = size;
    size += aligned<Real>((k + rows) * k);
    layout_[f].upper = size;
    size += aligned<Real>(rows * k);
  }
  factor_.resize(size);
  const size_t rows = 3 * tree_.order.size();
  reciprocal_.assign(rows, 0);
  exchange_.assign(rows, 0);
}

// Update matrices of odd and even generations grow from opposite ends of a stack, because a front
// builds its matrix while it reads its children's. Each thread has a separate stack; the fronts
// above reuse this memory. Matrices handed over between threads are stored separately.
template <class Real>
void FrontFactors<Real>::lay_out_stack() {
  const int fronts = tree_.fronts();
  std::vector<int> end(fronts);
  for (int f = fronts - 1; f >= 0; --f) end[f] = tree_.parent[f] < 0 ? 0 : 1 - end[tree_.parent[f]];
  const auto update_size = [&](int f) {
    const int b = 3 * tree_.boundary_nodes(f);
    return aligned<Real>(static_cast<int64_t>(padded<Real>(b)) * b);
  };
  int64_t base = 0, top = 0;
  for (const std::vector<int>* list :
       {&shares_.subtrees[0], &shares_.subtrees[1], &shares_.above}) {
    if (list == &shares_.above) base = 0;
    int64_t height[2] = {0, 0};
    int64_t size = 0;
    for (const int f : *list) {
      if (!shares_.handed_over[f]) {
        layout_[f].update = height[end[f]];
        height[end[f]] += update_size(f);
        size = std::max(size, height[0] + height[1]);
      }
      for (int c = tree_.first_child[f]; c < tree_.first_child[f + 1]; ++c)
        if (!shares_.handed_over[tree_.child[c]]) height[1 - end[f]] -= update_size(tree_.child[c]);
    }
    for (const int f : *list)
      if (!shares_.handed_over[f])
        layout_[f].update =
            base + (end[f] == 0 ? layout_[f].update : size - layout_[f].update - update_size(f));
    base += size;
    top = std::max(top, base);
  }
  for (int f = 0; f < fronts; ++f)
    if (shares_.handed_over[f]) {
      layout_[f].update = top;
      top += update_size(f);
    }
  stack_.resize(top);
}

template <class Real>
void FrontFactors<Real>::map_entries(const BlockPattern& pattern) {
  const std::vector<int64_t> mirror = mirror_entries(pattern);
  entry_.reserve(pattern.column.size());
  std::vector<int> place(pattern.n);
  std::vector<Entry> upper;
  int rows = 0;
  for (int f = 0; f < tree_.fronts(); ++f) {
    const int first = tree_.first_pivot[f], last = tree_.first_pivot[f + 1];
    const int pivots = tree_.pivots(f), boundary = tree_.boundary_nodes(f);
    for (int p = first; p < last; ++p) place[p] = p - first;
    for (int i = 0; i < boundary; ++i)
      place[tree_.boundary[tree_.first_boundary[f] + i]] = pivots + i;
    const int64_t upper_step = padded<Real>(3 * boundary), lower_step = 3 * pivots + upper_step;
    layout_[f].first_entry = static_cast<int64_t>(entry_.size());
    upper.clear();
    for (int p = first; p < last; ++p) {
      const int node = tree_.order[p];
      const int64_t mine = 3 * (p - first);
      for (int64_t e = pattern.row_start[node]; e < pattern.row_start[node + 1]; ++e) {
        const int q = tree_.position[pattern.column[e]];
        if (q < first) continue;
        const int64_t other = 3 * place[q];
        // column `mine` of A11 or A21
        entry_.push_back(
            {static_cast<int>(mirror[e]), static_cast<int>(other + mine * lower_step)});
        if (q >= last)
          upper.push_back(
              {static_cast<int>(e), static_cast<int>(other - 3 * pivots + mine * upper_step)});
      }
    }
    layout_[f].first_upper_entry = static_cast<int64_t>(entry_.size());
    entry_.insert(entry_.end(), upper.begin(), upper.end());
    rows = std::max(rows, 3 * (pivots + boundary));
  }
  local_.assign(rows, 0);
}

template <class Real>
int64_t FrontFactors<Real>::bytes() const {
  return bytes_of(layout_) + bytes_of(entry_) + bytes_of(exchange_) + bytes_of(reciprocal_) +
         bytes_of(idle_) + bytes_of(local_) +
         static_cast<int64_t>(sizeof(Real)) * (factor_.size() + stack_.size()) +
         bytes_of(shares_.above) + bytes_of(shares_.subtrees[0]) + bytes_of(shares_.subtrees[1]) +
         bytes_of(shares_.handed_over);
}

template <class Real>
bool FrontFactors<Real>::factorise_front(int f, const double* values, bool definite,
                                         const Sharing* sharing) {
  if (idle_[f]) return true;
  const FrontKernels<Real>& kernels = front_kernels<Real>();
  const Layout& at = layout_[f];
  const int k = 3 * tree_.pivots(f), b = 3 * tree_.boundary_nodes(f);
  const int64_t upper_step = padded<Real>(b), lower_step = k + upper_step;
  const int64_t first = 3 * static_cast<int64_t>(tree_.first_pivot[f]);
  const Front<Real> front{k,
                          b,
                          factor_.get() + at.lower,
                          factor_.get() + at.upper,
                          stack_.get() + at.update,
                          reciprocal_.data() + first,
                          exchange_.data() + first,
                          tree_.first_child[f] == tree_.first_child[f + 1],
                          definite};
  std::fill_n(front.lower, lower_step * k, Real(0));
  std::fill_n(front.upper, upper_step * k, Real(0));
  if (!front.fresh) std::fill_n(front.update, upper_step * b, Real(0));

  const int64_t end =
      f + 1 < tree_.fronts() ? layout_[f + 1].first_entry : static_cast<int64_t>(entry_.size());
  for (int64_t e = at.first_entry; e < at.first_upper_entry; ++e) {
    const double* block = values + 9 * static_cast<int64_t>(entry_[e].from);
    Real* to = front.lower + entry_[e].to;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) to[i + j * lower_step] = static_cast<Real>(block[3 * i + j]);
  }
  for (int64_t e = at.first_upper_entry; e < end; ++e) {
    const double* block = values + 9 * static_cast<int64_t>(entry_[e].from);
    Real* to = front.upper + entry_[e].to;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) to[j + i * upper_step] = static_cast<Real>(block[3 * i + j]);
  }
  for (int c = tree_.first_child[f]; c < tree_.first_child[f + 1]; ++c) {
    const int child = tree_.child[c];
    if (idle_[child]) continue;
    kernels.extend_add(stack_.get() + layout_[child].update, 3 * tree_.boundary_nodes(child),
                       tree_.run.data() + tree_.first_run[child],
                       tree_.run.data() + tree_.first_run[child + 1], front);
  }
  return kernels.factorise(front, sharing);
}

template <class Real>
struct FrontFactors<Real>::Work {
  FrontFactors& factors;
  const double* values;
  bool definite;
  const std::function<void()>& pause;
  std::atomic<bool> over{false};  // after a failed front or an exception of `pause`
  std::exception_ptr thrown = nullptr;
  double done = 0;  // since the last pause, by the calling thread

  // Factorises a list of fronts in order, until a failure.
  void go_through(const std::vector<int>& fronts, const Sharing* sharing, bool pauses) {
    for (const int f : fronts) {
      if (over) return;
      if (!factors.factorise_front(f, values, definite, sharing)) over = true;
      if (pauses && pause) rest(factors.tree_.flops(f));
    }
  }

  void rest(double flops) {
    done += flops;
    if (done < flops_to_pause) return;
    done = 0;
    try {
      pause();
    } catch (...) {  // the other thread must finish first
      thrown = std::current_exception();
      over = true;
    }
  }

  static void part(void* self, int half) {
    Work& work = *static_cast<Work*>(self);
    work.go_through(work.factors.shares_.subtrees[half], nullptr, half == 0);
  }
};

template <class Real>
bool FrontFactors<Real>::factorise(const double* values, bool definite, SecondThread* second,
                                   const std::function<void()>& pause) {
  Sharing sharing{[](void* thread, void (*job)(void*, int), void* data) {
                    static_cast<SecondThread*>(thread)->run(job, data);
                  },
                  second};
  Work work{*this, values, definite, pause};
  if (second) second->run(&Work::part, &work);
  work.go_through(shares_.above, second ? &sharing : nullptr, true);
  if (work.thrown) std::rethrow_exception(work.thrown);
  return !work.over;
}

template <class Real>
void FrontFactors<Real>::solve(Real* x) const {
  const FrontKernels<Real>& kernels = front_kernels<Real>();
  for (int f = 0; f < tree_.fronts(); ++f) {
    if (idle_[f]) continue;
    gather(x, f);
    kernels.forward(
        3 * tree_.pivots(f), 3 * tree_.boundary_nodes(f), factor_.get() + layout_[f].lower,
        exchange_.data() + 3 * static_cast<int64_t>(tree_.first_pivot[f]), local_.data());
    scatter(x, f);
  }
  for (int f = tree_.fronts() - 1; f >= 0; --f) {
    if (idle_[f]) continue;
    const int64_t first = 3 * static_cast<int64_t>(tree_.first_pivot[f]);
    gather(x, f);
    kernels.backward(3 * tree_.pivots(f), 3 * tree_.boundary_nodes(f),
                     factor_.get() + layout_[f].lower, factor_.get() + layout_[f].upper,
                     reciprocal_.data() + first, local_.data());
    std::copy_n(local_.data(), 3 * tree_.pivots(f), x + first);
  }
}

template <class Real>
void FrontFactors<Real>::solve_transposed(Real* x) const {
  const FrontKernels<Real>& kernels = front_kernels<Real>();
  for (int f = 0; f < tree_.fronts(); ++f) {
    if (idle_[f]) continue;
    gather(x, f);
    kernels.forward_transposed(3 * tree_.pivots(f), 3 * tree_.boundary_nodes(f),
                               factor_.get() + layout_[f].lower, factor_.get() + layout_[f].upper,
                               reciprocal_.data() + 3 * static_cast<int64_t>(tree_.first_pivot[f]),
                               local_.data());
    scatter(x, f);
  }
  for (int f = tree_.fronts() - 1; f >= 0; --f) {
    if (idle_[f]) continue;
    const int64_t first = 3 * static_cast<int64_t>(tree_.first_pivot[f]);
    gather(x, f);
    kernels.backward_transposed(3 * tree_.pivots(f), 3 * tree_.boundary_nodes(f),
                                factor_.get() + layout_[f].lower, exchange_.data() + first,
                                local_.data());
    std::copy_n(local_.data(), 3 * tree_.pivots(f), x + first);
  }
}

template <class Real>
void FrontFactors<Real>::gather(const Real* x, int f) const {
  const int pivots = 3 * tree_.pivots(f), boundary = tree_.boundary_nodes(f);
  const int* outside = tree_.boundary.data() + tree_.first_boundary[f];
  std::copy_n(x + 3 * static_cast<int64_t>(tree_.first_pivot[f]), pivots, local_.data());
  Real* to = local_.data() + pivots;
  for (int i = 0; i < boundary; ++i, to += 3) {
    const Real* from = x + 3 * static_cast<int64_t>(outside[i]);
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  }
}

template <class Real>
void FrontFactors<Real>::scatter(Real* x, int f) const {
  const int pivots = 3 * tree_.pivots(f), boundary = tree_.boundary_nodes(f);
  std::copy_n(local_.data(), pivots, x + 3 * static_cast<int64_t>(tree_.first_pivot[f]));
  const int* outside = tree_.boundary.data() + tree_.first_boundary[f];
  const Real* from = local_.data() + pivots;
  for (int i = 0; i < boundary; ++i, from += 3) {
    Real* to = x + 3 * static_cast<int64_t>(outside[i]);
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  }
}

template class FrontFactors<double>;
template class FrontFactors<float>;

}  // namespace codend
