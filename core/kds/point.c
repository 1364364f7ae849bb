// SPDX-License-Identifier: MIT
#include "kds/point.h"

#include <math.h>

#include "geometry/distance.h"

/// Of the sum of the extents: 2^-37. The slack of a point that is some hundred extents away is off by less,
/// and it is a hundredth of what a contact may be early by.
#define TOLERANCE 7.2759576141834259e-12

bmr_error bmr_point_prepare(bmr_kds *kds) {
    bmr_point_state *state = bmr_point_get(kds);
    state->hierarchy = kds->shapes[0].hierarchies[kds->info->hierarchy];
    state->point = kds->shapes[1].polygon->vertices[0];
    state->turned = bmr_pose_identity();
    return BMR_OK;
}

bmr_vec2 bmr_point_at(const bmr_kds *kds, const bmr_pose *b_in_a) {
    return bmr_transform(b_in_a, bmr_point_view(kds)->point);
}

double bmr_point_tolerance(const bmr_kds *kds) {
    return TOLERANCE * (kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent);
}

double bmr_point_need(const bmr_kds *kds) {
    return bmr_kds_reach(kds) + bmr_point_tolerance(kds);
}

double bmr_point_failing(const bmr_kds *kds) {
    return 0.5 * bmr_point_tolerance(kds);
}

bool bmr_point_closest(bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 *direction) {
    bmr_point_state *state = bmr_point_get(kds);
    double distance;
    return bmr_kds_closest(kds, b_in_a, &state->near_a, &state->near_b, direction, &distance) &&
           distance > bmr_point_need(kds);
}

bool bmr_point_take_free(bmr_kds *kds, const bmr_pose *b_in_a) {
    bmr_point_state *state = bmr_point_get(kds);
    bmr_vec2 direction;
    if (!bmr_point_closest(kds, b_in_a, &direction))
        return false;
    const bmr_polygon *polygon = bmr_hierarchy_polygon(state->hierarchy);
    unsigned steps = 0;
    const bmr_vec2 support = polygon->vertices[bmr_support_counted(polygon, direction, &steps)];
    bmr_kds_tally(kds, steps);
    state->edge = BMR_NO_EDGE;
    state->free_line.normal = direction;
    state->free_line.offset = bmr_dot(direction, support);
    return bmr_point_holds(kds, bmr_point_at(kds, b_in_a));
}

bmr_line bmr_point_line(const bmr_kds *kds) {
    const bmr_point_state *state = bmr_point_view(kds);
    return state->edge == BMR_NO_EDGE ? state->free_line : bmr_hierarchy_line(state->hierarchy, state->edge);
}

int bmr_point_level(const bmr_kds *kds) {
    const bmr_point_state *state = bmr_point_view(kds);
    return (int)(state->edge == BMR_NO_EDGE ? bmr_hierarchy_depth(state->hierarchy)
                                            : bmr_hierarchy_level(state->hierarchy, state->edge));
}

double bmr_point_value(const bmr_kds *kds, bmr_vec2 x) {
    const bmr_line line = bmr_point_line(kds);
    return bmr_dot(line.normal, x) - (line.offset + kds->def.margin);
}

bool bmr_point_holds(const bmr_kds *kds, bmr_vec2 x) {
    return bmr_point_value(kds, x) > bmr_point_failing(kds);
}

size_t bmr_point_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    const bmr_line line = bmr_point_line(kds);
    conditions[0] =
        bmr_condition_beyond(0, line.normal, line.offset + kds->def.margin, bmr_point_view(kds)->point, 0);
    return 1;
}

void bmr_point_proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const bmr_line line = bmr_point_line(kds);
    const bmr_vec2 against = bmr_neg(bmr_unrotate(&bmr_point_view(kds)->turned, line.normal));
    proof->owner = 0;
    proof->line.normal = line.normal;
    // Of a sum the line is B's support beyond A's own.
    proof->line.offset = bmr_dot(line.normal, a->vertices[bmr_polygon_support(a, line.normal)]);
    proof->nearest = b->vertices[bmr_polygon_support(b, against)];
    proof->level = bmr_point_level(kds);
}

bool bmr_point_is_after(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 x) {
    const bmr_vec2 normal = bmr_hierarchy_line(hierarchy, edge).normal;
    const bmr_vec2 touch = bmr_hierarchy_polygon(hierarchy)->vertices[bmr_hierarchy_touch(hierarchy, edge)];
    return bmr_dot(bmr_left(normal), bmr_sub(x, touch)) > 0.0;
}

bmr_edge bmr_point_descend(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 x, double need,
                           unsigned *steps) {
    const bool after = bmr_point_is_after(hierarchy, edge, x);
    const bmr_boomerang whole = bmr_hierarchy_boomerang(hierarchy, edge);
    bmr_edge cut = after ? whole.child_after : whole.child_before;
    while (cut != BMR_NO_EDGE) {
        ++*steps;
        if (bmr_edge_slack(hierarchy, cut, x) > need)
            return cut;
        const bmr_boomerang half = bmr_hierarchy_boomerang(hierarchy, cut);
        cut = after ? half.child_before : half.child_after;
    }
    return BMR_NO_EDGE;
}
