// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONVEX32_POSES_H
#define BOOMERANG_TEST_CONVEX32_POSES_H

#include "convex32/convex32.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Random and adversarial polygons of any size, and pairs of poses: resting, sliding, corner to corner, deep.

typedef enum convex32_kind {
    KIND_REGULAR,
    KIND_ELLIPSE, ///< down to needles
    KIND_RANDOM,
    KIND_CLUSTERED, ///< nearly all vertices in a few short arcs
    KIND_ROUNDED,   ///< a box whose corners are quarter circles
    KIND_HALF,      ///< half a disc: one long edge, many short
    KIND_BOX,
    KIND_TRIANGLE,
    KINDS
} convex32_kind;

/// Of about `count` vertices (boxes and triangles have theirs) and sizes from 0.05 to 5, somewhere near the
/// origin. Never NULL.
bmr_convex32_block *random_convex32(test_random *d, convex32_kind kind, uint32_t count);
convex32_kind random_kind(test_random *d);

bmr_transform32 random_pose32(test_random *d, double range);

/// Puts b against a, which stays where it is: their separation along some direction is from -1.5 to 2.5 times
/// `skin`, or anything down to concentric.
bmr_transform32 pose_against(test_random *d, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                             const bmr_convex32 *b, double skin);

/// A step later: both have moved and turned by a little.
bmr_transform32 moved_a_little(test_random *d, const bmr_transform32 *pose, double step);

#ifdef __cplusplus
}
#endif
#endif
