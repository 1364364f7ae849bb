// SPDX-License-Identifier: MIT
// The eager structure for a point (section 5): the active triangle, the cell of the hierarchy's tiling that
// the point is in. A triangle is named by the node whose edge is its inner edge; its outer edges are the
// node's. The outside of P_0 is four pinwheel cells: beyond root k and not beyond root k + 1, named by the
// root.
//
// Cells overlap by twice the tolerance: a side is left only when the point is that far beyond it, and an
// inner edge is taken only from one tolerance on. So a point that runs along a side, or through an apex, is
// never between cells and never thrown back.
#include <math.h>

#include "hierarchy/tree.h"
#include "kds/chains.h"
#include "kds/point.h"
#include "kds/registry.h"

enum { INNER, OUTER_BEFORE, OUTER_AFTER };

/// More moves than this between cells that follow each other is no motion but a jump.
#define MOST_MOVES 128

/// The slack beyond an outer edge at which the cell is left.
static double outer_limit(const bmr_kds *kds) {
    return kds->def.margin + 2.0 * bmr_point_tolerance(kds);
}

/// The outer side that the point is beyond by more than `limit`, the farther of two; BMR_NO_EDGE: none.
static bmr_edge beyond_outer(const bmr_kds *kds, bmr_vec2 x, double limit) {
    const bmr_point_state *state = bmr_point_look(kds);
    const bmr_boomerang b = bmr_hierarchy_boomerang(state->hierarchy, state->edge);
    const double after = bmr_edge_slack(state->hierarchy, b.outer_after, x);
    double before = -INFINITY;
    if (b.level > 0) // a pinwheel cell has no side there: the one before ends at this root's line
        before = bmr_edge_slack(state->hierarchy, b.outer_before, x);
    if (!((before > after ? before : after) > limit))
        return BMR_NO_EDGE;
    return before > after ? b.outer_before : b.outer_after;
}

static bool in_cell(const bmr_kds *kds, bmr_vec2 x) {
    const double limit = outer_limit(kds) - bmr_point_failing(kds);
    return bmr_point_holds(kds, x) && beyond_outer(kds, x, limit) == BMR_NO_EDGE;
}

/// From a cell nearby to the one that the point is in. False: not found.
static bool settle(bmr_kds *kds, bmr_vec2 x, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const double need = bmr_point_need(kds);
    for (int moves = 0; moves < MOST_MOVES; ++moves) {
        ++*touched;
        const bmr_edge outer = beyond_outer(kds, x, need);
        if (outer != BMR_NO_EDGE) {
            state->edge = outer;
            continue;
        }
        if (bmr_edge_slack(state->hierarchy, state->edge, x) > need)
            return true;
        const bmr_chains *chains = bmr_kds_chains_of(kds);
        const bmr_edge inner = chains ? bmr_kds_chains_search(chains, state->edge, x, need, touched)
                                      : bmr_point_descend(state->hierarchy, state->edge, x, need, touched);
        if (inner == BMR_NO_EDGE)
            return false;
        state->edge = inner;
    }
    return false;
}

/// From scratch: the closest direction leads down the tree to the boomerang, and the first node that the
/// point is beyond is its triangle's.
static bool locate(bmr_kds *kds, const bmr_pose *b_in_a, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_hierarchy *h = state->hierarchy;
    bmr_vec2 u;
    if (!bmr_point_closest(kds, b_in_a, &u))
        return false;
    const bmr_vec2 x = bmr_point_at(kds, b_in_a);
    const double need = bmr_point_need(kds);
    const bmr_corner top = bmr_tree_extreme(h, u, 0, touched);
    double slack;
    bmr_edge edge = bmr_corner_widest_edge(h, top, x, &slack);
    bmr_edge cut = top.cut;
    while (!(slack > need) && cut != BMR_NO_EDGE) {
        ++*touched;
        edge = cut;
        slack = bmr_edge_slack(h, cut, x);
        const bmr_boomerang b = bmr_hierarchy_boomerang(h, cut);
        cut = bmr_cross(bmr_hierarchy_line(h, cut).normal, u) >= 0.0 ? b.child_after : b.child_before;
    }
    state->edge = edge;
    if (slack > need && settle(kds, x, touched) && in_cell(kds, x))
        return true;
    return bmr_point_take_free(kds, b_in_a);
}

bool bmr_triangle_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const bool apart = locate(kds, &now->pose, &report->touched);
    report->level_after = apart ? bmr_point_level(kds) : 0;
    return apart;
}

/// Lemma 3.2: a convex curve beside P meets at most one triangle of a level.
/// Lemma 3.3(c): a convex curve at distance s meets O(log(D/s)) compass triangles.
/// Lemma 3.4(c): a convex curve at distance s meets O(log(D/s)) Dudley triangles.
/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
bool bmr_triangle_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_vec2 x = bmr_point_at(kds, &now->pose);
    const bmr_edge edge_before = state->edge;
    report->level_before = report->level_after = bmr_point_level(kds);
    const bool certified = bmr_point_holds(kds, x);
    const bool is_free = edge_before == BMR_NO_EDGE;
    if (is_free ? certified : in_cell(kds, x))
        return true;
    const bool found = !is_free && settle(kds, x, &report->touched) && in_cell(kds, x);
    if (!found && !locate(kds, &now->pose, &report->touched))
        return false;
    report->level_after = bmr_point_level(kds);
    report->kind = !certified && report->level_after > report->level_before ? BMR_KDS_STAB : BMR_KDS_CROSS;
    report->line_changed = is_free || state->edge != edge_before;
    return true;
}

/// The condition of not being beyond an outer side.
static bmr_condition behind(const bmr_kds *kds, bmr_edge edge, int label) {
    const bmr_point_state *state = bmr_point_look(kds);
    const bmr_line line = bmr_hierarchy_line(state->hierarchy, edge);
    return bmr_condition_beyond(0, bmr_neg(line.normal), -(line.offset + outer_limit(kds)), state->point,
                                label);
}

size_t bmr_triangle_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    const bmr_point_state *state = bmr_point_look(kds);
    size_t count = bmr_point_conditions(kds, conditions);
    if (state->edge == BMR_NO_EDGE)
        return count;
    const bmr_boomerang b = bmr_hierarchy_boomerang(state->hierarchy, state->edge);
    conditions[count++] = behind(kds, b.outer_after, OUTER_AFTER);
    if (b.level > 0)
        conditions[count++] = behind(kds, b.outer_before, OUTER_BEFORE);
    return count;
}

/// The point is in the triangle, whose sides are those of the tiling.
bmr_error bmr_triangle_audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const bmr_point_state *state = bmr_point_look(kds);
    if (state->edge == BMR_NO_EDGE)
        return BMR_OK;
    if (state->edge >= bmr_hierarchy_edge_count(state->hierarchy))
        return BMR_ERROR_INVALID_STRUCTURE;
    const double slop = bmr_point_tolerance(kds);
    const bmr_edge outer = beyond_outer(kds, bmr_point_at(kds, b_in_a), outer_limit(kds) + slop);
    return outer == BMR_NO_EDGE ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

static const bmr_kds_class by_levels = {.state_bytes = sizeof(bmr_point_state),
                                        .prepare = bmr_point_prepare,
                                        .start = bmr_triangle_start,
                                        .conditions = bmr_triangle_conditions,
                                        .repair = bmr_triangle_repair,
                                        .proof = bmr_point_proof,
                                        .audit = bmr_triangle_audit};
/// The chains lie behind the state, unless the shape has them.
static const bmr_kds_class by_bisection = {.state_bytes = sizeof(bmr_chained_state),
                                           .extra_bytes = bmr_kds_chains_bytes,
                                           .prepare = bmr_kds_chains_prepare,
                                           .start = bmr_triangle_start,
                                           .conditions = bmr_triangle_conditions,
                                           .repair = bmr_triangle_repair,
                                           .proof = bmr_point_proof,
                                           .audit = bmr_triangle_audit};

BMR_KDS_INFO(triangle_levels_compass, "triangle-levels-compass",
             "point: active triangle, level by level, compass", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS, &by_levels);
BMR_KDS_INFO(triangle_levels_dudley, "triangle-levels-dudley",
             "point: active triangle, level by level, Dudley", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY, &by_levels);
BMR_KDS_INFO(triangle_binary_dudley, "triangle-binary-dudley",
             "point: active triangle, binary search, Dudley", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY, &by_bisection);
