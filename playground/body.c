// SPDX-License-Identifier: MIT
#include "body.h"

#include <math.h>
#include <stdlib.h>

static bmr_error build(play_body *body, const bmr_vec2 *points, size_t count) {
    bmr_error error = bmr_polygon_create(points, count, NULL, &body->polygon);
    if (error == BMR_OK && body->polygon->count < 3)
        error = BMR_ERROR_TOO_FEW_POINTS;
    if (error == BMR_OK)
        error = bmr_compass_create(PLAY_MOST_CORNERS, NULL, &body->compass);
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT && error == BMR_OK; ++kind)
        error = bmr_hierarchy_build((bmr_hierarchy_kind)kind, body->polygon, body->compass, NULL,
                                    &body->hierarchies[kind]);
    return error;
}

/// The middle of the points' hull's disk.
static bmr_error middle_of(const bmr_vec2 *points, size_t count, bmr_vec2 *middle) {
    bmr_polygon *hull;
    const bmr_error error = bmr_polygon_create(points, count, NULL, &hull);
    if (error != BMR_OK)
        return error;
    *middle = hull->center;
    bmr_polygon_destroy(hull, NULL);
    return BMR_OK;
}

bmr_error play_body_create(const bmr_vec2 *points, size_t count, double scale, play_body **body) {
    if (!points || !body)
        return BMR_ERROR_NULL_ARGUMENT;
    if (count > PLAY_MOST_CORNERS || !(scale > 0.0) || !isfinite(scale))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_vec2 middle, moved[PLAY_MOST_CORNERS];
    bmr_error error = middle_of(points, count, &middle);
    if (error != BMR_OK)
        return error;
    for (size_t i = 0; i < count; ++i)
        moved[i] = bmr_scale(scale, bmr_sub(points[i], middle));
    play_body *made = calloc(1, sizeof *made);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    error = build(made, moved, count);
    if (error == BMR_OK)
        *body = made;
    else
        play_body_destroy(made);
    return error;
}

bmr_error play_body_create_ngon(bmr_ngon kind, size_t n, uint64_t seed, double scale, play_body **body) {
    bmr_vec2 points[PLAY_MOST_CORNERS];
    if (n > PLAY_MOST_CORNERS)
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_error error = bmr_ngon_points(kind, n, seed, points);
    return error == BMR_OK ? play_body_create(points, n, scale, body) : error;
}

void play_body_destroy(play_body *body) {
    if (!body)
        return;
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
        bmr_hierarchy_destroy(body->hierarchies[kind], NULL);
    bmr_compass_destroy(body->compass, NULL);
    bmr_polygon_destroy(body->polygon, NULL);
    free(body);
}

bmr_shape play_body_shape(const play_body *body) {
    bmr_shape shape = {.polygon = body->polygon};
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
        shape.hierarchies[kind] = body->hierarchies[kind];
    return shape;
}

size_t play_envelope(const bmr_hierarchy *hierarchy, uint32_t level, const bmr_pose *pose,
                     bmr_vec2 *corners) {
    const uint32_t depth = bmr_hierarchy_depth(hierarchy);
    if (level > depth)
        level = depth;
    size_t count = 0;
    bmr_edge edge = 0;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(hierarchy, edge, level);
        corners[count++] = bmr_transform(pose, bmr_hierarchy_corner_point(hierarchy, corner));
        edge = corner.after;
    } while (edge != 0);
    return count;
}
