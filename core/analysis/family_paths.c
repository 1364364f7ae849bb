// SPDX-License-Identifier: MIT
// The paths of the families of motion, each a function of one free parameter.
#include "analysis/family_paths.h"
#include "geometry/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846
/// A pass begins and ends this many diameters from the near place: where both bounding boxes are well apart.
#define PASS_LENGTH 4.0
/// How far TO_AND_FRO turns to either side: 1.5 degrees.
#define SWING 0.026179938779914945
/// How far zigzag goes out, in diameters.
#define ZIGZAG_DEPTH 0.25
/// A Brownian walk's standard deviation at its end, in diameters per coordinate.
#define BROWNIAN_SPREAD 1.0
/// A wanderer's step on the log scale of its distance, and (times sqrt(distance / D)) in angle: so that the
/// straight leg between two places sinks by a few per cent of the distance only.
#define WANDER_LOG_STEP 0.4
#define WANDER_ANGLE_STEP 0.6
/// A wanderer's distance stays between sigma and this part of D.
#define WANDER_FAR 0.5
/// The largest angle that a leg turns by: its rational rotation is smooth far beyond.
#define LEG_ANGLE 1.0

/// Where B's frame must be, in the rotation of `turn`, for the two supports in the unit direction to be `gap`
/// apart.
static bmr_vec2 place_at_gap(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *turn,
                             bmr_vec2 direction, double gap) {
    const bmr_vec2 on_a = a->vertices[bmr_polygon_support(a, direction)];
    const bmr_vec2 on_b = b->vertices[bmr_polygon_support(b, bmr_neg(bmr_unrotate(turn, direction)))];
    return bmr_add(bmr_sub(on_a, bmr_rotate(turn, on_b)), bmr_scale(gap, direction));
}

bmr_error bmr_path_pieces(const bmr_motion_piece *a, const bmr_motion_piece *b,
                          const bmr_allocator *allocator, bmr_motion *motions[2]) {
    bmr_motion *made = NULL;
    bmr_error error = bmr_motion_create(a, allocator, &made);
    if (error != BMR_OK)
        return error;
    error = bmr_motion_create(b, allocator, &motions[1]);
    if (error != BMR_OK)
        bmr_motion_destroy(made);
    else
        motions[0] = made;
    return error;
}

bmr_error bmr_path_finish(bmr_error error, bmr_motion *motions[2]) {
    if (error != BMR_OK) {
        bmr_motion_destroy(motions[0]);
        bmr_motion_destroy(motions[1]);
    }
    return error;
}

/// An algebraic piece that rests at the pose.
static bmr_algebraic_piece still_at(bmr_pose pose) {
    bmr_algebraic_piece p;
    memset(&p, 0, sizeof p);
    p.x[0] = pose.position.x;
    p.y[0] = pose.position.y;
    p.a[0] = 1.0;
    p.start_c = pose.c;
    p.start_s = pose.s;
    return p;
}

/// Adds a piece to a motion from `time` on, its origin there.
static bmr_error append_piece(bmr_motion *motion, double time, const bmr_algebraic_piece *algebraic) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = time;
    piece.as.algebraic = *algebraic;
    return bmr_motion_change(motion, time, &piece);
}

static const bmr_pose at_origin = {{0.0, 0.0}, 1.0, 0.0};

bmr_error bmr_path_pass(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                        bmr_motion *motions[2]) {
    const bmr_vec2 near_place = place_at_gap(plan->a, plan->b, &plan->turn, plan->toward, gap);
    const bmr_vec2 along = bmr_left(plan->toward);
    const double reach = PASS_LENGTH * plan->diameter;
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    bmr_pose middle = plan->turn;
    middle.position = near_place;
    const double bend = plan->bend * plan->diameter * 4.0; // at half time 1: bend * D
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = 0.5;
    bmr_algebraic_piece *p = &piece.as.algebraic;
    *p = still_at(middle);
    p->degree = plan->bend > 0.0 ? 2 : 1;
    p->x[1] = 2.0 * reach * along.x;
    p->y[1] = 2.0 * reach * along.y;
    p->x[2] = bend * plan->toward.x;
    p->y[2] = bend * plan->toward.y;
    const bmr_motion_piece tumble = bmr_piece_screw(0.5, at_origin, at_origin.position, plan->spin),
                           rest = bmr_piece_rest(at_origin);
    return bmr_path_pieces(plan->family == BMR_FAMILY_TUMBLE ? &tumble : &rest, &piece, allocator, motions);
}

bmr_error bmr_path_polynomial(const bmr_family_plan *plan, double scale, const bmr_allocator *allocator,
                              bmr_motion *motions[2]) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = 0.5;
    bmr_algebraic_piece *p = &piece.as.algebraic;
    *p = still_at(plan->turn);
    p->degree = plan->degree;
    double power = 1.0; // from the half time -1 .. 1 to time - origin
    for (size_t k = 0; k <= plan->degree; k++, power *= 2.0) {
        p->x[k] = scale * power * plan->x[k];
        p->y[k] = scale * power * plan->y[k];
    }
    // B's centre, at the start's rotation, is what the path is for.
    const bmr_vec2 shift = bmr_sub(plan->a->center, bmr_rotate(&plan->turn, plan->b->center));
    p->x[0] += shift.x;
    p->y[0] += shift.y;
    bmr_motion_piece a = bmr_piece_rest(at_origin);
    if (plan->family == BMR_FAMILY_RIGID_ALGEBRAIC) {
        a.origin = 0.5;
        a.kind = BMR_PIECE_ALGEBRAIC;
        a.as.algebraic = still_at(at_origin);
        a.as.algebraic.rotation_degree = 2;
        a.as.algebraic.b[1] = 2.0 * plan->half_turn[0];
        a.as.algebraic.b[2] = 4.0 * plan->half_turn[1];
    }
    return bmr_path_pieces(&a, &piece, allocator, motions);
}

bmr_error bmr_path_spin(const bmr_family_plan *plan, double distance, const bmr_allocator *allocator,
                        bmr_motion *motions[2]) {
    bmr_pose b = plan->turn;
    // A turns about its frame's origin: B is set out from there.
    b.position = bmr_sub(bmr_scale(distance, plan->toward), bmr_rotate(&plan->turn, plan->b->center));
    const bmr_motion_piece spin = bmr_piece_screw(0.0, at_origin, at_origin.position, plan->spin),
                           rest = bmr_piece_rest(b);
    return bmr_path_pieces(&spin, &rest, allocator, motions);
}

/// From pose to pose in one leg: straight, and turning by the rational rotation whose half angle has a
/// linear tangent.
static bmr_error append_leg(bmr_motion *motion, double time, double duration, bmr_pose from, bmr_pose to) {
    bmr_algebraic_piece p = still_at(from);
    p.degree = 1;
    p.x[1] = (to.position.x - from.position.x) / duration;
    p.y[1] = (to.position.y - from.position.y) / duration;
    const double c = from.c * to.c + from.s * to.s, s = from.c * to.s - from.s * to.c;
    if (s != 0.0) {
        p.rotation_degree = 1;
        p.b[1] = tan(0.5 * atan2(s, c)) / duration;
    }
    return append_piece(motion, time, &p);
}

static bmr_pose turned(bmr_pose pose, double angle) {
    const double c = cos(angle), s = sin(angle);
    const bmr_pose r = {pose.position, c * pose.c - s * pose.s, s * pose.c + c * pose.s};
    const double length = hypot(r.c, r.s); // a walk's roundings must not add up
    const bmr_pose unit = {r.position, r.c / length, r.s / length};
    return unit;
}

static bmr_vec2 direction_of(double angle) {
    return bmr_vec2_make(cos(angle), sin(angle));
}

/// Where both bodies are at the end of a leg.
typedef struct place {
    bmr_pose a, b;
} place;

/// A walk in `steps` legs of equal time; `next` gives the place at the end of leg k from that at its start.
typedef struct walker {
    const bmr_family_plan *plan;
    double parameter;
    double angle, log_gap; ///< of a wanderer
} walker;
typedef place (*walk_step)(walker *w, place at, size_t k);

static bmr_error walk(walker *w, bmr_pose start, walk_step next, const bmr_allocator *allocator,
                      bmr_motion *motions[2]) {
    const bmr_motion_piece rest_a = bmr_piece_rest(at_origin), rest_b = bmr_piece_rest(start);
    bmr_error error = bmr_path_pieces(&rest_a, &rest_b, allocator, motions);
    if (error != BMR_OK)
        return error;
    const size_t steps = w->plan->steps;
    const bmr_family family = w->plan->family;
    const bool rigid = family == BMR_FAMILY_RIGID_BROWNIAN || family == BMR_FAMILY_RIGID_WANDER ||
                       family == BMR_FAMILY_TO_AND_FRO;
    place at = {at_origin, start};
    for (size_t k = 0; k < steps && error == BMR_OK; k++) {
        const place to = next(w, at, k);
        const double time = (double)k / (double)steps, duration = 1.0 / (double)steps;
        error = append_leg(motions[1], time, duration, at.b, to.b);
        if (rigid && error == BMR_OK)
            error = append_leg(motions[0], time, duration, at.a, to.a);
        at = to;
    }
    const bmr_algebraic_piece still_a = still_at(at.a), still_b = still_at(at.b);
    if (error == BMR_OK)
        error = append_piece(motions[1], 1.0, &still_b);
    if (rigid && error == BMR_OK)
        error = append_piece(motions[0], 1.0, &still_a);
    return bmr_path_finish(error, motions);
}

static bmr_pose zigzag_pose(const walker *w, size_t k) {
    const bmr_family_plan *plan = w->plan;
    const double start = atan2(plan->toward.y, plan->toward.x);
    const double angle = start + 2.0 * PI * (double)k / (double)plan->steps;
    const double out = k % 2 ? ZIGZAG_DEPTH * plan->diameter : 0.0;
    bmr_pose pose = plan->turn;
    pose.position = place_at_gap(plan->a, plan->b, &plan->turn, direction_of(angle), w->parameter + out);
    return pose;
}
static place zigzag_step(walker *w, place at, size_t k) {
    at.b = zigzag_pose(w, k + 1);
    return at;
}
bmr_error bmr_path_zigzag(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                          bmr_motion *motions[2]) {
    walker w = {plan, gap, 0.0, 0.0};
    return walk(&w, zigzag_pose(&w, 0), zigzag_step, allocator, motions);
}

static place swing_step(walker *w, place at, size_t k) {
    (void)w;
    at.a = turned(at_origin, k % 2 ? -SWING : SWING);
    return at;
}
bmr_error bmr_path_to_and_fro(const bmr_family_plan *plan, double distance, const bmr_allocator *allocator,
                              bmr_motion *motions[2]) {
    walker w = {plan, distance, 0.0, 0.0};
    bmr_pose b = plan->turn;
    b.position = bmr_sub(bmr_scale(distance, plan->toward), bmr_rotate(&plan->turn, plan->b->center));
    return walk(&w, b, swing_step, allocator, motions);
}

static double limit(double value, double most) {
    return fmin(fmax(value, -most), most);
}

static place brownian_step(walker *w, place at, size_t k) {
    const bmr_walk_draw *draw = &w->plan->draws[k];
    const double root = 1.0 / sqrt((double)w->plan->steps);
    const double step = BROWNIAN_SPREAD * w->plan->diameter * root;
    if (w->plan->family == BMR_FAMILY_RIGID_BROWNIAN)
        at.a = turned(at.a, limit(PI * root * draw->angle, LEG_ANGLE));
    at.b.position = bmr_add(at.b.position, bmr_scale(step, bmr_vec2_make(draw->x, draw->y)));
    return at;
}
bmr_error bmr_path_brownian(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                            bmr_motion *motions[2]) {
    walker w = {plan, gap, 0.0, 0.0};
    bmr_pose start = plan->turn;
    start.position = place_at_gap(plan->a, plan->b, &plan->turn, plan->toward, gap);
    return walk(&w, start, brownian_step, allocator, motions);
}

/// Folds x into [0, width] like a ray between mirrors.
static double reflect(double x, double width) {
    const double r = fabs(remainder(x, 2.0 * width));
    return width > 0.0 ? r : 0.0;
}

static place wander_step(walker *w, place at, size_t k) {
    const bmr_family_plan *plan = w->plan;
    const bmr_walk_draw *draw = &plan->draws[k];
    const double far = fmax(WANDER_FAR * plan->diameter, plan->sigma);
    // The parameter scales all gaps: at sigma they lie between sigma and far.
    const double width = log(far / plan->sigma);
    w->log_gap = reflect(w->log_gap + WANDER_LOG_STEP * draw->x, width);
    const double part = exp(w->log_gap), gap = w->parameter * part;
    const double step = WANDER_ANGLE_STEP * sqrt(fmin(plan->sigma * part / plan->diameter, 1.0));
    w->angle += limit(step * draw->y, LEG_ANGLE);
    if (plan->family == BMR_FAMILY_RIGID_WANDER)
        at.a = turned(at.a, limit(step * draw->angle, LEG_ANGLE));
    // The place is found in A's frame, where B is turned against A.
    const bmr_pose turn = bmr_pose_relative(&at.a, &plan->turn);
    const bmr_vec2 direction = bmr_unrotate(&at.a, direction_of(w->angle));
    at.b.position = bmr_rotate(&at.a, place_at_gap(plan->a, plan->b, &turn, direction, gap));
    return at;
}
bmr_error bmr_path_wander(const bmr_family_plan *plan, double gap, const bmr_allocator *allocator,
                          bmr_motion *motions[2]) {
    const double far = fmax(WANDER_FAR * plan->diameter, plan->sigma);
    walker w = {plan, gap, atan2(plan->toward.y, plan->toward.x), 0.5 * log(far / plan->sigma)};
    bmr_pose start = plan->turn;
    start.position = place_at_gap(plan->a, plan->b, &plan->turn, plan->toward, gap * exp(w.log_gap));
    return walk(&w, start, wander_step, allocator, motions);
}

// ---- once around A, at a fixed distance ----
//
// Once around A at a fixed distance: B's frame follows the offset of the Minkowski sum A + (-B), whose
// boundary is made of both polygons' edges and of arcs about pairs of vertices.

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
    bmr_algebraic_piece p = still_at(o->at);
    p.degree = 1;
    p.x[1] = by.x / duration;
    p.y[1] = by.y / duration;
    o->error = append_piece(o->motion, o->time, &p);
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
    bmr_algebraic_piece p = still_at(o->at);
    p.degree = 3;
    const double t = 1.0 / duration;
    p.x[1] = d0.x * t;
    p.y[1] = d0.y * t;
    p.x[2] = (3.0 * chord.x - 2.0 * d0.x - d1.x) * t * t;
    p.y[2] = (3.0 * chord.y - 2.0 * d0.y - d1.y) * t * t;
    p.x[3] = (d0.x + d1.x - 2.0 * chord.x) * t * t * t;
    p.y[3] = (d0.y + d1.y - 2.0 * chord.y) * t * t * t;
    o->error = append_piece(o->motion, o->time, &p);
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
    const bmr_vec2 corner = place_at_gap(plan->a, plan->b, &plan->turn, u, 0.0);
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
        const bmr_algebraic_piece end = still_at(o.at);
        if (o.error == BMR_OK)
            o.error = append_piece(o.motion, fmax(o.time, 1.0), &end);
        error = bmr_path_finish(o.error, motions);
    }
    bmr_release(allocator, sides, bytes);
    return error;
}
