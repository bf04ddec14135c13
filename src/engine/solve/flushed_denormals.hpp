#pragma once

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace codend {

// Returns the control word of the thread's floating-point unit, or 0 for an unknown processor. It
// controls denormal numbers, which slow many processors down severely.
inline std::uint64_t floating_point_control() {
#if defined(__SSE2__) || defined(_M_X64)
  return _mm_getcsr();
#elif defined(__aarch64__) && defined(__GNUC__)
  std::uint64_t control;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(control));
  return control;
#else
  return 0;
#endif
}

inline void set_floating_point_control(std::uint64_t control) {
#if defined(__SSE2__) || defined(_M_X64)
  _mm_setcsr(static_cast<unsigned>(control));
#elif defined(__aarch64__) && defined(__GNUC__)
  __asm__ __volatile__("msr fpcr, %0" : : "r"(control));
#else
  (void)control;
#endif
}

// Treats denormal numbers as zero in the constructing thread, for the lifetime of the object.
class FlushedDenormals {
 public:
  FlushedDenormals() : before_(floating_point_control()) {
    set_floating_point_control(before_ | flush);
  }
  ~FlushedDenormals() { set_floating_point_control(before_); }
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
#if defined(__SSE2__) || defined(_M_X64)
  static constexpr std::uint64_t flush = 0x8040;  // flush to zero, denormals are zeros
#elif defined(__aarch64__)
  static constexpr std::uint64_t flush = std::uint64_t(1) << 24;  // FZ
#else
  static constexpr std::uint64_t flush = 0;
#endif
  std::uint64_t before_;
};

}  // namespace codend
