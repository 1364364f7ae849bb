// SPDX-License-Identifier: MIT
// Walls: four lines, and the segments that couples see of them (frame.c).
#include <math.h>
#include <string.h>

#include "world/parts.h"

bmr_line bmr_wall_line(const bmr_world *w, const bmr_resident *wall) {
    static const bmr_vec2 inwards[BMR_WALLS] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
    const size_t side = (size_t)(wall->id - BMR_WALL(0));
    const bmr_vec2 corner = side % 2 == 0 ? w->def.low : w->def.high;
    const bmr_line line = {inwards[side], bmr_dot(inwards[side], corner)};
    return line;
}

void bmr_walls_make(bmr_world *w) {
    for (int side = 0; side < BMR_WALLS; side++) {
        bmr_resident *const wall = &w->walls[side];
        bmr_pose pose = bmr_pose_identity();
        pose.position = side % 2 == 0 ? w->def.low : w->def.high;
        const bmr_motion_piece rest = bmr_piece_rest(pose);
        bmr_timed_piece_set(&wall->now, -INFINITY, &rest);
        wall->head.item.place = BMR_NOT_QUEUED;
        wall->id = BMR_WALL(side);
        wall->birth = UINT64_MAX - BMR_WALLS + (uint64_t)side;
        wall->mass = wall->inertia = INFINITY;
        wall->since = -INFINITY;
        wall->until = INFINITY;
    }
}

static bmr_error build_hierarchy(bmr_world *w, const bmr_polygon *polygon, bmr_hierarchy **hierarchy) {
    switch (w->def.structure->hierarchy) {
    case BMR_HIERARCHY_COMPASS: {
        const bmr_error error = w->compass ? BMR_OK : bmr_compass_create(2, &w->counted, &w->compass);
        return error == BMR_OK ? bmr_hierarchy_build_compass(polygon, w->compass, &w->counted, hierarchy)
                               : error;
    }
    case BMR_HIERARCHY_DUDLEY:
        return bmr_hierarchy_build_dudley(polygon, &w->counted, hierarchy);
    case BMR_HIERARCHY_DOBKIN_KIRKPATRICK:
        return bmr_hierarchy_build_dobkin_kirkpatrick(polygon, &w->counted, hierarchy);
    default:
        return BMR_OK;
    }
}

static void destroy(bmr_world *w, bmr_beside *beside) {
    for (int upright = 0; upright < 2; upright++) {
        bmr_hierarchy_destroy(beside->hierarchies[upright], &w->counted);
        bmr_polygon_destroy(beside->polygons[upright], &w->counted);
    }
    bmr_world_give(w, beside, sizeof *beside);
}

static bmr_error make_segment(bmr_world *w, bmr_beside *beside, int upright) {
    const double half = ldexp(1.0, beside->size);
    const bmr_vec2 end = upright ? bmr_vec2_make(0.0, half) : bmr_vec2_make(half, 0.0);
    const bmr_vec2 ends[2] = {bmr_neg(end), end};
    bmr_error error = bmr_polygon_create(ends, 2, &w->counted, &beside->polygons[upright]);
    if (error == BMR_OK)
        error = build_hierarchy(w, beside->polygons[upright], &beside->hierarchies[upright]);
    beside->shapes[upright].polygon = beside->polygons[upright];
    if (w->def.structure->hierarchy >= 0)
        beside->shapes[upright].hierarchies[w->def.structure->hierarchy] = beside->hierarchies[upright];
    return error;
}

bmr_error bmr_walls_beside(bmr_world *w, double radius, const bmr_beside **found) {
    int size;
    // Longer than the disk and the margin: its ends are never what is nearest.
    frexp(fmax(bmr_grid_need(w, radius), BMR_MIN_SIDE), &size);
    for (const bmr_beside *b = w->beside; b; b = b->next)
        if (b->size == size) {
            *found = b;
            return BMR_OK;
        }
    bmr_beside *const beside = bmr_world_take(w, sizeof *beside);
    if (!beside)
        return BMR_ERROR_NO_MEMORY;
    memset(beside, 0, sizeof *beside);
    beside->size = size;
    for (int upright = 0; upright < 2; upright++) {
        const bmr_error error = make_segment(w, beside, upright);
        if (error != BMR_OK) {
            destroy(w, beside);
            return error;
        }
    }
    beside->next = w->beside;
    w->beside = beside;
    *found = beside;
    return BMR_OK;
}

void bmr_walls_destroy(bmr_world *w) {
    while (w->beside) {
        bmr_beside *const next = w->beside->next;
        destroy(w, w->beside);
        w->beside = next;
    }
    bmr_compass_destroy(w->compass, &w->counted);
}
