/* Sixteen rollouts at once by hand for AVX-512: two vectors of eight lanes, so that one's waiting is
 * the other's work; every trick known: polynomials just long enough, tanh skipped where
 * all lanes turn fast or the contact is saturated. */
#include <immintrin.h>

typedef double V __attribute__((vector_size(64)));
typedef long long M __attribute__((vector_size(64)));
#define NV 2
#define LANES (8 * NV)
#define S(x) ((V){0} + (x))
#define SIGN ((M){0} + (long long)(1ULL << 63))
#define IN static inline __attribute__((always_inline))
IN V vround(V x) { return (V)_mm512_roundscale_pd((__m512d)x, 0); }
IN V vscale(V x, V k) { return (V)_mm512_scalef_pd((__m512d)x, (__m512d)k); }
IN V vgexp(V x) { return (V)_mm512_getexp_pd((__m512d)x); }
IN V vgman(V x) { return (V)_mm512_getmant_pd((__m512d)x, _MM_MANT_NORM_p75_1p5, _MM_MANT_SIGN_zero); }
IN V vsqrt(V x) { return (V)_mm512_sqrt_pd((__m512d)x); }
IN V vabs(V x) { return (V)_mm512_abs_pd((__m512d)x); }
IN V vmin(V a, V b) { return (V)_mm512_min_pd((__m512d)a, (__m512d)b); }
IN V vmax(V a, V b) { return (V)_mm512_max_pd((__m512d)a, (__m512d)b); }
IN double hmin(V a) { return _mm512_reduce_min_pd((__m512d)a); }
IN V choose(V a, V b, V x, V y) /* a < b ? x : y */
{ return (V)_mm512_mask_blend_pd(_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ), (__m512d)y, (__m512d)x); }

IN V vexp(V x)
{
    V k = vround(x * 1.4426950408889634);
    V r = x - k * 6.93147180369123816490e-01; r = r - k * 1.90821492927058770002e-10;
    V p = S(2.5100472505694996e-08); /* Chebyshev */
    p = p * r + 2.7620201591031547e-07; p = p * r + 2.7557268276905696e-06; p = p * r + 2.4801521057867e-05;
    p = p * r + 0.00019841269863171557; p = p * r + 0.0013888888917367081; p = p * r + 0.008333333333330039;
    p = p * r + 0.041666666666623824; p = p * r + 0.16666666666666669; p = p * r + 0.5;
    p = p * r + 1.; p = p * r + 1.;
    return vscale(p, k);
}

IN V vlog(V x)
{
    V m = vgman(x), e = vgexp(x);
    e = choose(m, S(1.), e + 1., e); /* mantissa in [0.75, 1.5) */
    V f = (m - 1.) / (m + 1.), z = f * f, p = S(0.14617807153417325);
    p = p * z + 0.15331611722055008; p = p * z + 0.1818289243253687; p = p * z + 0.22222211089379496;
    p = p * z + 0.28571428626253836; p = p * z + 0.3999999999989889; p = p * z + 0.666666666666667;
    return e * 0.6931471805599453 + (2. * f + f * z * p);
}

IN V vsin(V x)
{
    V k = vround(x * 0.3183098861837907), r = x - k * 3.141592653589793116;
    r = r - k * 1.2246467991473532e-16;
    M odd = (M)(k + 0x1.8p52) << 63;
    V z = r * r, p = S(2.7312868913092307e-15);
    p = p * z - 7.643957622560617e-13; p = p * z + 1.6058976915095007e-10; p = p * z - 2.505210761086116e-08;
    p = p * z + 2.7557319219115013e-06; p = p * z - 0.00019841269841254795; p = p * z + 0.008333333333333316;
    p = p * z - 0.16666666666666666;
    return (V)((M)(r + r * z * p) ^ odd);
}

IN V vtanh(V x) { V e = vexp(2. * vmax(vmin(x, S(20.)), S(-20.))); return 1. - 2. / (e + 1.); }

struct derived { V k, c_d, b; double s, i_J1, i_J2, i_J3, i_w1, i_w3, i_r; };
struct motion { V w1, w2, w3, a1, a2, a3, F; };
struct state { V q1, q2, q3, w1, w2, w3, D[2], peak, P2[2]; };

IN V vpress(V x, V b, double s) /* contact deflection, its two tanh skipped when saturated */
{
    V ax = vabs(x), l = ax - b, r = ax + b, u = s * l;
    V tl = (V)((M)S(1.) | ((M)u & SIGN)), tr = S(1.);
    if (hmin(vabs(u)) < 20.) tl = vtanh(u);
    if (hmin(s * r) < 20.) tr = vtanh(s * r);
    V f = ax + 0.5 * (l * tl - r * tr);
    return (V)((M)f ^ ((M)x & SIGN));
}

IN struct motion rates(const struct machine *m, const struct derived *d, V q1, V q2, V q3,
                       V w1, V w2, V w3, int fast)
{
    V s4 = vsin(4. * q1 + m->p4), s8 = vsin(8. * q1 + m->p8), t1 = S(1.), t3 = S(1.);
    if (!fast) { t1 = vtanh(w1 * d->i_w1); t3 = vtanh(w3 * d->i_w3); }
    V T1 = m->T4 * s4 + m->T8 * s8 - m->c_t1 * w1 - m->T_f1 * t1;
    V Td = m->c_t3 * w3 + m->T_f3 * t3;
    V Tc = d->k * (q1 - q2) + d->c_d * (w1 - w2);
    V F = m->k_g * vpress(q2 - q3, d->b, d->s) + m->c_oil * (w2 - w3);
    return (struct motion){w1, w2, w3, (T1 - Tc) * d->i_J1, (Tc - F) * d->i_J2, (F - Td) * d->i_J3, F};
}

IN void damages(const struct machine *m, const struct derived *d, V Fc, V w3, V cos_q3,
                struct state *y, const double *logs)
{
    V speed = vabs(w3), n = vmax(speed * (30 / M_PI), S(1e-3)), log_n = vlog(n);
    V lk = logs[0] + choose(n, S(1000 - 1e-6), 0.83 * log_n - 10.714417768752456, 0.5 * log_n - 8.411832675758411);
    lk = vmin(vmax(lk, S(-2.302585092994046)), S(1.3862943611198906));
    V limit = S(-0.916290731874155);
    V e = choose(lk, limit, S(0.054381), choose(lk, S(0.), S(0.19087), S(0.071739)));
    V X = 1.5859 - choose(lk, limit, S(1.3993), S(1.2348)) * vexp(-e * lk);
    V log_ec = vmin(logs[1] + 0.68 * lk, S(0.)) + logs[2], turns = speed * logs[7];
    const double lever[2] = {m->lever1, m->lever2}, G[2] = {m->G1, m->G2};
    for (int i = 0; i < 2; ++i) {
        V Fr = lever[i] * Fc;
        V square = vmax(Fr * Fr + G[i] * G[i] + 2. * G[i] * Fr * cos_q3, S(1e-6));
        V log_P = 0.5 * vlog(square);
        V bracket = 1. - X * vexp(0.4 * (log_ec + logs[3 + i] - log_P));
        bracket = vmax(bracket, S(0.5083403685049885));
        y->D[i] += turns * vexp(9.185 * vlog(bracket) - 10. / 3 * (logs[5 + i] - log_P));
        y->P2[i] = vmax(y->P2[i], square);
    }
    y->peak = vmax(y->peak, vabs(Fc));
}

static void block(const struct machine *m, int64_t n_steps, int64_t stride, const double *k,
                  const double *gap, const double *start, double *end)
{
    const double logs[8] = {
        log(m->nu) + 0.5 * log(m->D_pw), log(m->c1) + 0.55 * log(m->D_pw),
        log(1 - m->c2 / cbrt(m->D_pw)), log(m->Cu1), log(m->Cu2), log(m->C1), log(m->C2),
        m->h / (2 * M_PI) / (0.1e6 * m->a1)};
    struct derived d[NV];
    struct state y[NV];
    for (int g = 0; g < NV; ++g) {
#define AT(p) ((V)_mm512_loadu_pd((p) + 8 * g))
        d[g] = (struct derived){AT(k), AT(k) * (m->kappa0 / m->omega0), AT(gap) / (2 * m->radius),
                                m->smoothing * m->radius, 1 / m->J1, 1 / m->J2, 1 / m->J3,
                                1 / m->w_t1, 1 / m->w_t3, 1 / m->radius};
        V *entries = (V *)&y[g];
        for (int i = 0; i < N_STATES; ++i) entries[i] = AT(start + i * stride);
    }
    double h = m->h, w_fast = 20 * fmax(m->w_t1, m->w_t3);
    for (int64_t i = 0; i < n_steps; ++i) {
        struct motion A[NV], B[NV], C[NV], D[NV];
        V slowest = vmin(y[0].w1, y[0].w3);
        for (int g = 1; g < NV; ++g) slowest = vmin(slowest, vmin(y[g].w1, y[g].w3));
        int fast = hmin(slowest) > w_fast + 1;
#define EACH for (int g = 0; g < NV; ++g)
#define STAGE(N, M, t, fast) EACH N[g] = rates(m, &d[g], y[g].q1 + (t) * M[g].w1, y[g].q2 + (t) * M[g].w2, \
    y[g].q3 + (t) * M[g].w3, y[g].w1 + (t) * M[g].a1, y[g].w2 + (t) * M[g].a2, y[g].w3 + (t) * M[g].a3, fast);
#define STAGES(fast) \
        EACH A[g] = rates(m, &d[g], y[g].q1, y[g].q2, y[g].q3, y[g].w1, y[g].w2, y[g].w3, fast); \
        STAGE(B, A, h / 2, fast) STAGE(C, B, h / 2, fast) STAGE(D, C, h, fast)
        if (fast) { STAGES(1) } else { STAGES(0) }
        EACH damages(m, &d[g], A[g].F * d[g].i_r, y[g].w3, vsin(y[g].q3 + M_PI / 2), &y[g], logs);
#define STEP(q, v) EACH y[g].q += h / 6 * (A[g].v + 2. * (B[g].v + C[g].v) + D[g].v);
        STEP(q1, w1) STEP(q2, w2) STEP(q3, w3) STEP(w1, a1) STEP(w2, a2) STEP(w3, a3)
    }
    EACH {
        V *entries = (V *)&y[g];
        for (int i = 0; i < N_STATES; ++i) {
            V x = i < 9 ? entries[i] : vsqrt(entries[i]);
            _mm512_storeu_pd(end + i * stride + 8 * g, (__m512d)x);
        }
    }
}
