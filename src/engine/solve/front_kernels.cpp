#include "front_kernels.hpp"

namespace codend {

namespace {

// registers of 16 bytes: SSE2 and NEON; split by the compiler where there is neither
namespace in_double {
using Real = double;
constexpr int lanes = 2, across = 1;
#include "front_kernels.inl"
}  // namespace in_double

namespace in_single {
using Real = float;
constexpr int lanes = 4, across = 1;
#include "front_kernels.inl"
}  // namespace in_single

}  // namespace

template <>
const FrontKernels<double>& portable_front_kernels<double>() {
  return in_double::kernels;
}

template <>
const FrontKernels<float>& portable_front_kernels<float>() {
  return in_single::kernels;
}

template <>
const FrontKernels<double>& front_kernels<double>() {
  static const FrontKernels<double>* const widest = avx512_front_kernels<double>();
  static const FrontKernels<double>* const wide = avx2_front_kernels<double>();
  return widest ? *widest : wide ? *wide : in_double::kernels;
}

template <>
const FrontKernels<float>& front_kernels<float>() {
  static const FrontKernels<float>* const widest = avx512_front_kernels<float>();
  static const FrontKernels<float>* const wide = avx2_front_kernels<float>();
  return widest ? *widest : wide ? *wide : in_single::kernels;
}

}  // namespace codend
