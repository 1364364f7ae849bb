// SPDX-License-Identifier: MIT
#include <math.h>

#include "convex32/gjk.h"

// At most so many times one direction is asked before the closest points are looked for again, and at most so
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

typedef struct question {
    moving a, b;
    double target, tolerance;
    double rounding; ///< of what is found along a direction
    double far;      ///< the centres are never farther apart
    double speed;    ///< of one centre as the other sees it
} question;

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
    m.center = bmr_widen(sweep->local_center);
    m.start = bmr_widen(sweep->c0);
    m.way = bmr_sub(bmr_widen(sweep->c), m.start);
    m.angle = (double)sweep->a0;
    m.turn = (double)sweep->a - m.angle;
    m.lever = (double)proxy->reach + sqrt(bmr_dot(m.center, m.center));
    return m;
}

static bmr_posed32 at(const moving *m, double t) {
    const double angle = m->angle + t * m->turn;
    bmr_posed32 shape;
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
static axis axis_at(const question *q, bmr_vec2 n, double since, double turn) {
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

static moment look(const question *q, const axis *along, double t, double distance) {
    const bmr_posed32 a = at(&q->a, t), b = at(&q->b, t);
    const moment m = {t, bmr_posed32_beyond(&a, &b, direction_at(along, t)) - q->rounding - distance};
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

/// When to look next: where the gap is about a quarter of the tolerance, by false position and bisection in
/// turns (`turn`), but no later than what is certain to hold.
static double next_time(const question *q, const axis *along, moment proved, moment beyond, int turn) {
    double part = 0.5 * (beyond.t - proved.t);
    if (beyond.gap < 0.0 && turn % 2 == 0)
        part *= 2.0 * (proved.gap - 0.25 * q->tolerance) / (proved.gap - beyond.gap);
    return proved.t + fmin(part, certain_part(along, proved.gap));
}

/// The last moment found up to which the direction keeps the shapes farther apart than the target. It has
/// less gap than half the tolerance left, or ends at t_max, or was hard to find.
static moment advance(const question *q, const axis *along, double t, double t_max) {
    moment proved = look(q, along, t, q->target), beyond = {t_max, 0.0};
    double next = t_max;
    for (int i = 0; i < MOST_TIMES && proved.gap > 0.25 * q->tolerance && next > proved.t; ++i) {
        const moment m = look(q, along, next, q->target);
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
static moment advance_turning(const question *q, bmr_vec2 n, double t, double t_max) {
    const axis with_a = axis_at(q, n, t, q->a.turn), with_b = axis_at(q, n, t, q->b.turn);
    const moment of_a = advance(q, &with_a, t, t_max), of_b = advance(q, &with_b, t, t_max);
    return of_a.t >= of_b.t ? of_a : of_b;
}

/// The direction that was good for another motion.
static bool keeps_apart(const question *q, bmr_vec32 direction, double t_max) {
    if (direction.x == 0.0f && direction.y == 0.0f)
        return false;
    const axis along = axis_at(q, bmr_widen(direction), 0.0, 0.0);
    const double distance = q->target + q->tolerance + q->rounding;
    const moment first = look(q, &along, 0.0, distance);
    return first.gap >= 0.0 && holds_between(&along, first, look(q, &along, t_max, distance));
}

static bmr_impact32 search(const question *q, double t_max, bmr_vec32 *direction, double *t) {
    bmr_closest32 closest = {0, 0};
    for (int i = 0; i < MOST_DIRECTIONS; ++i) {
        const bmr_posed32 a = at(&q->a, *t), b = at(&q->b, *t);
        bmr_gjk32 found;
        bmr_gjk32_search(&found, &a, &b, &closest);
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
            *direction = bmr_narrow(n);
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
    question q = {.a = move(a, sweep_a), .b = move(b, sweep_b)};
    q.target = target > slop ? target : slop;
    q.tolerance = 0.25 * slop;
    q.rounding = BMR_SUPPORT32_ROUNDING * ((double)a->reach + (double)b->reach);
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
