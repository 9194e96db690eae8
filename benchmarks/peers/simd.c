/* The batch by hand, for the widest vectors there are. */
#include "machine.h"
#ifdef __AVX512DQ__
#include "simd_512.h"
#else
#include "simd_256.h"
#endif

/* A whole number of blocks of LANES columns; states is (N_STATES, batch). */
void march_simd(const struct machine *m, int64_t n_steps, int64_t batch, const double *k,
                const double *gap, const double *states, double *ends)
{
    for (int64_t i = 0; i < batch; i += LANES)
        block(m, n_steps, batch, k + i, gap + i, states + i, ends + i);
}
