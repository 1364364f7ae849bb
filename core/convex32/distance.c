// SPDX-License-Identifier: MIT
#include <math.h>

#include "boomerang/pose.h"
#include "convex32/convex32_distance.h"
#include "convex32/directions.h"

/// @file
/// The search of Gilbert, Johnson and Keerthi for the closest points, which distance, cast and impact share.
/// Vertices are float, poses and all that is computed from them double: only the choice of a support is made
/// in float.

/// A shape at a pose.
typedef struct posed32 {
    const bmr_proxy32 *proxy;
    bmr_pose pose;
} posed32;

static inline bmr_vec32 narrow(bmr_vec2 v) {
    const bmr_vec32 r = {(float)v.x, (float)v.y};
    return r;
}

static inline posed32 posed32_at(const bmr_proxy32 *proxy, const bmr_transform32 *pose) {
    const posed32 r = {proxy, {convex32_wide(pose->p), (double)pose->c, (double)pose->s}};
    return r;
}

static inline bmr_vec2 posed32_vertex(const posed32 *shape, uint32_t vertex) {
    return bmr_transform(&shape->pose, convex32_wide(shape->proxy->polygon.vertices[vertex]));
}

/// What choosing supports in float may make of a distance: the reach of both times this.
#define SUPPORT_ROUNDING 0x1p-21

/// A vertex of the difference b - a.
typedef struct difference32 {
    bmr_vec2 w;
    uint32_t a, b;
    double weight; ///< its part of the closest point
} difference32;

/// What the search ended with. 3 vertices: they surround the origin, the shapes overlap.
typedef struct gjk32 {
    difference32 vertices[3];
    int count;
    bmr_vec2 closest; ///< of b - a; zero where they overlap
    double distance;  ///< its length
    int iterations;   ///< pairs of supports looked for
} gjk32;

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
        const bmr_vec2 p = convex32_wide(points[i]);
        const double square = bmr_dot(p, p);
        if (square > reach2) // not fmax: of that gcc 12 dies where it compiles for ARM64
            reach2 = square;
    }
    // Rounded up: twice the unit of a float.
    bmr_proxy32 proxy = {.polygon = {.vertices = points, .count = count}, .radius = radius};
    proxy.reach = (float)(sqrt(reach2) * (1.0 + 0x1p-22));
    return proxy;
}

/// The vertex farthest along a direction of the world, of about unit length.
static uint32_t posed32_support(const posed32 *shape, bmr_vec2 direction) {
    const bmr_convex32 *polygon = &shape->proxy->polygon;
    const bmr_vec32 d = narrow(bmr_unrotate(&shape->pose, direction));
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

static difference32 difference(const posed32 *a, uint32_t vertex_a, const posed32 *b, uint32_t vertex_b) {
    const difference32 d = {bmr_sub(posed32_vertex(b, vertex_b), posed32_vertex(a, vertex_a)), vertex_a,
                            vertex_b, 1.0};
    return d;
}

/// The vertex of b - a that is least along n.
static difference32 least(const posed32 *a, const posed32 *b, bmr_vec2 n) {
    return difference(a, posed32_support(a, n), b, posed32_support(b, bmr_neg(n)));
}

/// How far b lies beyond a along a direction of unit length; less than nothing where they overlap along it.
static double posed32_beyond(const posed32 *a, const posed32 *b, bmr_vec2 direction) {
    return bmr_dot(direction, least(a, b, direction).w);
}

/// Makes the simplex the part of the segment from p to q that is closest to the origin.
static void take_segment(gjk32 *s, difference32 p, difference32 q) {
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
static bool take_triangle(gjk32 *s, difference32 p, difference32 q, difference32 r) {
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
static void take(gjk32 *s, const difference32 *added) {
    const difference32 p = s->vertices[0], q = s->vertices[1];
    if (s->count == 1) {
        take_segment(s, p, *added);
        return;
    }
    if (take_triangle(s, p, q, *added))
        return;
    gjk32 other = *s;
    take_segment(s, p, *added);
    take_segment(&other, q, *added);
    if (other.distance < s->distance)
        *s = other;
}

static bool holds(const gjk32 *s, const difference32 *vertex) {
    for (int i = 0; i < s->count; ++i) {
        if (s->vertices[i].a == vertex->a && s->vertices[i].b == vertex->b)
            return true;
    }
    return false;
}

static double rounding_of(const posed32 *shape) {
    const bmr_vec2 place = shape->pose.position;
    return no_distance * ((double)shape->proxy->reach + fabs(place.x) + fabs(place.y));
}

/// Calls what is no more than rounding nothing. Of shapes whose reach is infinite nothing is.
static void drop_rounding(gjk32 *s, double rounding) {
    if (s->distance <= rounding && rounding < HUGE_VAL) {
        s->closest = bmr_vec2_make(0.0, 0.0);
        s->distance = 0.0;
    }
}

/// `closest` is where to begin, any numbers, and where it ended.
static void gjk32_search(gjk32 *search, const posed32 *a, const posed32 *b, bmr_closest32 *closest) {
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
        const difference32 found = least(a, b, n);
        ++search->iterations;
        if (holds(search, &found) ||
            !(search->distance - bmr_dot(n, found.w) > least_gain * search->distance))
            break;
        const gjk32 before = *search;
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

/// The closest points in the world.
static void gjk32_points(const gjk32 *search, const posed32 *a, const posed32 *b, bmr_vec2 *point_a,
                         bmr_vec2 *point_b) {
    *point_a = *point_b = bmr_vec2_make(0.0, 0.0);
    for (int i = 0; i < search->count; ++i) {
        const difference32 *v = &search->vertices[i];
        *point_a = bmr_add(*point_a, bmr_scale(v->weight, posed32_vertex(a, v->a)));
        *point_b = bmr_add(*point_b, bmr_scale(v->weight, posed32_vertex(b, v->b)));
    }
    if (search->count == 3)
        *point_b = *point_a;
}

bmr_distance32 bmr_convex32_distance(const bmr_proxy32 *a, const bmr_transform32 *pose_a,
                                     const bmr_proxy32 *b, const bmr_transform32 *pose_b,
                                     bmr_closest32 *closest) {
    const posed32 at_a = posed32_at(a, pose_a), at_b = posed32_at(b, pose_b);
    gjk32 search;
    gjk32_search(&search, &at_a, &at_b, closest);
    bmr_vec2 point_a, point_b;
    gjk32_points(&search, &at_a, &at_b, &point_a, &point_b);
    bmr_distance32 answer = {narrow(point_a),
                             narrow(point_b),
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

// Grazing casts halve what is left at each step, all others square it: this is for grazing ones that cross
// 500 m at a slop.
enum { MOST_CAST_STEPS = 64 };

bool bmr_convex32_cast(const bmr_proxy32 *a, const bmr_transform32 *pose_a, const bmr_proxy32 *b,
                       const bmr_transform32 *pose_b, bmr_vec32 translation, float linear_slop,
                       bmr_cast32 *cast) {
    const bmr_cast32 none = {{0.0f, 0.0f}, {0.0f, 0.0f}, 1.0f, 0};
    *cast = none;
    const posed32 at_a = posed32_at(a, pose_a), start = posed32_at(b, pose_b);
    posed32 at_b = start;
    const double slop = (double)linear_slop, skin = 2.0 * slop;
    const double radius_a = fmax((double)a->radius, skin), radius_b = fmax((double)b->radius, skin);
    const double wanted = fmax(skin, radius_a + radius_b - skin), tolerance = 0.5 * slop;
    const bmr_vec2 way = convex32_wide(translation);

    // Box2D says no at once where the first two vertices that it looks at have met.
    bmr_closest32 closest = {posed32_support(&at_a, bmr_neg(way)), posed32_support(&at_b, way)};
    const bmr_vec2 first = bmr_sub(posed32_vertex(&at_b, closest.b), posed32_vertex(&at_a, closest.a));
    if (!(sqrt(bmr_dot(first, first)) - wanted > tolerance))
        return false;

    double lambda = 0.0;
    gjk32 search;
    for (int step = 0; step < MOST_CAST_STEPS; ++step) {
        gjk32_search(&search, &at_a, &at_b, &closest);
        cast->iterations += search.iterations;
        if (!(search.distance > 0.0))
            return false;
        if (search.distance - wanted <= tolerance)
            break;
        // The distance is a convex function of lambda, its slope the speed along the closest points.
        const double speed = -bmr_dot(way, search.closest) / search.distance;
        if (!(speed > 0.0))
            return false;
        lambda += (search.distance - wanted) / speed;
        if (!(lambda <= 1.0))
            return false;
        at_b.pose.position = bmr_add(start.pose.position, bmr_scale(lambda, way));
    }
    bmr_vec2 point_a, point_b;
    gjk32_points(&search, &at_a, &at_b, &point_a, &point_b);
    const bmr_vec2 normal = bmr_scale(1.0 / search.distance, search.closest);
    cast->point = narrow(bmr_add(point_a, bmr_scale(radius_a, normal)));
    cast->normal = narrow(normal);
    cast->lambda = (float)lambda;
    return true;
}

// At most so many times one direction is tried before the closest points are found again, and at most so
// many directions there are. Box2D's own search has 20; this one usually takes three. Sides that turn by
// radians next to each other need more: after FEW_DIRECTIONS that stand still, directions that turn are
// tried, too.
enum { MOST_TIMES = 12, FEW_DIRECTIONS = 32, MOST_DIRECTIONS = 400 };

/// A shape on its way.
typedef struct moving {
    const bmr_proxy32 *proxy;
    bmr_vec2 center, start, way; ///< the centre in the shape's frame; in the world, and how far it goes
    double angle, turn;
    double lever; ///< no vertex is farther from the centre
} moving;

typedef struct sweeps {
    moving a, b;
    double target, tolerance;
    double rounding; ///< of what is found along a direction
    double far;      ///< the centres are never farther apart
    double speed;    ///< of one centre as the other sees it
} sweeps;

/// A direction that turns evenly, or stands still.
typedef struct axis {
    bmr_vec2 n; ///< at a time
    double since, turn;
    double bend; ///< of what lies between the shapes along it: its second derivative is at most this
} axis;

/// A direction at a time.
typedef struct moment {
    double t;
    double gap; ///< how much more than the distance asked for lies between the shapes
} moment;

static moving move(const bmr_proxy32 *proxy, const bmr_sweep32 *sweep) {
    moving m;
    m.proxy = proxy;
    m.center = convex32_wide(sweep->local_center);
    m.start = convex32_wide(sweep->c0);
    m.way = bmr_sub(convex32_wide(sweep->c), m.start);
    m.angle = (double)sweep->a0;
    m.turn = (double)sweep->a - m.angle;
    m.lever = (double)proxy->reach + sqrt(bmr_dot(m.center, m.center));
    return m;
}

static posed32 at(const moving *m, double t) {
    const double angle = m->angle + t * m->turn;
    posed32 shape;
    shape.proxy = m->proxy;
    shape.pose.c = cos(angle);
    shape.pose.s = sin(angle);
    shape.pose.position =
        bmr_sub(bmr_add(m->start, bmr_scale(t, m->way)), bmr_rotate(&shape.pose, m->center));
    return shape;
}

/// What a shape adds to the bend. How far the shape reaches along a direction is a function of the angle
/// between the two, and its second derivative is at least -lever: that of a single vertex is the negative of
/// how far it reaches, and where another vertex becomes the farthest the slope jumps up.
static double bend_of(const moving *m, double turn) {
    const double relative = m->turn - turn;
    return m->lever * relative * relative;
}

/// A direction n at a time, with the bend of what lies between the shapes along it. The centres are D + t V
/// apart. Along a direction that stands still that adds no bend. Along one that turns at the rate w the
/// second derivative of n (D + t V) is -w^2 n (D + t V) + 2 w V n', n' a quarter turn from n.
static axis axis_at(const sweeps *q, bmr_vec2 n, double since, double turn) {
    const double centers = turn != 0.0 ? turn * turn * q->far + 2.0 * fabs(turn) * q->speed : 0.0;
    const axis along = {n, since, turn, bend_of(&q->a, turn) + bend_of(&q->b, turn) + centers};
    return along;
}

static bmr_vec2 direction_at(const axis *along, double t) {
    if (along->turn == 0.0)
        return along->n;
    const double angle = along->turn * (t - along->since);
    const bmr_pose turned = {{0.0, 0.0}, cos(angle), sin(angle)};
    return bmr_rotate(&turned, along->n);
}

static moment moment_at(const sweeps *q, const axis *along, double t, double distance) {
    const posed32 a = at(&q->a, t), b = at(&q->b, t);
    const moment m = {t, posed32_beyond(&a, &b, direction_at(along, t)) - q->rounding - distance};
    return m;
}

/// Does a direction that keeps the shapes apart at two times do so in between?
///
/// What lies between them is below its chord by no more than bend x (1 - x) / 2, x from 0 to 1 the part of
/// the time. What is left of the gaps is a parabola, and its minimum above zero.
static bool holds_between(const axis *along, moment first, moment last) {
    if (!(first.gap >= 0.0) || !(last.gap >= 0.0))
        return false;
    const double part = last.t - first.t;
    const double bulge = 0.5 * part * part * along->bend;
    return bulge <= 0.0 || sqrt(bulge) <= sqrt(first.gap) + sqrt(last.gap);
}

/// How long that lasts for certain if it holds at the end.
static double certain_part(const axis *along, double gap) {
    const double bulge = 0.5 * along->bend;
    return bulge > 0.0 ? sqrt(gap / bulge) : HUGE_VAL;
}

/// When to test next: where the gap is about a quarter of the tolerance, by false position and bisection in
/// turns (`turn`), but no later than what is certain to hold.
static double next_time(const sweeps *q, const axis *along, moment proved, moment beyond, int turn) {
    double part = 0.5 * (beyond.t - proved.t);
    if (beyond.gap < 0.0 && turn % 2 == 0)
        part *= 2.0 * (proved.gap - 0.25 * q->tolerance) / (proved.gap - beyond.gap);
    return proved.t + fmin(part, certain_part(along, proved.gap));
}

/// The last moment found up to which the direction keeps the shapes farther apart than the target. It has
/// less gap than half the tolerance left, or ends at t_max, or was hard to find.
static moment advance(const sweeps *q, const axis *along, double t, double t_max) {
    moment proved = moment_at(q, along, t, q->target), beyond = {t_max, 0.0};
    double next = t_max;
    for (int i = 0; i < MOST_TIMES && proved.gap > 0.25 * q->tolerance && next > proved.t; ++i) {
        const moment m = moment_at(q, along, next, q->target);
        if (!holds_between(along, proved, m)) {
            beyond = m;
        } else {
            proved = m;
            if (m.t >= t_max || m.gap <= 0.5 * q->tolerance)
                break;
        }
        next = next_time(q, along, proved, beyond, i);
    }
    return proved;
}

/// The same, of directions that turn with either shape. Where a vertex slides along a side that turns, one
/// that stands still soon has the side's far end before it and is left; the side's own normal is not.
static moment advance_turning(const sweeps *q, bmr_vec2 n, double t, double t_max) {
    const axis with_a = axis_at(q, n, t, q->a.turn), with_b = axis_at(q, n, t, q->b.turn);
    const moment of_a = advance(q, &with_a, t, t_max), of_b = advance(q, &with_b, t, t_max);
    return of_a.t >= of_b.t ? of_a : of_b;
}

/// The direction that was good for another motion.
static bool keeps_apart(const sweeps *q, bmr_vec32 direction, double t_max) {
    if (direction.x == 0.0f && direction.y == 0.0f)
        return false;
    const axis along = axis_at(q, convex32_wide(direction), 0.0, 0.0);
    const double distance = q->target + q->tolerance + q->rounding;
    const moment first = moment_at(q, &along, 0.0, distance);
    return first.gap >= 0.0 && holds_between(&along, first, moment_at(q, &along, t_max, distance));
}

static bmr_impact32 search(const sweeps *q, double t_max, bmr_vec32 *direction, double *t) {
    bmr_closest32 closest = {0, 0};
    for (int i = 0; i < MOST_DIRECTIONS; ++i) {
        const posed32 a = at(&q->a, *t), b = at(&q->b, *t);
        gjk32 found;
        gjk32_search(&found, &a, &b, &closest);
        if (!(found.distance > 0.0) && *t <= 0.0)
            return found.distance <= 0.0 ? BMR_IMPACT_OVERLAPPED : BMR_IMPACT_FAILED;
        if (found.distance < q->target + q->tolerance)
            return BMR_IMPACT_TOUCHING;
        if (*t >= t_max) {
            *t = t_max; // which may be below 0
            return BMR_IMPACT_SEPARATED;
        }
        const bmr_vec2 n = bmr_scale(1.0 / found.distance, found.closest);
        const axis still = axis_at(q, n, *t, 0.0);
        moment proved = advance(q, &still, *t, t_max);
        if (i >= FEW_DIRECTIONS && proved.t < t_max) {
            const moment turning = advance_turning(q, n, *t, t_max);
            proved = turning.t > proved.t ? turning : proved;
        }
        if (proved.t >= t_max && proved.gap > q->tolerance) {
            *direction = narrow(n);
            *t = t_max;
            return BMR_IMPACT_SEPARATED;
        }
        if (!(proved.t > *t))
            return BMR_IMPACT_FAILED;
        *t = proved.t;
    }
    return BMR_IMPACT_FAILED;
}

bmr_impact32 bmr_convex32_impact(const bmr_proxy32 *a, const bmr_sweep32 *sweep_a, const bmr_proxy32 *b,
                                 const bmr_sweep32 *sweep_b, float t_max, float linear_slop,
                                 bmr_vec32 *direction, float *t) {
    const double slop = (double)linear_slop;
    const double target = (double)a->radius + (double)b->radius - 3.0 * slop;
    sweeps q = {.a = move(a, sweep_a), .b = move(b, sweep_b)};
    q.target = target > slop ? target : slop;
    q.tolerance = 0.25 * slop;
    q.rounding = SUPPORT_ROUNDING * ((double)a->reach + (double)b->reach);
    // Of shapes of kilometres, supports are off by as much.
    q.tolerance = fmax(q.tolerance, 4.0 * q.rounding);
    const bmr_vec2 between = bmr_sub(q.b.start, q.a.start), way = bmr_sub(q.b.way, q.a.way);
    const bmr_vec2 after = bmr_add(between, bmr_scale((double)t_max, way));
    q.far = sqrt(fmax(bmr_dot(between, between), bmr_dot(after, after)));
    q.speed = sqrt(bmr_dot(way, way));
    *t = t_max;
    if (keeps_apart(&q, *direction, (double)t_max))
        return BMR_IMPACT_SEPARATED;
    double time = 0.0;
    const bmr_impact32 answer = search(&q, (double)t_max, direction, &time);
    *t = (float)time;
    return answer;
}
