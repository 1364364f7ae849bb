// SPDX-License-Identifier: MIT
// The inflated cell complex for a point (section 6): Q'_0 without Q as triangles and trapezoids. Between
// Q'_(j-1) and Q'_j each edge of Q_j has one cell: a trapezoid if it is an edge of Q_(j-1) too, and a
// triangle with its apex on the corner of Q'_(j-1) that it cut if it is new. The last layer is between the
// last inflated envelope and the polygon itself. Cells are not stored: a cell is an edge and a j, and its
// sides connect a corner with the corner it came from.
#include "hierarchy/tree.h"
#include "kds/point_inflated.h"
#include "kds/registry.h"

/// A walk from the edge of most slack passes a cell or two.
#define MOST_CELLS 64

/// How far the polygon between two layers is moved out: its eps and the margin; the polygon itself: the
/// margin.
static double layer_offset(const bmr_kds *kds, const bmr_inflation *inflation, uint32_t j) {
    const uint32_t last = bmr_inflation_last(inflation, bmr_point_look(kds)->hierarchy);
    return kds->def.margin + (j <= last ? bmr_inflation_offset(inflation, j) : 0.0);
}

bmr_connector bmr_point_complex_connector(const bmr_kds *kds, bmr_corner corner, uint32_t j) {
    const bmr_hierarchy *h = bmr_point_look(kds)->hierarchy;
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
    const bmr_hierarchy *h = bmr_point_look(kds)->hierarchy;
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

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
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
                                      .repair = repair,
                                      .proof = bmr_point_proof};

BMR_KDS_INFO(point_complex, "point-complex", "point: inflated cell complex, compass",
             "6, complex of triangles and trapezoids", BMR_KDS_POINT, BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS,
             &by_cell);
