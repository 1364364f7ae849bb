// SPDX-License-Identifier: MIT
// Once around A at a fixed distance: B's frame follows the offset of the Minkowski sum A + (-B), whose
// boundary is made of both polygons' edges and of arcs about pairs of vertices.
#include <math.h>
#include <stdlib.h>

#include "analysis/family_paths.h"
#include "geometry/memory.h"

#define PI 3.14159265358979323846
/// An arc piece is a cubic; up to this angle it is off the circle by less than 1e-6 of the radius.
#define ARC_ANGLE (PI / 8.0)
/// Directions nearer than this are one.
#define SAME_ANGLE 1e-12

/// An outer normal of the sum, and whose edge it is.
typedef struct side {
    double angle;
    uint32_t edge;
    int owner; ///< 0: A's, 1: B's
} side;

static int compare_sides(const void *p, const void *q) {
    const side *s = p, *t = q;
    if (s->angle != t->angle)
        return s->angle < t->angle ? -1 : 1;
    return s->owner != t->owner ? s->owner - t->owner : (s->edge > t->edge) - (s->edge < t->edge);
}

static size_t edge_count(const bmr_polygon *p) {
    return p->count > 1 ? p->count : 0;
}

typedef struct orbit {
    bmr_motion *motion;
    bmr_pose at; ///< of B's frame
    double time; ///< reached so far
    double gap;
    double perimeter; ///< of the sum
    bmr_error error;
} orbit;

/// Half the time goes with the length of edges, half with the angle: both stay well above the resolution of
/// time, however small the gap.
static void append_edge(orbit *o, bmr_vec2 by) {
    const double duration = 0.5 * hypot(by.x, by.y) / o->perimeter;
    if (o->error != BMR_OK || !(o->time + duration > o->time))
        return;
    bmr_algebraic_piece p = bmr_path_still(o->at);
    p.degree = 1;
    p.x[1] = by.x / duration;
    p.y[1] = by.y / duration;
    o->error = bmr_path_append(o->motion, o->time, &p);
    o->time += duration;
    o->at.position = bmr_add(o->at.position, by);
}

/// A cubic with the circle's tangents at both ends, and its middle on the circle.
static void append_arc_piece(orbit *o, double from, double angle) {
    const double duration = 0.5 * angle / (2.0 * PI);
    if (o->error != BMR_OK || !(o->time + duration > o->time))
        return;
    const bmr_vec2 u = {cos(from), sin(from)}, v = {cos(from + angle), sin(from + angle)};
    const double handle = 4.0 * tan(0.25 * angle); // three times the Bezier handle
    const bmr_vec2 d0 = bmr_scale(o->gap * handle, bmr_left(u)), d1 = bmr_scale(o->gap * handle, bmr_left(v));
    const bmr_vec2 chord = bmr_scale(o->gap, bmr_sub(v, u));
    bmr_algebraic_piece p = bmr_path_still(o->at);
    p.degree = 3;
    const double t = 1.0 / duration;
    p.x[1] = d0.x * t;
    p.y[1] = d0.y * t;
    p.x[2] = (3.0 * chord.x - 2.0 * d0.x - d1.x) * t * t;
    p.y[2] = (3.0 * chord.y - 2.0 * d0.y - d1.y) * t * t;
    p.x[3] = (d0.x + d1.x - 2.0 * chord.x) * t * t * t;
    p.y[3] = (d0.y + d1.y - 2.0 * chord.y) * t * t * t;
    o->error = bmr_path_append(o->motion, o->time, &p);
    o->time += duration;
    o->at.position = bmr_add(o->at.position, chord);
}

static void append_arc(orbit *o, double from, double angle) {
    if (!(angle > SAME_ANGLE))
        return;
    const int pieces = (int)ceil(angle / ARC_ANGLE);
    for (int i = 0; i < pieces; i++)
        append_arc_piece(o, from + angle * i / pieces, angle / pieces);
}

/// The sides of A + (-B) in the order of their angles, B turned; returns the perimeter.
static double collect_sides(const bmr_family_plan *plan, side *sides) {
    double perimeter = 0.0;
    size_t k = 0;
    for (int owner = 0; owner < 2; owner++) {
        const bmr_polygon *p = owner == 0 ? plan->a : plan->b;
        for (uint32_t i = 0; i < edge_count(p); i++) {
            const bmr_vec2 normal = bmr_polygon_normal(p, i),
                           edge = bmr_sub(p->vertices[(i + 1) % p->count], p->vertices[i]);
            const bmr_vec2 n = owner == 0 ? normal : bmr_neg(bmr_rotate(&plan->turn, normal));
            const side s = {atan2(n.y, n.x), i, owner};
            sides[k++] = s;
            perimeter += hypot(edge.x, edge.y);
        }
    }
    qsort(sides, k, sizeof *sides, compare_sides);
    return perimeter;
}

static void go_round(orbit *o, const bmr_family_plan *plan, const side *sides, size_t count) {
    double angle = sides[0].angle;
    for (size_t k = 0; k < count; k++) {
        append_arc(o, angle, sides[k].angle - angle);
        angle = sides[k].angle;
        const bmr_polygon *p = sides[k].owner == 0 ? plan->a : plan->b;
        const uint32_t i = sides[k].edge;
        const bmr_vec2 edge = bmr_sub(p->vertices[(i + 1) % p->count], p->vertices[i]);
        append_edge(o, sides[k].owner == 0 ? edge : bmr_neg(bmr_rotate(&plan->turn, edge)));
    }
    append_arc(o, angle, sides[0].angle + 2.0 * PI - angle);
}

/// B's frame where the first side begins: the last vertices of both before its direction.
static bmr_vec2 start_of(const bmr_family_plan *plan, const side *sides, size_t count, double gap) {
    // In the middle of the gap before the first side no edge ties.
    const double before = sides[count - 1].angle - 2.0 * PI, middle = 0.5 * (before + sides[0].angle);
    const bmr_vec2 u = {cos(middle), sin(middle)}, first = {cos(sides[0].angle), sin(sides[0].angle)};
    const bmr_vec2 corner = bmr_place_at_gap(plan->a, plan->b, &plan->turn, u, 0.0);
    return bmr_add(corner, bmr_scale(gap, first));
}

bmr_error bmr_path_orbit(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                         bmr_motion *motions[2]) {
    const size_t count = edge_count(plan->a) + edge_count(plan->b), bytes = (count + 1) * sizeof(side);
    side *sides = bmr_allocate(allocator, bytes);
    if (!sides)
        return BMR_ERROR_NO_MEMORY;
    const double perimeter = collect_sides(plan, sides);
    bmr_pose start = plan->turn;
    start.position = start_of(plan, sides, count, gap);
    const bmr_motion_piece rest_a = bmr_piece_rest(bmr_pose_identity()), rest_b = bmr_piece_rest(start);
    bmr_error error = bmr_path_pieces(&rest_a, &rest_b, allocator, motions);
    if (error == BMR_OK) {
        orbit o = {motions[1], start, 0.0, gap, perimeter, BMR_OK};
        go_round(&o, plan, sides, count);
        const bmr_algebraic_piece end = bmr_path_still(o.at);
        if (o.error == BMR_OK)
            o.error = bmr_path_append(o.motion, fmax(o.time, 1.0), &end);
        error = bmr_path_finish(o.error, motions);
    }
    bmr_release(allocator, sides, bytes);
    return error;
}
