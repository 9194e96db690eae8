/* The motion of sixteen rollouts, four vectors of four lanes, in chunks of steps.
 *
 * Times are in steps: a speed W is an angle a step, a rate A an angle a step squared, and h
 * is in the constants. The state is what the torques know: twists x with their speeds v (1
 * less 2, 2 less 3) and the engine's angle and speed. */
#define NV 4
#define EACH UNROLLED for (int g = 0; g < NV; ++g)
#define CHUNK 64 /* steps: what is kept of them fits the first cache; a multiple of FOUR */

/* What does not change in a rollout. Torques are rates of the inertia they act on. */
struct constants {
    V k, c, k_g, c_oil, inverse_1_2, inverse_2_3; /* the last: J1 / J2, J2 / J3 */
    V edge, steep;                                /* half the gap; -2 s log2 e */
    V s4, c4, s8, c8, mean, mean_fast;            /* excitation in sine and cosine of 4 q1 */
    V c_t1, T_f1, w_t1, c_t3, T_f3, w_t3;         /* w_t: inverse */
    int sharp;                                    /* saturated at the gap's other edge */
};
struct motion { V x12, x23, v12, v23, q1, W1, s, c; }; /* s, c: sine, cosine of 4 q1 */
struct rates { V a12, a23, a1, a3; };
struct kept { V F[CHUNK], W3[CHUNK], q3[CHUNK]; }; /* of a vector, for its damage */

static struct constants constants(const struct machine *m, V k, V gap)
{
    double h = m->h, h2 = h * h, r = m->radius, s = m->smoothing * r, u = h2 / m->J1;
    V b = gap / (2 * r), s_b = s * b;
    return (struct constants){
        k * u, k * (m->kappa0 / m->omega0 * h / m->J1), S(m->k_g * h2 / m->J2), S(m->c_oil * h / m->J2),
        S(m->J1 / m->J2), S(m->J2 / m->J3), b, S(-2 * s * M_LOG2E),
        S(u * m->T4 * cos(m->p4)), S(u * m->T4 * sin(m->p4)), S(2 * u * m->T8 * cos(m->p8)),
        S(-2 * u * m->T8 * sin(m->p8)), S(u * m->T8 * sin(m->p8)), S(u * (m->T8 * sin(m->p8) - m->T_f1)),
        S(h * m->c_t1 / m->J1), S(u * m->T_f1), S(1 / (h * m->w_t1)),
        S(h * m->c_t3 / m->J3), S(h2 * m->T_f3 / m->J3), S(1 / (h * m->w_t3)), !any(s_b < 20.)};
}

static struct motion motion(const struct machine *m, int64_t stride, const double *start)
{
    V q1 = load(start), q2 = load(start + stride), q3 = load(start + 2 * stride);
    V w1 = load(start + 3 * stride), w2 = load(start + 4 * stride), w3 = load(start + 5 * stride);
    return (struct motion){q1 - q2, q2 - q3, (w1 - w2) * m->h, (w2 - w3) * m->h, q1, w1 * m->h};
}

/* The contact's deflections at two twists of two: l (1 + tanh s l) / 2 + r (1 - tanh s r) / 2
 * of |x|, with the sign of x. */
IN void press(const struct constants *ks, const V *x, V *f, int sharp)
{
    V l[FOUR], y[FOUR];
    ALL l[i] = vabs(x[i]) - ks[i % 2].edge;
    ALL y[i] = vmax(vmin(l[i] * ks->steep, S(1000.)), S(-1000.));
    exp2s(y, y);
    ALL f[i] = l[i] / (1. + y[i]);
    if (!sharp) {
        ALL y[i] = vmax((vabs(x[i]) + ks[i % 2].edge) * ks->steep, S(-1000.));
        exp2s(y, y);
        ALL f[i] += (vabs(x[i]) + ks[i % 2].edge) * (y[i] / (1. + y[i]));
    }
    ALL f[i] = (V)((M)f[i] ^ ((M)x[i] & SIGN));
}

IN V excitation(const struct constants *k, V s, V c, int fast)
{
    return s * (k->s4 + s * k->c8) + (c * (k->c4 + s * k->s8) + (fast ? k->mean_fast : k->mean));
}

/* `fast`: too fast for the friction's tanh, which is in the excitation's mean then. */
IN struct rates rates(const struct constants *k, V T, V f, V x12, V v12, V v23, V W1, V W3, int fast, V *F)
{
    V T3 = k->c_t3 * W3 + (fast ? k->T_f3 : k->T_f3 * vtanh(W3 * k->w_t3));
    V T1 = T - k->c_t1 * W1;
    if (!fast) T1 -= k->T_f1 * vtanh(W1 * k->w_t1);
    V Tc = k->k * x12 + k->c * v12, A1 = T1 - Tc;
    *F = k->k_g * f + k->c_oil * v23;
    V A2 = Tc * k->inverse_1_2 - *F, A3 = *F * k->inverse_2_3 - T3;
    return (struct rates){A1 - A2, A2 - A3, A1, A3};
}

/* What a step of a vector has found so far: stage A at its start, B and C in the middle, D at
 * the end. A and B lie at positions known at once, C and D wait for the rates of A and B only:
 * the contacts of two stages and two vectors are worked out together. */
struct found { V s_B, c_B, s_D, c_D, T_A, T_B, W3; struct rates A, B; };

IN void start(const struct constants *k, const struct motion *y, struct found *o, int fast)
{
    /* 4 q1 turns by d up to the middle, by as much again up to the end; d is 0.05 at most. */
    V d = 2. * y->W1, z = d * d;
    V s = d + d * z * (-1. / 6 + z * (1. / 120)), c = 1. + z * (-0.5 + z * (1. / 24 - z * (1. / 720)));
    o->s_B = y->s * c + y->c * s; o->c_B = y->c * c - y->s * s;
    o->s_D = o->s_B * c + o->c_B * s; o->c_D = o->c_B * c - o->s_B * s;
    o->T_A = excitation(k, y->s, y->c, fast); o->T_B = excitation(k, o->s_B, o->c_B, fast);
    o->W3 = y->W1 - y->v12 - y->v23;
}

IN void first_rates(const struct constants *k, const struct motion *y, struct found *o, V f_A, V f_B, int fast, V *F)
{
    V ignored;
    o->A = rates(k, o->T_A, f_A, y->x12, y->v12, y->v23, y->W1, o->W3, fast, F);
    o->B = rates(k, o->T_B, f_B, y->x12 + 0.5 * y->v12, y->v12 + 0.5 * o->A.a12, y->v23 + 0.5 * o->A.a23,
                 y->W1 + 0.5 * o->A.a1, o->W3 + 0.5 * o->A.a3, fast, &ignored);
}

IN void finish_step(const struct constants *k, struct motion *y, const struct found *o, V f_C, V f_D, int fast)
{
    /* What the rates turn 4 q1 further, 1e-5 at most: its square counts where it adds up. */
    struct rates A = o->A, B = o->B, C, D;
    V e = A.a1, T = excitation(k, o->s_B + e * o->c_B, o->c_B - e * o->s_B, fast), ignored;
    C = rates(k, T, f_C, y->x12 + 0.5 * y->v12 + 0.25 * A.a12, y->v12 + 0.5 * B.a12, y->v23 + 0.5 * B.a23,
              y->W1 + 0.5 * B.a1, o->W3 + 0.5 * B.a3, fast, &ignored);
    e = 2. * B.a1; T = excitation(k, o->s_D + e * o->c_D, o->c_D - e * o->s_D, fast);
    D = rates(k, T, f_D, y->x12 + y->v12 + 0.5 * B.a12, y->v12 + C.a12, y->v23 + C.a23,
              y->W1 + C.a1, o->W3 + C.a3, fast, &ignored);
    e = (A.a1 + B.a1 + C.a1) * (2. / 3);
    y->s = o->s_D + e * (o->c_D - 0.5 * e * o->s_D); y->c = o->c_D - e * (o->s_D + 0.5 * e * o->c_D);
#define ADVANCE(x, v, a) { \
    V middle = B.a + C.a, sum = A.a + middle; \
    y->x += y->v + sum * (1. / 6); y->v += ((sum + middle) + D.a) * (1. / 6); }
    ADVANCE(x12, v12, a12) ADVANCE(x23, v23, a23) ADVANCE(q1, W1, a1)
}

/* Runge and Kutta's step for angles with their speeds. */
IN void step(const struct constants *k, struct motion *y, struct kept *kept, int i, int fast, int sharp)
{
    V x[2 * NV], f[2 * NV];
    struct found o[NV];
#define ONE(g) (4 * ((g) / 2) + (g) % 2) /* two vectors' first stages, then their second ones */
#define TWO(g) (ONE(g) + 2)
#define PRESS UNROLLED for (int g = 0; g < NV; g += 2) press(&k[g], &x[ONE(g)], &f[ONE(g)], sharp);
    EACH { x[ONE(g)] = y[g].x23; x[TWO(g)] = y[g].x23 + 0.5 * y[g].v23; }
    EACH {
        start(&k[g], &y[g], &o[g], fast);
        kept[g].W3[i] = o[g].W3; kept[g].q3[i] = y[g].q1 - y[g].x12 - y[g].x23;
    }
    PRESS
    EACH {
        first_rates(&k[g], &y[g], &o[g], f[ONE(g)], f[TWO(g)], fast, &kept[g].F[i]);
        x[ONE(g)] = x[TWO(g)] + 0.25 * o[g].A.a23; x[TWO(g)] = y[g].x23 + y[g].v23 + 0.5 * o[g].B.a23;
    }
    PRESS
    EACH finish_step(&k[g], &y[g], &o[g], f[ONE(g)], f[TWO(g)], fast);
}

static void chunk(const struct constants *k, struct motion *motion, struct kept *kept, int n, int fast, int sharp)
{
    struct motion y[NV];
    EACH {
        y[g] = motion[g];
        V angles[FOUR] = {4. * y[g].q1 - M_PI_2, 4. * y[g].q1}, found[FOUR];
        cosines(angles, found);
        y[g].s = found[0]; y[g].c = found[1];
    }
    if (fast && sharp) for (int i = 0; i < n; ++i) step(k, y, kept, i, 1, 1);
    else if (sharp) for (int i = 0; i < n; ++i) step(k, y, kept, i, 0, 1);
    else for (int i = 0; i < n; ++i) step(k, y, kept, i, 0, 0);
    EACH motion[g] = y[g];
}
