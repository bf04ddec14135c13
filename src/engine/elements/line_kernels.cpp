#include "line_kernels.hpp"

#include "../base/pi.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#else
#include <cmath>
#endif

// On Linux only processors without AVX2 use these kernels on x86-64, so they are compiled for size.
#if defined(__linux__) && defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("Os")
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

CylinderCoefficients cylinder_coefficients(const CylinderLaw& law, double q_n, double q_t, double d,
                                           double viscosity) {
  TwineMaterial material;
  material.diameter = d;
  material.law = law;
  const TwineMaterial* const laws[lanes] = {&material, &material};
  const Pack normal = Pack{} + law.normal_share * law.normal;
  const Pack tangential = Pack{} + law.tangential_share * law.tangential;
  Coefficients k = {normal * q_n, normal, tangential * q_t, Pack{}, tangential, Pack{}};
  use_speed_laws(laws, viscosity, Pack{} + q_n, Pack{} + q_t, k);
  return {k.a[0], k.a_n[0], k.b[0], k.b_n[0], k.b_t[0], law.tangential_share * law.skin};
}

void load_coefficients(const TwineMaterial& material, double strain, double* out) {
  const TwinePull pull = twine_pull(material, strain);
  out[0] = pull.tension - pull.modulus * strain;
  out[1] = pull.modulus;
}

}  // namespace codend
