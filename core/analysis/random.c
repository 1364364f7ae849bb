// SPDX-License-Identifier: MIT
#include "analysis/random.h"

#include "kinetic/roots.h"

gsl_rng *bmr_random_create(uint64_t seed) {
    bmr_gsl_guard_enter();
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    bmr_gsl_guard_leave();
    if (random) // the upper half is folded in: the generator takes 32 bits
        gsl_rng_set(random, (unsigned long)((seed ^ (seed >> 32) * 2654435761u) & 0xffffffffu));
    return random;
}
