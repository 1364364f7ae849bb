// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_POLYGONS_H
#define BMR_TEST_POLYGONS_H

#include <stddef.h>
#include <stdint.h>

#include "boomerang/polygon.h"
#include "random.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Polygons for tests and benchmarks: the same bits from the same seed on every run.

/// Shapes that are hard in different ways. All lie around the origin with a diameter between 1 and 4, but for
/// the integer ones (GRID, PARALLEL), whose coordinates are integers so that parallel edges are exactly
/// parallel.
typedef enum test_family {
    TEST_REGULAR,     ///< regular n-gon, random phase
    TEST_CIRCLE,      ///< n random points on a circle
    TEST_ELLIPSE,     ///< n random points on a 4:1 ellipse, turned
    TEST_NEEDLE,      ///< n random points on an ellipse of aspect 1e6, turned
    TEST_NEEDLE_FLAT, ///< the same along the x axis
    TEST_LENS,        ///< two flat arcs: two sharp corners
    TEST_BOX,         ///< axis-parallel rectangle: edges coincide with compass directions; n is ignored
    TEST_TURNED_BOX,  ///< a rectangle turned by a multiple of 22.5 degrees, hence up to rounding on the
                      ///< compass
    TEST_OCTAGON,    ///< regular octagon-like box with cut corners: edges exactly E, NE, N, ...; n is ignored
    TEST_GRID,       ///< hull of n random points of a small integer grid
    TEST_PARALLEL,   ///< centrally symmetric with n integer edges: each has an exactly parallel partner
    TEST_TINY_EDGES, ///< a random polygon whose corners are cut by edges of relative length 1e-9
    TEST_NEARLY_FLAT, ///< triangle with one side bulged by some 1e-12: neighbouring directions agree within
                      ///< 1e-11
    TEST_CLUSTER,     ///< all but three points on an arc of 1e-3 radians
    TEST_FAMILY_COUNT
} test_family;

/// For messages: "regular", "circle", ...
const char *test_family_name(test_family family);

/// Fills `points` with the family's points for a wanted number n >= 3 of vertices, and returns how many
/// points that is (not more than n + 12: have that much room). Not all points need be vertices of the hull.
size_t test_points(test_family family, size_t n, test_random *random, bmr_vec2 *points);

/// The hull of test_points by malloc, and NULL only if that fails.
bmr_polygon *test_polygon(test_family family, size_t n, test_random *random);
/// Of any family with 3 to `most` vertices, small numbers as often as large ones; one in ten a point or a
/// segment; one in four of another size and away from its frame's origin. Aborts where there is no memory.
bmr_polygon *test_any_polygon(size_t most, test_random *random);
/// Scaled and then moved. Takes the polygon.
bmr_polygon *test_moved_polygon(bmr_polygon *polygon, double scale, bmr_vec2 by);

/// Particular shapes; `points` has room for what is returned.
size_t test_regular_points(size_t n, double radius, double phase, bmr_vec2 *points);
size_t test_box_points(double half_width, double half_height, bmr_vec2 *points);
/// 5 to 62 points (have room for them) that are hard to tell from points of one line: on it up to rounding,
/// an ulp or two beside it, in clusters of ulps, some anywhere. Their hull may be a segment, or a polygon no
/// thicker than rounding.
size_t test_hard_points(test_random *random, bmr_vec2 *points);
/// Turns by `angle`, then moves by (x, y).
void test_move_points(bmr_vec2 *points, size_t count, double angle, double x, double y);

#ifdef __cplusplus
}
#endif
#endif
