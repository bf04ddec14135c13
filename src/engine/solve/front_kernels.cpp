#include "front_kernels.hpp"

namespace codend {

namespace {

// registers of 16 bytes: SSE2 and NEON; split by the compiler on other processors
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

constexpr FrontKernelSet set{in_double::kernels, in_single::kernels};

const FrontKernelSet& fastest() {
  static const FrontKernelSet* const widest = avx512_front_kernels();
  static const FrontKernelSet* const wide = avx2_front_kernels();
  return widest ? *widest : wide ? *wide : set;
}

}  // namespace

const FrontKernelSet& portable_front_kernels() { return set; }

template <>
const FrontKernels<double>& front_kernels<double>() {
  return fastest().in_double;
}

template <>
const FrontKernels<float>& front_kernels<float>() {
  return fastest().in_single;
}

}  // namespace codend
