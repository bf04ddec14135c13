#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace codend {

// Uninitialised array, aligned to cache lines. Large arrays use huge pages if available, because
// mapping millions of numbers in 4 kB pages takes longer than clearing them.
template <class Real>
class LargeStore {
 public:
  // Drops the contents. Throws std::bad_alloc.
  void resize(std::int64_t to) {
    data_.reset();
    size_ = to;
    const std::size_t bytes = static_cast<std::size_t>(to) * sizeof(Real);
    const std::size_t align = bytes < 2 * large_page ? cache_line : large_page;
    const std::size_t whole = (bytes + align - 1) / align * align;
    data_ = {static_cast<Real*>(::operator new(whole, std::align_val_t(align))), {align}};
#if defined(__linux__)
    if (align == large_page) madvise(data_.get(), whole, MADV_HUGEPAGE);
#endif
  }
  Real* get() const { return data_.get(); }
  std::int64_t size() const { return size_; }

 private:
  static constexpr std::size_t cache_line = 64, large_page = std::size_t(1) << 21;  // bytes

  struct Release {
    std::size_t align = cache_line;
    void operator()(Real* data) const { ::operator delete(data, std::align_val_t(align)); }
  };
  std::unique_ptr<Real, Release> data_;
  std::int64_t size_ = 0;
};

}  // namespace codend
