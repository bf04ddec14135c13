#include "front_kernels.hpp"

// Not for Windows, where GCC misaligns register spills to the stack (GCC bug 54412).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(_WIN32)

// After all other headers, so that only the kernels in this file use these instructions.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif

namespace codend {

namespace {

bool runs_here() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

namespace in_double {
using Real = double;
constexpr int lanes = 4, across = 1;
#include "front_kernels.inl"
}  // namespace in_double

namespace in_single {
using Real = float;
constexpr int lanes = 8, across = 1;
#include "front_kernels.inl"
}  // namespace in_single

constexpr FrontKernelSet set{in_double::kernels, in_single::kernels};

}  // namespace

const FrontKernelSet* avx2_front_kernels() { return runs_here() ? &set : nullptr; }

}  // namespace codend

#ifdef __clang__
#pragma clang attribute pop
#endif

#else

namespace codend {

const FrontKernelSet* avx2_front_kernels() { return nullptr; }

}  // namespace codend

#endif
