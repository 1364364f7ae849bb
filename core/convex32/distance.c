// SPDX-License-Identifier: MIT
#include <math.h>

#include "convex32/gjk.h"

// Each step halves the arc that is searched, so even 65,535 vertices take some twenty.
enum { MOST_STEPS = 64 };

// A support that brings the shapes nearer by less than this part of their distance ends the search. Far below
// what float supports resolve, far above what double arithmetic confuses.
static const double least_gain = 1e-10;

// Rounding moves each vertex of the difference by a few 2^-53 of the shapes' reach and place. A distance that
// is no more than 2^-40 of them is so short that its direction cannot be trusted. Where a side of the
// difference is nearest, rounding alone may decide on which of its two sides the origin lies, and so turn the
// direction round. Where a vertex is nearest, the direction may be off by 1e-4. The search therefore calls
// such a distance 0: the shapes overlap.
static const double no_distance = 0x1p-40;

bmr_proxy32 bmr_proxy32_points(const bmr_vec32 *points, uint32_t count, float radius) {
    double reach2 = 0.0;
    for (uint32_t i = 0; i < count; ++i) {
        const bmr_vec2 p = bmr_widen(points[i]);
        const double square = bmr_dot(p, p);
        if (square > reach2) // not fmax: of that gcc 12 dies where it compiles for ARM64
            reach2 = square;
    }
    // Rounded up: twice the unit of a float.
    bmr_proxy32 proxy = {.polygon = {.vertices = points, .count = count}, .radius = radius};
    proxy.reach = (float)(sqrt(reach2) * (1.0 + 0x1p-22));
    return proxy;
}

uint32_t bmr_posed32_support(const bmr_posed32 *shape, bmr_vec2 direction) {
    const bmr_convex32 *polygon = &shape->proxy->polygon;
    const bmr_vec32 d = bmr_narrow(bmr_unrotate(&shape->pose, direction));
    if (polygon->normals != NULL)
        return bmr_convex32_support(polygon, d);
    uint32_t best = 0;
    float most = polygon->vertices[0].x * d.x + polygon->vertices[0].y * d.y;
    for (uint32_t i = 1; i < polygon->count; ++i) {
        const float along = polygon->vertices[i].x * d.x + polygon->vertices[i].y * d.y;
        if (along > most) {
            best = i;
            most = along;
        }
    }
    return best;
}

static bmr_difference32 difference(const bmr_posed32 *a, uint32_t vertex_a, const bmr_posed32 *b,
                                   uint32_t vertex_b) {
    const bmr_difference32 d = {bmr_sub(bmr_posed32_vertex(b, vertex_b), bmr_posed32_vertex(a, vertex_a)),
                                vertex_a, vertex_b, 1.0};
    return d;
}

/// The vertex of b - a that is least along n.
static bmr_difference32 least(const bmr_posed32 *a, const bmr_posed32 *b, bmr_vec2 n) {
    return difference(a, bmr_posed32_support(a, n), b, bmr_posed32_support(b, bmr_neg(n)));
}

double bmr_posed32_beyond(const bmr_posed32 *a, const bmr_posed32 *b, bmr_vec2 direction) {
    return bmr_dot(direction, least(a, b, direction).w);
}

/// Makes the simplex the part of the segment from p to q that is closest to the origin.
static void take_segment(bmr_gjk32 *s, bmr_difference32 p, bmr_difference32 q) {
    const bmr_vec2 e = bmr_sub(q.w, p.w);
    const double from_p = -bmr_dot(p.w, e), from_q = bmr_dot(q.w, e);
    s->count = 1;
    s->vertices[0] = from_p <= 0.0 ? p : q;
    s->vertices[0].weight = 1.0;
    s->closest = s->vertices[0].w;
    if (from_p > 0.0 && from_q > 0.0) {
        p.weight = from_q / (from_p + from_q);
        q.weight = from_p / (from_p + from_q);
        s->count = 2;
        s->vertices[0] = p;
        s->vertices[1] = q;
        // By the normal: the points may be far from the origin and their mean near it.
        const bmr_vec2 normal = bmr_left(e);
        s->closest = bmr_scale(bmr_dot(normal, p.w) / bmr_dot(normal, normal), normal);
    }
    s->distance = sqrt(bmr_dot(s->closest, s->closest));
}

/// Is the origin inside? Then that is the simplex.
static bool take_triangle(bmr_gjk32 *s, bmr_difference32 p, bmr_difference32 q, bmr_difference32 r) {
    const double of_p = bmr_cross(q.w, r.w), of_q = bmr_cross(r.w, p.w), of_r = bmr_cross(p.w, q.w);
    const bool inside = (of_p > 0.0 && of_q > 0.0 && of_r > 0.0) || (of_p < 0.0 && of_q < 0.0 && of_r < 0.0);
    if (!inside)
        return false;
    const double sum = of_p + of_q + of_r;
    p.weight = of_p / sum;
    q.weight = of_q / sum;
    r.weight = of_r / sum;
    s->count = 3;
    s->vertices[0] = p;
    s->vertices[1] = q;
    s->vertices[2] = r;
    s->closest = bmr_vec2_make(0.0, 0.0);
    s->distance = 0.0;
    return true;
}

/// Adds a vertex and keeps what is closest to the origin. The side that was there is not: the origin lies on
/// the new vertex' side of it.
static void take(bmr_gjk32 *s, const bmr_difference32 *added) {
    const bmr_difference32 p = s->vertices[0], q = s->vertices[1];
    if (s->count == 1) {
        take_segment(s, p, *added);
        return;
    }
    if (take_triangle(s, p, q, *added))
        return;
    bmr_gjk32 other = *s;
    take_segment(s, p, *added);
    take_segment(&other, q, *added);
    if (other.distance < s->distance)
        *s = other;
}

static bool holds(const bmr_gjk32 *s, const bmr_difference32 *vertex) {
    for (int i = 0; i < s->count; ++i) {
        if (s->vertices[i].a == vertex->a && s->vertices[i].b == vertex->b)
            return true;
    }
    return false;
}

static double rounding_of(const bmr_posed32 *shape) {
    const bmr_vec2 place = shape->pose.position;
    return no_distance * ((double)shape->proxy->reach + fabs(place.x) + fabs(place.y));
}

/// Calls what is no more than rounding nothing. Of shapes whose reach is infinite nothing is.
static void drop_rounding(bmr_gjk32 *s, double rounding) {
    if (s->distance <= rounding && rounding < HUGE_VAL) {
        s->closest = bmr_vec2_make(0.0, 0.0);
        s->distance = 0.0;
    }
}

void bmr_gjk32_search(bmr_gjk32 *search, const bmr_posed32 *a, const bmr_posed32 *b, bmr_closest32 *closest) {
    search->vertices[0] = difference(a, closest->a < a->proxy->polygon.count ? closest->a : 0, b,
                                     closest->b < b->proxy->polygon.count ? closest->b : 0);
    search->count = 1;
    search->closest = search->vertices[0].w;
    search->distance = sqrt(bmr_dot(search->closest, search->closest));
    search->iterations = 0;
    const double rounding = rounding_of(a) + rounding_of(b);
    drop_rounding(search, rounding);
    while (search->distance > 0.0 && search->iterations < MOST_STEPS) {
        const bmr_vec2 n = bmr_scale(1.0 / search->distance, search->closest);
        const bmr_difference32 found = least(a, b, n);
        ++search->iterations;
        if (holds(search, &found) ||
            !(search->distance - bmr_dot(n, found.w) > least_gain * search->distance))
            break;
        const bmr_gjk32 before = *search;
        take(search, &found);
        drop_rounding(search, rounding);
        if (search->count < 3 && !(search->distance < before.distance)) { // rounding has the last word
            *search = before;
            break;
        }
    }
    closest->a = search->vertices[0].a;
    closest->b = search->vertices[0].b;
}

void bmr_gjk32_points(const bmr_gjk32 *search, const bmr_posed32 *a, const bmr_posed32 *b, bmr_vec2 *point_a,
                      bmr_vec2 *point_b) {
    *point_a = *point_b = bmr_vec2_make(0.0, 0.0);
    for (int i = 0; i < search->count; ++i) {
        const bmr_difference32 *v = &search->vertices[i];
        *point_a = bmr_add(*point_a, bmr_scale(v->weight, bmr_posed32_vertex(a, v->a)));
        *point_b = bmr_add(*point_b, bmr_scale(v->weight, bmr_posed32_vertex(b, v->b)));
    }
    if (search->count == 3)
        *point_b = *point_a;
}

bmr_distance32 bmr_convex32_distance(const bmr_proxy32 *a, const bmr_transform32 *pose_a,
                                     const bmr_proxy32 *b, const bmr_transform32 *pose_b,
                                     bmr_closest32 *closest) {
    const bmr_posed32 at_a = bmr_posed32_at(a, pose_a), at_b = bmr_posed32_at(b, pose_b);
    bmr_gjk32 search;
    bmr_gjk32_search(&search, &at_a, &at_b, closest);
    bmr_vec2 point_a, point_b;
    bmr_gjk32_points(&search, &at_a, &at_b, &point_a, &point_b);
    bmr_distance32 answer = {bmr_narrow(point_a),
                             bmr_narrow(point_b),
                             (float)search.distance,
                             search.iterations,
                             (int32_t)search.count,
                             {0},
                             {0}};
    for (int i = 0; i < search.count; ++i) {
        answer.vertex_a[i] = search.vertices[i].a;
        answer.vertex_b[i] = search.vertices[i].b;
    }
    return answer;
}

bool bmr_convex32_apart_along(const bmr_proxy32 *a, const bmr_transform32 *pose_a, const bmr_proxy32 *b,
                              const bmr_transform32 *pose_b, float distance, bmr_vec32 direction) {
    const bmr_posed32 at_a = bmr_posed32_at(a, pose_a), at_b = bmr_posed32_at(b, pose_b);
    const double rounding =
        BMR_SUPPORT32_ROUNDING * ((double)a->reach + (double)b->reach + fabs((double)distance));
    return bmr_posed32_beyond(&at_a, &at_b, bmr_widen(direction)) > (double)distance + rounding;
}
