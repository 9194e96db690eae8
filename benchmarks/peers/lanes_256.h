/* Vectors of four lanes (AVX2 and FMA), and elementary functions without branches.
 *
 * These take FOUR vectors and do one thing to all before the next: coefficients are loaded
 * once, and a chain's waiting is filled by the other three. Processors look ahead too little
 * to find that by themselves. */
#include <immintrin.h>

typedef double V __attribute__((vector_size(32)));
typedef long long M __attribute__((vector_size(32)));
typedef unsigned long long U __attribute__((vector_size(32)));
#define S(x) ((V){0} + (x))
#define SIGN ((M){0} + (long long)(1ULL << 63))
#define IN static inline __attribute__((always_inline))
#define UNROLLED _Pragma("GCC unroll 16")
#define FOUR 4
#define ALL UNROLLED for (int i = 0; i < FOUR; ++i)
IN V vround(V x) { return (V)_mm256_round_pd((__m256d)x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
/* An integer's last bits, shifted: 1.5 2^52 added, they are the sum's last. */
IN M low_bits(V k, int shift) { return (M)(k + 0x1.8p52) << shift; }
IN V vsqrt(V x) { return (V)_mm256_sqrt_pd((__m256d)x); }
IN V vabs(V x) { return (V)((M)x & ~SIGN); }
IN V vmin(V a, V b) { return (V)_mm256_min_pd((__m256d)a, (__m256d)b); }
IN V vmax(V a, V b) { return (V)_mm256_max_pd((__m256d)a, (__m256d)b); }
IN int any(M mask) { return _mm256_movemask_pd((__m256d)mask); }
IN V choose(M mask, V x, V y) { return (V)_mm256_blendv_pd((__m256d)y, (__m256d)x, (__m256d)mask); }
IN V load(const double *p) { return (V)_mm256_loadu_pd(p); }
IN void store(double *p, V x) { _mm256_storeu_pd(p, (__m256d)x); }

/* Coefficients interpolate at Chebyshev nodes, here and in all that follows. */
IN void polynomials(const double *coefficients, int degree, const V *x, V *p)
{
    ALL p[i] = coefficients[degree - 1] + x[i] * coefficients[degree];
    UNROLLED for (int j = degree - 2; j >= 0; --j) ALL p[i] = coefficients[j] + x[i] * p[i];
}

static const double EXP2[] = {
    1.0, 0.6931471805459335, 0.2402265069581299, 0.05550410941205934, 0.00961812915940262,
    0.0013333450568000008, 0.00015403455852419016, 1.5310079402383103e-05, 1.3255224884799127e-06};

/* 2^x for |x| < 1000, within 1.1e-12. */
IN void exp2s(const V *x, V *y)
{
    V k[FOUR], r[FOUR];
    ALL k[i] = vround(x[i]);
    ALL r[i] = x[i] - k[i];
    polynomials(EXP2, 8, r, y);
    ALL y[i] = (V)((M)y[i] + low_bits(k[i], 52));
}

static const double COS[] = {
    0.9999999999992479, -0.49999999997012745, 0.0416666664728516, -0.0013888884170785351,
    2.4801039927686234e-05, -2.7524670412306244e-07, 1.990750591532521e-09};

/* cos x for |x| < 1e4, within 1e-12. */
IN void cosines(const V *x, V *y)
{
    V k[FOUR], r[FOUR];
    ALL k[i] = vround(x[i] * M_1_PI);
    ALL r[i] = x[i] - k[i] * M_PI;
    ALL r[i] *= r[i];
    polynomials(COS, 6, r, y);
    ALL y[i] = (V)((M)y[i] ^ low_bits(k[i], 63));
}

static const double LOG2[] = {
    2.8853900817899873, 0.9617966734515483, 0.5770835660048934, 0.41167376623623664, 0.3407120415869158};

/* log2 x of positive, normal x, within 2.1e-12. */
IN void log2s(const V *x, V *y)
{
    V e[FOUR], z[FOUR], s[FOUR];
    ALL {
        M offset = (M)x[i] - 0x3fe6a09e667f3bcd; /* of sqrt 1/2, so that the rest is in [sqrt 1/2, sqrt 2) */
        V m = (V)((M)x[i] - (offset & (long long)0xfff0000000000000));
        e[i] = (V)((M)((U)(offset + 0x4000000000000000) >> 52) | 0x4330000000000000) - (0x1p52 + 1024);
        s[i] = (m - 1.) / (m + 1.);
    }
    ALL z[i] = s[i] * s[i];
    polynomials(LOG2, 4, z, y);
    ALL y[i] = e[i] + s[i] * y[i];
}

IN V vexp2(V x) { V xs[FOUR] = {x, x, x, x}, ys[FOUR]; exp2s(xs, ys); return ys[0]; }
IN V vlog2(V x) { V xs[FOUR] = {x, x, x, x}, ys[FOUR]; log2s(xs, ys); return ys[0]; }
IN V vtanh(V u)
{
    u = vmax(vmin(u, S(20.)), S(-20.));
    return 1. - 2. / (1. + vexp2(u * (2 * M_LOG2E)));
}
