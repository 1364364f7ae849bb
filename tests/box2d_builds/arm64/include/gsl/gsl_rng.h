// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_ARM64_GSL_RNG_H
#define BMR_TEST_ARM64_GSL_RNG_H

#include <random>

/// @file
/// What the games use of the GNU Scientific Library, of which there is no build for another processor on most
/// machines. Other numbers than its own, so other games than elsewhere; each is held against stock on the
/// same numbers.

struct gsl_rng {
    std::mt19937_64 generator;
};
enum gsl_rng_type { gsl_rng_mt19937 };

inline gsl_rng *gsl_rng_alloc(gsl_rng_type) {
    return new gsl_rng;
}
inline void gsl_rng_free(gsl_rng *rng) {
    delete rng;
}
inline void gsl_rng_set(gsl_rng *rng, unsigned long seed) {
    rng->generator.seed(seed);
}
inline double gsl_rng_uniform(gsl_rng *rng) {
    return double{rng->generator() >> 11} * 0x1p-53;
}
inline unsigned long gsl_rng_uniform_int(gsl_rng *rng, unsigned long count) {
    return rng->generator() % count;
}

#endif
