// SPDX-License-Identifier: MIT
// The lazy structure for a point (section 5): one separating edge, replaced only when the point crosses its
// line. A push goes to the outer edge that the point is beyond, a stab to the first of the edges that cut
// this one.
#include "hierarchy/tree.h"
#include "kds/point.h"
#include "kds/registry.h"

/// The coarsest edge that separates, in the neighbourhood of the closest direction on each level.
static bool from_closest(bmr_kds *kds, const bmr_pose *b_in_a, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_hierarchy *h = state->hierarchy;
    bmr_vec2 u;
    if (!bmr_point_closest(kds, b_in_a, &u))
        return false;
    const bmr_vec2 x = bmr_point_at(kds, b_in_a);
    bmr_corner corner = bmr_tree_extreme(h, u, 0, touched);
    for (uint32_t level = 0; level <= bmr_hierarchy_depth(h); ++level) {
        corner = bmr_tree_refine(h, corner, u, level, touched);
        ++*touched;
        double slack;
        const bmr_edge edge = bmr_corner_widest_edge(h, corner, x, &slack);
        if (slack > bmr_point_need(kds)) {
            state->edge = edge;
            return true;
        }
    }
    return bmr_point_take_free(kds, b_in_a);
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const bool apart = from_closest(kds, &now->pose, &report->touched);
    report->level_after = apart ? bmr_point_level(kds) : 0;
    return apart;
}

/// The outer edge, or of a root the neighbour, that the point is beyond.
static bmr_edge push(const bmr_kds *kds, bmr_vec2 x) {
    const bmr_point_state *state = bmr_point_view(kds);
    const bmr_boomerang b = bmr_hierarchy_boomerang(state->hierarchy, state->edge);
    const double before = bmr_edge_slack(state->hierarchy, b.outer_before, x);
    const double after = bmr_edge_slack(state->hierarchy, b.outer_after, x);
    if (!((before > after ? before : after) > bmr_point_need(kds)))
        return BMR_NO_EDGE;
    return before > after ? b.outer_before : b.outer_after;
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_vec2 x = bmr_point_at(kds, &now->pose);
    report->level_before = report->level_after = bmr_point_level(kds);
    if (bmr_point_holds(kds, x))
        return true;
    report->kind = BMR_KDS_PUSH;
    report->line_changed = true;
    bmr_edge next = BMR_NO_EDGE;
    if (state->edge != BMR_NO_EDGE) {
        ++report->touched;
        next = push(kds, x);
        if (next == BMR_NO_EDGE) {
            report->kind = BMR_KDS_STAB;
            next = bmr_point_descend(state->hierarchy, state->edge, x, bmr_point_need(kds), &report->touched);
        }
    }
    if (next != BMR_NO_EDGE)
        state->edge = next;
    else if (!from_closest(kds, &now->pose, &report->touched))
        return false;
    report->level_after = bmr_point_level(kds);
    return true;
}

static const bmr_kds_class lazy = {.state_bytes = sizeof(bmr_point_state),
                                   .prepare = bmr_point_prepare,
                                   .start = start,
                                   .conditions = bmr_point_conditions,
                                   .repair = repair,
                                   .proof = bmr_point_proof};

BMR_KDS_INFO(point_lazy_dudley, "point-lazy-dudley", "point: separating edge, Dudley",
             "5, one point, one polygon (lazy)", BMR_KDS_POINT, BMR_KDS_RECOMMENDED, BMR_HIERARCHY_DUDLEY,
             &lazy);
