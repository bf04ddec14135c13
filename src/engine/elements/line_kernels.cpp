#include "line_kernels.hpp"

#include "../base/pi.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#else
#include <cmath>
#endif

namespace codend {

namespace {

constexpr int lanes = 2;  // SSE2 and NEON; other processors split it

#include "line_kernels.inl"

#if defined(__SSE2__)
Pack root(Pack x) { return _mm_sqrt_pd(x); }
#else
Pack root(Pack x) {
  for (int l = 0; l < lanes; ++l) x[l] = std::sqrt(x[l]);
  return x;
}
#endif

void store_across(Pack a, Pack b, Pack c, Pack d, double* out, int step) {
  store(out, Pack{a[0], b[0]});
  store(out + 2, Pack{c[0], d[0]});
  store(out + step, Pack{a[1], b[1]});
  store(out + step + 2, Pack{c[1], d[1]});
}

}  // namespace

const LineKernels& portable_line_kernels() { return kernels; }

const LineKernels& line_kernels() {
  static const LineKernels* const wide = avx2_line_kernels();
  return wide ? *wide : kernels;
}

void speed_coefficients(const TwineMaterial& material, double q_n, double q_t, double viscosity,
                        double* out) {
  const CylinderCoefficients k =
      cylinder_coefficients(material.law, q_n, q_t, material.diameter, viscosity);
  out[0] = k.a;
  out[1] = k.a_n;
  out[2] = k.b;
  out[3] = k.b_n;
  out[4] = k.b_t;
}

void load_coefficients(const TwineMaterial& material, double strain, double* out) {
  const TwinePull pull = twine_pull(material, strain);
  out[0] = pull.tension - pull.modulus * strain;
  out[1] = pull.modulus;
}

}  // namespace codend
