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
// Bodies that are aligned need a displacement, and the margin needs lines moved outwards: see held_cell.
//
// Lines moved outwards make mitred corners. A pair nearer than sqrt(2) times the margin may be within them,
// and in no cell; there the structure holds the closest direction as free-fd2 does, and its level is one
// below the hierarchies' deepest.
#include <float.h>
#include <math.h>

#include "hierarchy/mixed.h"
#include "kds/registry.h"
#include "kds/windowed_line.h"

/// A cell of the mixed hierarchy as conditions and as a proof.
///
/// A point that moves along a border of two cells, or hierarchies with edges in common directions that never
/// turn, would make conditions that are zero and stay zero. So the cell is one of A and of B displaced by a
/// fixed tiny rigid motion: by design nothing is aligned with A then. All lines are moved outwards by as
/// much, and by half the margin each: what is proved holds for B itself, with the margin.

/// The pose for which a cell is chosen may differ from that of the event by this part of the extents, and by
/// as many radians.
#define HELD_SLACK 1e-9
/// Level of what is outside of M_0.
#define HELD_OUTSIDE_LEVEL (-1)

typedef struct held_cell {
    bmr_mixed mixed;       ///< at the rotation of the last event, a little ahead
    bmr_pose displacement; ///< of B in its own frame
    double scale;          ///< the extents
    double spread;         ///< how far B's points are from where the displacement has them, at most
    bmr_mixed_cell cell;   ///< a cell, or an edge of M_0
} held_cell;

/// What the conditions are labelled: the roles of the sides, and the two orders.
enum { HELD_SIDE = 8, HELD_PAGE = HELD_SIDE + 4, HELD_COLLAPSE };

static inline bool held_is_cell(const held_cell *held) {
    return held->cell.kind < BMR_MIXED_OUTSIDE;
}

/// B's displacement: an angle in radians, which is also its way as a part of the extents. Well above the
/// angle within which directions are merged (1e-11) and above rounding, well below any sensible margin.
#define DISPLACEMENT 0x1p-33
/// Its direction: no multiple of any compass angle.
#define DISPLACEMENT_X 0.8191
#define DISPLACEMENT_Y 0.5737

/// No cell yet, but all that does not depend on the pose.
static held_cell held_make(const bmr_kds *kds) {
    held_cell held = {.displacement = {.c = cos(DISPLACEMENT), .s = sin(DISPLACEMENT)}};
    const double extent_b = kds->shapes[1].polygon->extent;
    held.scale = fmax(kds->shapes[0].polygon->extent + extent_b, kds->def.margin);
    const double way = DISPLACEMENT * held.scale;
    held.displacement.position = bmr_vec2_make(way * DISPLACEMENT_X, way * DISPLACEMENT_Y);
    held.spread = way + DISPLACEMENT * 1.5 * extent_b; // a corner of the square is sqrt(2) extents away
    const double apart = kds->def.margin + 2.0 * held.spread + 2.0 * HELD_SLACK * held.scale;
    held.mixed = bmr_mixed_make(bmr_kds_hierarchy(kds, 0), bmr_kds_hierarchy(kds, 1), 1.0, 0.0, 0.5 * apart);
    return held;
}

/// The pose of the displaced B, given that of B.
static bmr_pose held_displaced(const held_cell *held, const bmr_pose *pose) {
    const bmr_pose *d = &held->displacement;
    const bmr_pose q = {bmr_transform(pose, d->position), pose->c * d->c - pose->s * d->s,
                        pose->s * d->c + pose->c * d->s};
    return q;
}

/// The level of the edge that made the cell.
static int held_level(const held_cell *held) {
    const int32_t stage = bmr_mixed_stage(&held->mixed, &held->cell);
    return stage < 0 ? HELD_OUTSIDE_LEVEL : stage / 2 + 1;
}

/// The edge whose line is the proof, and its body.
static bmr_edge held_edge(const held_cell *held, int *owner) {
    const bool own = held->cell.kind == BMR_MIXED_TRIANGLE || held->cell.kind == BMR_MIXED_OUTSIDE;
    *owner = own ? held->cell.owner : 1 - held->cell.owner;
    return own ? held->cell.edge : held->cell.other[0];
}

static bmr_condition condition_of_side(const held_cell *held, const bmr_mixed_figure *f, size_t i) {
    const bmr_mixed_part *part = &f->parts[i];
    const bmr_line *line = &f->lines[part->of][part->line];
    const bmr_vec2 p = f->corners[1 - part->of][part->corner];
    const int owner = part->of ? 1 - f->owner : f->owner, label = HELD_SIDE + part->role;
    const double sign = (double)part->beyond;
    if (owner == 0)
        return bmr_condition_beyond(0, bmr_scale(sign, line->normal), sign * line->offset,
                                    bmr_transform(&held->displacement, p), label);
    const bmr_vec2 n = bmr_rotate(&held->displacement, line->normal);
    const double offset = line->offset + bmr_dot(n, held->displacement.position);
    return bmr_condition_beyond(1, bmr_scale(sign, n), sign * offset, p, label);
}

static bmr_vec2 normal_in(const bmr_mixed_figure *f, int body, bmr_edge edge) {
    const int of = body == f->owner ? 0 : 1;
    int i = 0;
    while (i < 2 && f->edges[of][i] != edge)
        ++i;
    return f->lines[of][i].normal;
}

/// Lemma 4.2: a full turn of Q turns O(mn log m) pages.
/// -B's normals are those of B turned round.
static bmr_condition condition_of_order(const held_cell *held, const bmr_mixed_figure *f,
                                        const bmr_mixed_order *order) {
    const bmr_vec2 first = normal_in(f, order->owner, order->first);
    const bmr_vec2 second = normal_in(f, 1 - order->owner, order->second);
    const int label = order->page_turn ? HELD_PAGE : HELD_COLLAPSE;
    return order->owner == 0
               ? bmr_condition_turn(0, first, bmr_neg(bmr_rotate(&held->displacement, second)), label)
               : bmr_condition_turn(1, bmr_neg(bmr_rotate(&held->displacement, first)), second, label);
}

/// One BEYOND for each side, then, if the pair may turn, two TURNs.
static size_t held_conditions(const held_cell *held, bool turns, bmr_condition *out) {
    bmr_mixed_figure figure;
    bmr_mixed_order orders[2];
    bmr_mixed_draw(&held->mixed, &held->cell, &figure);
    const size_t count = figure.sides;
    for (size_t i = 0; i < count; ++i)
        out[i] = condition_of_side(held, &figure, i);
    if (!turns)
        return count;
    bmr_mixed_orders(&held->mixed, &held->cell, orders);
    out[count] = condition_of_order(held, &figure, &orders[0]);
    out[count + 1] = condition_of_order(held, &figure, &orders[1]);
    return count + 2;
}

static void held_proof(const held_cell *held, bmr_kds_proof *out) {
    int owner;
    const bmr_edge edge = held_edge(held, &owner);
    const bmr_hierarchy *other = held->mixed.hierarchies[1 - owner];
    bmr_mixed_order orders[2]; // of the corner's first edge and the line's, and of the line's and the second
    bmr_mixed_orders(&held->mixed, &held->cell, orders);
    out->owner = owner;
    out->line = bmr_hierarchy_line(held->mixed.hierarchies[owner], edge);
    out->nearest =
        bmr_hierarchy_corner_point(other, bmr_hierarchy_corner(other, orders[0].first, orders[1].second));
    if (owner == 1) { // the line has B's displacement: out until all of B itself is behind it
        out->line.normal = bmr_rotate(&held->displacement, out->line.normal);
        out->line.offset += bmr_dot(out->line.normal, held->displacement.position) + held->spread;
    }
    out->level = held_level(held);
}

/// The other body's edges of a cell: there when e was inserted, and a triangle's two adjacent.
static bool is_of_its_stage(const held_cell *held) {
    const int other = 1 - held->cell.owner;
    const bmr_hierarchy *h = held->mixed.hierarchies[other];
    const uint32_t level = (uint32_t)(bmr_mixed_stage(&held->mixed, &held->cell) + 1 - other) / 2u;
    if (bmr_hierarchy_level(h, held->cell.other[0]) > level)
        return false;
    return held->cell.kind != BMR_MIXED_TRIANGLE ||
           bmr_hierarchy_corner_after(h, held->cell.other[0], level).after == held->cell.other[1];
}

/// Up to HELD_SLACK: are all conditions true? And is the tuple one of its stage: were the other body's
/// edges there when e was inserted, a triangle's two adjacent?
static bmr_error held_audit(const held_cell *held, const bmr_pose *b_in_a) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = held_conditions(held, true, conditions);
    for (size_t i = 0; i < count; ++i) {
        const double unit = conditions[i].kind == BMR_CONDITION_TURN ? 1.0 : held->scale;
        if (!(bmr_condition_value(&conditions[i], b_in_a) > -2.0 * HELD_SLACK * unit))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    return held_is_cell(held) && !is_of_its_stage(held) ? BMR_ERROR_INVALID_STRUCTURE : BMR_OK;
}

/// A repair does not use the pose of the event, where the failed condition is zero up to rounding, but at
/// one a little later: the bodies have moved on by this part of the extents. That is far above rounding
/// (1e-15), and far below what the offset of the lines allows (HELD_SLACK). Where the failure was found
/// early, that is the failure itself, but never farther than HELD_SLACK.
#define AHEAD 1e-12
/// If the pair turns at all, it has turned by this angle (radians) at least.
#define AHEAD_ANGLE 1e-14
/// A condition's value nearer to zero than this has no sign that means anything: it is eight roundings, of
/// the extents for a length, of 1 for the sine of an angle. (A search for failures takes even larger values
/// for zero, and then goes by the rates.)
#define NO_SIGN (4.0 * DBL_EPSILON)

/// Where there is no cell, the part of the gap that a window may cost: free-fd2's.
#define CLOSE_PART 0.3

typedef struct cell_state {
    held_cell held;           ///< unless `close`
    bool close;               ///< within the mitres: the line is the proof
    bmr_windowed_line line;   ///< if close
    uint32_t tile;            ///< tiled: of the cell
    bmr_mixed_tiling *tiling; ///< behind this state; NULL: none yet
    unsigned char block[];    ///< the tiling's
} cell_state;

/// Has the pair the whole tiling?
static bool is_tiled(const bmr_kds *kds) {
    return kds->info->domain == BMR_KDS_TRANSLATION;
}
static cell_state *state_of(bmr_kds *kds) {
    return (cell_state *)(void *)kds->state;
}
static const cell_state *constant_state_of(const bmr_kds *kds) {
    return (const cell_state *)(const void *)kds->state;
}

static bmr_error prepare(bmr_kds *kds) {
    state_of(kds)->held = held_make(kds);
    return BMR_OK;
}

static size_t conditions(const bmr_kds *kds, bmr_condition *out) {
    const cell_state *s = constant_state_of(kds);
    return s->close ? bmr_windowed_conditions(&s->line, kds->def.margin, out)
                    : held_conditions(&s->held, !is_tiled(kds), out);
}

static void proof(const bmr_kds *kds, bmr_kds_proof *out) {
    const cell_state *s = constant_state_of(kds);
    if (s->close)
        bmr_windowed_proof(&s->line, out);
    else
        held_proof(&s->held, out);
}

static int level_of(const cell_state *s) {
    return s->close ? s->line.level : held_level(&s->held);
}

static bool same_line(const cell_state *a, const cell_state *b) {
    int of_a, of_b;
    if (a->close || b->close)
        return a->close && b->close && bmr_windowed_same_line(&a->line, &b->line);
    return held_edge(&a->held, &of_a) == held_edge(&b->held, &of_b) && of_a == of_b;
}

// --- a little ahead ---

/// B's pose a little after `now`; that of `now` where the rates are unknown. If the failed condition is still
/// positive and falls, that is after it has come to zero, where this is near enough.
static bmr_pose pose_ahead(const cell_state *s, const bmr_instant *now, const bmr_condition *failed) {
    const double speed = hypot(now->velocity.x, now->velocity.y) + fabs(now->spin) * s->held.scale;
    double time = speed > 0.0 ? AHEAD * s->held.scale / speed : 0.0;
    if (failed && speed > 0.0) {
        const double value = bmr_condition_value(failed, &now->pose), rate = bmr_condition_rate(failed, now);
        if (value > 0.0 && rate < 0.0)
            time = fmin(fmax(time, 2.0 * value / -rate), HELD_SLACK * s->held.scale / speed);
    }
    double angle = now->spin * time;
    if (angle != 0.0 && fabs(angle) < AHEAD_ANGLE)
        angle = copysign(AHEAD_ANGLE, angle);
    const bmr_pose *q = &now->pose;
    bmr_pose ahead = {bmr_add(q->position, bmr_scale(time, now->velocity)), q->c - angle * q->s,
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
    return bmr_mixed_next(mixed, &s->held.cell, (bmr_mixed_role)(failed->label - HELD_SIDE), &ray, touched);
}

/// The usual case: the cell on the other side holds x and becomes the active one. False, and nothing has
/// changed: it does not hold x, or the structure is tiled, which walks by stored neighbours instead.
static bool step_over(bmr_kds *kds, const bmr_condition *failed, bmr_vec2 x, unsigned *touched) {
    cell_state *s = state_of(kds);
    if (is_tiled(kds) || s->close || !held_is_cell(&s->held))
        return false;
    const bmr_mixed_cell next = across(s, failed, x, touched);
    if (next.kind >= BMR_MIXED_OUTSIDE || !bmr_mixed_holds(&s->held.mixed, &next, x))
        return false;
    s->held.cell = next;
    return true;
}

/// Finds the cell that holds x by a walk that comes from far outside, against `direction`. False: contact, or
/// lost.
static bool find_from_outside(bmr_kds *kds, bmr_vec2 x, bmr_vec2 direction, unsigned *touched) {
    cell_state *s = state_of(kds);
    if (is_tiled(kds)) {
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
    if (!held_is_cell(&s->held)) { // M_0 is entered through the edge that was held, or near it
        if (hold_outside(s, x))
            return true;
        const bmr_vec2 n = bmr_hierarchy_line(s->held.mixed.hierarchies[cell.owner], cell.edge).normal;
        const bmr_pose turned = {{0.0, 0.0}, -s->held.mixed.c, -s->held.mixed.s};
        return find_from_outside(kds, x, cell.owner == 0 ? n : bmr_rotate(&turned, n), touched);
    }
    if (is_tiled(kds))
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
    if (!is_tiled(kds) || (same && s->tiling))
        return;
    s->tiling = (bmr_mixed_tiling *)(void *)s->block;
    bmr_mixed_tiling_build(s->tiling, &s->held.mixed, kds->bytes - sizeof(bmr_kds) - sizeof *s);
    bmr_kds_tally(kds, bmr_mixed_tiling_count(s->tiling));
    s->tile = bmr_mixed_tiling_find(s->tiling, &s->held.cell);
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    cell_state *s = state_of(kds);
    s->held.mixed.steps = kds->steps;
    const bmr_pose ahead = pose_ahead(s, now, NULL), q = held_displaced(&s->held, &ahead);
    set_rotation(kds, &q);
    const bool apart = find_by_closest(kds, NULL, now, q.position, &report->touched);
    if (apart)
        report->level_after = level_of(s);
    s->held.mixed.steps = NULL;
    return apart;
}

/// What the failure of a condition is called.
static bmr_kds_event_kind kind_of(const cell_state *s, const bmr_condition *failed) {
    if (s->close)
        return failed->label >= BMR_WINDOWED_LOW ? BMR_KDS_ROLL : BMR_KDS_PUSH;
    if (failed->label >= HELD_PAGE)
        return !held_is_cell(&s->held)      ? BMR_KDS_ROLL
               : failed->label == HELD_PAGE ? BMR_KDS_PAGE_TURN
                                            : BMR_KDS_COLLAPSE;
    return held_is_cell(&s->held) && failed->label == HELD_SIDE + BMR_MIXED_INNER ? BMR_KDS_STAB
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

/// Goes to the cell that holds x. False: that is the cell of which a condition just failed, or lost.
static bool leave_cell(bmr_kds *kds, const cell_state *left, const bmr_condition *failed, bmr_vec2 x,
                       unsigned *touched) {
    cell_state *s = state_of(kds);
    if (step_over(kds, failed, x, touched))
        return true;
    return !s->close && find_from_cell(kds, x, touched) && !same_cell(left, s);
}

static bool mend(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    cell_state *s = state_of(kds);
    bmr_condition held[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, held);
    if (!(failed < count))
        failed = 0;
    const bmr_pose ahead = pose_ahead(s, now, &held[failed]);
    // If it is positive a little ahead, the repair was called too early, or the failure lasts for less than
    // the step ahead.
    const bool heals = bmr_condition_value(&held[failed], &ahead) > 0.0;
    if (heals && !fails_now(s, &held[failed], now, &ahead))
        return true;
    const cell_state before = *s;
    report->kind = kind_of(s, &held[failed]);
    report->level_before = level_of(s);
    const bmr_pose q = held_displaced(&s->held, &ahead);
    set_rotation(kds, &q);
    const bool left = !heals && leave_cell(kds, &before, &held[failed], q.position, &report->touched);
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
    const bool is_its_tile = !is_tiled(kds) || !held_is_cell(&s->held) ||
                             bmr_mixed_tiling_find(s->tiling, &s->held.cell) == s->tile;
    return is_its_tile ? held_audit(&s->held, b_in_a) : BMR_ERROR_INVALID_STRUCTURE;
}

static size_t tiling_bytes(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)def;
    return bmr_mixed_tiling_most_bytes(a->hierarchies[BMR_HIERARCHY_DUDLEY],
                                       b->hierarchies[BMR_HIERARCHY_DUDLEY]);
}

#define CELL_CLASS(extra)                                                                                    \
    {                                                                                                        \
        .state_bytes = sizeof(cell_state), .extra_bytes = (extra), .prepare = prepare, .start = start,       \
        .conditions = conditions, .repair = repair, .proof = proof, .audit = audit                           \
    }
static const bmr_kds_class implicit_cell = CELL_CLASS(NULL), tiling = CELL_CLASS(tiling_bytes);

BMR_KDS_INFO(active_cell_compass, "active-cell-compass", "Active cell of the mixed hierarchy, compass",
             "4, 5 (two polygons, rigid motion)", BMR_KDS_RIGID, BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS,
             &implicit_cell);
BMR_KDS_INFO(active_cell_dudley, "active-cell-dudley", "Active cell of the mixed hierarchy, Dudley",
             "4, 5 (two polygons, rigid motion)", BMR_KDS_RIGID, BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY,
             &implicit_cell);
BMR_KDS_INFO(tiling_dudley, "tiling-dudley", "The whole mixed hierarchy as a tiling, Dudley",
             "4 (if we are willing to construct it)", BMR_KDS_TRANSLATION, BMR_KDS_CONTROL,
             BMR_HIERARCHY_DUDLEY, &tiling);
