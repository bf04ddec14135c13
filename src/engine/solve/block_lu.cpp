#include "block_lu.hpp"

#include <algorithm>
#include <stdexcept>

#include "front_kernels.hpp"

namespace codend {

namespace {

// Columns start on a cache line where a front begins.
int64_t aligned(int64_t doubles) { return (doubles + 7) / 8 * 8; }

template <class T>
int64_t bytes_of(const std::vector<T>& v) {
  return static_cast<int64_t>(v.capacity() * sizeof(T));
}

// For each entry of the pattern, the entry that mirrors it.
std::vector<int64_t> mirror_entries(const BlockPattern& pattern) {
  std::vector<int64_t> mirror(pattern.column.size());
  std::vector<int64_t> next(pattern.row_start.begin(), pattern.row_start.end() - 1);
  for (size_t e = 0; e < mirror.size(); ++e) mirror[e] = next[pattern.column[e]]++;
  return mirror;
}

}  // namespace

void BlockLU::analyse(const BlockPattern& pattern, const double* coordinates) {
  check_pattern(pattern);
  factorised_ = false;
  tree_ = assembly_tree(pattern, nested_dissection(pattern, coordinates));
  lay_out_factors();
  lay_out_stack();
  map_entries(pattern);
  measure();
}

void BlockLU::lay_out_factors() {
  layout_.assign(tree_.fronts(), {});
  int64_t size = 0;
  for (int f = 0; f < tree_.fronts(); ++f) {
    const int64_t k = 3 * tree_.pivots(f), rows = padded(3 * tree_.boundary_nodes(f));
    layout_[f].lower = size;
    size += aligned((k + rows) * k);
    layout_[f].upper = size;
    size += aligned(rows * k);
  }
  factor_.resize(size);
  const size_t rows = 3 * tree_.order.size();
  reciprocal_.assign(rows, 0);
  exchange_.assign(rows, 0);
  ordered_.assign(rows, 0);
}

// Update matrices of odd and even generations grow from opposite ends of the stack: a front then
// builds its own at one end while its children's lie on top of the other.
void BlockLU::lay_out_stack() {
  const int fronts = tree_.fronts();
  std::vector<int> end(fronts);
  for (int f = fronts - 1; f >= 0; --f) end[f] = tree_.parent[f] < 0 ? 0 : 1 - end[tree_.parent[f]];
  int64_t height[2] = {0, 0};
  int64_t size = 0;
  const auto update_size = [&](int f) {
    const int64_t b = 3 * tree_.boundary_nodes(f);
    return aligned(padded(static_cast<int>(b)) * b);
  };
  for (int f = 0; f < fronts; ++f) {
    layout_[f].update = height[end[f]];
    height[end[f]] += update_size(f);
    size = std::max(size, height[0] + height[1]);
    for (int c = tree_.first_child[f]; c < tree_.first_child[f + 1]; ++c)
      height[1 - end[f]] -= update_size(tree_.child[c]);
  }
  for (int f = 0; f < fronts; ++f)
    if (end[f] == 1) layout_[f].update = size - layout_[f].update - update_size(f);
  stack_.resize(size);
}

void BlockLU::map_entries(const BlockPattern& pattern) {
  const std::vector<int64_t> mirror = mirror_entries(pattern);
  entry_.clear();
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
    const int64_t upper_step = padded(3 * boundary), lower_step = 3 * pivots + upper_step;
    layout_[f].first_entry = static_cast<int64_t>(entry_.size());
    upper.clear();
    for (int p = first; p < last; ++p) {
      const int node = tree_.order[p];
      const int64_t mine = 3 * (p - first);
      for (int64_t e = pattern.row_start[node]; e < pattern.row_start[node + 1]; ++e) {
        const int q = tree_.position[pattern.column[e]];
        if (q < first) continue;
        const int64_t other = 3 * place[q];
        // down column `mine`: in A11 or A21
        entry_.push_back({9 * mirror[e], layout_[f].lower + other + mine * lower_step});
        if (q >= last)
          upper.push_back({9 * e, layout_[f].upper + other - 3 * pivots + mine * upper_step});
      }
    }
    layout_[f].first_upper_entry = static_cast<int64_t>(entry_.size());
    entry_.insert(entry_.end(), upper.begin(), upper.end());
    rows = std::max(rows, 3 * (pivots + boundary));
  }
  local_.assign(rows, 0);
}

void BlockLU::measure() {
  figures_ = {};
  figures_.fronts = tree_.fronts();
  figures_.largest_front = static_cast<int>(local_.size());
  figures_.stack_entries = stack_.size();
  for (int f = 0; f < tree_.fronts(); ++f) {
    const double k = 3.0 * tree_.pivots(f), b = 3.0 * tree_.boundary_nodes(f);
    figures_.factor_entries += static_cast<int64_t>(k * (k + 2 * b));
    figures_.flops += 2 * (k * k * k / 3 + k * k * b + k * b * b);
  }
  figures_.bytes = bytes_of(layout_) + bytes_of(entry_) + bytes_of(exchange_) + 8 * (factor_.size() + stack_.size()) +
                   bytes_of(reciprocal_) + bytes_of(ordered_) +
                   bytes_of(local_) + bytes_of(tree_.order) + bytes_of(tree_.position) +
                   bytes_of(tree_.first_pivot) + bytes_of(tree_.parent) +
                   bytes_of(tree_.first_boundary) + bytes_of(tree_.boundary) +
                   bytes_of(tree_.first_child) + bytes_of(tree_.child) +
                   bytes_of(tree_.first_run) + bytes_of(tree_.run);
}

bool BlockLU::factorise(const double* values) {
  const FrontKernels& kernels = front_kernels();
  factorised_ = false;
  for (int f = 0; f < tree_.fronts(); ++f) {
    const Layout& at = layout_[f];
    const int k = 3 * tree_.pivots(f), b = 3 * tree_.boundary_nodes(f);
    const int64_t upper_step = padded(b), lower_step = k + upper_step;
    const Front front{k,
                      b,
                      factor_.data() + at.lower,
                      factor_.data() + at.upper,
                      stack_.data() + at.update,
                      reciprocal_.data() + 3 * static_cast<int64_t>(tree_.first_pivot[f]),
                      exchange_.data() + 3 * static_cast<int64_t>(tree_.first_pivot[f])};
    std::fill_n(front.lower, lower_step * k, 0.0);
    std::fill_n(front.upper, upper_step * k, 0.0);
    std::fill_n(front.update, upper_step * b, 0.0);

    const int64_t end = f + 1 < tree_.fronts() ? layout_[f + 1].first_entry
                                               : static_cast<int64_t>(entry_.size());
    for (int64_t e = at.first_entry; e < at.first_upper_entry; ++e) {
      const double* block = values + entry_[e].from;
      double* to = factor_.data() + entry_[e].to;
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) to[i + j * lower_step] = block[3 * i + j];
    }
    for (int64_t e = at.first_upper_entry; e < end; ++e) {
      const double* block = values + entry_[e].from;
      double* to = factor_.data() + entry_[e].to;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) to[j + i * upper_step] = block[3 * i + j];
    }
    for (int c = tree_.first_child[f]; c < tree_.first_child[f + 1]; ++c) {
      const int child = tree_.child[c];
      kernels.extend_add(stack_.data() + layout_[child].update, 3 * tree_.boundary_nodes(child),
                         tree_.run.data() + tree_.first_run[child],
                         tree_.run.data() + tree_.first_run[child + 1], front);
    }
    if (!kernels.factorise(front)) return false;
  }
  factorised_ = true;
  return true;
}

void BlockLU::solve(const double* b, double* x) const {
  if (!factorised_) throw std::logic_error("block LU: no factors to solve with");
  const FrontKernels& kernels = front_kernels();
  const int64_t n = static_cast<int64_t>(tree_.order.size());
  for (int64_t p = 0; p < n; ++p)
    std::copy_n(b + 3 * static_cast<int64_t>(tree_.order[p]), 3, &ordered_[3 * p]);
  for (int f = 0; f < tree_.fronts(); ++f) {
    const int pivots = 3 * tree_.pivots(f), boundary = 3 * tree_.boundary_nodes(f);
    const int64_t first = 3 * static_cast<int64_t>(tree_.first_pivot[f]);
    gather(f);
    kernels.forward(pivots, boundary, factor_.data() + layout_[f].lower, exchange_.data() + first,
                    local_.data());
    std::copy_n(local_.data(), pivots, ordered_.data() + first);
    const int* outside = tree_.boundary.data() + tree_.first_boundary[f];
    for (int i = 0; i < boundary / 3; ++i)
      std::copy_n(&local_[pivots + 3 * i], 3, &ordered_[3 * static_cast<int64_t>(outside[i])]);
  }
  for (int f = tree_.fronts() - 1; f >= 0; --f) {
    const int pivots = 3 * tree_.pivots(f), boundary = 3 * tree_.boundary_nodes(f);
    const int64_t first = 3 * static_cast<int64_t>(tree_.first_pivot[f]);
    gather(f);
    kernels.backward(pivots, boundary, factor_.data() + layout_[f].lower,
                     factor_.data() + layout_[f].upper, reciprocal_.data() + first, local_.data());
    std::copy_n(local_.data(), pivots, ordered_.data() + first);
  }
  for (int64_t p = 0; p < n; ++p)
    std::copy_n(&ordered_[3 * p], 3, x + 3 * static_cast<int64_t>(tree_.order[p]));
}

void BlockLU::gather(int f) const {
  const int pivots = 3 * tree_.pivots(f), boundary = tree_.boundary_nodes(f);
  const int* outside = tree_.boundary.data() + tree_.first_boundary[f];
  std::copy_n(&ordered_[3 * static_cast<int64_t>(tree_.first_pivot[f])], pivots, local_.data());
  for (int i = 0; i < boundary; ++i)
    std::copy_n(&ordered_[3 * static_cast<int64_t>(outside[i])], 3, &local_[pivots + 3 * i]);
}

}  // namespace codend
