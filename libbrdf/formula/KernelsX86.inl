// Simd<T> for x86-64, chosen by the instruction set this file is compiled for; see Kernels.inl, which it ends by
// including. The vector functions are SLEEF's, at most 1.0 ulp off (erfc 1.5 ulp), which tests/formula measures against
// extended precision.
#include <brdf/formula/SpecialFunctions.h>
#include <immintrin.h>
#include <sleef.h>

namespace {

double digammaOfPositive(double x);

#if defined(__AVX512F__)
#define BRDF_F(name, accuracy) Sleef_##name##f16_##accuracy##avx512f
#define BRDF_D(name, accuracy) Sleef_##name##d8_##accuracy##avx512f
using FloatV = __m512;
using DoubleV = __m512d;
#elif defined(__AVX2__)
#define BRDF_F(name, accuracy) Sleef_##name##f8_##accuracy##avx2
#define BRDF_D(name, accuracy) Sleef_##name##d4_##accuracy##avx2
using FloatV = __m256;
using DoubleV = __m256d;
#else
#define BRDF_F(name, accuracy) Sleef_##name##f4_##accuracy##sse2
#define BRDF_D(name, accuracy) Sleef_##name##d2_##accuracy##sse2
using FloatV = __m128;
using DoubleV = __m128d;
#endif

template <class T>
struct Simd;

// What float and double share, with SLEEF's names filled in by CALL.
#define BRDF_SIMD(T, VECTOR, CALL)                                                           \
  template <>                                                                                \
  struct Simd<T> {                                                                           \
    using V = VECTOR;                                                                        \
    typedef T Loose __attribute__((vector_size(sizeof(V)), aligned(alignof(T)), may_alias)); \
    static constexpr unsigned width = sizeof(V) / sizeof(T);                                 \
    static V fill(T x) { return x - V{}; }                                                   \
    static V load(const T* p) { return (V) * (const Loose*)p; }                              \
    static void store(T* p, V v) { *(Loose*)p = (Loose)v; }                                  \
    static V abs(V a) { return CALL(fabs, )(a); }                                            \
    static V floor(V a) { return CALL(floor, )(a); }                                         \
    static V exp(V a) { return CALL(exp, u10)(a); }                                          \
    static V expm1(V a) { return CALL(expm1, u10)(a); }                                      \
    static V log(V a) { return CALL(log, u10)(a); }                                          \
    static V log1p(V a) { return CALL(log1p, u10)(a); }                                      \
    static V sin(V a) { return CALL(sin, u10)(a); }                                          \
    static V cos(V a) { return CALL(cos, u10)(a); }                                          \
    static V tan(V a) { return CALL(tan, u10)(a); }                                          \
    static V asin(V a) { return CALL(asin, u10)(a); }                                        \
    static V acos(V a) { return CALL(acos, u10)(a); }                                        \
    static V atan(V a) { return CALL(atan, u10)(a); }                                        \
    static V sinh(V a) { return CALL(sinh, u10)(a); }                                        \
    static V cosh(V a) { return CALL(cosh, u10)(a); }                                        \
    static V tanh(V a) { return CALL(tanh, u10)(a); }                                        \
    static V erf(V a) { return CALL(erf, u10)(a); }                                          \
    static V erfc(V a) { return CALL(erfc, u15)(a); }                                        \
    static V lgamma(V a) { return CALL(lgamma, u10)(a); }                                    \
    static V pow(V a, V b) { return CALL(pow, u10)(a, b); }                                  \
    static V atan2(V a, V b) { return CALL(atan2, u10)(a, b); }                              \
    static V clampToOne(V a) {                                                               \
      const V one = fill(1);                                                                 \
      return a > one ? one : (a < -one ? -one : a);                                          \
    }                                                                                        \
    static V each(double (*f)(double), V a) {                                                \
      V r{};                                                                                 \
      for (unsigned i = 0; i < width; ++i) r[i] = static_cast<T>(f(a[i]));                   \
      return r;                                                                              \
    }                                                                                        \
    static V each(double (*f)(double, double), V a, V b) {                                   \
      V r{};                                                                                 \
      for (unsigned i = 0; i < width; ++i) r[i] = static_cast<T>(f(a[i], b[i]));             \
      return r;                                                                              \
    }                                                                                        \
    static V digamma(V a) { return each(digammaOfPositive, a); }                             \
    static V sqrt(V a);                                                                      \
    static V divide(V a, V b);                                                               \
    static V mulAdd(V a, V b, V c);                                                          \
  };

#define BRDF_CALL_F(name, accuracy) BRDF_F(name, accuracy)
#define BRDF_CALL_D(name, accuracy) BRDF_D(name, accuracy)
BRDF_SIMD(float, FloatV, BRDF_CALL_F)
BRDF_SIMD(double, DoubleV, BRDF_CALL_D)

#if defined(__AVX512F__)
// Quotients and roots from the processor's 14-bit estimates, refined by Newton steps and a last one on the residual,
// whose fused multiply-add is exact: at most 0.56 ulp off, and two to four times faster than the instructions. Lanes
// where a step meets 0, infinity, NaN, a subnormal numerator or a denominator so huge that its refined reciprocal is
// subnormal (0 in float, which flushes) send their whole vector to the instruction.
constexpr int kZero = 0x06, kSubnormal = 0x20;  // classes of vfpclass
inline FloatV Simd<float>::divide(FloatV a, FloatV b) {
  const FloatV one = fill(1);
  FloatV r = _mm512_rcp14_ps(b);
  r = _mm512_fmadd_ps(r, _mm512_fnmadd_ps(b, r, one), r);
  FloatV q = a * r;
  q = _mm512_fmadd_ps(_mm512_fnmadd_ps(b, q, a), r, q);
  const __mmask16 bad = _mm512_cmp_ps_mask(q, q, _CMP_UNORD_Q) | _mm512_fpclass_ps_mask(r, kZero | kSubnormal);
  return __builtin_expect(bad == 0, 1) ? q : a / b;
}
inline DoubleV Simd<double>::divide(DoubleV a, DoubleV b) {
  const DoubleV one = fill(1);
  DoubleV r = _mm512_rcp14_pd(b);
  const DoubleV e = _mm512_fnmadd_pd(b, r, one);
  r = _mm512_fmadd_pd(r, _mm512_fmadd_pd(e, e, e), r);
  DoubleV q = a * r;
  q = _mm512_fmadd_pd(_mm512_fnmadd_pd(b, q, a), r, q);
  const __mmask8 bad = _mm512_cmp_pd_mask(q, q, _CMP_UNORD_Q) | _mm512_fpclass_pd_mask(r, kZero | kSubnormal) |
                       _mm512_fpclass_pd_mask(a, kSubnormal);
  return __builtin_expect(bad == 0, 1) ? q : a / b;
}
inline FloatV Simd<float>::sqrt(FloatV a) {
  const FloatV y = _mm512_rsqrt14_ps(a);
  const FloatV s = a * y;
  const FloatV root = _mm512_fmadd_ps(_mm512_fnmadd_ps(s, s, a), fill(0.5f) * y, s);
  return __builtin_expect(_mm512_cmp_ps_mask(root, root, _CMP_ORD_Q) == 0xffff, 1) ? root : _mm512_sqrt_ps(a);
}
inline DoubleV Simd<double>::sqrt(DoubleV a) {
  DoubleV y = _mm512_rsqrt14_pd(a);
  const DoubleV e = _mm512_fnmadd_pd(a * y, y, fill(1));
  y = _mm512_fmadd_pd(_mm512_fmadd_pd(e, fill(0.375), fill(0.5)), e * y, y);
  const DoubleV s = a * y;
  const DoubleV root = _mm512_fmadd_pd(_mm512_fnmadd_pd(s, s, a), fill(0.5) * y, s);
  return __builtin_expect(_mm512_cmp_pd_mask(root, root, _CMP_ORD_Q) == 0xff, 1) ? root : _mm512_sqrt_pd(a);
}
inline FloatV Simd<float>::mulAdd(FloatV a, FloatV b, FloatV c) { return _mm512_fmadd_ps(a, b, c); }
inline DoubleV Simd<double>::mulAdd(DoubleV a, DoubleV b, DoubleV c) { return _mm512_fmadd_pd(a, b, c); }
#elif defined(__AVX2__)
inline FloatV Simd<float>::divide(FloatV a, FloatV b) { return a / b; }
inline DoubleV Simd<double>::divide(DoubleV a, DoubleV b) { return a / b; }
inline FloatV Simd<float>::sqrt(FloatV a) { return _mm256_sqrt_ps(a); }
inline DoubleV Simd<double>::sqrt(DoubleV a) { return _mm256_sqrt_pd(a); }
inline FloatV Simd<float>::mulAdd(FloatV a, FloatV b, FloatV c) { return _mm256_fmadd_ps(a, b, c); }
inline DoubleV Simd<double>::mulAdd(DoubleV a, DoubleV b, DoubleV c) { return _mm256_fmadd_pd(a, b, c); }
#else  // no fused multiply-add before AVX2: two roundings
inline FloatV Simd<float>::divide(FloatV a, FloatV b) { return a / b; }
inline DoubleV Simd<double>::divide(DoubleV a, DoubleV b) { return a / b; }
inline FloatV Simd<float>::sqrt(FloatV a) { return _mm_sqrt_ps(a); }
inline DoubleV Simd<double>::sqrt(DoubleV a) { return _mm_sqrt_pd(a); }
inline FloatV Simd<float>::mulAdd(FloatV a, FloatV b, FloatV c) { return a * b + c; }
inline DoubleV Simd<double>::mulAdd(DoubleV a, DoubleV b, DoubleV c) { return a * b + c; }
#endif

// Digamma for x > 0: recurrence up to 10, then the asymptotic series (Abramowitz and Stegun 6.3.5, 6.3.18).
double digammaOfPositive(double x) {
  if (!(x > 0)) return x * 0 / 0.0;
  double sum = 0;
  for (; x < 10; x += 1) sum -= 1 / x;
  const double y = 1 / (x * x);
  return sum + __builtin_log(x) - 0.5 / x -
         y * (1. / 12 -
              y * (1. / 120 - y * (1. / 252 - y * (1. / 240 - y * (1. / 132 - y * (691. / 32760 - y / 12))))));
}

}  // namespace

#include <brdf/formula/Kernels.inl>
