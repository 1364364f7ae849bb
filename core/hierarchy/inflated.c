// SPDX-License-Identifier: MIT
#include "boomerang/inflated.h"

#include "hierarchy/tree.h"

/// Section 6, tuning: with richer roots and slower offsets beta nears 1 and kappa nears 3.
bmr_inflation bmr_inflation_make(double diameter, double alpha, double ratio, uint32_t root_level) {
    const bmr_inflation inflation = {alpha * diameter, ratio, root_level};
    return inflation;
}

double bmr_inflation_diameter(const bmr_polygon *polygon) {
    return 2.0 * polygon->radius;
}

double bmr_inflation_offset(const bmr_inflation *inflation, uint32_t j) {
    double offset = inflation->first, factor = inflation->ratio;
    for (; j > 0; j >>= 1) { // exact where the ratio is a power of two
        if (j & 1u)
            offset *= factor;
        factor *= factor;
    }
    return offset;
}

uint32_t bmr_inflation_level(const bmr_inflation *inflation, const bmr_hierarchy *hierarchy, uint32_t j) {
    const uint32_t last = bmr_inflation_last(inflation, hierarchy);
    return j < last ? inflation->root_level + j : bmr_hierarchy_depth(hierarchy);
}

uint32_t bmr_inflation_last(const bmr_inflation *inflation, const bmr_hierarchy *hierarchy) {
    const uint32_t depth = bmr_hierarchy_depth(hierarchy);
    return depth > inflation->root_level ? depth - inflation->root_level : 0;
}

double bmr_edge_slack(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 point) {
    const bmr_line line = bmr_hierarchy_line(hierarchy, edge);
    return bmr_dot(line.normal, point) - line.offset;
}

bmr_vec2 bmr_inflated_corner(const bmr_hierarchy *hierarchy, bmr_corner corner, double offset) {
    const bmr_vec2 a = bmr_hierarchy_line(hierarchy, corner.before).normal;
    const bmr_vec2 b = bmr_hierarchy_line(hierarchy, corner.after).normal;
    // <a, w> = <b, w> = 1 for w = (a + b) / (1 + <a, b>); adjacent normals are at most 90 degrees apart.
    const bmr_vec2 w = bmr_scale(1.0 / (1.0 + bmr_dot(a, b)), bmr_add(a, b));
    return bmr_add(bmr_hierarchy_corner_point(hierarchy, corner), bmr_scale(offset, w));
}

bmr_edge bmr_corner_widest_edge(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 point,
                                double *slack) {
    const double before = bmr_edge_slack(hierarchy, corner.before, point);
    const double after = bmr_edge_slack(hierarchy, corner.after, point);
    *slack = before >= after ? before : after;
    return before >= after ? corner.before : corner.after;
}

/// The parameter at which the line from `start` along `direction` crosses the inflated edge's line inwards;
/// -INFINITY where it does not. A line enters a convex polygon at the last of all edges' lines that it
/// crosses inwards.
static double crossing(const bmr_hierarchy *h, bmr_edge edge, double offset, bmr_vec2 start,
                       bmr_vec2 direction) {
    const bmr_line line = bmr_hierarchy_line(h, edge);
    const double rate = bmr_dot(line.normal, direction);
    return rate < 0.0 ? (line.offset + offset - bmr_dot(line.normal, start)) / rate : -INFINITY;
}

bmr_entry bmr_inflated_entry(const bmr_hierarchy *hierarchy, uint32_t level, double offset, bmr_vec2 start,
                             bmr_vec2 direction) {
    bmr_entry entry = {0, -INFINITY, 0};
    for (bmr_edge root = 0; root < BMR_ROOTS; ++root) {
        const double t = crossing(hierarchy, root, offset, start, direction);
        if (t > entry.parameter) {
            entry.edge = root;
            entry.parameter = t;
        }
    }
    // A level cuts the entered edge at both ends, and only these cuts can be entered instead.
    const bmr_node *nodes = hierarchy->nodes;
    uint64_t before = nodes[entry.edge].child_before, after = nodes[entry.edge].child_after;
    for (uint64_t i = 1; i <= level && (before != BMR_NO_CHILD || after != BMR_NO_CHILD); ++i) {
        ++entry.steps;
        const bool cut_before = before != BMR_NO_CHILD && nodes[before].level == i;
        const bool cut_after = after != BMR_NO_CHILD && nodes[after].level == i;
        const double t_before =
            cut_before ? crossing(hierarchy, (bmr_edge)before, offset, start, direction) : -INFINITY;
        const double t_after =
            cut_after ? crossing(hierarchy, (bmr_edge)after, offset, start, direction) : -INFINITY;
        if (t_before > entry.parameter || t_after > entry.parameter) {
            entry.edge = (bmr_edge)(t_before > t_after ? before : after);
            entry.parameter = fmax(t_before, t_after);
            before = nodes[entry.edge].child_before;
            after = nodes[entry.edge].child_after;
            continue;
        }
        if (cut_before)
            before = nodes[before].child_after;
        if (cut_after)
            after = nodes[after].child_before;
    }
    return entry;
}
