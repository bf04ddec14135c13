#include "front_kernels.hpp"

// Windows is left out: GCC there misaligns 32-byte spills to the stack (GCC bug 54412).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(_WIN32)

// After every other header, so that only the kernels of this file use these instructions.
#pragma GCC target("avx2,fma")

namespace codend {

namespace {

bool runs_here() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

namespace in_double {
using Real = double;
constexpr int lanes = 4;
#include "front_kernels.inl"
}  // namespace in_double

namespace in_single {
using Real = float;
constexpr int lanes = 8;
#include "front_kernels.inl"
}  // namespace in_single

}  // namespace

template <>
const FrontKernels<double>* avx2_front_kernels<double>() {
  return runs_here() ? &in_double::kernels : nullptr;
}

template <>
const FrontKernels<float>* avx2_front_kernels<float>() {
  return runs_here() ? &in_single::kernels : nullptr;
}

}  // namespace codend

#else

namespace codend {

template <>
const FrontKernels<double>* avx2_front_kernels<double>() {
  return nullptr;
}

template <>
const FrontKernels<float>* avx2_front_kernels<float>() {
  return nullptr;
}

}  // namespace codend

#endif
