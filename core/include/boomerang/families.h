// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FAMILIES_H
#define BOOMERANG_FAMILIES_H

#include <stdint.h>

#include "boomerang/motion.h"
#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Families of motions of two polygons with a chosen least separation, and polygons of n points to move on
/// them. The paper's table of event bounds is measured on these. In boomerang::kinetic. The same seed gives
/// the same bits everywhere (gsl_rng_mt19937).

typedef enum bmr_family {
    BMR_FAMILY_LINE,            ///< straight pass, no rotation
    BMR_FAMILY_PARABOLA,        ///< pass that bends away from A: a convex path
    BMR_FAMILY_ALGEBRAIC,       ///< polynomial path of degree 5
    BMR_FAMILY_ORBIT,           ///< once around A at the same distance all the time
    BMR_FAMILY_ZIGZAG,          ///< once around A in straight legs, in and out
    BMR_FAMILY_BROWNIAN,        ///< random walk in straight legs of random direction
    BMR_FAMILY_WANDER,          ///< random walk around A, the distance a random walk on the log scale
    BMR_FAMILY_SPIN,            ///< A turns once in place, B rests
    BMR_FAMILY_RIGID_ALGEBRAIC, ///< polynomial path of degree 4, rational rotation by polynomials of degree 2
    BMR_FAMILY_TUMBLE,          ///< straight pass of two bodies; one of them spins
    BMR_FAMILY_RIGID_BROWNIAN,  ///< Brownian, the angle too
    BMR_FAMILY_RIGID_WANDER,    ///< wander, the angle too
    BMR_FAMILY_TO_AND_FRO,      ///< A turns to and fro in place by 1.5 degrees, B rests
    BMR_FAMILY_COUNT
} bmr_family;

/// "line", "parabola", "algebraic", "orbit", "zigzag", "brownian", "wander", "spin", "rigid-algebraic",
/// "tumble", "rigid-brownian", "rigid-wander", "to-and-fro"; NULL for anything else.
const char *bmr_family_name(bmr_family family);
/// Does the relative rotation change? The families before SPIN translate only.
bool bmr_family_is_rigid(bmr_family family);
/// Is the path convex in the paper's sense (bending away from A)? Then one fixed line covers it.
bool bmr_family_is_convex(bmr_family family);

typedef struct bmr_family_def {
    bmr_family family;
    /// D/sigma: the larger diameter over the least separation, in [1, 1e9].
    double ratio;
    uint64_t seed;  ///< of directions, rotations and walks
    unsigned steps; ///< legs of zigzag (at least 8), Brownian, wander and to-and-fro; 0: 64, 1024, 256, 256
    unsigned turns; ///< of tumble; 0: 4
} bmr_family_def;

/// Motions of A and B for the times 0 to 1. B only translates; in the rigid families A turns about its
/// frame's origin, in the others it rests.
typedef struct bmr_family_motion {
    bmr_motion *motions[2];
    double diameter;   ///< D
    double sigma;      ///< D / ratio
    double separation; ///< the measured least separation, within 1 % of sigma
    double nearest;    ///< a time at which it occurs
} bmr_family_motion;

/// Makes the motion of two polygons. All families have one free parameter (an offset or a scale). It is
/// searched until the least separation over the motion, measured to 0.1 % by bmr_least_distance, is within
/// 0.5 % of sigma. The orbit is built at its distance from the polygons' edges and vertices, and checked once
/// in each piece. Takes milliseconds, more if the separation stays next to sigma for long (spin of a disc).
/// Errors: NULL_ARGUMENT, OUT_OF_RANGE (a def that makes no sense, two points, sigma below 1e-12 of the
/// extents), TOO_LARGE (more steps than can be addressed), NO_MEMORY, and those of bmr_motion_create.
bmr_error bmr_family_create(const bmr_family_def *def, const bmr_polygon *a, const bmr_polygon *b,
                            const bmr_allocator *allocator, bmr_family_motion *made);
/// Destroys the two motions.
void bmr_family_destroy(bmr_family_motion *made);

/// The largest distance between two vertices. O(n log n).
double bmr_polygon_diameter(const bmr_polygon *polygon);

/// The least distance of the two polygons over [from, to] (finite), to within `tolerance` (> 0, length units;
/// INFINITY: one sample of each piece). *distance is attained at *time, and nowhere is the distance smaller
/// by more than the tolerance. 0 if they touch. It subdivides by the bodies' speed bounds: a distance and a
/// speed close each interval. Cost: (speed * time / tolerance) distances at worst, if the distance stays
/// least. Errors: NULL_ARGUMENT, OUT_OF_RANGE (tolerance not positive, from > to).
bmr_error bmr_least_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_motion *motion_a,
                             const bmr_motion *motion_b, double from, double to, double tolerance,
                             double *distance, double *time);

/// Polygons of n points, all of diameter 2 or a little less, around the origin.
typedef enum bmr_ngon {
    BMR_NGON_REGULAR, ///< regular n-gon of circumradius 1, phase from the seed
    BMR_NGON_RANDOM,  ///< n random points on a 4:1 ellipse, turned: all are vertices
    BMR_NGON_LENS,    ///< two arcs of 60 degrees: two sharp corners
    BMR_NGON_ELLIPSE, ///< n points at equal eccentric angles on a 4:1 ellipse, turned
    BMR_NGON_DISC,    ///< regular n-gon of circumradius 1/2, phase from the seed
    BMR_NGON_COUNT
} bmr_ngon;
/// "regular", "random", "lens", "ellipse", "disc"; NULL for anything else.
const char *bmr_ngon_name(bmr_ngon kind);
/// Fills `points` (room for n >= 3) with the polygon's points. Errors: NULL_ARGUMENT, OUT_OF_RANGE (n < 3 or
/// above BMR_MAX_VERTICES, no such kind), NO_MEMORY.
bmr_error bmr_ngon_points(bmr_ngon kind, size_t n, uint64_t seed, bmr_vec2 *points);

#ifdef __cplusplus
}
#endif
#endif
