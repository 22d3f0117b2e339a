/// Three-component vectors of SIMD registers and missing vector operations. For kernels only, see simd.h: all code is
/// in the unnamed namespace of one instruction set.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "base/lane_transpose.h"
#include "base/simd.h"
#include "base/unaligned_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct Vec {
  Lanes x, y, z;
};

inline Lanes all(double value) {
  return Lanes{} + value;
}
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Lanes& s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// True if any lane is above zero.
inline bool any(const Lanes& x) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_GT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_GT_OQ)) != 0;
#elif defined(__SSE2__)
  return _mm_movemask_pd(_mm_cmpgt_pd(x, _mm_setzero_pd())) != 0;
#else
  bool found = false;
  for (int l = 0; l < kWidth; ++l) {
    found = found || x[l] > 0.0;
  }
  return found;
#endif
}

inline Lanes root(const Lanes& a) {
#if defined(__AVX512F__)
  return _mm512_maskz_sqrt_pd(0xff, a);  // g++ 12 warns about _mm512_sqrt_pd
#elif defined(__AVX__)
  return _mm256_sqrt_pd(a);
#elif defined(__SSE2__)
  return _mm_sqrt_pd(a);
#else
  Lanes r;
  for (int l = 0; l < kWidth; ++l) {
    r[l] = __builtin_sqrt(a[l]);
  }
  return r;
#endif
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
