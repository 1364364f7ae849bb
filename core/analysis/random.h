// SPDX-License-Identifier: MIT
#ifndef BMR_ANALYSIS_RANDOM_H
#define BMR_ANALYSIS_RANDOM_H

#include <stdint.h>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

/// A generator of this seed, to be given to gsl_rng_free; NULL if there is no memory (GSL's handler, which
/// would abort, is kept off).
gsl_rng *bmr_random_create(uint64_t seed);

#endif
