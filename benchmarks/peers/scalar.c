/* One rollout by hand: ISO 281 through logarithms, 5 log and 5 exp for two bearings. */
#include "machine.h"

struct derived {
    double k, c_d, b, s, i_J1, i_J2, i_J3, i_w1, i_w3;
    double log_kappa, log_ec, log_ec_factor, log_Cu[2], log_C[2], lever[2], G[2];
};

struct motion { double w1, w2, w3, a1, a2, a3, F; };

static inline double saturated_tanh(double u)
{
    if (u > 20) return 1;
    if (u < -20) return -1;
    return tanh(u);
}

static inline struct motion rates(const struct machine *m, const struct derived *d,
                                  double q1, double q2, double q3, double w1, double w2, double w3)
{
    double T1 = m->T4 * sin(4 * q1 + m->p4) + m->T8 * sin(8 * q1 + m->p8)
                - m->c_t1 * w1 - m->T_f1 * saturated_tanh(w1 * d->i_w1);
    double Td = m->c_t3 * w3 + m->T_f3 * saturated_tanh(w3 * d->i_w3);
    double Tc = d->k * (q1 - q2) + d->c_d * (w1 - w2);
    double x = q2 - q3, l = x - d->b, r = x + d->b;
    double f = x + 0.5 * (l * saturated_tanh(d->s * l) - r * saturated_tanh(d->s * r));
    double F = m->k_g * f + m->c_oil * (w2 - w3);
    struct motion y = {w1, w2, w3, (T1 - Tc) * d->i_J1, (Tc - F) * d->i_J2, (F - Td) * d->i_J3, F};
    return y;
}

static void damages(const struct machine *m, const struct derived *d, double Fc,
                    double w3, double cos_q3, double *y)
{
    double speed = fabs(w3), n = fmax(speed * (30 / M_PI), 1e-3), log_n = log(n);
    int slow = n < 1000 - 1e-6;
    double lk = d->log_kappa + (slow ? 0.83 * log_n - log(45000.) : 0.5 * log_n - log(4500.));
    lk = fmin(fmax(lk, log(0.1)), log(4.));
    int low = lk < log(0.4), middle = lk < 0;
    double e = low ? 0.054381 : middle ? 0.19087 : 0.071739;
    double X = 1.5859 - (low ? 1.3993 : 1.2348) * exp(-e * lk);
    double log_ec = fmin(d->log_ec + 0.68 * lk, 0.) + d->log_ec_factor;
    double turns = speed * m->h / (2 * M_PI);
    for (int i = 0; i < 2; ++i) {
        double Fr = d->lever[i] * Fc, G = d->G[i];
        double square = fmax(Fr * Fr + G * G + 2 * Fr * G * cos_q3, 1e-6);
        double log_P = 0.5 * log(square);
        double bracket = 1 - X * exp(0.4 * (log_ec + d->log_Cu[i] - log_P));
        bracket = fmax(bracket, 0.5083403685049885); /* a_ISO <= 50 */
        double log_life = 10. / 3 * (d->log_C[i] - log_P) - 9.185 * log(bracket);
        y[6 + i] += turns * exp(-log_life) / (0.1e6 * m->a1);
        y[9 + i] = fmax(y[9 + i], sqrt(square));
    }
    y[8] = fmax(y[8], fabs(Fc));
}

void march_scalar(const struct machine *m, int64_t n_steps, double k, double gap, double *y)
{
    struct derived d = {
        k, m->kappa0 * k / m->omega0, gap / (2 * m->radius), m->smoothing * m->radius,
        1 / m->J1, 1 / m->J2, 1 / m->J3, 1 / m->w_t1, 1 / m->w_t3,
        log(m->nu) + 0.5 * log(m->D_pw), log(m->c1) + 0.55 * log(m->D_pw),
        log(1 - m->c2 / cbrt(m->D_pw)), {log(m->Cu1), log(m->Cu2)}, {log(m->C1), log(m->C2)},
        {m->lever1, m->lever2}, {m->G1, m->G2}};
    double h = m->h;
    for (int64_t i = 0; i < n_steps; ++i) {
        double q1 = y[0], q2 = y[1], q3 = y[2], w1 = y[3], w2 = y[4], w3 = y[5];
        struct motion A = rates(m, &d, q1, q2, q3, w1, w2, w3);
#define AT(M, t) rates(m, &d, q1 + (t) * M.w1, q2 + (t) * M.w2, q3 + (t) * M.w3, \
                       w1 + (t) * M.a1, w2 + (t) * M.a2, w3 + (t) * M.a3)
        struct motion B = AT(A, h / 2), C = AT(B, h / 2), D = AT(C, h);
        damages(m, &d, A.F / m->radius, w3, cos(q3), y);
#define STEP(v) (h / 6 * (A.v + 2 * (B.v + C.v) + D.v))
        y[0] = q1 + STEP(w1); y[1] = q2 + STEP(w2); y[2] = q3 + STEP(w3);
        y[3] = w1 + STEP(a1); y[4] = w2 + STEP(a2); y[5] = w3 + STEP(a3);
    }
}
