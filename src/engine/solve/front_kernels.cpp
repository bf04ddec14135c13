#include "front_kernels.hpp"

namespace codend {

namespace {

constexpr int lanes = 2;  // SSE2 and NEON; split by the compiler where there is neither

#include "front_kernels.inl"

}  // namespace

const FrontKernels& portable_front_kernels() { return kernels; }

const FrontKernels& front_kernels() {
  static const FrontKernels* const wide = avx2_front_kernels();
  return wide ? *wide : kernels;
}

}  // namespace codend
