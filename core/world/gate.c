// SPDX-License-Identifier: MIT
// When two disks meet and part: a function of the two motions alone.
//
// A couple's time begins at its epoch, when the later of the two pieces that hold now was set. From there on
// its disks meet when their centres come within the *reach*, part when they are farther than bmr_gate_parted
// of that, meet again, and so on: one list of times. Whoever asks for the next one gets the next one of that
// list, whenever he asks. Where both paths are straight lines the list has one entry of each kind, in closed
// form. Else each is searched for: curve.c.
//
// The reach is larger than the sum of the radii and the margin by a margin, by a 64th, and by the rounding of
// places at the epoch; so rounding of any of this never makes the disks meet too late. (Where a rounding of
// the time is longer than a margin's way, the couple is stopped as soon as they meet: search.c, clock_end.)
#include <float.h>
#include <math.h>

#include "geometry/length.h"
#include "kinetic/motion.h"
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
    bmr_vec2 start;
    if (piece->kind == BMR_PIECE_SCREW) {
        start = piece->as.screw.start.position;
        *velocity = piece->as.screw.velocity;
    } else {
        const bmr_algebraic_piece *p = &piece->as.algebraic;
        start = bmr_vec2_make(p->x[0], p->y[0]);
        *velocity = p->degree > 0 ? bmr_vec2_make(p->x[1], p->y[1]) : bmr_vec2_make(0.0, 0.0);
    }
    return bmr_add(start, bmr_scale(time - piece->origin, *velocity));
}

bmr_vec2 bmr_path_position(const bmr_motion_piece *piece, double time) {
    bmr_vec2 velocity;
    return is_straight(piece) ? straight(piece, time, &velocity)
                              : bmr_piece_instant(piece, time).pose.position;
}

// ---- the two of a couple ----

/// From the first's centre to the second's image.
static bmr_vec2 way_at(const bmr_world *w, const bmr_couple *c, double time) {
    const bmr_vec2 a = bmr_path_position(&c->side[0]->now.piece, time);
    const bmr_vec2 b = bmr_path_position(&c->side[1]->now.piece, time);
    return bmr_sub(bmr_add(b, bmr_couple_shift(w, c)), a);
}

double bmr_gate_distance(const bmr_world *w, const bmr_couple *c, double time) {
    if (bmr_resident_is_wall(c->side[1])) {
        const bmr_line line = bmr_wall_line(w, c->side[1]);
        return bmr_dot(line.normal, bmr_path_position(&c->side[0]->now.piece, time)) - line.offset;
    }
    return bmr_length(way_at(w, c, time));
}

double bmr_gate_reach(const bmr_world *w, const bmr_couple *c) {
    const double epoch = bmr_couple_epoch(c);
    const bool wall = bmr_resident_is_wall(c->side[1]);
    const bmr_vec2 a = bmr_path_position(&c->side[0]->now.piece, epoch);
    const bmr_vec2 b = wall ? w->def.high : bmr_path_position(&c->side[1]->now.piece, epoch);
    const bmr_vec2 shift = bmr_couple_shift(w, c);
    const double places = fabs(a.x) + fabs(a.y) + fabs(b.x) + fabs(b.y) + fabs(shift.x) + fabs(shift.y);
    const double sum = c->side[0]->radius + (wall ? 0.0 : c->side[1]->radius) + 2.0 * w->def.kds.margin;
    return REACH_PART * sum + BMR_PLACE_ROUNDING * places;
}

double bmr_gate_parted(const bmr_world *w, double reach) {
    return fmax(PARTED * reach, reach + w->def.kds.hysteresis);
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

static bool both_straight(const bmr_couple *c) {
    return is_straight(&c->side[0]->now.piece) && is_straight(&c->side[1]->now.piece);
}

static interval straight_within(const bmr_world *w, const bmr_couple *c, double epoch, double reach) {
    bmr_vec2 velocity_a, velocity_b;
    const bmr_vec2 a = straight(&c->side[0]->now.piece, epoch, &velocity_a);
    if (bmr_resident_is_wall(c->side[1])) {
        const bmr_line line = bmr_wall_line(w, c->side[1]);
        return below(bmr_dot(line.normal, a) - line.offset, bmr_dot(line.normal, velocity_a), reach);
    }
    const bmr_vec2 b = straight(&c->side[1]->now.piece, epoch, &velocity_b);
    const bmr_vec2 way = bmr_sub(bmr_add(b, bmr_couple_shift(w, c)), a);
    return within(way, bmr_sub(velocity_b, velocity_a), reach);
}

// ---- both ----

static bmr_error next_change(const bmr_world *w, const bmr_couple *c, bool meets, double after, double *time,
                             bool *look) {
    const double reach = bmr_gate_reach(w, c), epoch = bmr_couple_epoch(c);
    if (!isfinite(reach))
        return BMR_ERROR_NOT_FINITE;
    if (!both_straight(c))
        return bmr_curve_next(w, c, reach, meets, after, time, look);
    const interval inside = straight_within(w, c, epoch, meets ? reach : bmr_gate_parted(w, reach));
    if (isnan(inside.from))
        return BMR_ERROR_NOT_FINITE;
    *look = false;
    const bool ever = inside.from <= inside.to;
    // What is over by no more than the clock's rounding is not over.
    const double now = after - BMR_CLOCK_ROUNDINGS * DBL_EPSILON * (fabs(after) + fabs(epoch));
    if (meets)
        *time = ever && epoch + inside.to > now ? fmax(after, epoch + inside.from) : INFINITY;
    else
        *time = ever ? fmax(after, epoch + inside.to) : after;
    return BMR_OK;
}

bmr_error bmr_gate_meets(const bmr_world *w, const bmr_couple *c, double after, double *time, bool *look) {
    return next_change(w, c, true, after, time, look);
}

bmr_error bmr_gate_parts(const bmr_world *w, const bmr_couple *c, double after, double *time, bool *look) {
    return next_change(w, c, false, after, time, look);
}

// ---- cells ----

/// When x + v (t - origin) leaves [low, high], not before `after`.
static double leaves(double x, double velocity, double origin, double low, double high, double after) {
    if (velocity == 0.0)
        return INFINITY;
    return fmax(after, origin + ((velocity > 0.0 ? high : low) - x) / velocity);
}

bmr_error bmr_gate_crosses(const bmr_world *w, const bmr_resident *r, double after, double *time,
                           bool *look) {
    const int level = r->cell->level;
    const double width = bmr_cell_width(w, level), height = bmr_cell_height(w, level);
    const bmr_vec2 base = w->def.boundary == BMR_PERIODIC ? w->def.low : bmr_vec2_make(0.0, 0.0);
    const bmr_vec2 low = bmr_vec2_make(base.x + ((double)r->column - BMR_CELL_HYSTERESIS) * width,
                                       base.y + ((double)r->row - BMR_CELL_HYSTERESIS) * height);
    const bmr_vec2 high = bmr_vec2_make(base.x + ((double)r->column + 1.0 + BMR_CELL_HYSTERESIS) * width,
                                        base.y + ((double)r->row + 1.0 + BMR_CELL_HYSTERESIS) * height);
    const bmr_motion_piece *piece = &r->now.piece;
    *look = false;
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
    return bmr_curve_leaves(w, piece, low, high, fmin(width, height), after, time, look);
}
