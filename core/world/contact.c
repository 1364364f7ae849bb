// SPDX-License-Identifier: MIT
// What a contact is: where two polygons touch, along which normal, and how they move there.
#include <math.h>
#include <string.h>

#include "boomerang/distance.h"
#include "world/parts.h"

/// Two sides face each other when their far ends are not farther apart than the near ones by more than this
/// part of the margin.
#define FACING_PART 0.125

/// The two ends of the side that is extreme in a direction; both the same where it is a vertex.
typedef struct side {
    bmr_vec2 ends[2];
} side;

static side extreme_side(const bmr_polygon *polygon, bmr_vec2 direction, double room) {
    const uint32_t n = polygon->count, i = bmr_polygon_support(polygon, direction);
    const bmr_vec2 v = polygon->vertices[i];
    const uint32_t neighbours[2] = {(i + 1) % n, (i + n - 1) % n};
    side found = {{v, v}};
    for (int k = 0; k < 2; k++) {
        const bmr_vec2 u = polygon->vertices[neighbours[k]];
        if (neighbours[k] != i && bmr_dot(direction, bmr_sub(v, u)) <= room)
            found.ends[1] = u;
    }
    return found;
}

/// Where two sides that face each other overlap, along the tangent: A's frame, beside A. False: in no more
/// than a point.
static bool facing(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 normal,
                   double room, bmr_vec2 points[2]) {
    const bmr_vec2 tangent = bmr_left(normal);
    const side own = extreme_side(a, normal, room);
    const side other = extreme_side(b, bmr_neg(bmr_unrotate(b_in_a, normal)), room);
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        const bmr_vec2 p = k == 0 ? own.ends[0] : bmr_transform(b_in_a, other.ends[0]);
        const bmr_vec2 q = k == 0 ? own.ends[1] : bmr_transform(b_in_a, other.ends[1]);
        low[k] = fmin(bmr_dot(tangent, p), bmr_dot(tangent, q));
        high[k] = fmax(bmr_dot(tangent, p), bmr_dot(tangent, q));
    }
    const double from = fmax(low[0], low[1]), to = fmin(high[0], high[1]);
    if (!(to > from))
        return false;
    const double level = bmr_dot(normal, own.ends[0]);
    points[0] = bmr_add(bmr_scale(level, normal), bmr_scale(from, tangent));
    points[1] = bmr_add(bmr_scale(level, normal), bmr_scale(to, tangent));
    return true;
}

void bmr_touch_move(bmr_touch *touch, const bmr_vec2 velocity[2], const double spin[2]) {
    bmr_contact *const contact = &touch->contact;
    for (size_t k = 0; k < contact->count; k++) {
        const bmr_vec2 a = bmr_add(velocity[0], bmr_scale(spin[0], bmr_left(touch->arm[0][k])));
        const bmr_vec2 b = bmr_add(velocity[1], bmr_scale(spin[1], bmr_left(touch->arm[1][k])));
        contact->velocity[k] = bmr_sub(b, a);
        contact->approach[k] = bmr_dot(contact->normal, contact->velocity[k]);
    }
}

void bmr_touch_describe(const bmr_world *w, const bmr_couple *c, bool placed, bmr_touch *touch) {
    memset(touch, 0, sizeof *touch);
    bmr_contact *const contact = &touch->contact;
    contact->time = w->time;
    contact->a = c->side[0]->id;
    contact->b = c->side[1]->id;
    contact->image = bmr_couple_shift(w, c);
    contact->placed = placed;
    contact->again = c->near->again;
    contact->count = 1;
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    const bmr_pose seen_a = bmr_motion_pose(motion.a, w->time, NULL, NULL);
    const bmr_pose seen_b = bmr_motion_pose(motion.b, w->time, NULL, NULL);
    const bmr_pose b_in_a = bmr_pose_relative(&seen_a, &seen_b);
    bmr_vec2 velocity[2];
    double spin[2];
    bmr_pose poses[2]; // in the world
    for (int i = 0; i < 2; i++) {
        const bmr_motion own = bmr_motion_of_piece(&c->side[i]->now);
        poses[i] = bmr_motion_pose(&own, w->time, &velocity[i], &spin[i]);
    }

    bmr_closest_points closest;
    bmr_overlap overlap;
    bmr_vec2 normal = {0.0, 0.0}, points[2] = {{0.0, 0.0}, {0.0, 0.0}};
    if (bmr_distance(motion.shape_a, NULL, motion.shape_b, &b_in_a, &closest) == BMR_OK &&
        closest.distance > 0.0) {
        normal = closest.normal;
        points[0] = closest.point_a;
        contact->distance = closest.distance;
    } else if (bmr_penetration(motion.shape_a, NULL, motion.shape_b, &b_in_a, &overlap) == BMR_OK) {
        normal = overlap.normal;
        points[0] = overlap.point_a;
    }
    const double room = FACING_PART * w->def.kds.margin;
    if (contact->distance > 0.0 && facing(motion.shape_a, motion.shape_b, &b_in_a, normal, room, points))
        contact->count = 2;
    contact->normal = bmr_rotate(&poses[0], normal);
    // Arms from what lies between the two: bodies far from the origin keep their digits. (A wall's arm is
    // that of the segment beside the body; a wall does not turn.)
    const bmr_vec2 way = bmr_sub(seen_b.position, seen_a.position);
    for (size_t k = 0; k < contact->count; k++) {
        touch->arm[0][k] = bmr_rotate(&poses[0], points[k]);
        touch->arm[1][k] = bmr_sub(touch->arm[0][k], way);
        contact->points[k] = bmr_add(poses[0].position, touch->arm[0][k]);
    }
    bmr_touch_move(touch, velocity, spin);
}
