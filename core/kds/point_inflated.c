// SPDX-License-Identifier: MIT
// The inflated structures for a point (section 6): one separating edge, chosen so that the point is beyond it
// by eps_j or more, j the least level whose inflated envelope has the point outside. Two ways to choose it:
//
// - the paper's: the edge of Q_j whose inflated copy the old line enters Q'_j through; each breakpoint is
//   computed when it is needed, in O(j), and j is searched from the old edge's level outwards;
// - the cell that the point is in, in the complex of triangles and trapezoids between the inflated envelopes
//   (point_complex.c).
//
// At the start, and where neither finds an edge, the edge of most slack on the level is taken, found on the
// way down along the closest direction.
//
// If the point is inside the last Q'_j, in the annulus around the polygon, no slack can be promised. Near the
// polygon the coarsest edge that separates is taken, of which a convex path needs one a level at most; that
// of most slack would fail at each edge of a polygon that the path comes geometrically nearer to. Where no
// edge separates: the closest direction.
//
// The paper's tuning remark (a richer root polygon, offsets that shrink more slowly: beta towards 1, kappa =
// 2 beta + 1 towards 3), measured on a regular 256-gon and a 4:1 ellipse, 60 motions, most slack: the least
// movement between events over the distance, where slack is promised, and the mean events on a circle around
// the polygon and on a wander.
//
//   root_level      0     0     0     2     2     2     4     4
//   offset_ratio  0.25   0.5   0.9   0.5   0.7   0.9   0.5   0.9
//   move / d      0.40  0.74  0.74  0.98  0.98  0.98 0.999 0.999
//   circle        19.9  19.6  20.1  20.0  19.9  19.9  20.0  20.0
//   wander        21.5  14.7  13.3  13.8  13.4  13.3  13.4  13.3
//
// The paper expects more events and work from it. Events do not grow on these motions; what a slower ratio
// costs is the annulus, which begins at eps of the last level: 0.9^depth of the diameter in place of
// 2^-depth.
#include "kds/point_inflated.h"

#include <math.h>

#include "hierarchy/tree.h"
#include "kds/registry.h"
#include "kds/windowed_line.h"

bmr_inflation bmr_point_inflation(const bmr_kds *kds) {
    const double diameter = bmr_inflation_diameter(bmr_hierarchy_polygon(bmr_point_view(kds)->hierarchy));
    return bmr_inflation_make(diameter, kds->def.alpha, kds->def.offset_ratio, kds->def.root_level);
}

double bmr_point_promised(const bmr_kds *kds, const bmr_inflation *inflation, uint32_t j) {
    const double offset = bmr_inflation_offset(inflation, j), least = bmr_point_tolerance(kds);
    return bmr_point_need(kds) - least + (offset > least ? offset : least);
}

/// Section 6, Dudley: an inflated Dudley hierarchy doubles beta.
/// Lemma 6.1: after an event P moves d/beta before the next, beta = 2 (1 + sqrt 2).
bmr_level_choice bmr_point_most_slack(bmr_kds *kds, bmr_vec2 x, bmr_vec2 u, unsigned *touched) {
    const bmr_hierarchy *h = bmr_point_view(kds)->hierarchy;
    const bmr_inflation inflation = bmr_point_inflation(kds);
    const uint32_t last = bmr_inflation_last(&inflation, h);
    bmr_level_choice choice = {BMR_NO_EDGE, 0, -INFINITY}, coarsest = choice;
    bmr_corner corner = bmr_tree_extreme(h, u, bmr_inflation_level(&inflation, h, 0), touched);
    for (uint32_t j = 0; j <= last; ++j) {
        corner = bmr_tree_refine(h, corner, u, bmr_inflation_level(&inflation, h, j), touched);
        ++*touched;
        choice.edge = bmr_corner_widest_edge(h, corner, x, &choice.slack);
        choice.j = j;
        if (choice.slack >= bmr_point_promised(kds, &inflation, j))
            return choice;
        if (coarsest.edge == BMR_NO_EDGE && choice.slack > bmr_point_need(kds))
            coarsest = choice;
    }
    const double below = bmr_coarse_below(&inflation, bmr_hierarchy_depth(h));
    if (coarsest.edge != BMR_NO_EDGE && choice.slack - kds->def.margin < below)
        choice = coarsest;
    choice.j = last + 1;
    return choice;
}

bool bmr_point_choose_by_slack(bmr_kds *kds, const bmr_pose *b_in_a, unsigned *touched) {
    bmr_vec2 u;
    if (!bmr_point_closest(kds, b_in_a, &u))
        return false;
    const bmr_level_choice choice = bmr_point_most_slack(kds, bmr_point_at(kds, b_in_a), u, touched);
    if (!(choice.slack > bmr_point_need(kds)))
        return bmr_point_take_free(kds, b_in_a);
    bmr_point_get(kds)->edge = choice.edge;
    return true;
}

/// The edge that the old line enters Q'_j through, if that has the point outside.
static bool enters(const bmr_kds *kds, uint32_t j, bmr_vec2 x, bmr_vec2 direction, bmr_edge *edge,
                   unsigned *touched) {
    const bmr_hierarchy *h = bmr_point_view(kds)->hierarchy;
    const bmr_inflation inflation = bmr_point_inflation(kds);
    const double promised = bmr_point_promised(kds, &inflation, j);
    const uint32_t level = bmr_inflation_level(&inflation, h, j);
    const bmr_entry entry = bmr_inflated_entry(h, level, promised, x, direction);
    *touched += 1 + entry.steps;
    if (!(entry.parameter > 0.0) || !(bmr_edge_slack(h, entry.edge, x) > bmr_point_need(kds)))
        return false;
    *edge = entry.edge;
    return true;
}

/// The paper's rule: from the point along the old edge's line to where that touches the polygon. False: the
/// point is there, or in the annulus.
static bool choose_by_old_line(bmr_kds *kds, bmr_vec2 x, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_hierarchy *h = state->hierarchy;
    if (state->edge == BMR_NO_EDGE)
        return false;
    const bmr_vec2 along = bmr_left(bmr_hierarchy_line(h, state->edge).normal);
    const bool after = bmr_point_is_after(h, state->edge, x);
    const bmr_vec2 direction = after ? bmr_neg(along) : along;
    const bmr_inflation inflation = bmr_point_inflation(kds);
    // The inflated envelopes are nested: outside one is outside all that follow. From the level of the old
    // edge outwards, in steps that double, and then by halves: O(log(levels passed + 1)) breakpoints.
    const uint32_t last = bmr_inflation_last(&inflation, h), level = bmr_hierarchy_level(h, state->edge),
                   old = level > inflation.root_level ? level - inflation.root_level : 0,
                   from = old < last ? old : last;
    bmr_edge found = BMR_NO_EDGE;
    uint32_t low = 0, high = from; // the answer is in [low, high], and `found` that of high
    if (enters(kds, from, x, direction, &found, touched)) {
        for (uint32_t step = 1; low < high; step *= 2) {
            const uint32_t probe = high - low > step ? high - step : low;
            if (!enters(kds, probe, x, direction, &found, touched)) {
                low = probe + 1;
                break;
            }
            high = probe;
        }
    } else {
        low = from + 1;
        for (uint32_t step = 1;; step *= 2) {
            if (low > last)
                return false;
            high = last - low > step - 1 ? low + (step - 1) : last;
            if (enters(kds, high, x, direction, &found, touched))
                break;
            low = high + 1;
        }
    }
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (enters(kds, middle, x, direction, &found, touched))
            high = middle;
        else
            low = middle + 1;
    }
    state->edge = found;
    return true;
}

bool bmr_point_inflated_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const bool apart = bmr_point_choose_by_slack(kds, &now->pose, &report->touched);
    report->level_after = apart ? bmr_point_level(kds) : 0;
    return apart;
}

bool bmr_point_inflated_fails(const bmr_kds *kds, bmr_vec2 x, bmr_kds_report *report) {
    report->level_before = report->level_after = bmr_point_level(kds);
    return !bmr_point_holds(kds, x);
}

bool bmr_point_inflated_done(const bmr_kds *kds, bool apart, bmr_kds_report *report) {
    report->line_changed = apart;
    report->level_after = apart ? bmr_point_level(kds) : report->level_before;
    report->kind = report->level_after > report->level_before ? BMR_KDS_STAB : BMR_KDS_PUSH;
    return apart;
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    const bmr_vec2 x = bmr_point_at(kds, &now->pose);
    if (!bmr_point_inflated_fails(kds, x, report))
        return true;
    const bool apart = choose_by_old_line(kds, x, &report->touched) ||
                       bmr_point_choose_by_slack(kds, &now->pose, &report->touched);
    return bmr_point_inflated_done(kds, apart, report);
}

static const bmr_kds_class by_old_line = {.state_bytes = sizeof(bmr_point_state),
                                          .prepare = bmr_point_prepare,
                                          .start = bmr_point_inflated_start,
                                          .conditions = bmr_point_conditions,
                                          .repair = repair,
                                          .proof = bmr_point_proof};
BMR_KDS_INFO(point_inflated_compass, "point-inflated-compass",
             "point: inflated, entry of the old line, compass", "6, breakpoints on the fly", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS, &by_old_line);
BMR_KDS_INFO(point_inflated_dudley, "point-inflated-dudley", "point: inflated, entry of the old line, Dudley",
             "6, breakpoints on the fly", BMR_KDS_POINT, BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY, &by_old_line);

// The inflated cell complex for a point (section 6): Q'_0 without Q as triangles and trapezoids. Between
// Q'_(j-1) and Q'_j each edge of Q_j has one cell: a trapezoid if it is an edge of Q_(j-1) too, and a
// triangle with its apex on the corner of Q'_(j-1) that it cut if it is new. The last layer is between the
// last inflated envelope and the polygon itself. Cells are not stored: a cell is an edge and a j, and its
// sides connect a corner with the corner it came from.

/// A walk from the edge of most slack passes a cell or two.
#define MOST_CELLS 64

/// How far the polygon between two layers is moved out: its eps and the margin; the polygon itself: the
/// margin.
static double layer_offset(const bmr_kds *kds, const bmr_inflation *inflation, uint32_t j) {
    const uint32_t last = bmr_inflation_last(inflation, bmr_point_view(kds)->hierarchy);
    return kds->def.margin + (j <= last ? bmr_inflation_offset(inflation, j) : 0.0);
}

bmr_connector bmr_point_complex_connector(const bmr_kds *kds, bmr_corner corner, uint32_t j) {
    const bmr_hierarchy *h = bmr_point_view(kds)->hierarchy;
    const bmr_inflation inflation = bmr_point_inflation(kds);
    const uint32_t level = bmr_inflation_level(&inflation, h, j);
    const uint32_t level_out = bmr_inflation_level(&inflation, h, j - 1);
    const bmr_corner origin = level > level_out ? bmr_hierarchy_coarsen(h, corner, level) : corner;
    const bmr_connector connector = {bmr_inflated_corner(h, corner, layer_offset(kds, &inflation, j)),
                                     bmr_inflated_corner(h, origin, layer_offset(kds, &inflation, j - 1))};
    return connector;
}

/// > 0: the point is counter-clockwise of the connector, looking outwards.
static double side(bmr_connector connector, bmr_vec2 x) {
    return bmr_cross(bmr_sub(connector.outer, connector.inner), bmr_sub(x, connector.inner));
}

/// Is the point nearer to the first end of an edge than to the second, along the edge?
static bool beyond_middle(bmr_vec2 first, bmr_vec2 second, bmr_vec2 x) {
    const bmr_vec2 middle = bmr_scale(0.5, bmr_add(first, second));
    return bmr_dot(bmr_sub(first, second), bmr_sub(x, middle)) > 0.0;
}

bmr_edge bmr_point_complex_cell(const bmr_kds *kds, bmr_edge from, uint32_t j, bmr_vec2 x,
                                unsigned *touched) {
    const bmr_hierarchy *h = bmr_point_view(kds)->hierarchy;
    const bmr_inflation inflation = bmr_point_inflation(kds);
    const uint32_t level = bmr_inflation_level(&inflation, h, j);
    bmr_edge edge = from;
    int sense = 0; // never back
    for (int cells = 0; cells < MOST_CELLS; ++cells) {
        ++*touched;
        const bmr_corner after = bmr_tree_corner_after(h, edge, level, touched);
        const bmr_corner before = bmr_tree_corner_before(h, edge, level, touched);
        const bmr_connector left = bmr_point_complex_connector(kds, after, j),
                            right = bmr_point_complex_connector(kds, before, j);
        bool on = sense >= 0 && side(left, x) > 0.0;
        const bool back = sense <= 0 && side(right, x) < 0.0;
        // Where the edge's ends turn by a right angle and more, a point can be beyond the lines of both
        // connectors.
        if (on && back)
            on = beyond_middle(left.inner, right.inner, x);
        if (on) {
            edge = after.after;
            sense = 1;
        } else if (back) {
            edge = before.before;
            sense = -1;
        } else {
            return edge;
        }
    }
    return from;
}

static bool repair_cell(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    const bmr_vec2 x = bmr_point_at(kds, &now->pose);
    if (!bmr_point_inflated_fails(kds, x, report))
        return true;
    bmr_vec2 u;
    if (!bmr_point_closest(kds, &now->pose, &u))
        return bmr_point_inflated_done(kds, false, report);
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_level_choice best = bmr_point_most_slack(kds, x, u, &report->touched);
    const bmr_inflation inflation = bmr_point_inflation(kds);
    // In the annulus a cell promises nothing.
    const bool promised = best.j > 0 && best.j <= bmr_inflation_last(&inflation, state->hierarchy);
    const bmr_edge cell =
        promised ? bmr_point_complex_cell(kds, best.edge, best.j, x, &report->touched) : best.edge;
    const double need = bmr_point_need(kds);
    bool apart = true;
    if (bmr_edge_slack(state->hierarchy, cell, x) > need)
        state->edge = cell;
    else if (best.slack > need)
        state->edge = best.edge;
    else
        apart = bmr_point_take_free(kds, &now->pose);
    return bmr_point_inflated_done(kds, apart, report);
}

static const bmr_kds_class by_cell = {.state_bytes = sizeof(bmr_point_state),
                                      .prepare = bmr_point_prepare,
                                      .start = bmr_point_inflated_start,
                                      .conditions = bmr_point_conditions,
                                      .repair = repair_cell,
                                      .proof = bmr_point_proof};

BMR_KDS_INFO(point_complex, "point-complex", "point: inflated cell complex, compass",
             "6, complex of triangles and trapezoids", BMR_KDS_POINT, BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS,
             &by_cell);
