/* The keyed machine as someone would write it by hand, for the scalar and SIMD peers.
 * All in SI; bearings 1 and 2; a rollout is (stiffness, gap, start) -> totals. */
#include <math.h>
#include <stdint.h>

struct machine {
    double J1, J2, J3;                     /* inertias */
    double kappa0, omega0;                 /* coupling damping kappa0 k / omega0 */
    double radius, k_g, c_oil, smoothing;  /* key */
    double T4, p4, T8, p8;                 /* excitation and phases, orders 4 and 8 */
    double c_t1, T_f1, w_t1, c_t3, T_f3, w_t3; /* resistances */
    double lever1, lever2, G1, G2;         /* force and weight on each bearing */
    double C1, C2, Cu1, Cu2;               /* dynamic ratings, fatigue limits */
    double a1;                             /* reliability */
    double nu, D_pw, c1, c2;               /* viscosity mm^2/s, pitch mm, dirt */
    double h;                              /* time step */
};

#define N_STATES 11 /* three angles, three speeds, two damages, three peaks */
