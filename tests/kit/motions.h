// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_MOTIONS_H
#define BMR_TEST_MOTIONS_H

#include <string.h>

#include "boomerang/hierarchy.h"
#include "boomerang/motion.h"
#include "boomerang/pair.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Motions of two polygons for tests, and how far apart they really are.

/// The distance of the two polygons, 0 where they overlap, in rational arithmetic and rounded once
/// (exact_distance.h). O(n + m).
double test_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a);

/// Where B must be, turned by `angle`, to have A's and B's supports in `direction` (radians) `gap` apart: the
/// distance is then at most |gap|, and `gap` when the closest direction is that one.
bmr_pose test_pose_at(const bmr_polygon *a, const bmr_polygon *b, double direction, double angle, double gap);

typedef enum test_motion_kind {
    TEST_MOTION_LINE,    ///< a straight pass without rotation
    TEST_MOTION_TUMBLE,  ///< a straight pass, spinning
    TEST_MOTION_ORBIT,   ///< around the other, at a fixed gap
    TEST_MOTION_ROLLING, ///< around the other and spinning, gap breathing, in and out of contact
    TEST_MOTION_SPIN,    ///< spinning in place
    TEST_MOTION_WANDER,  ///< a random walk in all three
    TEST_MOTION_TREMBLE, ///< noise of some 1e-7 around a touching place
    TEST_MOTION_JUMP,    ///< anywhere at each step
    TEST_MOTION_KIND_COUNT
} test_motion_kind;

/// A motion of two polygons. Lengths are in units of the smaller polygon's size.
typedef struct test_motion {
    test_motion_kind kind;
    const bmr_polygon *a, *b;
    double unit;
    double direction, angle, gap;       ///< now
    double direction_speed, spin, rush; ///< per step
    bmr_vec2 position, velocity;        ///< for the straight and the fixed ones
} test_motion;
test_motion test_motion_make(test_motion_kind kind, const bmr_polygon *a, const bmr_polygon *b,
                             test_random *random);
bmr_pose test_motion_next(test_motion *motion, test_random *random);

/// A pair of two polygons that knows nothing yet. Each has the hierarchy that the structure walks on; none
/// for the free direction. Takes the polygons over.
typedef struct test_pair {
    bmr_shape shape[2];
    bmr_pair_def def;
    bmr_pair pair;
    bmr_counters counters; ///< of test_pair_advance
} test_pair;
test_pair test_pair_make(bmr_structure structure, bmr_polygon *a, bmr_polygon *b);
void test_pair_destroy(test_pair *pair);
#define own_pair OWNED(test_pair_destroy) test_pair
/// `gap` may be NULL.
bmr_answer test_pair_advance(test_pair *pair, const bmr_pose *pose, double *gap);
/// bmr_pair_audit; prints the pair if that is not BMR_OK.
bmr_error test_pair_audit(const test_pair *pair, const bmr_pose *pose);

// --- pieces of motions ---

/// A path whose a and b are 1 and 0 at `origin`, which its terms are about: x and y alone are asked for where
/// it does not turn. O(1).
static inline bmr_motion_piece test_algebraic(double origin, bmr_algebraic_piece path) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = origin;
    piece.as.algebraic = path;
    piece.as.algebraic.a[0] = piece.as.algebraic.start_c = 1.0;
    return piece;
}

/// Lets a piece begin at this time and pose, with the rates that it has: what a change of plan asks for.
/// O(1).
static inline void test_piece_begin(bmr_motion_piece *piece, double time, bmr_pose pose) {
    if (piece->kind == BMR_PIECE_SCREW) {
        piece->as.screw.start = pose;
    } else {
        piece->as.algebraic.x[0] = pose.position.x;
        piece->as.algebraic.y[0] = pose.position.y;
        piece->as.algebraic.a[0] = 1.0;
        piece->as.algebraic.b[0] = 0.0;
        piece->as.algebraic.start_c = pose.c;
        piece->as.algebraic.start_s = pose.s;
    }
    piece->origin = time;
}

#ifdef __cplusplus
}
#endif
#endif
