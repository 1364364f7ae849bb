// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_BODY_H
#define BOOMERANG_PLAYGROUND_BODY_H

#include "boomerang/families.h"
#include "boomerang/hierarchy.h"

/// The most corners that a body of the playground has.
#define PLAY_MOST_CORNERS 256u

/// A polygon with all three hierarchies.
typedef struct play_body {
    bmr_polygon *polygon;
    bmr_compass *compass;
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT];
} play_body;

/// The hull of the points, moved so that its bounding disk is about the origin, all multiplied by `scale`.
/// Errors: those of bmr_polygon_create and the hierarchies' builders, OUT_OF_RANGE (more than
/// PLAY_MOST_CORNERS points, a scale that is not positive), TOO_FEW_POINTS (a hull of fewer than three); then
/// *body is untouched.
bmr_error play_body_create(const bmr_vec2 *points, size_t count, double scale, play_body **body);
/// The same of one of core's polygons.
bmr_error play_body_create_ngon(bmr_ngon kind, size_t n, uint64_t seed, double scale, play_body **body);
/// NULL is no error.
void play_body_destroy(play_body *body);
bmr_shape play_body_shape(const play_body *body);

/// The most corners of an envelope of a body: a compass hierarchy has at most five edges a corner.
#define PLAY_MOST_ENVELOPE (5u * PLAY_MOST_CORNERS)
/// The corners of the envelope of a level (of the deepest, if it is deeper), counter-clockwise, at a pose.
/// `corners` takes PLAY_MOST_ENVELOPE. Returns how many there are.
size_t play_envelope(const bmr_hierarchy *hierarchy, uint32_t level, const bmr_pose *pose, bmr_vec2 *corners);

#endif
