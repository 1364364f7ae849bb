// SPDX-License-Identifier: MIT
// The lazy structure (certificate/walk.h) of two polygons, event-driven. What the paper leaves open is
// settled like this:
//
// - A line is taken from one tolerance beyond the margin on and fails at the margin; a corner's cone is
//   widened by an angle on either side, and the loss that this may mean is added to the line's offset. So
//   nothing fails where it was made, parallel edges that never turn included.
// - Coarser levels are taken only for a good part of the finer gap. "Until the next coarser envelopes
//   intersect" takes lines that prove next to nothing, after a roll above all: roll, coarsen, stab, and
//   again.
// - Between two corners no edge's line separates by more than the distance over sqrt 2: near the margin the
//   closest direction itself is the line, fixed in A.
//
// The coarsest proof is the rectangles' (level 0), as in the paper: disks around the bodies would save the
// four rolls a turn of bodies that spin far apart, but have no line to show as a proof.
#include <math.h>

#include "certificate/walk.h"
#include "geometry/distance.h"
#include "hierarchy/tree.h"
#include "kds/registry.h"
#include "kds/structure.h"

enum { LINE, CONE_BEFORE, CONE_AFTER, CONDITIONS };

/// Of the sum of the extents: as for points, 2^-37.
#define TOLERANCE 7.2759576141834259e-12
/// The cone of the nearest corner is this much (radians) wider on both sides. Neighbouring edges differ by at
/// least 1e-11.
#define CONE_SLACK 1e-11
/// Beyond an edge's line by that angle, an envelope is nearer by at most that times its length: four radii
/// are more than the diagonal of any bounding rectangle.
#define CONE_RADII 4.0
typedef struct lazy_state {
    bmr_lazy_place at;       ///< edge BMR_NO_EDGE: the free line
    bmr_line free_line;      ///< A's frame
    uint32_t near_a, near_b; ///< where the last distance query ended
} lazy_state;

static lazy_state *state_of(bmr_kds *kds) {
    return (lazy_state *)(void *)kds->state;
}
static const lazy_state *view(const bmr_kds *kds) {
    return (const lazy_state *)(const void *)kds->state;
}

static double tolerance(const bmr_kds *kds) {
    return TOLERANCE * (kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent);
}

/// What the widened cone may cost, the worse of the two bodies.
static double cone_loss(const bmr_kds *kds) {
    const double radius = fmax(kds->shapes[0].polygon->radius, kds->shapes[1].polygon->radius);
    return CONE_SLACK * CONE_RADII * radius;
}

/// The gap from which on a line is taken.
static double need(const bmr_kds *kds) {
    return bmr_kds_reach(kds) + cone_loss(kds) + tolerance(kds);
}

static bmr_line line_of(const bmr_kds *kds) {
    const lazy_state *state = view(kds);
    return state->at.edge == BMR_NO_EDGE
               ? state->free_line
               : bmr_hierarchy_line(bmr_kds_hierarchy(kds, state->at.owner), state->at.edge);
}

static bmr_vec2 turned_by_slack(bmr_vec2 normal, double slack) {
    return bmr_add(normal, bmr_scale(slack, bmr_left(normal)));
}

static size_t conditions(const bmr_kds *kds, bmr_condition *k) {
    const lazy_state *state = view(kds);
    const bmr_hierarchy *other = bmr_kds_hierarchy(kds, 1 - state->at.owner);
    const bmr_line line = line_of(kds);
    const bmr_vec2 before = bmr_hierarchy_line(other, state->at.corner.before).normal;
    const bmr_vec2 after = bmr_hierarchy_line(other, state->at.corner.after).normal;
    k[LINE] =
        bmr_condition_beyond(state->at.owner, line.normal, line.offset + kds->def.margin + cone_loss(kds),
                             bmr_hierarchy_corner_point(other, state->at.corner), LINE);
    // The direction against the normal is in the cone: counter-clockwise of `before`, clockwise of `after`.
    k[CONE_BEFORE] =
        bmr_condition_turn(state->at.owner, line.normal, turned_by_slack(before, -CONE_SLACK), CONE_BEFORE);
    k[CONE_AFTER] = bmr_condition_turn(state->at.owner, bmr_neg(line.normal),
                                       turned_by_slack(after, CONE_SLACK), CONE_AFTER);
    return CONDITIONS;
}

/// Which conditions stand, by more than what the caller's rounding and ours may differ by.
static bool line_holds(const bmr_kds *kds, const bmr_pose *b_in_a) {
    bmr_condition k[CONDITIONS];
    conditions(kds, k);
    return bmr_condition_value(&k[LINE], b_in_a) > 0.5 * tolerance(kds);
}
static bool cone_holds(const bmr_kds *kds, const bmr_pose *b_in_a) {
    bmr_condition k[CONDITIONS];
    conditions(kds, k);
    return bmr_condition_value(&k[CONE_BEFORE], b_in_a) > 0.25 * CONE_SLACK &&
           bmr_condition_value(&k[CONE_AFTER], b_in_a) > 0.25 * CONE_SLACK;
}

/// A repair at work.
typedef struct repair {
    bmr_kds *kds;
    bmr_lazy lazy;
} repair;

/// Makes the certificate of a candidate. False, and nothing is changed: it does not hold by enough.
static bool certify(void *context, const bmr_candidate *candidate, int level) {
    repair *r = context;
    lazy_state *state = state_of(r->kds);
    const bmr_lazy_place before = state->at;
    state->at.owner = candidate->owner;
    state->at.edge = candidate->edge;
    state->at.corner = candidate->corner[1 - candidate->owner];
    state->at.level = level;
    if (line_holds(r->kds, r->lazy.walk.pose) && cone_holds(r->kds, r->lazy.walk.pose))
        return true;
    state->at = before;
    return false;
}

/// The old edge's line is as good as ever with another corner, if it holds: a roll asks for no larger gap.
static void begin_repair(repair *r, bmr_kds *kds, const bmr_instant *now) {
    const repair begun = {
        kds,
        {.walk = {.hierarchies = {bmr_kds_hierarchy(kds, 0), bmr_kds_hierarchy(kds, 1)}, .pose = &now->pose},
         .reach = need(kds),
         .roll_reach = -INFINITY,
         .take = certify,
         .context = r}};
    *r = begun;
}

/// The closest direction itself. False: contact.
static bool take_free(repair *r, bmr_vec2 direction) {
    lazy_state *state = state_of(r->kds);
    const bmr_polygon *a = r->kds->shapes[0].polygon;
    const bmr_hierarchy *b = r->lazy.walk.hierarchies[1];
    const bmr_vec2 against = bmr_unrotate(r->lazy.walk.pose, bmr_neg(direction));
    state->at.owner = 0;
    state->at.edge = BMR_NO_EDGE;
    state->free_line.normal = direction;
    state->free_line.offset =
        bmr_dot(direction, a->vertices[bmr_support_counted(a, direction, &r->lazy.walk.steps)]);
    state->at.level = bmr_walk_deepest(r->lazy.walk.hierarchies);
    state->at.corner = bmr_tree_extreme(b, against, bmr_hierarchy_depth(b), &r->lazy.walk.steps);
    return line_holds(r->kds, r->lazy.walk.pose);
}

/// From the exact closest direction, top down: the coarsest level that separates. False: contact.
static bool from_closest(repair *r) {
    lazy_state *state = state_of(r->kds);
    bmr_vec2 direction;
    double distance;
    if (!bmr_kds_closest(r->kds, r->lazy.walk.pose, &state->near_a, &state->near_b, &direction, &distance) ||
        !(distance > need(r->kds)))
        return false;
    return bmr_lazy_start(&r->lazy, direction, 0) || take_free(r, direction);
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    repair r;
    begin_repair(&r, kds, now);
    const bool apart = from_closest(&r);
    bmr_kds_tally(kds, r.lazy.walk.steps);
    report->level_after = apart ? view(kds)->at.level : 0;
    return apart;
}

/// The free line stays and the nearest corner becomes the one that is extreme now. False: the line does not
/// hold for it.
static bool roll_free(repair *r) {
    lazy_state *state = state_of(r->kds);
    bmr_walk_start(&r->lazy.walk, state->free_line.normal, state->at.level);
    state->at.corner = r->lazy.walk.corner[1];
    return line_holds(r->kds, r->lazy.walk.pose);
}

/// Rolls, pushes or stabs, and takes coarser levels. False: contact.
static bool repair_edge(repair *r, bool turned, bool *rolled) {
    const bmr_lazy_end end = bmr_lazy_repair(&r->lazy, view(r->kds)->at, turned);
    *rolled = end == BMR_LAZY_ROLL;
    if (end == BMR_LAZY_NONE)
        return from_closest(r);
    if (end != BMR_LAZY_STAB)
        bmr_walk_ascend(&r->lazy.walk, r->lazy.found, r->lazy.reach, r->lazy.reach, certify, r);
    return true;
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
/// Theorem 5.3: rigid motions: O(log min{n, D/s}) an event, O(mu^2) events.
static bool repair_pair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    repair r;
    begin_repair(&r, kds, now);
    const lazy_state before = *view(kds);
    report->level_before = report->level_after = before.at.level;
    const bool turned = !cone_holds(kds, &now->pose);
    if (!turned && line_holds(kds, &now->pose))
        return true;
    const bool free_line = before.at.edge == BMR_NO_EDGE;
    bool rolled = free_line && turned && roll_free(&r);
    const bool apart = rolled || (free_line ? from_closest(&r) : repair_edge(&r, turned, &rolled));
    bmr_kds_tally(kds, r.lazy.walk.steps);
    if (!apart)
        return false;
    const lazy_state *state = view(kds);
    report->level_after = state->at.level;
    report->kind = rolled ? BMR_KDS_ROLL : state->at.level > before.at.level ? BMR_KDS_STAB : BMR_KDS_PUSH;
    report->line_changed = state->at.owner != before.at.owner || state->at.edge != before.at.edge ||
                           (state->at.edge == BMR_NO_EDGE && !rolled);
    return true;
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    const lazy_state *state = view(kds);
    proof->owner = state->at.owner;
    proof->line = line_of(kds);
    proof->nearest =
        bmr_hierarchy_corner_point(bmr_kds_hierarchy(kds, 1 - state->at.owner), state->at.corner);
    proof->level = state->at.level;
}

/// The edge and the corner are on the level, and the corner is the extreme one there.
static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const lazy_state *state = view(kds);
    const bmr_hierarchy *other = bmr_kds_hierarchy(kds, 1 - state->at.owner);
    const uint32_t level = bmr_walk_side_level(other, state->at.level);
    const bmr_hierarchy *const hierarchies[2] = {bmr_kds_hierarchy(kds, 0), bmr_kds_hierarchy(kds, 1)};
    bmr_lazy_place at = state->at;
    if (at.edge == BMR_NO_EDGE)
        at.edge = 0; // of every level
    if (!bmr_lazy_is_place(hierarchies, &at))
        return BMR_ERROR_INVALID_STRUCTURE;
    const bmr_vec2 normal = line_of(kds).normal;
    const bmr_vec2 against =
        state->at.owner == 0 ? bmr_neg(bmr_unrotate(b_in_a, normal)) : bmr_neg(bmr_rotate(b_in_a, normal));
    const bmr_corner extreme = bmr_hierarchy_extreme(other, against, level);
    const double most = bmr_dot(against, bmr_hierarchy_corner_point(other, extreme));
    const double mine = bmr_dot(against, bmr_hierarchy_corner_point(other, state->at.corner));
    return mine >= most - cone_loss(kds) - tolerance(kds) ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

static const bmr_kds_class lazy = {.state_bytes = sizeof(lazy_state),
                                   .start = start,
                                   .conditions = conditions,
                                   .repair = repair_pair,
                                   .proof = proof,
                                   .audit = audit};

BMR_KDS_INFO(lazy_compass, "lazy-compass", "edge and corner of one level, compass", "5, two polygons (lazy)",
             BMR_KDS_RIGID, BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS, &lazy);
BMR_KDS_INFO(lazy_dudley, "lazy-dudley", "edge and corner of one level, Dudley", "5, two polygons (lazy)",
             BMR_KDS_RIGID, BMR_KDS_RECOMMENDED, BMR_HIERARCHY_DUDLEY, &lazy);
