#include "../base/pi.hpp"
#include "line_kernels.hpp"

// Not on Windows: GCC misaligns spills of AVX registers to the stack there (GCC bug 54412).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(_WIN32)

#include <immintrin.h>

// After all other headers, so that only the kernels of this file use these instructions.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif

namespace codend {

namespace {

constexpr int lanes = 4;

#include "line_kernels.inl"

Pack root(Pack x) { return _mm256_sqrt_pd(x); }

void store_across(Pack a, Pack b, Pack c, Pack d, double* out, int step) {
  const Pack ab_even = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
  const Pack cd_even = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
  store(out, _mm256_permute2f128_pd(ab_even, cd_even, 0x20));
  store(out + step, _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20));
  store(out + 2 * step, _mm256_permute2f128_pd(ab_even, cd_even, 0x31));
  store(out + 3 * step, _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31));
}

}  // namespace

const LineKernels* avx2_line_kernels() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kernels : nullptr;
}

}  // namespace codend

#ifdef __clang__
#pragma clang attribute pop
#endif

#else

const codend::LineKernels* codend::avx2_line_kernels() { return nullptr; }

#endif
