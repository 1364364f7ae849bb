// SPDX-License-Identifier: MIT
#include "boomerang/motion.h"

#include <math.h>
#include <string.h>

#include "geometry/length.h"
#include "geometry/memory.h"
#include "kinetic/motion.h"

// ---- one piece ----

/// How far a rotation given by the caller may be off unit length.
#define UNIT_TOLERANCE 1e-9

/// Bounds of a rational rotation near a pole (a and b both nearly zero): halvings of the interval before
/// giving up.
#define POLE_DEPTH 10

/// Bounds are computed in floating point; this much more covers the rounding of the few dozen operations.
#define BOUND_SLACK (1.0 + 1e-12)

static bool all_finite(const double *values, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (!isfinite(values[i]))
            return false;
    return true;
}

static bool any_nonzero(const double *values, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (values[i] != 0.0)
            return true;
    return false;
}

static bmr_error check_rotation(double c, double s) {
    if (!isfinite(c) || !isfinite(s))
        return BMR_ERROR_NOT_FINITE;
    return fabs(hypot(c, s) - 1.0) <= UNIT_TOLERANCE ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
}

static bmr_error check_algebraic(const bmr_algebraic_piece *p) {
    if (p->degree > BMR_MOTION_MAX_DEGREE || p->rotation_degree > BMR_MOTION_MAX_DEGREE)
        return BMR_ERROR_OUT_OF_RANGE;
    const size_t terms = p->degree + 1, rotation_terms = p->rotation_degree + 1;
    if (!all_finite(p->x, terms) || !all_finite(p->y, terms) || !all_finite(p->a, rotation_terms) ||
        !all_finite(p->b, rotation_terms))
        return BMR_ERROR_NOT_FINITE;
    if (!any_nonzero(p->a, rotation_terms) && !any_nonzero(p->b, rotation_terms))
        return BMR_ERROR_OUT_OF_RANGE;
    return check_rotation(p->start_c, p->start_s);
}

static bmr_error check_screw(const bmr_screw_motion *s) {
    const double numbers[] = {s->start.position.x, s->start.position.y, s->velocity.x, s->velocity.y,
                              s->spin};
    if (!all_finite(numbers, sizeof numbers / sizeof *numbers))
        return BMR_ERROR_NOT_FINITE;
    return check_rotation(s->start.c, s->start.s);
}

bmr_error bmr_piece_check(const bmr_motion_piece *piece) {
    if (!isfinite(piece->origin))
        return BMR_ERROR_NOT_FINITE;
    switch (piece->kind) {
    case BMR_PIECE_ALGEBRAIC:
        return check_algebraic(&piece->as.algebraic);
    case BMR_PIECE_SCREW:
        return check_screw(&piece->as.screw);
    }
    return BMR_ERROR_OUT_OF_RANGE;
}

/// The value, and where not NULL the derivative.
static double evaluate(const double *c, size_t degree, double u, double *slope) {
    double value = c[degree], rate = 0.0;
    for (size_t k = degree; k-- > 0;) {
        rate = rate * u + value;
        value = value * u + c[k];
    }
    if (slope)
        *slope = rate;
    return value;
}

static bmr_instant algebraic_instant(const bmr_algebraic_piece *p, double u) {
    bmr_instant now;
    now.pose.position.x = evaluate(p->x, p->degree, u, &now.velocity.x);
    now.pose.position.y = evaluate(p->y, p->degree, u, &now.velocity.y);
    double da, db;
    const double a = evaluate(p->a, p->rotation_degree, u, &da);
    const double b = evaluate(p->b, p->rotation_degree, u, &db);
    const double length = bmr_length(bmr_vec2_make(a, b)), ca = a / length, sa = b / length;
    const double c = ca * ca - sa * sa, s = 2.0 * ca * sa;
    now.pose.c = c * p->start_c - s * p->start_s;
    now.pose.s = s * p->start_c + c * p->start_s;
    now.spin = 2.0 * (ca * (db / length) - sa * (da / length));
    return now;
}

static bmr_pose screw_pose(const bmr_screw_motion *motion, double time) {
    const double angle = motion->spin * time;
    const double c = cos(angle), s = sin(angle);
    bmr_pose pose;
    pose.position = bmr_add(motion->start.position, bmr_scale(time, motion->velocity));
    pose.c = c * motion->start.c - s * motion->start.s;
    pose.s = s * motion->start.c + c * motion->start.s;
    return pose;
}

bmr_instant bmr_piece_instant(const bmr_motion_piece *piece, double time) {
    const double u = time - piece->origin;
    if (piece->kind == BMR_PIECE_ALGEBRAIC)
        return algebraic_instant(&piece->as.algebraic, u);
    const bmr_screw_motion *screw = &piece->as.screw;
    const bmr_instant now = {screw_pose(screw, u), screw->velocity, screw->spin};
    return now;
}

bool bmr_piece_is_algebraic(const bmr_motion_piece *piece) {
    return piece->kind == BMR_PIECE_ALGEBRAIC || piece->as.screw.spin == 0.0;
}

/// p(u) becomes p(u + by). O(degree^2).
static void taylor_shift(double *c, size_t degree, double by) {
    for (size_t i = 0; i < degree; i++)
        for (size_t k = degree; k-- > i;)
            c[k] += by * c[k + 1];
}

bmr_algebraic_piece bmr_piece_expand(const bmr_motion_piece *piece, double time) {
    const double by = time - piece->origin;
    if (piece->kind == BMR_PIECE_ALGEBRAIC) {
        bmr_algebraic_piece local = piece->as.algebraic;
        taylor_shift(local.x, local.degree, by);
        taylor_shift(local.y, local.degree, by);
        taylor_shift(local.a, local.rotation_degree, by);
        taylor_shift(local.b, local.rotation_degree, by);
        return local;
    }
    const bmr_screw_motion *screw = &piece->as.screw;
    bmr_algebraic_piece local;
    memset(&local, 0, sizeof local);
    local.degree = 1;
    local.x[0] = screw->start.position.x + by * screw->velocity.x;
    local.y[0] = screw->start.position.y + by * screw->velocity.y;
    local.x[1] = screw->velocity.x;
    local.y[1] = screw->velocity.y;
    local.a[0] = 1.0;
    local.start_c = screw->start.c;
    local.start_s = screw->start.s;
    return local;
}

/// Sums of |z_k| h^k, of its derivative and of its second one, over k >= first, z_k = (x[k], y[k]).
static void magnitudes(const double *x, const double *y, size_t degree, size_t first, double h,
                       double sums[3]) {
    double power[3] = {1.0, 0.0, 0.0}; // h^k and its derivatives
    sums[0] = sums[1] = sums[2] = 0.0;
    for (size_t k = 0; k <= degree; k++) {
        const double z = bmr_length(bmr_vec2_make(x[k], y[k]));
        for (int i = 0; i < 3 && k >= first; i++)
            sums[i] += z * power[i];
        power[2] = power[2] * h + 2.0 * power[1];
        power[1] = power[1] * h + power[0];
        power[0] *= h;
    }
}

static bmr_piece_rates join(bmr_piece_rates a, bmr_piece_rates b) {
    const bmr_piece_rates both = {fmax(a.speed, b.speed), fmax(a.acceleration, b.acceleration),
                                  fmin(a.spin_low, b.spin_low), fmax(a.spin_high, b.spin_high),
                                  fmax(a.spin_change, b.spin_change)};
    return both;
}

/// The rotation is by the angle 2 arg z, z = a + i b; so the spin is 2 Im(z'/z) and its derivative
/// 2 Im(z''/z - (z'/z)^2). Around the middle of the interval, |z| >= |z_0| - sum of the rest.
static bmr_piece_rates algebraic_bounds(const bmr_motion_piece *piece, double from, double to, int depth,
                                        size_t *intervals) {
    ++*intervals;
    const double middle = from + (to - from) / 2.0, h = fmax(middle - from, to - middle);
    const bmr_algebraic_piece p = bmr_piece_expand(piece, middle);
    double path[3], turn[3];
    magnitudes(p.x, p.y, p.degree, 1, h, path);
    magnitudes(p.a, p.b, p.rotation_degree, 1, h, turn);
    const double center = bmr_length(bmr_vec2_make(p.a[0], p.b[0])), least = center - turn[0];
    if (!(least >= 0.5 * center && center > 0.0) && depth > 0)
        return join(algebraic_bounds(piece, from, middle, depth - 1, intervals),
                    algebraic_bounds(piece, middle, to, depth - 1, intervals));
    bmr_piece_rates rates = {path[1] * BOUND_SLACK, path[2] * BOUND_SLACK, -INFINITY, INFINITY, INFINITY};
    if (least > 0.0) {
        const double first = turn[1] / least, second = turn[2] / least;
        rates.spin_change = 2.0 * (second + first * first) * BOUND_SLACK;
        const double spin =
            p.rotation_degree > 0 ? 2.0 * (p.a[0] * p.b[1] - p.b[0] * p.a[1]) / (center * center) : 0.0;
        const double off = rates.spin_change * h + fabs(spin) * (BOUND_SLACK - 1.0);
        const double most = 2.0 * first * BOUND_SLACK;
        rates.spin_low = fmax(spin - off, -most);
        rates.spin_high = fmin(spin + off, most);
    }
    return rates;
}

bmr_piece_rates bmr_piece_bounds(const bmr_motion_piece *piece, double from, double to, size_t *intervals) {
    if (piece->kind == BMR_PIECE_ALGEBRAIC)
        return algebraic_bounds(piece, from, to, POLE_DEPTH, intervals);
    ++*intervals;
    const bmr_screw_motion *screw = &piece->as.screw;
    const bmr_piece_rates rates = {bmr_length(screw->velocity) * BOUND_SLACK, 0.0, screw->spin, screw->spin,
                                   0.0};
    return rates;
}

double bmr_motion_piece_speed(const bmr_motion_piece *piece, double from, double to, double radius) {
    if (piece->kind == BMR_PIECE_ALGEBRAIC && (piece->as.algebraic.degree > BMR_MOTION_MAX_DEGREE ||
                                               piece->as.algebraic.rotation_degree > BMR_MOTION_MAX_DEGREE))
        return INFINITY;
    size_t intervals = 0;
    const bmr_piece_rates rates = bmr_piece_bounds(piece, from, to, &intervals);
    const double spin = bmr_rates_spin(&rates);
    return radius > 0.0 ? rates.speed + spin * radius * BOUND_SLACK : rates.speed;
}

/// Room for pieces is doubled from here.
#define FIRST_CAPACITY 2

bmr_motion_piece bmr_piece_rest(bmr_pose pose) {
    return bmr_piece_screw(0.0, pose, bmr_vec2_make(0.0, 0.0), 0.0);
}

bmr_motion_piece bmr_piece_screw(double origin, bmr_pose pose, bmr_vec2 velocity, double spin) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_SCREW;
    piece.origin = origin;
    piece.as.screw.start = pose;
    piece.as.screw.velocity = velocity;
    piece.as.screw.spin = spin;
    return piece;
}

static bmr_error make_motion(size_t capacity, const bmr_allocator *allocator, bmr_motion **motion) {
    size_t bytes;
    if (!bmr_size_product(capacity, sizeof(bmr_timed_piece), &bytes))
        return BMR_ERROR_TOO_LARGE;
    bmr_motion *made = bmr_allocate(allocator, sizeof *made);
    bmr_timed_piece *pieces = made ? bmr_allocate(allocator, bytes) : NULL;
    if (!pieces) {
        if (made)
            bmr_release(allocator, made, sizeof *made);
        return BMR_ERROR_NO_MEMORY;
    }
    made->allocator = allocator;
    made->count = 0;
    made->capacity = capacity;
    made->pieces = pieces;
    *motion = made;
    return BMR_OK;
}

static void normalize(double *c, double *s) {
    const double length = hypot(*c, *s);
    *c /= length;
    *s /= length;
}

void bmr_timed_piece_set(bmr_timed_piece *timed, double from, const bmr_motion_piece *piece) {
    timed->from = from;
    timed->piece = *piece;
    if (piece->kind == BMR_PIECE_ALGEBRAIC)
        normalize(&timed->piece.as.algebraic.start_c, &timed->piece.as.algebraic.start_s);
    else
        normalize(&timed->piece.as.screw.start.c, &timed->piece.as.screw.start.s);
}

static void append(bmr_motion *motion, double from, const bmr_motion_piece *piece) {
    bmr_timed_piece_set(&motion->pieces[motion->count++], from, piece);
}

bmr_error bmr_motion_create(const bmr_motion_piece *piece, const bmr_allocator *allocator,
                            bmr_motion **motion) {
    if (!piece || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = bmr_piece_check(piece);
    if (error == BMR_OK)
        error = make_motion(FIRST_CAPACITY, allocator, motion);
    if (error == BMR_OK)
        append(*motion, -INFINITY, piece);
    return error;
}

/// The screw from one sample to the next, turning the shorter way round.
static bmr_motion_piece between(double from, const bmr_pose *a, double to, const bmr_pose *b) {
    const double duration = to - from;
    const bmr_vec2 way = bmr_sub(b->position, a->position);
    return bmr_piece_screw(from, *a, bmr_vec2_make(way.x / duration, way.y / duration),
                           bmr_pose_turn(a, b) / duration);
}

static bmr_error check_samples(const double *times, const bmr_pose *poses, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const bmr_motion_piece rest = bmr_piece_rest(poses[i]);
        const bmr_error error = bmr_piece_check(&rest);
        if (!isfinite(times[i]))
            return BMR_ERROR_NOT_FINITE;
        if (error != BMR_OK)
            return error;
        if (i == 0)
            continue;
        if (!(times[i] > times[i - 1]))
            return BMR_ERROR_OUT_OF_RANGE;
        // Samples so close in time that the speed overflows are no motion.
        const bmr_motion_piece piece = between(times[i - 1], &poses[i - 1], times[i], &poses[i]);
        if (bmr_piece_check(&piece) != BMR_OK)
            return BMR_ERROR_OUT_OF_RANGE;
    }
    return BMR_OK;
}

bmr_error bmr_motion_create_sampled(const double *times, const bmr_pose *poses, size_t count,
                                    const bmr_allocator *allocator, bmr_motion **motion) {
    if (!times || !poses || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    if (count == 0)
        return BMR_ERROR_NO_POINTS;
    bmr_error error = check_samples(times, poses, count);
    if (error == BMR_OK)
        error = make_motion(count + 1, allocator, motion);
    if (error != BMR_OK)
        return error;
    bmr_motion_piece piece = bmr_piece_rest(poses[0]);
    append(*motion, -INFINITY, &piece);
    for (size_t i = 0; i + 1 < count; i++) {
        piece = between(times[i], &poses[i], times[i + 1], &poses[i + 1]);
        append(*motion, times[i], &piece);
    }
    piece = bmr_piece_rest(poses[count - 1]);
    append(*motion, times[count - 1], &piece);
    return BMR_OK;
}

void bmr_motion_destroy(bmr_motion *motion) {
    if (!motion)
        return;
    const bmr_allocator *allocator = motion->allocator;
    bmr_release(allocator, motion->pieces, motion->capacity * sizeof *motion->pieces);
    bmr_release(allocator, motion, sizeof *motion);
}

/// Index of the last piece that begins at or before `time`.
static size_t find(const bmr_motion *motion, double time) {
    size_t low = 0, high = motion->count; // pieces[low].from <= time < pieces[high].from
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (motion->pieces[middle].from <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static bmr_error grow(bmr_motion *motion) {
    const size_t size = sizeof *motion->pieces;
    size_t bytes;
    if (!bmr_size_product(motion->capacity, 2 * size, &bytes))
        return BMR_ERROR_TOO_LARGE;
    const size_t capacity = 2 * motion->capacity;
    bmr_timed_piece *pieces = bmr_allocate(motion->allocator, bytes);
    if (!pieces)
        return BMR_ERROR_NO_MEMORY;
    memcpy(pieces, motion->pieces, motion->count * size);
    bmr_release(motion->allocator, motion->pieces, motion->capacity * size);
    motion->pieces = pieces;
    motion->capacity = capacity;
    return BMR_OK;
}

bmr_error bmr_motion_change(bmr_motion *motion, double time, const bmr_motion_piece *piece) {
    if (!motion || !piece)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(time))
        return BMR_ERROR_NOT_FINITE;
    bmr_error error = bmr_piece_check(piece);
    if (error != BMR_OK)
        return error;
    const size_t last = find(motion, time);
    const size_t keep = motion->pieces[last].from == time ? last : last + 1;
    if (keep == motion->capacity)
        error = grow(motion);
    if (error == BMR_OK) {
        motion->count = keep;
        append(motion, time, piece);
    }
    return error;
}

bmr_error bmr_motion_copy_from(const bmr_motion *motion, double time, const bmr_allocator *allocator,
                               bmr_motion **copy) {
    const size_t first = find(motion, time), count = motion->count - first;
    bmr_motion *made;
    const bmr_error error = make_motion(count, allocator, &made);
    if (error != BMR_OK)
        return error;
    memcpy(made->pieces, motion->pieces + first, count * sizeof *made->pieces);
    made->pieces[0].from = -INFINITY;
    made->count = count;
    *copy = made;
    return BMR_OK;
}

const bmr_motion_piece *bmr_motion_piece_at(const bmr_motion *motion, double time, double *end) {
    const size_t i = find(motion, time);
    if (end)
        *end = i + 1 < motion->count ? motion->pieces[i + 1].from : INFINITY;
    return &motion->pieces[i].piece;
}

bmr_pose bmr_motion_pose(const bmr_motion *motion, double time, bmr_vec2 *velocity, double *spin) {
    const bmr_instant now = bmr_piece_instant(bmr_motion_piece_at(motion, time, NULL), time);
    if (velocity)
        *velocity = now.velocity;
    if (spin)
        *spin = now.spin;
    return now.pose;
}
