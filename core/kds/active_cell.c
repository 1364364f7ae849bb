// SPDX-License-Identifier: MIT
// The active cell of the mixed hierarchy (sections 4 and 5): the conditions are that the configuration point
// stays in its cell and that the cell stays one.
//
//   active-cell-*  the cell is a tuple of edges, and its neighbours follow from the two hierarchies: O(1)
//                  bytes for a pair, any motion.
//   tiling-*       the whole tiling is made at the start, with the neighbours of every cell: for pairs that
//                  only translate.
//
// Three things are not in the paper.
//
// Outside of M_0 the structure holds the edge of M_0 that is farthest off; such events have level -1.
//
// Bodies that are aligned need a displacement, and the margin needs lines moved outwards: see held_cell.h.
//
// Lines moved outwards make mitred corners. A pair nearer than sqrt(2) times the margin may be within them,
// and in no cell; there the structure holds the closest direction as free-fd2 does, and its level is one
// below the hierarchies' deepest.
#include <float.h>
#include <math.h>

#include "hierarchy/mixed.h"
#include "kds/failing.h"
#include "kds/held_cell.h"
#include "kds/registry.h"
#include "kds/windowed_line.h"

/// A repair does not look at the pose of the event, where the failed condition is zero up to rounding, but at
/// one a little later: the bodies have moved on by this part of the extents. That is far above rounding
/// (1e-15), and far below what the offset of the lines allows (BMR_HELD_SLACK). Where the failure was found
/// early, it looks on to the failure itself, but never farther than BMR_HELD_SLACK.
#define AHEAD 1e-12
/// If the pair turns at all, it has turned by this angle (radians) at least.
#define AHEAD_ANGLE 1e-14
/// A condition's value nearer to zero than this has no sign that means anything: it is eight roundings, of
/// the extents for a length, of 1 for the sine of an angle. (A search for failures takes even larger values
/// for zero, and then goes by the rates.)
#define NO_SIGN (4.0 * DBL_EPSILON)

/// Where there is no cell, the part of the gap that a window may cost: free-fd2's.
#define CLOSE_PART 0.3

typedef struct cell_class {
    bmr_kds_class class; ///< first: an info's implementation is a pointer to it
    bool tiled;
} cell_class;

typedef struct cell_state {
    bmr_held_cell held;       ///< unless `close`
    bool close;               ///< within the mitres: the line is the proof
    bmr_windowed_line line;   ///< if close
    uint32_t tile;            ///< tiled: of the cell
    bmr_mixed_tiling *tiling; ///< behind this state; NULL: none yet
    unsigned char block[];    ///< the tiling's
} cell_state;

static const cell_class *class_of(const bmr_kds *kds) {
    return kds->info->implementation;
}
static cell_state *state_of(bmr_kds *kds) {
    return (cell_state *)(void *)kds->state;
}
static const cell_state *constant_state_of(const bmr_kds *kds) {
    return (const cell_state *)(const void *)kds->state;
}

static bmr_error prepare(bmr_kds *kds) {
    state_of(kds)->held = bmr_held_make(kds);
    return BMR_OK;
}

static size_t conditions(const bmr_kds *kds, bmr_condition *out) {
    const cell_state *s = constant_state_of(kds);
    return s->close ? bmr_windowed_conditions(&s->line, kds->def.margin, out)
                    : bmr_held_conditions(&s->held, kds->info->domain != BMR_KDS_TRANSLATION, out);
}

static void proof(const bmr_kds *kds, bmr_kds_proof *out) {
    const cell_state *s = constant_state_of(kds);
    if (s->close)
        bmr_windowed_proof(&s->line, out);
    else
        bmr_held_proof(&s->held, out);
}

static int level_of(const cell_state *s) {
    return s->close ? s->line.level : bmr_held_level(&s->held);
}

static bool same_line(const cell_state *a, const cell_state *b) {
    int of_a, of_b;
    if (a->close || b->close)
        return a->close && b->close && bmr_windowed_same_line(&a->line, &b->line);
    return bmr_held_edge(&a->held, &of_a) == bmr_held_edge(&b->held, &of_b) && of_a == of_b;
}

// --- a little ahead ---

/// Where the rates are unknown, supposes that the pair moves straight on through the condition that failed.
static void suppose_rates(bmr_instant *now, const bmr_condition *failed) {
    const bool of_a = failed->owner == 0;
    if (failed->kind == BMR_CONDITION_TURN)
        now->spin = of_a ? -1.0 : 1.0;
    else
        now->velocity = of_a ? bmr_neg(failed->normal) : bmr_rotate(&now->pose, failed->normal);
}

/// B's pose a little after `now`. If the failed condition is still positive and falls, that is after it has
/// come to zero, where this is near enough.
static bmr_pose look_ahead(const cell_state *s, const bmr_instant *now, const bmr_condition *failed) {
    bmr_instant then = *now;
    double speed = hypot(now->velocity.x, now->velocity.y) + fabs(now->spin) * s->held.scale;
    if (failed && !(speed > 0.0)) {
        suppose_rates(&then, failed);
        speed = hypot(then.velocity.x, then.velocity.y) + fabs(then.spin) * s->held.scale;
    }
    double time = speed > 0.0 ? AHEAD * s->held.scale / speed : 0.0;
    if (failed && speed > 0.0) {
        const double value = bmr_condition_value(failed, &now->pose),
                     rate = bmr_condition_rate(failed, &then);
        if (value > 0.0 && rate < 0.0)
            time = fmin(fmax(time, 2.0 * value / -rate), BMR_HELD_SLACK * s->held.scale / speed);
    }
    double angle = then.spin * time;
    if (angle != 0.0 && fabs(angle) < AHEAD_ANGLE)
        angle = copysign(AHEAD_ANGLE, angle);
    const bmr_pose *q = &now->pose;
    bmr_pose ahead = {bmr_add(q->position, bmr_scale(time, then.velocity)), q->c - angle * q->s,
                      q->s + angle * q->c}; // the angle's square is far below rounding
    return ahead;
}

// --- finding the cell ---

static bmr_vec2 center_of(const bmr_mixed *mixed, const bmr_mixed_cell *cell) {
    bmr_vec2 corners[BMR_MIXED_MAX_SIDES], sum = {0.0, 0.0};
    const size_t count = bmr_mixed_polygon(mixed, cell, corners);
    for (size_t i = 0; i < count; ++i)
        sum = bmr_add(sum, corners[i]);
    return bmr_scale(1.0 / (double)count, sum);
}

/// Outside of M_0: holds its edge. False: x is in M_0.
static bool hold_outside(cell_state *s, bmr_vec2 x) {
    double slack;
    const bmr_mixed_cell cell = bmr_mixed_outside(&s->held.mixed, x, &slack);
    if (!(slack > 0.0))
        return false;
    s->held.cell = cell;
    s->tile = BMR_MIXED_NO_TILE;
    return true;
}

/// Walks from `from`, a point of the present tile, or far off if the pair is outside, to x by the tiles'
/// stored neighbours. False: rounding lost the way, or the way met the sum.
static bool walk_tiles(cell_state *s, bmr_vec2 from, bmr_vec2 x, unsigned *touched) {
    bmr_mixed_kind kind;
    uint32_t tile = s->tile;
    if (!bmr_mixed_tiling_walk(s->tiling, &tile, &kind, from, x, touched))
        return false;
    if (tile == BMR_MIXED_NO_TILE)
        return kind == BMR_MIXED_OUTSIDE && hold_outside(s, x);
    s->tile = tile;
    s->held.cell = *bmr_mixed_tiling_cell(s->tiling, tile);
    return true;
}

/// The cell on the other side of the failed side, where x crosses it. If an order of edges failed (a page was
/// turned), the triangle that takes the cell's place. To be called in a cell only, not outside of M_0.
static bmr_mixed_cell across(const cell_state *s, const bmr_condition *failed, bmr_vec2 x,
                             unsigned *touched) {
    const bmr_mixed *mixed = &s->held.mixed;
    if (failed->kind == BMR_CONDITION_TURN) {
        ++*touched;
        return bmr_mixed_triangle(mixed, s->held.cell.owner, s->held.cell.edge);
    }
    const bmr_vec2 n = bmr_vec2_make(-failed->normal.x, -failed->normal.y);
    const bmr_pose turn = {{0.0, 0.0}, mixed->c, mixed->s};
    const bmr_mixed_ray ray = {x, failed->owner == 0 ? n : bmr_neg(bmr_rotate(&turn, n))};
    return bmr_mixed_next(mixed, &s->held.cell, (bmr_mixed_role)(failed->label - BMR_HELD_SIDE), &ray,
                          touched);
}

/// The usual case: the cell on the other side holds x and becomes the active one. False, and nothing has
/// changed: it does not hold x, or the structure is tiled, which walks by stored neighbours instead.
static bool step_over(bmr_kds *kds, const bmr_condition *failed, bmr_vec2 x, unsigned *touched) {
    cell_state *s = state_of(kds);
    if (class_of(kds)->tiled || s->close || !bmr_held_is_cell(&s->held))
        return false;
    const bmr_mixed_cell next = across(s, failed, x, touched);
    if (next.kind >= BMR_MIXED_OUTSIDE || !bmr_mixed_holds(&s->held.mixed, &next, x))
        return false;
    s->held.cell = next;
    return true;
}

/// Takes the cell on the other side without asking whether it holds x. For an x that is on the failed side up
/// to rounding: the condition and the walk compute that side from different corners, and may not agree on
/// which side x is. The condition decides, for it is what the caller goes by; in the new cell the opposite
/// condition is zero up to rounding, and grows. False, and nothing has changed: there is no such cell.
static bool force_over(bmr_kds *kds, const bmr_condition *failed, bmr_vec2 x, unsigned *touched) {
    cell_state *s = state_of(kds);
    if (s->close || !bmr_held_is_cell(&s->held))
        return false;
    const bmr_mixed_cell next = across(s, failed, x, touched);
    if (bmr_mixed_same(&next, &s->held.cell) || !bmr_mixed_exists(&s->held.mixed, &next))
        return false;
    s->held.cell = next;
    s->tile = class_of(kds)->tiled ? bmr_mixed_tiling_find(s->tiling, &next) : BMR_MIXED_NO_TILE;
    return true;
}

/// Finds the cell that holds x by a walk that comes from far outside, against `direction`. False: contact, or
/// lost.
static bool find_from_outside(bmr_kds *kds, bmr_vec2 x, bmr_vec2 direction, unsigned *touched) {
    cell_state *s = state_of(kds);
    if (class_of(kds)->tiled) {
        if (hold_outside(s, x))
            return true;
        s->tile = BMR_MIXED_NO_TILE;
        const double far = 8.0 * (s->held.scale + fabs(x.x) + fabs(x.y));
        return walk_tiles(s, bmr_add(x, bmr_scale(far, direction)), x, touched);
    }
    bmr_mixed_cell cell;
    if (!bmr_mixed_locate(&s->held.mixed, x, direction, &cell, touched) || cell.kind == BMR_MIXED_INSIDE)
        return false;
    if (cell.kind == BMR_MIXED_OUTSIDE)
        return hold_outside(s, x);
    s->held.cell = cell;
    return true;
}

/// Finds the cell that holds x by a walk from the last active cell. False: lost, or the way met the sum.
static bool find_from_cell(bmr_kds *kds, bmr_vec2 x, unsigned *touched) {
    cell_state *s = state_of(kds);
    bmr_mixed_cell cell = s->held.cell;
    if (!bmr_held_is_cell(&s->held)) { // M_0 is entered through the edge that was held, or near it
        bmr_mixed_side side[BMR_MIXED_MAX_SIDES];
        if (hold_outside(s, x))
            return true;
        (void)bmr_mixed_sides(&s->held.mixed, &cell, side);
        const bmr_vec2 n = bmr_mixed_line(&s->held.mixed, side->owner, side->edge).normal;
        const bmr_pose turned = {{0.0, 0.0}, -s->held.mixed.c, -s->held.mixed.s};
        return find_from_outside(kds, x, side->owner == 0 ? n : bmr_rotate(&turned, n), touched);
    }
    if (class_of(kds)->tiled)
        return s->tile != BMR_MIXED_NO_TILE && walk_tiles(s, center_of(&s->held.mixed, &cell), x, touched);
    if (!bmr_mixed_exists(&s->held.mixed, &cell)) {
        cell = bmr_mixed_triangle(&s->held.mixed, cell.owner, cell.edge);
        ++*touched;
    }
    if (!bmr_mixed_walk(&s->held.mixed, &cell, center_of(&s->held.mixed, &cell), x, touched) ||
        cell.kind == BMR_MIXED_INSIDE)
        return false;
    if (cell.kind == BMR_MIXED_OUTSIDE)
        return hold_outside(s, x);
    s->held.cell = cell;
    return true;
}

/// Holds a direction in the body in which it lasts longer at the rates of this instant.
static void hold_direction(bmr_kds *kds, const bmr_instant *now, bmr_vec2 u, double distance,
                           const uint32_t support[2]) {
    cell_state *s = state_of(kds);
    const uint32_t a = bmr_hierarchy_depth(s->held.mixed.hierarchies[0]),
                   b = bmr_hierarchy_depth(s->held.mixed.hierarchies[1]);
    bmr_windowed_line lines[2];
    for (int owner = 0; owner < 2; ++owner) {
        bmr_windowed_line_set(&lines[owner], kds, &now->pose, owner, u, support);
        bmr_windowed_corners(&lines[owner], kds, &now->pose, CLOSE_PART * (distance - kds->def.margin), 0);
    }
    const bool of_b = bmr_windowed_time(&lines[1], kds, now) > bmr_windowed_time(&lines[0], kds, now);
    s->line = lines[of_b];
    s->line.level = (int)(a > b ? a : b) + 1;
}

/// Do both states hold the same cell, or outside of M_0 the same edge of it?
static bool same_cell(const cell_state *a, const cell_state *b) {
    return !a->close && !b->close && bmr_mixed_same(&a->held.cell, &b->held.cell);
}

/// Asks for the closest direction, and takes the cell that it leads to. The direction itself becomes the
/// proof where no cell does: within the mitres, where rounding loses the way, and where the way leads back to
/// the cell of `left`, of which a condition has failed (NULL: there is none). False: contact.
static bool find_by_closest(bmr_kds *kds, const cell_state *left, const bmr_instant *now, bmr_vec2 x,
                            unsigned *touched) {
    cell_state *s = state_of(kds);
    uint32_t support[2] = {s->line.support[0], s->line.support[1]};
    bmr_vec2 u;
    double distance;
    ++*touched;
    if (!bmr_windowed_closest(kds, &now->pose, support, &u, &distance))
        return false;
    s->line.support[0] = support[0];
    s->line.support[1] = support[1];
    s->close = false;
    s->close = !find_from_outside(kds, x, u, touched) || (left && same_cell(left, s));
    if (s->close)
        hold_direction(kds, now, u, distance, support);
    return true;
}

static void set_rotation(bmr_kds *kds, const bmr_pose *ahead) {
    cell_state *s = state_of(kds);
    const bool same = s->held.mixed.c == ahead->c && s->held.mixed.s == ahead->s;
    s->held.mixed.c = ahead->c;
    s->held.mixed.s = ahead->s;
    if (!class_of(kds)->tiled || (same && s->tiling))
        return;
    s->tiling = (bmr_mixed_tiling *)(void *)s->block;
    bmr_mixed_tiling_build(s->tiling, &s->held.mixed, kds->bytes - sizeof(bmr_kds) - sizeof *s);
    bmr_kds_tally(kds, bmr_mixed_tiling_count(s->tiling));
    s->tile = bmr_mixed_tiling_find(s->tiling, &s->held.cell);
}

static bool find(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    cell_state *s = state_of(kds);
    const bmr_pose ahead = look_ahead(s, now, NULL), q = bmr_held_displaced(&s->held, &ahead);
    set_rotation(kds, &q);
    if (!find_by_closest(kds, NULL, now, q.position, &report->touched))
        return false;
    report->level_after = level_of(s);
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    state_of(kds)->held.mixed.steps = kds->steps;
    const bool apart = find(kds, now, report);
    state_of(kds)->held.mixed.steps = NULL;
    return apart;
}

/// What the failure of a condition is called.
static bmr_kds_event_kind kind_of(const cell_state *s, const bmr_condition *failed) {
    if (s->close)
        return failed->label >= BMR_WINDOWED_LOW ? BMR_KDS_ROLL : BMR_KDS_PUSH;
    if (failed->label >= BMR_HELD_PAGE)
        return !bmr_held_is_cell(&s->held)      ? BMR_KDS_ROLL
               : failed->label == BMR_HELD_PAGE ? BMR_KDS_PAGE_TURN
                                                : BMR_KDS_COLLAPSE;
    return bmr_held_is_cell(&s->held) && failed->label == BMR_HELD_SIDE + BMR_MIXED_INNER ? BMR_KDS_STAB
                                                                                          : BMR_KDS_CROSS;
}

/// For a condition that is positive a little ahead: has it failed all the same? It has, unless it is positive
/// now, or zero up to rounding and growing by more than rounding.
static bool fails_now(const cell_state *s, const bmr_condition *condition, const bmr_instant *now,
                      const bmr_pose *ahead) {
    const double value = bmr_condition_value(condition, &now->pose);
    const double no_sign = NO_SIGN * (condition->kind == BMR_CONDITION_TURN ? 1.0 : s->held.scale);
    const bool grows =
        bmr_condition_value(condition, ahead) > no_sign && bmr_condition_rate(condition, now) > 0.0;
    return !(value > 0.0) && !(value >= -no_sign && grows);
}

/// After force_over: does any condition of the new cell fail at this instant? Where three cells meet within
/// the way that is looked ahead, x may never come to the one that was taken.
static bool fails_at_once(const bmr_kds *kds, const bmr_instant *now, const bmr_pose *ahead) {
    bmr_condition held[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, held);
    for (size_t i = 0; i < count; ++i)
        if (fails_now(constant_state_of(kds), &held[i], now, ahead))
            return true;
    return false;
}

/// Goes to the cell that holds x. Where that is the cell of which a condition just failed, takes the cell on
/// the other side of the failed side instead.
static bool leave_cell(bmr_kds *kds, const cell_state *left, const bmr_condition *failed, bmr_vec2 x,
                       unsigned *touched) {
    cell_state *s = state_of(kds);
    if (step_over(kds, failed, x, touched))
        return true;
    if (s->close || !find_from_cell(kds, x, touched))
        return false;
    return !same_cell(left, s) || force_over(kds, failed, x, touched);
}

static bool mend(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    cell_state *s = state_of(kds);
    bmr_condition held[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, held);
    if (!(failed < count))
        failed = 0;
    const bmr_pose ahead = look_ahead(s, now, &held[failed]);
    // If the condition named is positive a little ahead, another one may have failed at the same time. If
    // none is negative there, the repair was called too early, or the failure lasts for less than the look
    // ahead.
    for (size_t i = 0; i < count && bmr_condition_value(&held[failed], &ahead) > 0.0; ++i)
        if (!(bmr_condition_value(&held[i], &ahead) > 0.0))
            failed = i;
    const bool heals = bmr_condition_value(&held[failed], &ahead) > 0.0;
    if (heals && !fails_now(s, &held[failed], now, &ahead))
        return true;
    const cell_state before = *s;
    report->kind = kind_of(s, &held[failed]);
    report->level_before = level_of(s);
    const bmr_pose q = bmr_held_displaced(&s->held, &ahead);
    set_rotation(kds, &q);
    const bool left = heals ? force_over(kds, &held[failed], q.position, &report->touched) &&
                                  !fails_at_once(kds, now, &ahead)
                            : leave_cell(kds, &before, &held[failed], q.position, &report->touched);
    if (!left && !find_by_closest(kds, &before, now, q.position, &report->touched))
        return false;
    report->level_after = level_of(s);
    report->line_changed = !same_line(&before, s);
    return true;
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
/// Theorem 5.3: rigid motions: O(log min{n, D/s}) an event, O(mu^2) events.
static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    state_of(kds)->held.mixed.steps = kds->steps;
    const bool apart = mend(kds, now, failed, report);
    state_of(kds)->held.mixed.steps = NULL;
    return apart;
}

static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const cell_state *s = constant_state_of(kds);
    if (s->close)
        return bmr_windowed_audit(&s->line, kds, b_in_a);
    const bool is_its_tile = !class_of(kds)->tiled || !bmr_held_is_cell(&s->held) ||
                             bmr_mixed_tiling_find(s->tiling, &s->held.cell) == s->tile;
    return is_its_tile ? bmr_held_audit(&s->held, b_in_a) : BMR_ERROR_INVALID_STRUCTURE;
}

static size_t tiling_bytes(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)def;
    return bmr_mixed_tiling_most_bytes(a->hierarchies[BMR_HIERARCHY_DUDLEY],
                                       b->hierarchies[BMR_HIERARCHY_DUDLEY]);
}

#define CELL_CLASS(extra, is_tiled)                                                                          \
    {                                                                                                        \
        .class = {.state_bytes = sizeof(cell_state),                                                         \
                  .extra_bytes = (extra),                                                                    \
                  .prepare = prepare,                                                                        \
                  .start = start,                                                                            \
                  .conditions = conditions,                                                                  \
                  .repair = repair,                                                                          \
                  .proof = proof,                                                                            \
                  .audit = audit},                                                                           \
        .tiled = (is_tiled)                                                                                  \
    }
static const cell_class implicit_cell = CELL_CLASS(NULL, false), tiling = CELL_CLASS(tiling_bytes, true);

BMR_KDS_INFO(active_cell_compass, "active-cell-compass", "Active cell of the mixed hierarchy, compass",
             "4, 5 (two polygons, rigid motion)", BMR_KDS_RIGID, BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS,
             &implicit_cell);
BMR_KDS_INFO(active_cell_dudley, "active-cell-dudley", "Active cell of the mixed hierarchy, Dudley",
             "4, 5 (two polygons, rigid motion)", BMR_KDS_RIGID, BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY,
             &implicit_cell);
BMR_KDS_INFO(tiling_dudley, "tiling-dudley", "The whole mixed hierarchy as a tiling, Dudley",
             "4 (if we are willing to construct it)", BMR_KDS_TRANSLATION, BMR_KDS_CONTROL,
             BMR_HIERARCHY_DUDLEY, &tiling);
