// SPDX-License-Identifier: MIT
#include "geometry/distance.h"

#include <math.h>

#include "geometry/length.h"

/// Steps of a climb before it gives way to the binary search, which costs about as much as this many.
#define CLIMB_STEPS 12

/// Iterations before the search over two chains is asked where to go on. From the last closest points most
/// queries take one to four.
#define ITERATIONS_BEFORE_SEARCH 8

/// From the last closest points random and hard motions take 12 at most, vertices that crowd 24 and more.
/// Each iteration adds a vertex pair that no iteration before had, so that the loop ends without a cap too:
/// this one is for what rounding might think of.
#define MAX_ITERATIONS 100

/// A climb's answer must lie this far (relative to the extent) above the centre: at the bottom, both edges
/// can be level up to rounding.
#define CLIMB_ROUNDING 1e-15

static inline bool ascends(const bmr_polygon *p, uint32_t from, uint32_t to, bmr_vec2 direction) {
    return bmr_ascends(bmr_sub(p->vertices[to], p->vertices[from]), direction);
}

uint32_t bmr_support_near(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint, unsigned *steps) {
    const uint32_t n = polygon->count;
    if (n <= 2)
        return bmr_support_counted(polygon, direction, steps);
    uint32_t i = hint, climbed = 0;
    for (; climbed < CLIMB_STEPS; ++climbed) {
        const uint32_t next = i + 1 < n ? i + 1 : 0;
        if (!ascends(polygon, i, next, direction))
            break;
        i = next;
    }
    if (climbed == 0)
        for (; climbed < CLIMB_STEPS; ++climbed) {
            const uint32_t next = i > 0 ? i - 1 : n - 1;
            if (!ascends(polygon, i, next, direction))
                break;
            i = next;
        }
    const double rise = bmr_dot(direction, bmr_sub(polygon->vertices[i], polygon->center));
    const bool believed = rise > CLIMB_ROUNDING * polygon->extent * (fabs(direction.x) + fabs(direction.y));
    *steps += 1 + climbed;
    return climbed < CLIMB_STEPS && believed ? i : bmr_support_counted(polygon, direction, steps);
}

bmr_simplex bmr_simplex_make(uint32_t a, uint32_t b) {
    const bmr_simplex simplex = {1, {a, a, a}, {b, b, b}, 0};
    return simplex;
}

/// The search at work: the simplex with its points, and the point of it that is nearest to the origin.
typedef struct search {
    bmr_simplex simplex;
    bmr_vec2 point[3];
    bmr_vec2 nearest;
    double square; ///< of the distance of `nearest`
} search;

static void keep(search *s, uint32_t i, uint32_t j) {
    const search old = *s;
    s->simplex.a[0] = old.simplex.a[i], s->simplex.b[0] = old.simplex.b[i], s->point[0] = old.point[i];
    s->simplex.a[1] = old.simplex.a[j], s->simplex.b[1] = old.simplex.b[j], s->point[1] = old.point[j];
    s->simplex.count = i == j ? 1 : 2;
}

/// The point of the segment p q nearest to the origin: 0 = p itself, 1 = q itself, 2 = between them.
static int nearest_on_segment(bmr_vec2 p, bmr_vec2 q, bmr_vec2 *nearest) {
    const bmr_vec2 e = bmr_sub(q, p);
    const double along = -bmr_dot(p, e), length = bmr_dot(e, e);
    if (!(along > 0.0)) {
        *nearest = p;
        return 0;
    }
    if (along >= length) {
        *nearest = q;
        return 1;
    }
    // Across the segment rather than along it, and from both points as they are, for their difference has the
    // rounding of the farther one: no cancellation however near the origin is to the nearer one.
    *nearest = bmr_scale(bmr_cross(p, q) / length, bmr_vec2_make(e.y, -e.x));
    return 2;
}

/// Shrinks the simplex to the least face that holds its point nearest to the origin. False: the origin is
/// inside, and the simplex stays a triangle.
static bool reduce(search *s) {
    const uint32_t n = s->simplex.count;
    if (n == 3) {
        const double c01 = bmr_cross(s->point[0], s->point[1]), c12 = bmr_cross(s->point[1], s->point[2]),
                     c20 = bmr_cross(s->point[2], s->point[0]);
        if ((c01 > 0.0 && c12 > 0.0 && c20 > 0.0) || (c01 < 0.0 && c12 < 0.0 && c20 < 0.0))
            return false;
    }
    uint32_t first = 0, second = 0;
    s->nearest = s->point[0];
    s->square = bmr_dot(s->nearest, s->nearest);
    for (uint32_t j = 1; j < n; ++j)
        for (uint32_t i = 0; i < j; ++i) {
            bmr_vec2 nearest;
            const int where = nearest_on_segment(s->point[i], s->point[j], &nearest);
            const double square = bmr_dot(nearest, nearest);
            if (square < s->square || (i + j == 1 && square <= s->square)) {
                s->nearest = nearest;
                s->square = square;
                first = where == 1 ? j : i;
                second = where == 0 ? i : j;
            }
        }
    keep(s, first, second);
    return true;
}

static bool holds(const bmr_simplex *simplex, uint32_t a, uint32_t b) {
    for (uint32_t i = 0; i < simplex->count; ++i)
        if (simplex->a[i] == a && simplex->b[i] == b)
            return true;
    return false;
}

static void add(search *s, const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, uint32_t i,
                uint32_t j) {
    const uint32_t k = s->simplex.count++;
    s->simplex.a[k] = i;
    s->simplex.b[k] = j;
    s->point[k] = bmr_sub(bmr_transform(b_in_a, b->vertices[j]), a->vertices[i]);
}

/// From the origin towards the simplex, unit length; across it where it is a segment, which is exact to the
/// rounding of its points even where the distance is nearly nothing.
static bmr_vec2 direction_of(const search *s) {
    bmr_vec2 u = s->nearest;
    if (s->simplex.count == 2) {
        const bmr_vec2 e = bmr_sub(s->point[1], s->point[0]);
        u = bmr_vec2_make(e.y, -e.x);
        if (bmr_cross(s->point[0], s->point[1]) < 0.0)
            u = bmr_neg(u);
    }
    return bmr_scale(1.0 / sqrt(bmr_dot(u, u)), u);
}

/// Replaces the simplex by the one that the search over two chains finds, where that is nearer.
static void go_on_from_search(search *s, const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a) {
    bmr_simplex start;
    const bool apart = bmr_closest_start(a, b, b_in_a, &s->simplex, &start);
    s->simplex.steps = start.steps;
    if (!apart)
        return;
    search found = {.simplex = {.count = 0, .steps = start.steps}};
    for (uint32_t i = 0; i < start.count; ++i)
        add(&found, a, b, b_in_a, start.a[i], start.b[i]);
    if (reduce(&found) && found.square < s->square)
        *s = found;
}

bool bmr_closest_direction(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, double reach,
                           double slack, bmr_simplex *simplex, bmr_closest *closest) {
    // No simplex at all is as good a start as any vertices.
    const bmr_simplex start = simplex->count - 1u < 3u ? *simplex : bmr_simplex_make(0, 0);
    search s = {.simplex = {.count = 0, .steps = start.steps}};
    for (uint32_t i = 0; i < start.count; ++i)
        add(&s, a, b, b_in_a, start.a[i], start.b[i]);
    bool outside = reduce(&s);
    bmr_closest best = {{1.0, 0.0}, -1.0, 0, 0};
    for (int iteration = 0; outside && iteration < MAX_ITERATIONS; ++iteration) {
        if (iteration == ITERATIONS_BEFORE_SEARCH)
            go_on_from_search(&s, a, b, b_in_a);
        if (s.square <= reach * reach)
            break; // two points of the polygons are that near
        const bmr_vec2 u = direction_of(&s);
        const uint32_t i = bmr_support_near(a, u, s.simplex.a[0], &s.simplex.steps);
        const uint32_t j =
            bmr_support_near(b, bmr_unrotate(b_in_a, bmr_neg(u)), s.simplex.b[0], &s.simplex.steps);
        const bmr_vec2 w = bmr_sub(bmr_transform(b_in_a, b->vertices[j]), a->vertices[i]);
        const double separation = bmr_dot(u, w);
        if (separation > best.separation) {
            best.direction = u;
            best.separation = separation;
            best.a = i;
            best.b = j;
        }
        // If the goal is not less than the distance, the separation is good enough.
        const double goal = (separation + slack * (separation - reach)) * (1.0 + BMR_DISTANCE_TOLERANCE);
        if (separation > reach && goal * goal >= s.square)
            break;
        if (holds(&s.simplex, i, j))
            break;
        const double square = s.square;
        add(&s, a, b, b_in_a, i, j);
        outside = reduce(&s);
        if (outside && !(s.square < square))
            break; // rounding: no nearer, and never will be
    }
    *simplex = s.simplex;
    if (!outside || !(best.separation > reach))
        return false;
    *closest = best;
    return true;
}
