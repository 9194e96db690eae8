/* Lanes: one number, or as many as the processor's vectors hold, with one notation.
 *
 * Every operation rounds as IEEE 754 says and none mixes lanes, so a lane's result
 * depends neither on how many there are nor on its neighbours. Real is a lane's
 * double, Bits its pattern, Mask a yes or no.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(SINGLE_LANE)
#define LANES 1
#elif defined(__AVX512F__) && defined(__AVX512DQ__)
#define LANES 8
#elif defined(__AVX__)
#define LANES 4
#else
#define LANES 2
#endif

/* Four lanes need half a dozen of the processor's operations. GCC takes 0.4 s to read all
 * of them from immintrin.h, as long as for the rest, and has names of its own for them. */
#if LANES == 4 && defined(__GNUC__) && !defined(__clang__)
#define FUSED4(a, b, c) __builtin_ia32_vfmaddpd256(a, b, c)
#define BLEND4(a, b, m) __builtin_ia32_blendvpd256(a, b, m)
#define SIGNS4(x) __builtin_ia32_movmskpd256(x)
#define LARGER4(a, b) __builtin_ia32_maxpd256(a, b)
#define SMALLER4(a, b) __builtin_ia32_minpd256(a, b)
#define ROOT4(x) __builtin_ia32_sqrtpd256(x)
#elif LANES == 8 || LANES == 4
#include <immintrin.h>
#define FUSED4(a, b, c) _mm256_fmadd_pd((__m256d)(a), (__m256d)(b), (__m256d)(c))
#define BLEND4(a, b, m) _mm256_blendv_pd((__m256d)(a), (__m256d)(b), (__m256d)(m))
#define SIGNS4(x) _mm256_movemask_pd((__m256d)(x))
#define LARGER4(a, b) _mm256_max_pd((__m256d)(a), (__m256d)(b))
#define SMALLER4(a, b) _mm256_min_pd((__m256d)(a), (__m256d)(b))
#define ROOT4(x) _mm256_sqrt_pd((__m256d)(x))
#endif

#define INLINE static inline __attribute__((always_inline))
#define likely(condition) __builtin_expect(condition, 1)

/* Whether two vectors side by side pay: one's waiting is the other's work. */
#ifndef SIDE_BY_SIDE
#define SIDE_BY_SIDE 1
#endif

#if LANES == 1
typedef double Real;
typedef int64_t Bits;
typedef int Mask;
INLINE Bits bits(Real x) { Bits u; memcpy(&u, &x, sizeof u); return u; }
INLINE Real real(Bits u) { Real x; memcpy(&x, &u, sizeof x); return x; }
INLINE Real splat(double x) { return x; }
INLINE double first_lane(Real x) { return x; }
#define SPLAT_BITS(u) ((Bits)(u))
#define SHIFT_RIGHT(u, n) ((Bits)((uint64_t)(u) >> (n)))
#define SHIFT_LEFT(u, n) ((Bits)((uint64_t)(u) << (n)))
INLINE Real root(Real x) { return __builtin_sqrt(x); }
#else
typedef double Real __attribute__((vector_size(8 * LANES)));
typedef int64_t Bits __attribute__((vector_size(8 * LANES)));
typedef uint64_t Unsigned __attribute__((vector_size(8 * LANES)));
INLINE Bits bits(Real x) { return (Bits)x; }
INLINE Real real(Bits u) { return (Real)u; }
INLINE Real splat(double x) { return x - (Real){0}; }
INLINE double first_lane(Real x) { return x[0]; }
#define SPLAT_BITS(u) ((Bits){0} + (int64_t)(u))
#define SHIFT_RIGHT(u, n) ((Bits)((Unsigned)(u) >> (n)))
#define SHIFT_LEFT(u, n) ((Bits)((Unsigned)(u) << (n)))
#endif

/* a * b + c in one rounding where the processor can, the same at any width. */
#if defined(__FMA__) || defined(__aarch64__)
#define ROUNDS_ONCE
#endif
#if LANES == 8
INLINE Real fused(Real a, Real b, Real c) { return (Real)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c); }
#elif LANES == 4 && defined(ROUNDS_ONCE)
INLINE Real fused(Real a, Real b, Real c) { return (Real)FUSED4(a, b, c); }
#elif defined(ROUNDS_ONCE)
#if LANES == 1
INLINE Real fused(Real a, Real b, Real c) { return __builtin_fma(a, b, c); }
#else
INLINE Real fused(Real a, Real b, Real c)
{
    Real r;
    for (int i = 0; i < LANES; ++i) r[i] = __builtin_fma(a[i], b[i], c[i]);
    return r;
}
#endif
#else
INLINE Real fused(Real a, Real b, Real c) { return a * b + c; }
#endif

/* Comparisons are false for NaN; larger and smaller give their second argument then. */
#if LANES == 8
typedef __mmask8 Mask;
#define M512(x) ((__m512d)(x))
INLINE Mask less(Real a, Real b) { return _mm512_cmp_pd_mask(M512(a), M512(b), _CMP_LT_OQ); }
INLINE Mask less_equal(Real a, Real b) { return _mm512_cmp_pd_mask(M512(a), M512(b), _CMP_LE_OQ); }
INLINE Mask equal(Real a, Real b) { return _mm512_cmp_pd_mask(M512(a), M512(b), _CMP_EQ_OQ); }
INLINE Mask not(Mask m) { return (Mask)~m; }
INLINE Mask both(Mask a, Mask b) { return a & b; }
INLINE Mask either(Mask a, Mask b) { return a | b; }
INLINE Real choose(Mask m, Real a, Real b) { return (Real)_mm512_mask_blend_pd(m, M512(b), M512(a)); }
INLINE Real keep(Mask m, Real a) { return (Real)_mm512_maskz_mov_pd(m, M512(a)); }
INLINE int every(Mask m) { return m == 0xff; }
INLINE Real larger(Real a, Real b) { return (Real)_mm512_max_pd(M512(a), M512(b)); }
INLINE Real smaller(Real a, Real b) { return (Real)_mm512_min_pd(M512(a), M512(b)); }
INLINE Real root(Real x) { return (Real)_mm512_sqrt_pd(M512(x)); }
#elif LANES == 1
INLINE Mask less(Real a, Real b) { return a < b; }
INLINE Mask less_equal(Real a, Real b) { return a <= b; }
INLINE Mask equal(Real a, Real b) { return a == b; }
INLINE Mask not(Mask m) { return !m; }
INLINE Mask both(Mask a, Mask b) { return a & b; }
INLINE Mask either(Mask a, Mask b) { return a | b; }
INLINE Real choose(Mask m, Real a, Real b) { return m ? a : b; }
INLINE Real keep(Mask m, Real a) { return m ? a : 0.0; }
INLINE int every(Mask m) { return m; }
INLINE Real larger(Real a, Real b) { return a > b ? a : b; }
INLINE Real smaller(Real a, Real b) { return a < b ? a : b; }
#else
typedef Bits Mask;
INLINE Mask less(Real a, Real b) { return (Mask)(a < b); }
INLINE Mask less_equal(Real a, Real b) { return (Mask)(a <= b); }
INLINE Mask equal(Real a, Real b) { return (Mask)(a == b); }
INLINE Mask not(Mask m) { return ~m; }
INLINE Mask both(Mask a, Mask b) { return a & b; }
INLINE Mask either(Mask a, Mask b) { return a | b; }
INLINE Real keep(Mask m, Real a) { return real(m & bits(a)); }
#if LANES == 4
INLINE Real choose(Mask m, Real a, Real b) { return (Real)BLEND4(b, a, (Real)m); }
INLINE int every(Mask m) { return SIGNS4((Real)m) == 0xf; }
INLINE Real larger(Real a, Real b) { return (Real)LARGER4(a, b); }
INLINE Real smaller(Real a, Real b) { return (Real)SMALLER4(a, b); }
INLINE Real root(Real x) { return (Real)ROOT4(x); }
#else
INLINE Real choose(Mask m, Real a, Real b) { return real((m & bits(a)) | (~m & bits(b))); }
INLINE int every(Mask m) { return (m[0] & m[1]) != 0; }
INLINE Real larger(Real a, Real b) { return choose(less(b, a), a, b); }
INLINE Real smaller(Real a, Real b) { return choose(less(a, b), a, b); }
INLINE Real root(Real x) { return (Real){__builtin_sqrt(x[0]), __builtin_sqrt(x[1])}; }
#endif
#endif

#define SIGN_BIT SPLAT_BITS(INT64_MIN)
INLINE Real magnitude(Real x) { return real(bits(x) & ~SIGN_BIT); }
INLINE Real with_sign(Real x, Real sign) { return real((bits(x) & ~SIGN_BIT) | (bits(sign) & SIGN_BIT)); }

#if LANES == 4
INLINE Real by_sign(Real x, Real below, Real above) { return (Real)BLEND4(above, below, x); }
#elif LANES == 8
INLINE Real by_sign(Real x, Real below, Real above) { return choose(_mm512_movepi64_mask((__m512i)x), below, above); }
#elif LANES == 1
INLINE Real by_sign(Real x, Real below, Real above) { return signbit(x) ? below : above; }
#else
INLINE Real by_sign(Real x, Real below, Real above) { return choose((Mask)(bits(x) < 0), below, above); }
#endif

INLINE Real load(const double *from) { Real x; memcpy(&x, from, sizeof x); return x; }
INLINE void store(double *to, Real x) { memcpy(to, &x, sizeof x); }
