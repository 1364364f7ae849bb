// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_ADVERSARIES_H
#define BMR_TEST_ADVERSARIES_H

#include <math.h>

#include "boomerang/analysis.h"
#include "checks.h"
#include "owned.h"

/// @file
/// Motions that cost the rivals as many events as the paper says (section 5, introduction), however far apart
/// the polygons are. From time 0 to 1; the polygons' diameter is about 2. In C.

enum { ADVERSARY_MOST_VERTICES = 4096 };

typedef enum adversary_kind {
    /// Two regular n-gons pass each other on a long straight line. All features on one side take part:
    /// Theta(n) events of closest features and inner tangents.
    ADVERSARY_PASS,
    /// A regular n-gon turns once in place before a nearly flat chain of n vertices as long as one of its
    /// edges: each corner sweeps over the whole chain, Theta(n^2) events of closest features.
    ADVERSARY_GEAR
} adversary_kind;

typedef struct adversary {
    bmr_polygon *polygons[2];
    bmr_motion *motions[2];
} adversary;

static inline bmr_polygon *adversary_polygon(const bmr_vec2 *points, size_t n) {
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create_raw(points, n, NULL, &polygon), BMR_OK);
    return polygon;
}

/// Its least separation is `separation` up to 1 % and the sagitta of an edge.
static inline adversary adversary_make(adversary_kind kind, size_t n, double separation) {
    const double pi = 3.14159265358979323846;
    bmr_vec2 points[ADVERSARY_MOST_VERTICES];
    assert_true(n <= ADVERSARY_MOST_VERTICES);
    // Turned by an odd angle: no edge is parallel to one of the other's for ever.
    for (size_t i = 0; i < n; i++) {
        const double angle = 0.1 + 2.0 * pi * (double)i / (double)n;
        points[i] = bmr_vec2_make(cos(angle), sin(angle));
    }
    adversary made = {.polygons = {adversary_polygon(points, n)}};
    bmr_motion_piece a = bmr_piece_rest(bmr_pose_identity()), b;
    if (kind == ADVERSARY_PASS) {
        // It begins and ends so far from the middle that the direction turns by all but a tenth of a radian
        // on either side.
        const double reach = 10.0 * (2.0 + separation);
        const bmr_pose middle = {{0.0, 2.0 + separation}, cos(0.2), sin(0.2)};
        b = bmr_piece_screw(0.5, middle, bmr_vec2_make(2.0 * reach, 0.0), 0.0);
    } else {
        // A corner of the gear sweeps to both sides by sin(pi / n); a little less is swept over whole. The
        // chain rises by so little that at the separation the vertices' regions are still of about the width
        // of their edges.
        const double half = 0.9 * sin(pi / (double)n), rise = 0.05 * half * half / (1.0 + separation);
        for (size_t i = 0; i + 1 < n; i++) {
            const double x = 1.0 - 2.0 * (double)i / (double)(n - 2); // counter-clockwise: from right to left
            points[i] = bmr_vec2_make(half * x, rise * (1.0 - x * x));
        }
        points[n - 1] = bmr_vec2_make(0.0, -1.0);
        const bmr_pose below = {{0.0, -1.0 - separation}, 1.0, 0.0};
        a = bmr_piece_screw(0.0, bmr_pose_identity(), bmr_vec2_make(0.0, 0.0), 2.0 * pi);
        b = bmr_piece_rest(below);
    }
    made.polygons[1] = adversary_polygon(points, n);
    made.motions[0] = made_motion(a);
    made.motions[1] = made_motion(b);
    return made;
}

#endif
