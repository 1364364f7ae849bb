// SPDX-License-Identifier: MIT
// Motions that cost the rivals as many events as the paper says (section 5, introduction), however far apart
// the polygons are.
#include <math.h>
#include <string.h>

#include "analysis/family_paths.h"
#include "geometry/memory.h"

#include "boomerang/analysis.h"

#define PI 3.14159265358979323846
#define MOST_VERTICES 4096
/// A pass begins and ends this many times (diameter + separation) from the middle: its direction turns by all
/// but a tenth of a radian on either side.
#define PASS_REACH 10.0

const char *bmr_adversary_name(bmr_adversary_kind kind) {
    static const char *const names[BMR_ADVERSARY_COUNT] = {"pass", "gear"};
    return (unsigned)kind < BMR_ADVERSARY_COUNT ? names[kind] : NULL;
}

static void regular_points(size_t n, bmr_vec2 *points) {
    // Turned by an odd angle: no edge is parallel to one of the other's for ever.
    for (size_t i = 0; i < n; i++) {
        const double angle = 0.1 + 2.0 * PI * (double)i / (double)n;
        points[i] = bmr_vec2_make(cos(angle), sin(angle));
    }
}

/// A chain of n - 1 vertices along the top, from (-half, 0) to (half, 0), that rises by a little, and one far
/// below. `rise` is so small that at distance `separation` the vertices' regions are still of about the width
/// of their edges.
static void chain_points(size_t n, double half, double rise, bmr_vec2 *points) {
    for (size_t i = 0; i + 1 < n; i++) {
        const double x = 1.0 - 2.0 * (double)i / (double)(n - 2); // counter-clockwise: from right to left
        points[i] = bmr_vec2_make(half * x, rise * (1.0 - x * x));
    }
    points[n - 1] = bmr_vec2_make(0.0, -1.0);
}

static bmr_error make_polygons(bmr_adversary_kind kind, size_t n, double separation, bmr_vec2 *points,
                               const bmr_allocator *allocator, bmr_polygon *polygons[2]) {
    regular_points(n, points);
    bmr_error error = bmr_polygon_create_raw(points, n, allocator, &polygons[0]);
    if (error != BMR_OK)
        return error;
    if (kind == BMR_ADVERSARY_GEAR) {
        // A corner of the gear sweeps to both sides by sin(pi / n); a little less is swept over whole.
        const double half = 0.9 * sin(PI / (double)n);
        // The end normals lean by 2 rise / half, which at the distance shifts by a tenth of the chain at
        // most.
        chain_points(n, half, 0.05 * half * half / (1.0 + separation), points);
    }
    error = bmr_polygon_create_raw(points, n, allocator, &polygons[1]);
    if (error != BMR_OK)
        bmr_polygon_destroy(polygons[0], allocator);
    return error;
}

static bmr_error make_motions(bmr_adversary_kind kind, double separation, const bmr_allocator *allocator,
                              bmr_motion *motions[2]) {
    const bmr_vec2 none = {0.0, 0.0};
    if (kind == BMR_ADVERSARY_PASS) {
        const double reach = PASS_REACH * (2.0 + separation);
        const bmr_pose middle = {{0.0, 2.0 + separation}, cos(0.2), sin(0.2)};
        const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
        const bmr_motion_piece pass = bmr_piece_screw(0.5, middle, bmr_vec2_make(2.0 * reach, 0.0), 0.0);
        return bmr_path_pieces(&rest, &pass, allocator, motions);
    }
    const bmr_pose below = {{0.0, -1.0 - separation}, 1.0, 0.0};
    const bmr_motion_piece spin = bmr_piece_screw(0.0, bmr_pose_identity(), none, 2.0 * PI);
    const bmr_motion_piece rest = bmr_piece_rest(below);
    return bmr_path_pieces(&spin, &rest, allocator, motions);
}

bmr_error bmr_adversary_create(bmr_adversary_kind kind, size_t n, double separation,
                               const bmr_allocator *allocator, bmr_adversary *adversary) {
    if (!adversary)
        return BMR_ERROR_NULL_ARGUMENT;
    if ((unsigned)kind >= BMR_ADVERSARY_COUNT || n < 3 || n > MOST_VERTICES || !(separation > 0.0) ||
        !(separation <= BMR_MAX_COORDINATE))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_vec2 *points = bmr_allocate(allocator, n * sizeof *points);
    if (!points)
        return BMR_ERROR_NO_MEMORY;
    bmr_adversary made;
    memset(&made, 0, sizeof made);
    bmr_error error = make_polygons(kind, n, separation, points, allocator, made.polygons);
    bmr_release(allocator, points, n * sizeof *points);
    if (error != BMR_OK)
        return error;
    error = make_motions(kind, separation, allocator, made.motions);
    if (error == BMR_OK) {
        *adversary = made;
    } else {
        bmr_polygon_destroy(made.polygons[0], allocator);
        bmr_polygon_destroy(made.polygons[1], allocator);
    }
    return error;
}

void bmr_adversary_destroy(bmr_adversary *adversary, const bmr_allocator *allocator) {
    for (int k = 0; adversary && k < 2; k++) {
        bmr_motion_destroy(adversary->motions[k]);
        bmr_polygon_destroy(adversary->polygons[k], allocator);
    }
}
