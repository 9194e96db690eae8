/* Elementary functions of lanes, without branches on a lane's value: a lane's result is
 * the same at any width. Within 2.5 units in the last place unless said otherwise;
 * NaN and infinity come out as they should. Numbers below the smallest normal one count
 * as zero. Coefficients interpolate at Chebyshev nodes, computed with 60 digits.
 */

/* Adding and taking off 1.5 * 2^52 rounds to an integer, whose low bits are then in
 * the sum's. */
#define ROUNDER 0x1.8p52
#define LN2_HIGH 0x1.62e42feep-1
#define LN2_LOW 0x1.a39ef35793c76p-33

/* (exp(r) - 1 - r) / r^2 for |r| <= ln(2) / 2, by Estrin's scheme. */
INLINE Real exp_tail(Real r)
{
    Real r2 = r * r, r4 = r2 * r2;
    Real a = fused(r, splat(0x1.5555555555556p-3), splat(0x1.0000000000001p-1));
    Real b = fused(r, splat(0x1.11111111109a6p-7), splat(0x1.5555555553d37p-5));
    Real c = fused(r, splat(0x1.a01a01a7cebcdp-13), splat(0x1.6c16c1789d1d7p-10));
    Real d = fused(r, splat(0x1.71de0d85293b8p-19), splat(0x1.a019b8ca26fcfp-16));
    Real e = fused(r, splat(0x1.af390ba7e6f47p-26), splat(0x1.2891d4ffbb0f9p-22));
    a = fused(r2, b, a);
    c = fused(r2, d, c);
    return fused(r4, fused(r4, e, c), a);
}

/* For |x| <= 708, or NaN. */
INLINE Real lane_exp_of_moderate(Real x)
{
    Real shifted = fused(x, splat(0x1.71547652b82fep0), splat(ROUNDER));
    Real k = shifted - splat(ROUNDER);
    Real r = fused(k, splat(-LN2_LOW), fused(k, splat(-LN2_HIGH), x));
    Real y = fused(r * r, exp_tail(r), r) + splat(1);
    return real(bits(y) + SHIFT_LEFT(bits(shifted), 52));
}

INLINE Real lane_exp(Real x)
{
    Real highest = splat(0x1.62e42fefa39efp9), lowest = splat(-0x1.6232bdd7abcd2p9);
    Real y = lane_exp_of_moderate(larger(lowest, smaller(highest, x))); /* NaN stays */
    y = choose(less(highest, x), splat(INFINITY), y);
    return choose(less(x, lowest), splat(0), y);
}

/* Beyond this tanh is 1 or -1 to the last bit. */
INLINE Mask at_end(Real x) { return less(splat(22), magnitude(x)); }
INLINE Real end_of(Real x) { return with_sign(splat(1), x); }

/* tanh |x| = (1 - E) / (1 + E) with E = exp(-2 |x|), from E - 1 without cancellation. */
INLINE Real lane_tanh(Real x)
{
    Real u = smaller(splat(22), magnitude(x)) * splat(-2); /* NaN stays */
    Real shifted = fused(u, splat(0x1.71547652b82fep0), splat(ROUNDER));
    Real k = shifted - splat(ROUNDER);
    Real r = fused(k, splat(-LN2_LOW), fused(k, splat(-LN2_HIGH), u));
    Real p = fused(r * r, exp_tail(r), r);
    Real scale = real(SHIFT_LEFT(bits(shifted), 52) + SPLAT_BITS(0x3ff0000000000000));
    Real less_one = fused(scale, p, scale - splat(1));
    return with_sign(less_one / (less_one + splat(2)), x);
}

/* The same where it mostly is at its end: apart, so that it takes no registers. */
static __attribute__((noinline, cold)) Real tanh_within(Real x) { return lane_tanh(x); }

/* 2^y for |y| <= 1000, or NaN: within 2 units in the last place, and mostly additions,
 * for which a processor has pipes beside those of its products. */
INLINE Real power_of_two(Real y)
{
    Real shifted = y + splat(ROUNDER);
    Real r = (y - (shifted - splat(ROUNDER))) * splat(0x1.62e42fefa39efp-1);
    Real power = fused(r * r, exp_tail(r), r) + splat(1);
    return real(bits(power) + SHIFT_LEFT(bits(shifted), 52));
}
#define TO_POWER_OF_TWO splat(2 * 0x1.71547652b82fep0) /* exp 2 x = 2^(this x) */

/* tanh x = 1 - 2 / (1 + exp 2 x) to 2e-16 of 1: where it is multiplied by a distance that
 * vanishes with x, or added to 1. Far from zero it is 1 or -1 to the last bit too. */
INLINE Real tanh_at_edge(Real x)
{
    Real held = larger(splat(-22), smaller(splat(22), x)); /* NaN stays */
    return splat(1) - splat(2) / (splat(1) + power_of_two(held * TO_POWER_OF_TWO));
}
INLINE Mask at_end_above(Real x) { return less(splat(22), x); }
static __attribute__((noinline, cold)) Real tanh_beyond(Real x) { return tanh_at_edge(x); }

/* How far a contact at either end of a gap 2 p is pressed at x, its edges smoothed by
 * tanh of k times the distance: what `contacts.py` says. */
INLINE Real share_beyond(Real k, Real distance) /* exp(-2 k distance) */
{
    Real y = (k * -TO_POWER_OF_TWO) * distance;
    return power_of_two(larger(splat(-900), smaller(splat(900), y))); /* NaN stays */
}
static __attribute__((noinline, cold)) Real pressed_at_other_edge(Real x, Real p, Real k)
{
    Real r = magnitude(x) + p, e = share_beyond(k, r);
    return keep(not(at_end_above(k * p)), r * (e / (splat(1) + e)));
}
INLINE Real lane_pressed(Real x, Real p, Real k)
{
    Real l = magnitude(x) - p;
    Real f = l / (splat(1) + share_beyond(k, l));
    if (!likely(every(at_end_above(k * p)))) f = f + pressed_at_other_edge(x, p, k);
    return real(bits(f) ^ (bits(x) & SIGN_BIT));
}

/* x = 2^k m, m in [sqrt(1/2), sqrt(2)); log m = 2 artanh((m - 1) / (m + 1)). */
INLINE Real lane_log_of_normal(Real x) /* at least the smallest normal number, or NaN */
{
    Bits offset = bits(x) - SPLAT_BITS(0x3fe6a09e667f3bcd);
    Bits exponent = offset & SPLAT_BITS(0xfff0000000000000);
    Real m = real(bits(x) - exponent);
    Bits biased = SHIFT_RIGHT(offset + SPLAT_BITS(0x4000000000000000), 52);
    Real k = real(biased | SPLAT_BITS(0x4330000000000000)) - splat(0x1p52 + 1024);
    Real f = m - splat(1), s = f / (f + splat(2)), z = s * s, z2 = z * z;
    Real a = fused(z, splat(0x1.9999999995273p-2), splat(0x1.5555555555558p-1));
    Real b = fused(z, splat(0x1.c71c62d5e53e0p-3), splat(0x1.2492492dfd86cp-2));
    Real c = fused(z, splat(0x1.39fdcceb4bb45p-3), splat(0x1.7462b91b8df65p-3));
    Real q = fused(z2, fused(z2, fused(z2, splat(0x1.2b5f68a50d903p-3), c), b), a);
    /* log m = f - s (f - z q): f is exact, the rest small beside it. */
    Real rest = fused(k, splat(LN2_LOW), -(s * (f - z * q)));
    Real y = fused(k, splat(LN2_HIGH), f + rest);
    return choose(less_equal(x, splat(0x1.fffffffffffffp1023)), y, x * x);
}

INLINE Real lane_log(Real x)
{
    Real y = lane_log_of_normal(x);
    Real below = choose(less(x, splat(0)), splat(NAN), splat(-INFINITY));
    return choose(less(x, splat(0x1p-1022)), below, y);
}

/* sin(x) = (-1)^k sin(x - k pi). Pi comes in parts whose product with k is exact, in
 * one rounding or, up to |x| = 1e8, in two. */
INLINE Real sin_reduced(Real x, Real k, Bits sign)
{
#ifdef ROUNDS_ONCE
    Real r = fused(k, splat(-0x1.921fb54442d18p1), x);
    r = fused(k, splat(-0x1.1a62633145c07p-53), r);
#else
    Real r = fused(k, splat(-0x1.921fb54p1), x);
    r = fused(k, splat(-0x1.10b461p-29), r);
    r = fused(k, splat(-0x1.a62633145c06ep-57), r);
#endif
    Real z = r * r, z2 = z * z;
    Real a = fused(z, splat(0x1.1111111111107p-7), splat(-0x1.5555555555555p-3));
    Real b = fused(z, splat(0x1.71de3a5453a9cp-19), splat(-0x1.a01a01a018a6bp-13));
    Real c = fused(z, splat(0x1.612400c8c470dp-33), splat(-0x1.ae6455a012592p-26));
    Real d = fused(z, splat(0x1.899eb3575b7f2p-49), splat(-0x1.ae5109fea6b7ap-41));
    a = fused(z2, b, a);
    c = fused(z2, d, c);
    Real q = fused(z2 * z2, c, a);
    return real(bits(fused(r * z, q, r)) ^ sign);
}

INLINE Real lane_sin(Real x)
{
    Real shifted = fused(x, splat(0x1.45f306dc9c883p-2), splat(ROUNDER));
    return sin_reduced(x, shifted - splat(ROUNDER), SHIFT_LEFT(bits(shifted), 63));
}

/* cos(x) = (-1)^(k + 1) sin(x - (k + 1/2) pi) */
INLINE Real lane_cos(Real x)
{
    Real turns = fused(x, splat(0x1.45f306dc9c883p-2), splat(-0.5));
    Real shifted = turns + splat(ROUNDER);
    Real k = (shifted - splat(ROUNDER)) + splat(0.5);
    return sin_reduced(x, k, SHIFT_LEFT(~bits(shifted), 63));
}

/* Sine and cosine together. */
typedef struct { Real sine, cosine; } Wave;
INLINE Wave lane_wave(Real x) { return (Wave){lane_sin(x), lane_cos(x)}; }
static __attribute__((noinline, cold)) Wave wave_anew(Real x) { return lane_wave(x); }

/* Sine and cosine of x, from those of x - d: for |d| < 0.14 by short series, whose first
 * terms left out are below 1e-17, anew for others. */
INLINE Wave lane_turned(Real s, Real c, Real d, Real x)
{
    Real z = d * d, z2 = z * z;
    Real a = fused(z, splat(1.0 / 120), splat(-1.0 / 6));
    Real b = fused(z, splat(1.0 / 24), splat(-0.5));
    Real a2 = fused(z, splat(1.0 / 362880), splat(-1.0 / 5040));
    Real b2 = fused(z, splat(1.0 / 40320), splat(-1.0 / 720));
    b2 = fused(z2, splat(-1.0 / 3628800), b2);
    Real sine = fused(d * z, fused(z2, a2, a), d);
    Real versed = z * fused(z2, b2, b); /* cos d - 1 */
    Wave w = {
        s + fused(c, sine, s * versed),
        c + fused(-s, sine, c * versed),
    };
    Mask is_small = less(magnitude(d), splat(0.14));
    if (likely(every(is_small))) return w;
    Wave anew = wave_anew(x);
    return (Wave){choose(is_small, w.sine, anew.sine), choose(is_small, w.cosine, anew.cosine)};
}

/* Relative error about 1e-16 |y log x|: good where the result is of moderate size. */
INLINE Real lane_pow(Real x, Real y)
{
    Real size = lane_exp(y * lane_log(magnitude(x)));
    Real whole = (magnitude(y) + splat(0x1p52)) - splat(0x1p52);
    Bits odd = SHIFT_LEFT(bits(magnitude(y) + splat(0x1p52)), 63);
    Real negative = choose(equal(whole, magnitude(y)), real(bits(size) | odd), splat(NAN));
    Real power = choose(less(x, splat(0)), negative, size);
    return choose(equal(y, splat(0)), splat(1), power);
}

/* Unlike C's fmax and fmin these do not forget a NaN. */
INLINE Real lane_fmax(Real a, Real b) { return choose(equal(a, a), larger(a, b), a); }
INLINE Real lane_fmin(Real a, Real b) { return choose(equal(a, a), smaller(a, b), a); }

INLINE Real lane_sign(Real x)
{
    return choose(equal(x, splat(0)), splat(0), choose(equal(x, x), with_sign(splat(1), x), x));
}
