/* Damage of a chunk of steps, ISO 281. It does not feed back into the motion, so steps are
 * independent of each other here. With P2 = P^2, u = P2^(-1/15) gives P^-0.4 as u^3 and
 * P^(10/3) as P2^2 u^5: one logarithm and one power of 2 for a bearing and step. */
#define LOG2_0_1 -3.321928094887362
#define LOG2_0_4 -1.3219280948873622
#define BREAKS 12
struct bearings {
    double lever[2], twice_G[2], G2[2], to_Cu[2];    /* lever of the scaled force; Cu^0.4 */
    double to_speed, slow, quick, dirt, dirt_factor; /* all but the first as log2 */
    double breaks[BREAKS];                           /* speeds where a law changes */
};
struct totals { V D[2], peak, P2[2]; };

static struct bearings bearings(const struct machine *m)
{
    double to_force = m->J2 / (m->h * m->h * m->radius), nu = log2(m->nu) + 0.5 * log2(m->D_pw);
    struct bearings b = {
        {m->lever1 * to_force, m->lever2 * to_force}, {2 * m->G1, 2 * m->G2},
        {m->G1 * m->G1, m->G2 * m->G2}, {pow(m->Cu1, 0.4), pow(m->Cu2, 0.4)},
        1 / m->h, nu - log2(45000), nu - log2(4500), log2(m->c1) + 0.55 * log2(m->D_pw),
        log2(1 - m->c2 / cbrt(m->D_pw)), {1e-3 * M_PI / 30, (1000 - 1e-6) * M_PI / 30}};
    double kappas[5] = {LOG2_0_1, LOG2_0_4, 0, 2, -b.dirt / 0.68};
    for (int i = 0; i < 5; ++i) { /* of the slow law and the quick one, whether or not in force there */
        b.breaks[2 + i] = exp2((kappas[i] - b.slow) / 0.83) * M_PI / 30;
        b.breaks[7 + i] = exp2((kappas[i] - b.quick) / 0.5) * M_PI / 30;
    }
    return b;
}

/* Reading e + t: (dirt kappa^0.68)^0.4 times the bracket's factor at a speed [rad/s], and the
 * powers of speed that e and t go with near it. */
struct powers { V e, t, of_e, of_t; };
static struct powers lubrication(const struct bearings *b, V speed)
{
    V n = vmax(speed * (30 / M_PI), S(1e-3)), log_n = vlog2(n);
    M slow = n < 1000 - 1e-6;
    V slope = choose(slow, S(0.83), S(0.5));
    V free = slope * log_n + choose(slow, S(b->slow), S(b->quick)), kappa = vmin(vmax(free, S(LOG2_0_1)), S(2.));
    slope = choose((free == kappa) & (n > 1e-3), slope, S(0.));
    M low = kappa < LOG2_0_4, middle = kappa < 0.;
    V e = choose(low, S(0.054381), choose(middle, S(0.19087), S(0.071739)));
    V dirt = b->dirt + 0.68 * kappa, of_e = choose(dirt < 0., 0.4 * 0.68 * slope, S(0.));
    dirt = 0.4 * (vmin(dirt, S(0.)) + b->dirt_factor);
    return (struct powers){1.5859 * vexp2(dirt), -choose(low, S(1.3993), S(1.2348)) * vexp2(dirt - e * kappa),
                           of_e, of_e - e * slope};
}

#define TERMS 6
#define NEAR 0.01 /* the series' next term is below 1e-13 there */

/* The factor of the bracket at all kept speeds: by a series about their middle, unless the law
 * changes in between or they lie far apart, as near standstill. */
static void bracket_factors(const struct bearings *b, int n, const V *W3, V *speeds, V *factor)
{
    V least = S(1e300), most = S(0.);
    for (int i = 0; i < n; ++i) {
        speeds[i] = vabs(W3[i]) * b->to_speed;
        least = vmin(least, speeds[i]); most = vmax(most, speeds[i]);
    }
    V about = 0.5 * (least + most);
    M apart = most - about > NEAR * about;
    for (int j = 0; j < BREAKS; ++j) apart |= (least <= b->breaks[j]) & (b->breaks[j] <= most);
    if (any(apart)) {
        for (int i = 0; i < n; ++i) { struct powers p = lubrication(b, speeds[i]); factor[i] = p.e + p.t; }
        return;
    }
    struct powers p = lubrication(b, about);
    V inverse = 1. / about, series[TERMS], e = p.e, t = p.t;
    for (int j = 0; j < TERMS; ++j) {
        series[j] = e + t;
        e *= (p.of_e - j) * (1. / (j + 1)); t *= (p.of_t - j) * (1. / (j + 1));
    }
    for (int i = 0; i < n; ++i) {
        V d = speeds[i] * inverse - 1., sum = series[TERMS - 1];
        for (int j = TERMS - 2; j >= 0; --j) sum = sum * d + series[j];
        factor[i] = sum;
    }
}

static const double POWER[] = { /* (1 - y)^1.185 */
    1.0000000000000648, -1.1850000000445557, 0.10961250504225781, 0.029777839553719158, 0.013516885395813161,
    0.007538509747461015, 0.005425416739041049, -1.3713862969512086e-05, 0.015178602192217002,
    -0.03078432686520079, 0.05538137076604364, -0.05190246230803794, 0.025505243091444082};

/* (1 - y)^9.185, held where a_ISO is 50. */
IN void bracket_powers(V *y, V *power)
{
    V b[FOUR];
    ALL y[i] = vmin(y[i], S(1 - 0.5083403685049885));
    polynomials(POWER, 12, y, power);
    ALL b[i] = 1. - y[i];
    ALL b[i] *= b[i];
    ALL b[i] *= b[i];
    ALL power[i] *= b[i] * b[i];
}

/* Loops short enough that the processor has several of their items in hand at once. */
static void damages(const struct bearings *b, int n, struct kept *kept, struct totals *totals)
{
    V speed[CHUNK], factor[CHUNK], square[2 * CHUNK], root[2 * CHUNK];
    struct totals t = *totals;
    for (; n % FOUR; ++n) { /* whole fours, with copies of the last step at standstill */
        kept->F[n] = kept->F[n - 1]; kept->q3[n] = kept->q3[n - 1]; kept->W3[n] = S(0.);
    }
    for (int start = 0; start < n; start += FOUR) {
        V cosine[FOUR];
        cosines(kept->q3 + start, cosine);
        ALL {
            V F = kept->F[start + i];
            t.peak = vmax(t.peak, vabs(F));
            for (int j = 0; j < 2; ++j) {
                V Fr = F * b->lever[j], P2 = vmax(Fr * (Fr + b->twice_G[j] * cosine[i]) + b->G2[j], S(1e-6));
                t.P2[j] = vmax(t.P2[j], P2);
                square[2 * (start + i) + j] = P2;
            }
        }
    }
    for (int start = 0; start < 2 * n; start += FOUR) {
        V log[FOUR];
        log2s(square + start, log);
        ALL log[i] *= -1. / 15;
        exp2s(log, root + start);
    }
    bracket_factors(b, n, kept->W3, speed, factor);
    for (int start = 0; start < 2 * n; start += FOUR) { /* P^-0.4 and P^(10/3) from P^(-2/15) */
        V u2[FOUR], u3[FOUR], y[FOUR], power[FOUR];
        ALL u2[i] = root[start + i] * root[start + i];
        ALL u3[i] = u2[i] * root[start + i];
        ALL y[i] = factor[(start + i) / 2] * b->to_Cu[i % 2] * u3[i];
        bracket_powers(y, power);
        ALL {
            V P2 = square[start + i];
            t.D[i % 2] += (speed[(start + i) / 2] * power[i]) * ((P2 * P2) * (u2[i] * u3[i]));
        }
    }
    *totals = t;
}
