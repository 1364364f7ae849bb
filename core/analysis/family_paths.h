// SPDX-License-Identifier: MIT
#ifndef BMR_ANALYSIS_FAMILY_PATHS_H
#define BMR_ANALYSIS_FAMILY_PATHS_H

#include "boomerang/families.h"

#include <gsl/gsl_rng.h>

/// One random draw for each leg of a walk: standard normal, all three.
typedef struct bmr_walk_draw {
    double x, y, angle;
} bmr_walk_draw;

/// A family's motion before its free parameter is known: everything random is drawn here, once.
typedef struct bmr_family_plan {
    bmr_family family;
    const bmr_polygon *a, *b;
    double diameter, sigma;
    bmr_pose turn;   ///< B's rotation at the start; position 0
    bmr_vec2 toward; ///< unit direction from A to B at the near place (or the start)
    double bend, spin;
    double x[BMR_MOTION_MAX_DEGREE + 1], y[BMR_MOTION_MAX_DEGREE + 1]; ///< in half times, -1 .. 1
    double half_turn[2]; ///< of A, the rational rotation's b[1] and b[2], likewise
    size_t degree, steps;
    bmr_walk_draw *draws; ///< `steps` of them, or NULL
} bmr_family_plan;

/// Makes the motions for a value of the free parameter: a gap in length units, or for the polynomial paths
/// and SPIN a scale in length units.
typedef bmr_error (*bmr_family_path)(const bmr_family_plan *plan, double parameter,
                                     const bmr_allocator *allocator, bmr_motion *motions[2]);

bmr_error bmr_path_pass(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                        bmr_motion *motions[2]);
bmr_error bmr_path_polynomial(const bmr_family_plan *plan, double scale, const bmr_allocator *allocator,
                              bmr_motion *motions[2]);
bmr_error bmr_path_spin(const bmr_family_plan *plan, double distance, const bmr_allocator *allocator,
                        bmr_motion *motions[2]);
bmr_error bmr_path_to_and_fro(const bmr_family_plan *plan, double distance, const bmr_allocator *allocator,
                              bmr_motion *motions[2]);
bmr_error bmr_path_zigzag(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                          bmr_motion *motions[2]);
bmr_error bmr_path_brownian(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                            bmr_motion *motions[2]);
bmr_error bmr_path_wander(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                          bmr_motion *motions[2]);
/// At distance `gap` exactly; no search.
bmr_error bmr_path_orbit(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                         bmr_motion *motions[2]);

/// A generator of this seed, to be given to gsl_rng_free; NULL if there is no memory (GSL's handler, which
/// would abort, is kept off).
gsl_rng *bmr_random_create(uint64_t seed);
/// Makes both motions of one piece each; walks go on from there.
bmr_error bmr_path_pieces(const bmr_motion_piece *a, const bmr_motion_piece *b,
                          const bmr_allocator *allocator, bmr_motion *motions[2]);
/// Gives both motions back if `error` is one; returns it.
bmr_error bmr_path_finish(bmr_error error, bmr_motion *motions[2]);
#endif
