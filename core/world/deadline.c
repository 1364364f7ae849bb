// SPDX-License-Identifier: MIT
// When two disks meet and part: a function of the two motions alone.
//
// A pair's time begins at its epoch, when the later of the two pieces that hold now was set. From there on
// its disks meet when their centres come within the *reach*, part when they are farther than `parted`
// of that, meet again, and so on: one list of times. Whoever asks for the next one gets the next one of that
// list, whenever he asks. Where both paths are straight lines the list has one entry of each kind, in closed
// form. Else each is searched for, window by window.
//
// The reach is larger than the sum of the radii and the margin by a margin, by a 64th, and by the rounding of
// places at the epoch; so rounding of any of this never makes the disks meet too late. (Where a rounding of
// the time is longer than a margin's way, the pair is stopped as soon as they meet: pair.c, clock_end.)
#include <float.h>
#include <math.h>

#include "geometry/length.h"
#include "kinetic/failure.h"
#include "world/parts.h"

/// What the reach has more than it needs.
#define REACH_PART (1.0 + 0x1p-6)
/// Disks part at so many reaches, or a hysteresis farther, so that a pair lives until it is apart by that: at
/// density 0.3 a structure lives about as long as its bodies pass each other.
#define PARTED 1.25

typedef struct interval {
    double from, to; ///< from > to: empty
} interval;

// ---- paths ----

static bool is_straight(const bmr_motion_piece *piece) {
    return piece->kind == BMR_PIECE_SCREW || piece->as.algebraic.degree <= 1;
}

/// Of the frame's origin, whatever the body's rotation does: for a straight path its velocity too.
static bmr_vec2 straight(const bmr_motion_piece *piece, double time, bmr_vec2 *velocity) {
    const bmr_algebraic_piece *p = &piece->as.algebraic;
    if (piece->kind == BMR_PIECE_SCREW)
        *velocity = piece->as.screw.velocity;
    else
        *velocity = p->degree > 0 ? bmr_vec2_make(p->x[1], p->y[1]) : bmr_vec2_make(0.0, 0.0);
    return bmr_add(bmr_path_begins(piece), bmr_scale(time - piece->origin, *velocity));
}

bmr_vec2 bmr_path_position(const bmr_motion_piece *piece, double time) {
    bmr_vec2 velocity;
    return is_straight(piece) ? straight(piece, time, &velocity)
                              : bmr_piece_instant(piece, time).pose.position;
}

// ---- the two of a pair ----

/// When the later of the two began to move as it does now.
static double epoch_of(const bmr_body_pair *c) {
    return c->side[0]->since > c->side[1]->since ? c->side[0]->since : c->side[1]->since;
}

/// From the first's centre to the second's image.
static bmr_vec2 way_at(const bmr_world *w, const bmr_body_pair *c, double time) {
    const bmr_vec2 a = bmr_path_position(&c->side[0]->now.piece, time);
    const bmr_vec2 b = bmr_path_position(&c->side[1]->now.piece, time);
    return bmr_sub(bmr_add(b, bmr_body_pair_shift(w, c)), a);
}

double bmr_disks_distance(const bmr_world *w, const bmr_body_pair *c, double time) {
    if (bmr_body_is_wall(c->side[1])) {
        const bmr_line line = bmr_wall_line(w, c->side[1]);
        return bmr_dot(line.normal, bmr_path_position(&c->side[0]->now.piece, time)) - line.offset;
    }
    return bmr_length(way_at(w, c, time));
}

double bmr_disks_reach(const bmr_world *w, const bmr_body_pair *c) {
    const double epoch = epoch_of(c);
    const bool wall = bmr_body_is_wall(c->side[1]);
    const bmr_vec2 a = bmr_path_position(&c->side[0]->now.piece, epoch);
    const bmr_vec2 b = wall ? w->def.high : bmr_path_position(&c->side[1]->now.piece, epoch);
    const bmr_vec2 shift = bmr_body_pair_shift(w, c);
    const double places = fabs(a.x) + fabs(a.y) + fabs(b.x) + fabs(b.y) + fabs(shift.x) + fabs(shift.y);
    const double sum = c->side[0]->radius + c->side[1]->radius + 2.0 * w->def.kds.margin;
    return REACH_PART * sum + BMR_PLACE_ROUNDING * places;
}

/// Disks this far have parted.
static double parted(const bmr_world *w, double reach) {
    return fmax(PARTED * reach, reach + w->def.kds.hysteresis);
}

// ---- curved paths ----
//
// Time is cut into windows, counted from the epoch, and each is searched from its beginning: what is found
// does not depend on when it is asked for.

/// A window is so many times as long as the path needs for one reach, by the first of its powers to get
/// there.
#define WINDOW 16.0
/// Windows that one question searches.
#define WINDOWS 8
/// The shortest window, in parts of the epoch: below, its ends could not be told apart.
#define LEAST_WINDOW 0x1p-40
/// Windows that are left out at once, at most; and how far from the reach they must stay.
#define MOST_CLEAR 0x1p40
#define CLEAR_PART 1.125
/// A place is known when it is to this part of the reach: an eighth of what lies between to meet and to part.
#define EXACT_PART 0x1p-5
/// Sign changes in one window; two paths of degree 8 have 16 at most.
#define MOST_CHANGES 64

/// The same path without a rotation: the origin's alone.
static bmr_motion_piece path_of(const bmr_motion_piece *piece, bmr_vec2 shift) {
    bmr_motion_piece path = *piece;
    bmr_path_begin_at(&path, bmr_add(bmr_path_begins(piece), shift));
    if (path.kind == BMR_PIECE_SCREW) {
        path.as.screw.spin = 0.0;
    } else {
        path.as.algebraic.rotation_degree = 0;
        path.as.algebraic.a[0] = 1.0;
        path.as.algebraic.b[0] = 0.0;
    }
    return path;
}

/// The shortest time in which one term of a path, in powers of that time, grows to `length`.
static double time_for(const bmr_algebraic_piece *path, double length) {
    double least = INFINITY;
    for (size_t k = 1; k <= path->degree; k++) {
        const double size = bmr_length(bmr_vec2_make(path->x[k], path->y[k]));
        if (size > 0.0)
            least = fmin(least, pow(length / size, 1.0 / (double)k));
    }
    return least;
}

/// The way from the second disk's centre (or a wall's line) to the first's, in powers of the time from the
/// epoch: far from the world's origin its digits are those of the way, not of the places.
typedef struct curve {
    bmr_motion_piece rest, way; ///< the latter's time is 0 at the epoch
    double epoch, window, tolerance;
    double parted;                          ///< at this distance the disks have
    double size[BMR_MOTION_MAX_DEGREE + 1]; ///< of each power: of what it is the difference of
} curve;

/// A time that is early by this is early by next to nothing of a window, and of a cell, however fast they
/// are.
static double tolerance_of(const bmr_world *w, double time, double window) {
    return fmin(bmr_world_tolerance(w, time), 0x1p-40 * window);
}

static void add_sizes(const bmr_algebraic_piece *path, double *sizes) {
    for (size_t i = 1; i <= path->degree; i++)
        sizes[i] += bmr_length(bmr_vec2_make(path->x[i], path->y[i]));
}

/// Is the place so long after the epoch known to a part of the reach? Its terms are as long as the ways of
/// the two since then, and during a rounding of the clock it changes by their speeds. Where it is not, a
/// meeting could be taken for none.
static bool is_exact(const curve *k, double reach, double from, double to) {
    const double clock = BMR_CLOCK_ROUNDINGS * DBL_EPSILON * (fabs(k->epoch) + fabs(from) + fabs(to));
    const double elapsed = to - k->epoch;
    double way = 0.0, speed = 0.0, power = 1.0;
    for (size_t i = 1; i <= BMR_MOTION_MAX_DEGREE; i++) {
        speed += (double)i * k->size[i] * power;
        power *= elapsed;
        way += k->size[i] * power;
    }
    return BMR_PLACE_ROUNDING * way + clock * speed < EXACT_PART * reach;
}

static curve make_curve(const bmr_world *w, const bmr_body_pair *c, double reach) {
    curve k = {.epoch = epoch_of(c), .parted = parted(w, reach)};
    k.rest = bmr_piece_rest(bmr_pose_identity());
    k.way.kind = BMR_PIECE_ALGEBRAIC;
    const bmr_motion_piece paths[2] = {path_of(&c->side[0]->now.piece, bmr_vec2_make(0.0, 0.0)),
                                       path_of(&c->side[1]->now.piece, bmr_body_pair_shift(w, c))};
    const bmr_algebraic_piece a = bmr_piece_expand(&paths[0], k.epoch);
    const bmr_algebraic_piece b = bmr_piece_expand(&paths[1], k.epoch);
    bmr_algebraic_piece *const way = &k.way.as.algebraic;
    way->degree = a.degree > b.degree ? a.degree : b.degree;
    way->a[0] = way->start_c = 1.0;
    for (size_t i = 0; i <= way->degree; i++) {
        way->x[i] = (i <= a.degree ? a.x[i] : 0.0) - (i <= b.degree ? b.x[i] : 0.0);
        way->y[i] = (i <= a.degree ? a.y[i] : 0.0) - (i <= b.degree ? b.y[i] : 0.0);
    }
    add_sizes(&a, k.size);
    add_sizes(&b, k.size);
    const double least = LEAST_WINDOW * fmax(1.0, fabs(k.epoch));
    k.window = fmax(WINDOW * time_for(way, reach), least);
    // Two that go nearly the same way have long windows: not so long that their places drown in rounding.
    while (k.window < INFINITY && k.window > least && !is_exact(&k, reach, k.epoch, k.epoch + k.window))
        k.window *= 0.5;
    k.tolerance = tolerance_of(w, k.epoch, k.window);
    return k;
}

/// Apart by more than `reach`, as a condition of the curve.
static bmr_condition apart_by(const bmr_world *w, const bmr_body_pair *c, double reach) {
    const bmr_vec2 origin = bmr_vec2_make(0.0, 0.0);
    return bmr_body_is_wall(c->side[1])
               ? bmr_condition_beyond(0, bmr_wall_line(w, c->side[1]).normal, reach, origin, 0)
               : bmr_condition_disks(origin, origin, reach, 0);
}

/// The condition from `here` on, over `longest` or less: over so little that rounding is a part of the reach,
/// for what comes from afar and is soon gone again could drown in the rounding of how far it came. True: over
/// this time it is too far away anyway.
static bool expand(const curve *k, const bmr_condition *condition, bool against, const bmr_motion_piece *here,
                   double longest, bmr_condition_polynomial *p) {
    const bmr_algebraic_piece *const way = &here->as.algebraic;
    const double reach = condition->offset, distance = bmr_length(bmr_vec2_make(way->x[0], way->y[0]));
    for (double most = longest;; most = 0.5 * p->width) {
        bmr_condition_expand(condition, &k->rest, here, 0.0, most, p);
        if (condition->kind != BMR_CONDITION_DISKS || !(p->noise > EXACT_PART * reach * reach) ||
            !(p->width > 0.0))
            return false;
        double growth = 0.0, power = 1.0;
        for (size_t i = 1; i <= way->degree; i++) {
            power *= p->width;
            growth += bmr_length(bmr_vec2_make(way->x[i], way->y[i])) * power;
        }
        if (!against && distance - growth > CLEAR_PART * reach)
            return true;
    }
}

/// The first time in [from, to] at which the condition is no longer positive (with `against`: its opposite);
/// INFINITY: none. What is too close to call at the beginning is taken to be near: a structure that stands in
/// vain is no harm.
///
/// Each step expands the way about its own beginning, and takes that for the origin of time: what is too
/// close to call is then a rounding of the distance there, not of the world's time nor of the way since the
/// epoch.
static bmr_error first_change(const curve *k, const bmr_condition *condition, bool against, double from,
                              double to, double *time) {
    *time = INFINITY;
    for (size_t steps = 0; from < to; steps++) {
        bmr_motion_piece here = k->way;
        here.as.algebraic = bmr_piece_expand(&k->way, from - k->epoch);
        here.origin = 0.0;
        bmr_condition_polynomial p = {.width = to - from};
        const bool clear = expand(k, condition, against, &here, to - from, &p);
        if (!isfinite(p.noise))
            return BMR_ERROR_NOT_FINITE;
        if (steps == BMR_FAILURE_MAX_INTERVALS)
            return BMR_ERROR_OUT_OF_RANGE;
        for (size_t i = 0; against && i <= p.degree; i++)
            p.c[i] = -p.c[i];
        const bool positive = p.c[0] > p.noise;
        if (!clear && !positive && (!against || p.c[0] < -p.noise)) {
            *time = from;
            return BMR_OK;
        }
        double u;
        if (positive && !clear &&
            bmr_bernstein_first_root(p.c, p.degree, p.noise, k->tolerance / p.width, &u) && u <= 1.0) {
            *time = fmin(to, from + u * p.width);
            return BMR_OK;
        }
        const double next = p.width < to - from ? from + p.width : to;
        from = next > from ? next : nextafter(from, INFINITY);
    }
    return BMR_OK;
}

/// The first meeting (or parting) after `after` in the window [from, to], which begins at `from` with the
/// disks as `inside` says; INFINITY: none.
static bmr_error in_window(const bmr_world *w, const bmr_body_pair *c, const curve *k, double reach,
                           bool meets, bool inside, double from, double to, double after, double *time) {
    const bmr_condition near = apart_by(w, c, reach), far = apart_by(w, c, k->parted);
    for (int changes = 0; changes < MOST_CHANGES; changes++, inside = !inside) {
        double change;
        const bmr_error error = first_change(k, inside ? &far : &near, inside, from, to, &change);
        if (error != BMR_OK)
            return error;
        *time = change;
        if (change == INFINITY || (inside != meets && change > after))
            return BMR_OK;
        from = change;
    }
    *time = INFINITY;
    return BMR_OK;
}

/// In so much time from `from` on the centres cannot come from `distance` to the reach (or, `inside`, to
/// where they have parted).
static bool is_clear(const curve *k, double distance, bool inside, double reach, double from, double time) {
    const double since = from - k->epoch;
    const double way = bmr_motion_piece_speed(&k->way, since, since + time, 0.0) * time;
    return inside ? CLEAR_PART * (distance + way) < k->parted : distance - way > CLEAR_PART * reach;
}

/// So many windows from `from` on, as a power of 2 or 0, have no change: to search them would find the
/// same.
static double clear_windows(const curve *k, double distance, bool inside, double reach, double from) {
    double clear = 0.0, count = 1.0;
    for (; count <= MOST_CLEAR && is_clear(k, distance, inside, reach, from, count * k->window); count *= 2.0)
        clear = count;
    return clear;
}

/// The next meeting (or parting) of the two whose reach this is.
static bmr_error curve_next(const bmr_world *w, const bmr_body_pair *c, double reach, bool meets,
                            double after, double *time, bool *unfinished) {
    const curve k = make_curve(w, c, reach);
    *unfinished = false;
    *time = INFINITY;
    if (!(k.window < INFINITY)) { // both rest, or go together
        const double distance = bmr_disks_distance(w, c, k.epoch);
        if (meets ? distance <= reach : distance >= k.parted)
            *time = after;
        return isfinite(distance) ? BMR_OK : BMR_ERROR_NOT_FINITE;
    }
    double window = fmax(0.0, floor((after - k.epoch) / k.window));
    if (k.epoch + window * k.window > after && window > 0.0)
        window--;
    for (int i = 0; i < WINDOWS; i++, window++) {
        const double from = k.epoch + window * k.window, to = k.epoch + (window + 1.0) * k.window;
        const double distance = bmr_disks_distance(w, c, from);
        if (!isfinite(distance) || !(to > from))
            return BMR_ERROR_NOT_FINITE;
        if (!is_clear(&k, distance, false, reach, from, to - from) && !is_exact(&k, reach, from, to)) {
            if (from <= after)
                return BMR_ERROR_OUT_OF_RANGE;
            break; // who knows whether the world comes there
        }
        // Whoever asks for a meeting knows the disks to be apart until `after`, and the other way round.
        const bool inside = meets ? distance <= reach : distance < k.parted;
        if (inside == meets && from >= after) {
            *time = from;
            return BMR_OK;
        }
        // What changes at the very beginning of a window is new, unless that is past.
        const double past = from < after ? after : -INFINITY;
        const bmr_error error = in_window(w, c, &k, reach, meets, inside, from, to, past, time);
        if (error != BMR_OK || *time < INFINITY)
            return error;
        if (inside != meets)
            window += clear_windows(&k, bmr_disks_distance(w, c, to), inside, reach, to);
    }
    *unfinished = true;
    *time = k.epoch + window * k.window;
    return BMR_OK;
}

/// When the path leaves the rectangle, of a cell whose shorter side is `size`.
static bmr_error curve_leaves(const bmr_world *w, const bmr_motion_piece *piece, bmr_vec2 low, bmr_vec2 high,
                              double size, double after, double *time, bool *unfinished) {
    const bmr_motion_piece path = path_of(piece, bmr_vec2_make(0.0, 0.0));
    const bmr_algebraic_piece here = bmr_piece_expand(&path, after);
    const double span = WINDOW * time_for(&here, size);
    *time = INFINITY;
    *unfinished = false;
    if (!(span < INFINITY))
        return BMR_OK;
    const bmr_vec2 origin = bmr_vec2_make(0.0, 0.0);
    const bmr_condition sides[] = {bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), low.x, origin, 0),
                                   bmr_condition_beyond(0, bmr_vec2_make(-1.0, 0.0), -high.x, origin, 0),
                                   bmr_condition_beyond(0, bmr_vec2_make(0.0, 1.0), low.y, origin, 0),
                                   bmr_condition_beyond(0, bmr_vec2_make(0.0, -1.0), -high.y, origin, 0)};
    const curve k = {.rest = bmr_piece_rest(bmr_pose_identity()),
                     .way = {.kind = BMR_PIECE_ALGEBRAIC, .as.algebraic = here},
                     .epoch = after,
                     .window = span,
                     .tolerance = tolerance_of(w, after, span)};
    const double to = fmax(after + span, nextafter(after, INFINITY));
    if (!isfinite(to))
        return BMR_ERROR_NOT_FINITE;
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        double leaves_side;
        const bmr_error error = first_change(&k, &sides[i], false, after, fmin(to, *time), &leaves_side);
        if (error != BMR_OK)
            return error;
        *time = fmin(*time, leaves_side);
    }
    if (*time == INFINITY) {
        *time = to;
        *unfinished = true;
    }
    return BMR_OK;
}

// ---- straight paths ----

/// Time from the epoch, in which the way from `way` on is within the reach of the origin.
static interval within(bmr_vec2 way, bmr_vec2 velocity, double reach) {
    const double square = bmr_dot(velocity, velocity), speed = sqrt(square);
    const interval none = {INFINITY, -INFINITY}, always = {-INFINITY, INFINITY}, unknown = {NAN, NAN};
    if (!isfinite(square) || !isfinite(bmr_dot(way, way)))
        return unknown;
    if (!(square > 0.0))
        return bmr_dot(way, way) <= reach * reach ? always : none;
    // How far they pass each other: its rounding is that of the way, however long that is.
    const double miss = fabs(bmr_cross(way, velocity)) / speed;
    if (!(miss < reach))
        return none;
    const double nearest = -bmr_dot(way, velocity) / square;
    const double half = sqrt((reach - miss) * (reach + miss)) / speed;
    const interval inside = {nearest - half, nearest + half};
    return inside;
}

/// The same of a height above a wall.
static interval below(double height, double rate, double reach) {
    interval inside = {-INFINITY, INFINITY};
    if (rate < 0.0)
        inside.from = (height - reach) / -rate;
    else if (rate > 0.0)
        inside.to = (reach - height) / rate;
    else if (height > reach)
        inside.from = INFINITY, inside.to = -INFINITY;
    return inside;
}

static interval straight_within(const bmr_world *w, const bmr_body_pair *c, double epoch, double reach) {
    bmr_vec2 velocity_a, velocity_b;
    const bmr_vec2 a = straight(&c->side[0]->now.piece, epoch, &velocity_a);
    if (bmr_body_is_wall(c->side[1])) {
        const bmr_line line = bmr_wall_line(w, c->side[1]);
        return below(bmr_dot(line.normal, a) - line.offset, bmr_dot(line.normal, velocity_a), reach);
    }
    const bmr_vec2 b = straight(&c->side[1]->now.piece, epoch, &velocity_b);
    const bmr_vec2 way = bmr_sub(bmr_add(b, bmr_body_pair_shift(w, c)), a);
    return within(way, bmr_sub(velocity_b, velocity_a), reach);
}

// ---- both ----

bmr_error bmr_disks_next(const bmr_world *w, const bmr_body_pair *c, bool meets, double after, double *time,
                         bool *unfinished) {
    const double reach = bmr_disks_reach(w, c), epoch = epoch_of(c);
    if (!isfinite(reach))
        return BMR_ERROR_NOT_FINITE;
    if (!is_straight(&c->side[0]->now.piece) || !is_straight(&c->side[1]->now.piece))
        return curve_next(w, c, reach, meets, after, time, unfinished);
    const interval inside = straight_within(w, c, epoch, meets ? reach : parted(w, reach));
    if (isnan(inside.from))
        return BMR_ERROR_NOT_FINITE;
    *unfinished = false;
    const bool ever = inside.from <= inside.to;
    // What is over by no more than the clock's rounding is not over.
    const double now = after - BMR_CLOCK_ROUNDINGS * DBL_EPSILON * (fabs(after) + fabs(epoch));
    if (meets)
        *time = ever && epoch + inside.to > now ? fmax(after, epoch + inside.from) : INFINITY;
    else
        *time = ever ? fmax(after, epoch + inside.to) : after;
    return BMR_OK;
}

// ---- cells ----

/// When x + v (t - origin) leaves [low, high], not before `after`.
static double leaves(double x, double velocity, double origin, double low, double high, double after) {
    if (velocity == 0.0)
        return INFINITY;
    return fmax(after, origin + ((velocity > 0.0 ? high : low) - x) / velocity);
}

bmr_error bmr_body_leaves_cell(const bmr_world *w, const bmr_world_body *r, double after, double *time,
                               bool *unfinished) {
    bmr_vec2 low, high;
    bmr_cell_box(w, r->cell->level, r->column, r->row, BMR_CELL_HYSTERESIS, &low, &high);
    const bmr_motion_piece *piece = &r->now.piece;
    *unfinished = false;
    // Motions that go on from each other up to rounding may add that up.
    const bmr_vec2 now = bmr_path_position(piece, after);
    if (now.x < low.x || now.x > high.x || now.y < low.y || now.y > high.y) {
        *time = after;
        return BMR_OK;
    }
    if (is_straight(piece)) {
        bmr_vec2 velocity;
        const bmr_vec2 at = straight(piece, piece->origin, &velocity);
        *time = fmin(leaves(at.x, velocity.x, piece->origin, low.x, high.x, after),
                     leaves(at.y, velocity.y, piece->origin, low.y, high.y, after));
        return isnan(*time) ? BMR_ERROR_NOT_FINITE : BMR_OK;
    }
    const bmr_vec2 size = bmr_cell_size(w, r->cell->level);
    return curve_leaves(w, piece, low, high, fmin(size.x, size.y), after, time, unfinished);
}
