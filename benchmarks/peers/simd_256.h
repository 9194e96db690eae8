/* Sixteen rollouts at once by hand for AVX2 and FMA: a chunk of steps of the motion, then the
 * damage of what was kept of it. */
#include "lanes_256.h"
#include "motion_256.h"
#include "damage_256.h"

#define LANES (4 * NV)

static void write_end(const struct machine *m, const struct motion *y, const struct totals *t,
                      int64_t stride, const double *start, double *end)
{
    double per_turn = m->h / (2 * M_PI) / (0.1e6 * m->a1);
    double F = m->J2 / (m->h * m->h * m->radius), w = 1 / m->h;
    V q2 = y->q1 - y->x12, W2 = y->W1 - y->v12;
    V ends[N_STATES] = {
        y->q1, q2, q2 - y->x23, y->W1 * w, W2 * w, (W2 - y->v23) * w,
        t->D[0] * (per_turn * pow(m->C1, -10. / 3)), t->D[1] * (per_turn * pow(m->C2, -10. / 3)),
        t->peak * F, vsqrt(t->P2[0]), vsqrt(t->P2[1])};
    for (int i = 0; i < N_STATES; ++i) {
        V before = load(start + i * stride);
        V x = i < 6 ? ends[i] : i < 8 ? before + ends[i] : vmax(before, ends[i]);
        store(end + i * stride, x);
    }
}

static void block(const struct machine *m, int64_t n_steps, int64_t stride, const double *k,
                  const double *gap, const double *start, double *end)
{
    struct bearings b = bearings(m);
    struct constants c[NV];
    struct motion y[NV];
    struct totals totals[NV] = {0};
    struct kept kept[NV];
    double h = m->h, w_fast = h * (20 * fmax(m->w_t1, m->w_t3) + 1);
    int sharp = 1;
    EACH {
        c[g] = constants(m, load(k + 4 * g), load(gap + 4 * g));
        y[g] = motion(m, stride, start + 4 * g);
        sharp &= c[g].sharp;
    }
    /* What a chunk of steps slows down by still leaves the friction's tanh saturated. */
    for (int64_t i = 0; i < n_steps; i += CHUNK) {
        int n = n_steps - i < CHUNK ? (int)(n_steps - i) : CHUNK, fast = 1;
        EACH fast &= !any(vmin(y[g].W1, y[g].W1 - y[g].v12 - y[g].v23) < w_fast);
        chunk(c, y, kept, n, fast, sharp);
        EACH damages(&b, n, &kept[g], &totals[g]);
    }
    EACH write_end(m, &y[g], &totals[g], stride, start + 4 * g, end + 4 * g);
}
