/* One rollout by hand. Times are in steps: a speed W is an angle a step, a rate A an angle a
 * step squared. The state is what the torques know: twists x with their speeds v (1 less 2,
 * 2 less 3) and the engine's angle and speed. Damage does not feed back: what it needs is kept
 * for a chunk of steps and rated in a loop of its own, which the compiler turns into vectors. */
#include "machine.h"

#define CHUNK 64
#define IN static inline __attribute__((always_inline))

/* What does not change in a rollout. Torques are rates of the inertia they act on. */
struct constants {
    double k, c, k_g, c_oil, inverse_1_2, inverse_2_3; /* the last: J1 / J2, J2 / J3 */
    double edge, steep;                                /* half the gap; -2 s */
    double s4, c4, s8, c8, mean;                       /* excitation in sine and cosine of 4 q1 */
    double c_t1, T_f1, w_t1, c_t3, T_f3, w_t3;         /* w_t: inverse */
    int sharp;                                         /* saturated at the gap's other edge */
};
struct motion { double x12, x23, v12, v23, q1, W1, s, c; }; /* s, c: sine, cosine of 4 q1 */
struct rates { double a12, a23, a1, a3, F; };
struct kept { double F[CHUNK], W3[CHUNK], q3[CHUNK]; };

static struct constants constants(const struct machine *m, double k, double gap)
{
    double h = m->h, h2 = h * h, r = m->radius, s = m->smoothing * r, u = h2 / m->J1, b = gap / (2 * r);
    return (struct constants){
        k * u, k * (m->kappa0 / m->omega0 * h / m->J1), m->k_g * h2 / m->J2, m->c_oil * h / m->J2,
        m->J1 / m->J2, m->J2 / m->J3, b, -2 * s,
        u * m->T4 * cos(m->p4), u * m->T4 * sin(m->p4), 2 * u * m->T8 * cos(m->p8),
        -2 * u * m->T8 * sin(m->p8), u * m->T8 * sin(m->p8),
        h * m->c_t1 / m->J1, u * m->T_f1, 1 / (h * m->w_t1),
        h * m->c_t3 / m->J3, h2 * m->T_f3 / m->J3, 1 / (h * m->w_t3), s * b > 20};
}

IN double saturated_tanh(double u)
{
    return fabs(u) > 20 ? copysign(1, u) : tanh(u);
}

/* The contact's deflection: l (1 + tanh s l) / 2 + r (1 - tanh s r) / 2 of |x|, with the sign of x. */
IN double press(const struct constants *k, double x)
{
    double size = fabs(x), l = size - k->edge, f = l / (1 + exp(fmin(l * k->steep, 700)));
    if (!k->sharp) f += (size + k->edge) / (1 + exp(fmin((size + k->edge) * -k->steep, 700)));
    return copysign(1, x) * f;
}

IN double excitation(const struct constants *k, double s, double c)
{
    return s * (k->s4 + s * k->c8) + (c * (k->c4 + s * k->s8) + k->mean);
}

IN struct rates rates(const struct constants *k, double T, double f, double x12, double v12, double v23,
                      double W1, double W3)
{
    double T1 = T - k->c_t1 * W1 - k->T_f1 * saturated_tanh(W1 * k->w_t1);
    double T3 = k->c_t3 * W3 + k->T_f3 * saturated_tanh(W3 * k->w_t3);
    double Tc = k->k * x12 + k->c * v12, F = k->k_g * f + k->c_oil * v23;
    double A1 = T1 - Tc, A2 = Tc * k->inverse_1_2 - F, A3 = F * k->inverse_2_3 - T3;
    return (struct rates){A1 - A2, A2 - A3, A1, A3, F};
}

/* Runge and Kutta's step for angles with their speeds, stages A to D. A and B lie at positions
 * known at once, C and D wait for the rates of A and B only. */
static void step(const struct constants *k, struct motion *y, struct kept *kept, int i)
{
    /* 4 q1 turns by d up to the middle, by as much again up to the end; d is 0.05 at most. */
    double d = 2 * y->W1, z = d * d;
    double s = d + d * z * (-1. / 6 + z * (1. / 120)), c = 1 + z * (-0.5 + z * (1. / 24 - z * (1. / 720)));
    double s_B = y->s * c + y->c * s, c_B = y->c * c - y->s * s, s_D = s_B * c + c_B * s, c_D = c_B * c - s_B * s;
    double x12 = y->x12 + 0.5 * y->v12, x23 = y->x23 + 0.5 * y->v23, W3 = y->W1 - y->v12 - y->v23;
    double f_A = press(k, y->x23), f_B = press(k, x23);
    struct rates A = rates(k, excitation(k, y->s, y->c), f_A, y->x12, y->v12, y->v23, y->W1, W3);
    struct rates B = rates(k, excitation(k, s_B, c_B), f_B, x12, y->v12 + 0.5 * A.a12, y->v23 + 0.5 * A.a23,
                           y->W1 + 0.5 * A.a1, W3 + 0.5 * A.a3);
    double f_C = press(k, x23 + 0.25 * A.a23), f_D = press(k, y->x23 + y->v23 + 0.5 * B.a23);
    /* What the rates turn 4 q1 further, 1e-5 at most: its square counts where it adds up. */
    double e = A.a1;
    struct rates C = rates(k, excitation(k, s_B + e * c_B, c_B - e * s_B), f_C, x12 + 0.25 * A.a12,
                           y->v12 + 0.5 * B.a12, y->v23 + 0.5 * B.a23, y->W1 + 0.5 * B.a1, W3 + 0.5 * B.a3);
    e = 2 * B.a1;
    struct rates D = rates(k, excitation(k, s_D + e * c_D, c_D - e * s_D), f_D, y->x12 + y->v12 + 0.5 * B.a12,
                           y->v12 + C.a12, y->v23 + C.a23, y->W1 + C.a1, W3 + C.a3);
    kept->F[i] = A.F; kept->W3[i] = W3; kept->q3[i] = y->q1 - y->x12 - y->x23;
    e = (A.a1 + B.a1 + C.a1) * (2. / 3);
    y->s = s_D + e * (c_D - 0.5 * e * s_D); y->c = c_D - e * (s_D + 0.5 * e * c_D);
#define ADVANCE(x, v, a) { \
    double middle = B.a + C.a, sum = A.a + middle; \
    y->x += y->v + sum * (1. / 6); y->v += ((sum + middle) + D.a) * (1. / 6); }
    ADVANCE(x12, v12, a12) ADVANCE(x23, v23, a23) ADVANCE(q1, W1, a1)
}

/* ISO 281 through logarithms; of two bearings, damage and peak load. */
struct bearings {
    double lever[2], G[2], to_Cu[2], log_C[2]; /* lever of the scaled force; Cu^0.4 */
    double to_speed, log_kappa, log_ec, log_ec_factor, per_turn;
};

static struct bearings bearings(const struct machine *m)
{
    double to_force = m->J2 / (m->h * m->h * m->radius);
    return (struct bearings){
        {m->lever1 * to_force, m->lever2 * to_force}, {m->G1, m->G2}, {pow(m->Cu1, 0.4), pow(m->Cu2, 0.4)},
        {log(m->C1), log(m->C2)}, 1 / m->h, log(m->nu) + 0.5 * log(m->D_pw), log(m->c1) + 0.55 * log(m->D_pw),
        log(1 - m->c2 / cbrt(m->D_pw)), m->h / (2 * M_PI) / (0.1e6 * m->a1)};
}

/* The factor of (P / Cu)^-0.4 in the bracket of a_ISO. */
IN double bracket_factor(const struct bearings *b, double speed)
{
    double n = fmax(speed * (30 / M_PI), 1e-3), log_n = log(n);
    double lk = b->log_kappa + (n < 1000 - 1e-6 ? 0.83 * log_n - 10.714417768752456 : 0.5 * log_n - 8.411832675758411);
    lk = fmin(fmax(lk, -2.302585092994046), 1.3862943611198906);
    int low = lk < -0.916290731874155;
    double e = low ? 0.054381 : lk < 0 ? 0.19087 : 0.071739;
    double log_ec = fmin(b->log_ec + 0.68 * lk, 0) + b->log_ec_factor;
    return (1.5859 - (low ? 1.3993 : 1.2348) * exp(-e * lk)) * exp(0.4 * log_ec);
}

/* Of one bearing; its loop and those below become vectors with the C library's log, exp and cos. */
static void bearing(const struct bearings *b, int j, int n, const double *F, const double *speed,
                    const double *cosine, const double *factor, double *damage, double *peak2)
{
    double sum = 0, most = *peak2, lever = b->lever[j], G = b->G[j], log_C = b->log_C[j], to_Cu = b->to_Cu[j];
    for (int i = 0; i < n; ++i) {
        double Fr = lever * F[i], P2 = fmax(Fr * (Fr + 2 * G * cosine[i]) + G * G, 1e-6), log_P = 0.5 * log(P2);
        double bracket = fmax(1 - factor[i] * to_Cu * exp(-0.4 * log_P), 0.5083403685049885); /* a_ISO <= 50 */
        sum += speed[i] * exp(9.185 * log(bracket) + 10. / 3 * (log_P - log_C));
        most = fmax(most, P2);
    }
    *damage += sum * b->per_turn; *peak2 = most;
}

static void damages(const struct bearings *b, int n, const struct kept *kept, double *damage, double *peak)
{
    double speed[CHUNK], factor[CHUNK], cosine[CHUNK], largest = peak[0];
    for (int i = 0; i < n; ++i) speed[i] = fabs(kept->W3[i]) * b->to_speed;
    for (int i = 0; i < n; ++i) factor[i] = bracket_factor(b, speed[i]);
    for (int i = 0; i < n; ++i) { cosine[i] = cos(kept->q3[i]); largest = fmax(largest, fabs(kept->F[i])); }
    for (int j = 0; j < 2; ++j) bearing(b, j, n, kept->F, speed, cosine, factor, &damage[j], &peak[1 + j]);
    peak[0] = largest;
}

void march_scalar(const struct machine *m, int64_t n_steps, double k, double gap, double *y)
{
    struct constants c = constants(m, k, gap);
    struct bearings b = bearings(m);
    double h = m->h, to_force = m->J2 / (h * h * m->radius), damage[2] = {0}, peak[3] = {0};
    struct motion s = {y[0] - y[1], y[1] - y[2], (y[3] - y[4]) * h, (y[4] - y[5]) * h, y[0], y[3] * h};
    for (int64_t i = 0; i < n_steps; i += CHUNK) {
        int n = n_steps - i < CHUNK ? (int)(n_steps - i) : CHUNK;
        struct kept kept;
        s.s = sin(4 * s.q1); s.c = cos(4 * s.q1);
        for (int j = 0; j < n; ++j) step(&c, &s, &kept, j);
        damages(&b, n, &kept, damage, peak);
    }
    y[0] = s.q1; y[1] = s.q1 - s.x12; y[2] = y[1] - s.x23;
    y[3] = s.W1 / h; y[4] = (s.W1 - s.v12) / h; y[5] = (s.W1 - s.v12 - s.v23) / h;
    for (int j = 0; j < 2; ++j) { y[6 + j] += damage[j]; y[9 + j] = fmax(y[9 + j], sqrt(peak[1 + j])); }
    y[8] = fmax(y[8], peak[0] * to_force);
}
