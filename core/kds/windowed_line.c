// SPDX-License-Identifier: MIT
#include "kds/windowed_line.h"

#include <math.h>

#include "certificate/coarse.h"
#include "geometry/distance.h"
#include "geometry/length.h"

/// A direction counts as inside of a bracket when the sines of its angles to both ends are larger than this.
/// It is well above the rounding of unit vectors and poses, and far below the angles between the edges of any
/// smooth polygon.
#define INSIDE 1e-9

/// Edges whose directions agree up to rounding rise above one another by less than this part of the extent.
#define FLAT_PART (8.0 * INSIDE)

/// As the distance of two polygons that count as apart exceeds the margin by this part of their extents, no
/// condition of a fresh line is within BMR_FAILING_PART of zero.
#define CONTACT_PART (4.0 * BMR_FAILING_PART)

/// What an audit grants to rounding, in units of the extents.
#define AUDIT_PART 1e-11

static bool has_bracket(const bmr_windowed_line *w) {
    return w->low.x != 0.0 || w->low.y != 0.0;
}

size_t bmr_windowed_conditions(const bmr_windowed_line *w, double margin, bmr_condition *conditions) {
    const int owner = w->owner;
    const bmr_vec2 n = w->line.normal;
    size_t count = 0;
    for (int i = 0; i < w->count; ++i)
        conditions[count++] = bmr_condition_beyond(owner, n, w->line.offset + margin, w->point[i], i);
    if (has_bracket(w)) {
        // low, then the direction -n, then high, counter-clockwise
        conditions[count++] = bmr_condition_turn(owner, n, w->low, BMR_WINDOWED_LOW);
        conditions[count++] = bmr_condition_turn(owner, bmr_neg(n), w->high, BMR_WINDOWED_HIGH);
    }
    return count;
}

void bmr_windowed_proof(const bmr_windowed_line *w, bmr_kds_proof *proof) {
    proof->owner = w->owner;
    proof->line = w->line;
    proof->nearest = w->point[0];
    proof->level = w->level;
}

bool bmr_windowed_same_line(const bmr_windowed_line *a, const bmr_windowed_line *b) {
    return a->owner == b->owner && a->line.normal.x == b->line.normal.x &&
           a->line.normal.y == b->line.normal.y && a->line.offset == b->line.offset;
}

bmr_vec2 bmr_windowed_direction(const bmr_windowed_line *w, const bmr_pose *b_in_a) {
    return w->owner == 0 ? w->line.normal : bmr_neg(bmr_rotate(b_in_a, w->line.normal));
}

/// The line's direction as the other body sees it: the way it looks at the owner.
static bmr_vec2 facing(const bmr_windowed_line *w, const bmr_pose *b_in_a) {
    return w->owner == 0 ? bmr_unrotate(b_in_a, bmr_neg(w->line.normal))
                         : bmr_rotate(b_in_a, bmr_neg(w->line.normal));
}

static double extents(const bmr_kds *kds) {
    return kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent;
}

bmr_windowed_failure bmr_windowed_fails(const bmr_windowed_line *w, const bmr_kds *kds,
                                        const bmr_instant *now) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_windowed_conditions(w, kds->def.margin, conditions);
    const bmr_vec2 p = now->pose.position;
    const double reach = BMR_FAILING_PART * (extents(kds) + fabs(p.x) + fabs(p.y));
    bmr_windowed_failure failure = {false, 0};
    for (size_t i = 0; i < count; ++i) {
        const bool turn = conditions[i].kind == BMR_CONDITION_TURN;
        if (!bmr_condition_fails(&conditions[i], now, turn ? BMR_FAILING_PART : reach))
            continue;
        if (turn)
            failure.rolled = conditions[i].label == BMR_WINDOWED_HIGH ? 1 : -1;
        else
            failure.crossed = true;
    }
    return failure;
}

void bmr_windowed_line_set(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, int owner,
                           bmr_vec2 direction, const uint32_t support[2]) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const bmr_vec2 back = bmr_unrotate(b_in_a, bmr_neg(direction));
    unsigned steps = 0;
    w->support[0] = bmr_support_near(a, direction, support[0] % a->count, &steps);
    w->support[1] = bmr_support_near(b, back, support[1] % b->count, &steps);
    bmr_kds_tally(kds, steps);
    w->owner = (uint8_t)owner;
    w->level = 0;
    w->line.normal = owner == 0 ? direction : back;
    const bmr_vec2 touch = owner == 0 ? a->vertices[w->support[0]] : b->vertices[w->support[1]];
    w->line.offset = bmr_dot(w->line.normal, touch);
}

/// Moves an end of a bracket to a right angle from the direction if it is farther away: for a wider bracket
/// the two conditions would hold in other directions, too. (An end three right angles away would pass for one
/// that is a right angle away on the other side, hence the second test.)
static bmr_vec2 within_right_angle(bmr_vec2 end, bmr_vec2 direction, int side) {
    if (bmr_dot(end, direction) > 0.0 && side * bmr_cross(direction, end) > -INSIDE)
        return end;
    return side > 0 ? bmr_left(direction) : bmr_neg(bmr_left(direction));
}

void bmr_windowed_bracket(bmr_windowed_line *w, const bmr_pose *b_in_a, bmr_vec2 low, bmr_vec2 high) {
    const bmr_vec2 d = facing(w, b_in_a);
    w->low = within_right_angle(low, d, -1);
    w->high = within_right_angle(high, d, 1);
    w->fixed = false;
}

bool bmr_windowed_inside(const bmr_windowed_line *w, const bmr_pose *b_in_a) {
    const bmr_vec2 d = facing(w, b_in_a);
    return bmr_cross(w->low, d) > INSIDE && bmr_cross(d, w->high) > INSIDE;
}

void bmr_windowed_fix(bmr_windowed_line *w) {
    w->low = w->high = bmr_vec2_make(0.0, 0.0);
    w->fixed = true;
}

static bool ties(bmr_vec2 normal, bmr_vec2 direction) {
    return bmr_dot(normal, direction) > 0.0 && fabs(bmr_cross(normal, direction)) <= INSIDE;
}

/// Vertices `first` to `last` of a polygon, with the normals of the edges around them.
typedef struct run {
    const bmr_polygon *polygon;
    uint32_t first, last, count;
    bmr_vec2 low, high;
} run;

static void lengthen(run *r, int side) {
    const uint32_t n = r->polygon->count;
    if (r->count == n || r->count == BMR_WINDOWED_POINTS)
        return;
    ++r->count;
    if (side > 0) {
        r->last = r->last + 1 < n ? r->last + 1 : 0;
        r->high = bmr_polygon_normal(r->polygon, r->last);
    } else {
        r->first = r->first > 0 ? r->first - 1 : n - 1;
        r->low = bmr_polygon_normal(r->polygon, r->first > 0 ? r->first - 1 : n - 1);
    }
}

static void take_window(bmr_windowed_line *w, const bmr_window *window) {
    w->count = 2;
    w->low = window->low;
    w->high = window->high;
    for (int i = 0; i < 2; ++i)
        w->point[i] = window->corner[i];
}

void bmr_windowed_exact(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, int sense) {
    const int other = 1 - w->owner;
    const bmr_polygon *p = kds->shapes[other].polygon;
    const bmr_vec2 d = facing(w, b_in_a);
    unsigned steps = 1 + BMR_WINDOWED_POINTS; // at most so many of its vertices stand for it
    const uint32_t n = p->count, v = bmr_support_near(p, d, w->support[other] % n, &steps);
    bmr_kds_tally(kds, steps);
    w->support[other] = v;
    w->low = w->high = bmr_vec2_make(0.0, 0.0);
    w->point[0] = p->vertices[v];
    w->count = 1;
    w->fixed = false;
    if (n == 1)
        return;
    run r = {p, v, v, 1, bmr_polygon_normal(p, v > 0 ? v - 1 : n - 1), bmr_polygon_normal(p, v)};
    // First whatever ties with the support vertex, then one more on the side to which the direction turns.
    for (int i = 2; i < BMR_WINDOWED_POINTS; ++i) {
        if (ties(r.low, d))
            lengthen(&r, -1);
        else if (ties(r.high, d))
            lengthen(&r, 1);
    }
    if (sense == 0)
        sense = bmr_dot(r.high, d) > bmr_dot(r.low, d) ? 1 : -1;
    lengthen(&r, sense);
    for (uint32_t i = r.first;; i = i + 1 < n ? i + 1 : 0) {
        if (i != v)
            w->point[w->count++] = p->vertices[i];
        if (i == r.last)
            break;
    }
    if (r.count == n) // all of it
        return;
    bmr_windowed_bracket(w, b_in_a, r.low, r.high);
    if (bmr_windowed_inside(w, b_in_a))
        return;
    // More edges than that are one up to rounding. Two corners stand for them.
    bmr_window window;
    bmr_window_make(p, d, v, FLAT_PART * p->extent, 0, &window);
    bmr_kds_tally(kds, window.steps);
    take_window(w, &window);
}

double bmr_windowed_life(const bmr_windowed_line *w, const bmr_pose *b_in_a, int sense) {
    if (!has_bracket(w))
        return -2.0;
    const bmr_vec2 d = facing(w, b_in_a);
    const double low = bmr_dot(w->low, d), high = bmr_dot(w->high, d);
    return sense > 0 ? high : sense < 0 ? low : fmax(low, high);
}

double bmr_windowed_time(const bmr_windowed_line *w, const bmr_kds *kds, const bmr_instant *now) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_windowed_conditions(w, kds->def.margin, conditions);
    double time = INFINITY;
    for (size_t i = 0; i < count; ++i) {
        const double rate = bmr_condition_rate(&conditions[i], now);
        if (rate < 0.0)
            time = fmin(time, bmr_condition_value(&conditions[i], &now->pose) / -rate);
    }
    return time;
}

void bmr_windowed_corners(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, double limit,
                          int sense) {
    bmr_windowed_exact(w, kds, b_in_a, sense);
    if (!has_bracket(w))
        return;
    const int other = 1 - w->owner;
    const bmr_polygon *p = kds->shapes[other].polygon;
    const bmr_vec2 d = facing(w, b_in_a);
    bmr_window window;
    bmr_window_make(p, d, w->support[other], limit, sense, &window);
    bmr_kds_tally(kds, window.steps);
    const double exact = bmr_windowed_life(w, b_in_a, sense);
    // The exact window is kept only if it is also at least as wide against the sense of turning: the body may
    // turn back.
    const bool steady = sense == 0 || bmr_windowed_life(w, b_in_a, -sense) <=
                                          bmr_dot(sense > 0 ? window.low : window.high, d);
    if ((!(window.life < exact) && steady) || !(bmr_cross(window.low, d) > INSIDE) ||
        !(bmr_cross(d, window.high) > INSIDE))
        return;
    take_window(w, &window);
}

double bmr_windowed_least(const bmr_kds *kds) {
    return bmr_kds_reach(kds) + CONTACT_PART * extents(kds);
}

bool bmr_windowed_closest(const bmr_kds *kds, const bmr_pose *b_in_a, uint32_t support[2],
                          bmr_vec2 *direction, double *distance) {
    return bmr_kds_closest(kds, b_in_a, &support[0], &support[1], direction, distance) &&
           *distance > bmr_windowed_least(kds);
}

/// Does some point of the window reach as far as every vertex of the polygon in direction `d`?
static bool bounds(const bmr_windowed_line *w, const bmr_polygon *p, bmr_vec2 d, double slop) {
    double most = -INFINITY;
    for (int i = 0; i < w->count; ++i)
        most = fmax(most, bmr_dot(w->point[i], d));
    for (uint32_t i = 0; i < p->count; ++i)
        if (!(bmr_dot(p->vertices[i], d) <= most + slop))
            return false;
    return true;
}

bmr_error bmr_windowed_audit(const bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a) {
    const bmr_polygon *p = kds->shapes[1 - w->owner].polygon;
    if (!has_bracket(w) && !w->fixed) // it must be all vertices
        return w->count == p->count ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
    double slop = p->extent;
    for (int i = 0; i < w->count; ++i)
        slop = fmax(slop, fmax(fabs(w->point[i].x), fabs(w->point[i].y)));
    slop *= AUDIT_PART;
    const bmr_vec2 d = facing(w, b_in_a);
    if (w->fixed)
        return bounds(w, p, d, slop) ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
    if (!(bmr_cross(w->low, d) >= -INSIDE) || !(bmr_cross(d, w->high) >= -INSIDE) ||
        !bounds(w, p, w->low, slop) || !bounds(w, p, w->high, slop))
        return BMR_ERROR_INVALID_STRUCTURE;
    // Between two ends, the window's reach minus a vertex's is least where two of its points tie.
    for (int i = 0; i < w->count; ++i)
        for (int j = 0; j < w->count; ++j) {
            const bmr_vec2 e = bmr_scale_up_if_tiny(bmr_sub(w->point[j], w->point[i]));
            const double length = hypot(e.x, e.y);
            const bmr_vec2 tie = bmr_scale(1.0 / length, bmr_left(e));
            if (length > 0.0 && bmr_cross(w->low, tie) > 0.0 && bmr_cross(tie, w->high) > 0.0 &&
                !bounds(w, p, tie, slop))
                return BMR_ERROR_INVALID_STRUCTURE;
        }
    return BMR_OK;
}

static const bmr_windowed_line *line_of(const bmr_kds *kds) {
    return (const bmr_windowed_line *)(const void *)kds->state;
}

size_t bmr_windowed_own_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    return bmr_windowed_conditions(line_of(kds), kds->def.margin, conditions);
}

void bmr_windowed_own_proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    bmr_windowed_proof(line_of(kds), proof);
}

bmr_error bmr_windowed_own_audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    return bmr_windowed_audit(line_of(kds), kds, b_in_a);
}

bool bmr_coarse_line(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 closest, const uint32_t support[2],
                     bmr_windowed_line *line) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const double least = bmr_windowed_least(kds);
    unsigned steps = 0;
    bmr_coarse coarse;
    const bool found = bmr_coarse_pick(a, b, b_in_a, closest, least, support, &coarse, &steps);
    bmr_kds_tally(kds, steps);
    if (!found)
        return false;
    const bmr_vec2 direction = coarse.owner == 0 ? coarse.normal : bmr_neg(bmr_rotate(b_in_a, coarse.normal));
    bmr_windowed_line_set(line, kds, b_in_a, coarse.owner, direction, support);
    // Where little more than `least` is left, rounding moves the ends of the fan.
    const bmr_vec2 p = a->vertices[line->support[0]], q = b->vertices[line->support[1]];
    if (!(bmr_dot(direction, bmr_sub(bmr_transform(b_in_a, q), p)) > least))
        return false;
    bmr_windowed_exact(line, kds, b_in_a, 0);
    return true;
}
