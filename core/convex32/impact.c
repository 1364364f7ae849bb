// SPDX-License-Identifier: MIT
#include <math.h>

#include "convex32/gjk.h"

// A direction is asked at so many times at most before the closest points are looked for again, and so often
// are they looked for. Box2D's own search has 20 directions; this one takes three, but for sides that turn by
// radians next to each other.
enum { MOST_TIMES = 12, MOST_DIRECTIONS = 400 };

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
} question;

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

static moment look(const question *q, bmr_vec2 n, double t, double distance) {
    const bmr_posed32 a = at(&q->a, t), b = at(&q->b, t);
    const moment m = {t, bmr_posed32_beyond(&a, &b, n) - q->rounding - distance};
    return m;
}

/// Does a direction that keeps the shapes apart at two times do so in between?
///
/// Centres move along it evenly. How far a turning shape reaches along it is a function h of the angle whose
/// second derivative is at least -lever (a vertex' is its negative; where one takes over from another the
/// slope jumps up), so h is above its chord by no more than lever x (1 - x) turn^2 / 2, x from 0 to 1. What
/// is left of the gaps is a parabola, and its minimum above zero.
static bool holds_between(const question *q, moment first, moment last) {
    if (!(first.gap >= 0.0) || !(last.gap >= 0.0))
        return false;
    const double part = last.t - first.t;
    const double bulge =
        0.5 * part * part * (q->a.lever * q->a.turn * q->a.turn + q->b.lever * q->b.turn * q->b.turn);
    return bulge <= 0.0 || sqrt(bulge) <= sqrt(first.gap) + sqrt(last.gap);
}

/// How long that lasts for certain if it holds at the end.
static double certain_part(const question *q, double gap) {
    const double bulge = 0.5 * (q->a.lever * q->a.turn * q->a.turn + q->b.lever * q->b.turn * q->b.turn);
    return bulge > 0.0 ? sqrt(gap / bulge) : HUGE_VAL;
}

/// When to look next: where the gap is about a quarter of the tolerance, by false position and bisection in
/// turns (`turn`), but no later than what is certain to hold.
static double next_time(const question *q, moment proved, moment beyond, int turn) {
    double part = 0.5 * (beyond.t - proved.t);
    if (beyond.gap < 0.0 && turn % 2 == 0)
        part *= 2.0 * (proved.gap - 0.25 * q->tolerance) / (proved.gap - beyond.gap);
    return proved.t + fmin(part, certain_part(q, proved.gap));
}

/// The last moment found up to which the direction keeps the shapes farther apart than the target. It has
/// less gap than half the tolerance left, or ends at t_max, or was hard to find.
static moment advance(const question *q, bmr_vec2 n, double t, double t_max) {
    moment proved = look(q, n, t, q->target), beyond = {t_max, 0.0};
    double next = t_max;
    for (int i = 0; i < MOST_TIMES && proved.gap > 0.25 * q->tolerance && next > proved.t; ++i) {
        const moment m = look(q, n, next, q->target);
        if (!holds_between(q, proved, m)) {
            beyond = m;
        } else {
            proved = m;
            if (m.t >= t_max || m.gap <= 0.5 * q->tolerance)
                break;
        }
        next = next_time(q, proved, beyond, i);
    }
    return proved;
}

/// The direction that was good for another motion.
static bool keeps_apart(const question *q, bmr_vec32 direction, double t_max) {
    if (direction.x == 0.0f && direction.y == 0.0f)
        return false;
    const bmr_vec2 n = bmr_widen(direction);
    const double distance = q->target + q->tolerance + q->rounding;
    const moment first = look(q, n, 0.0, distance);
    return first.gap >= 0.0 && holds_between(q, first, look(q, n, t_max, distance));
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
        if (*t >= t_max)
            return BMR_IMPACT_SEPARATED;
        const bmr_vec2 n = bmr_scale(1.0 / found.distance, found.closest);
        const moment proved = advance(q, n, *t, t_max);
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
    question q = {move(a, sweep_a), move(b, sweep_b), target > slop ? target : slop, 0.25 * slop, 0.0};
    q.rounding = BMR_SUPPORT32_ROUNDING * ((double)a->reach + (double)b->reach);
    // Of shapes of kilometres, supports are off by as much.
    q.tolerance = fmax(q.tolerance, 4.0 * q.rounding);
    *t = t_max;
    if (keeps_apart(&q, *direction, (double)t_max))
        return BMR_IMPACT_SEPARATED;
    double time = 0.0;
    const bmr_impact32 answer = search(&q, (double)t_max, direction, &time);
    *t = (float)time;
    return answer;
}
