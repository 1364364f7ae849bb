// SPDX-License-Identifier: MIT
#include <stdbool.h>

#include "hierarchy/builder.h"

/// What rounding may do to a support value or a meeting point, as a multiple of the largest coordinate: some
/// ten roundings of 1.1e-16 each, and the same again.
#define AUDIT_ROUNDING 4e-15
/// The builder merged directions that agree within BMR_MERGE_ANGLE. It compared normals that are each rounded
/// to 1e-16, and so do the checks here.
#define AUDIT_MERGE_ANGLE (BMR_MERGE_ANGLE + 4e-16)

/// One audit: the tree and the length that counts as rounding.
typedef struct audit {
    const bmr_hierarchy *h;
    double rounding;
} audit;

static bool is_linked(const bmr_hierarchy *h, bmr_edge id) {
    const bmr_node *nodes = h->nodes, *node = &nodes[id];
    if (node->outer_before >= h->count || node->outer_after >= h->count || node->child_before >= h->count ||
        node->child_after >= h->count || node->touch >= h->polygon->count || node->level > h->depth)
        return false;
    if (id < BMR_ROOTS)
        return node->level == 0 && node->outer_before == (id + 3) % BMR_ROOTS &&
               node->outer_after == (id + 1) % BMR_ROOTS;
    // The deeper outer edge is the parent. As levels rise by one from parent to child, there is no cycle, and
    // every node hangs on a root.
    const bmr_node *before = &nodes[node->outer_before], *after = &nodes[node->outer_after];
    const uint64_t level = before->level > after->level ? before->level : after->level;
    if (node->level != level + 1 || (before->level == after->level && level > 0))
        return false;
    const bool by_before = before->level == level && before->child_after == id;
    const bool by_after = after->level == level && after->child_before == id;
    return level == 0 ? by_before && by_after : by_before != by_after;
}

static bool children_agree(const bmr_hierarchy *h, bmr_edge id) {
    const bmr_node *nodes = h->nodes, *node = &nodes[id];
    const uint64_t b = node->child_before, a = node->child_after;
    if (b != BMR_NO_CHILD && (nodes[b].outer_after != id || nodes[b].outer_before != node->outer_before))
        return false;
    return a == BMR_NO_CHILD || (nodes[a].outer_before == id && nodes[a].outer_after == node->outer_after);
}

/// The line is a support line: the touch vertices are on it, and neither neighbour is beyond it. For a convex
/// polygon that is as good as looking at all vertices.
static bool is_support_line(const audit *a, bmr_edge id) {
    const bmr_hierarchy *h = a->h;
    const bmr_polygon *p = h->polygon;
    const bmr_node *node = &h->nodes[id];
    if (!node->own && h->direction_count > 0 && node->direction >= h->direction_count)
        return false;
    const bmr_line line = bmr_hierarchy_line(h, id);
    const uint32_t first = (uint32_t)node->touch, last = bmr_tree_last_touch(h, node);
    const uint32_t before = first > 0 ? first - 1 : p->count - 1, after = last + 1 < p->count ? last + 1 : 0;
    const double on_first = bmr_dot(line.normal, p->vertices[first]) - line.offset;
    const double on_last = bmr_dot(line.normal, p->vertices[last]) - line.offset;
    return fabs(bmr_dot(line.normal, line.normal) - 1.0) <= AUDIT_ROUNDING && fabs(on_first) <= a->rounding &&
           fabs(on_last) <= a->rounding &&
           bmr_dot(line.normal, p->vertices[before]) - line.offset <= a->rounding &&
           bmr_dot(line.normal, p->vertices[after]) - line.offset <= a->rounding;
}

/// How many levels of a compass are cut by direction.
static uint32_t compass_levels(const bmr_hierarchy *h) {
    const uint32_t log = bmr_ceil_log2(h->polygon->count);
    return log > h->corner_levels ? log : h->corner_levels;
}

/// An edge of the upper levels of a compass is the bisector of its outer edges.
static bool is_bisector(const bmr_hierarchy *h, bmr_edge id) {
    const bmr_node *node = &h->nodes[id];
    if (h->kind != BMR_HIERARCHY_COMPASS || node->level == 0 || node->level > compass_levels(h))
        return true;
    const bmr_vec2 n = bmr_hierarchy_line(h, id).normal;
    const bmr_vec2 before = bmr_hierarchy_line(h, (bmr_edge)node->outer_before).normal;
    const bmr_vec2 after = bmr_hierarchy_line(h, (bmr_edge)node->outer_after).normal;
    return fabs(bmr_cross(before, n) - bmr_cross(n, after)) <= AUDIT_ROUNDING;
}

static bool same_corner(bmr_corner a, bmr_corner b) {
    return a.before == b.before && a.after == b.after && a.cut == b.cut;
}

static bool is_within(const audit *a, bmr_edge edge, bmr_vec2 point) {
    const bmr_line line = bmr_hierarchy_line(a->h, edge);
    return bmr_dot(line.normal, point) - line.offset <= a->rounding;
}

static bool is_on(const audit *a, bmr_edge edge, bmr_vec2 point) {
    const bmr_line line = bmr_hierarchy_line(a->h, edge);
    return fabs(bmr_dot(line.normal, point) - line.offset) <= a->rounding;
}

/// Checks one corner of one envelope: both its edges lead to it, it is convex, its point is on both lines,
/// the search for the extreme corner finds it in its own directions, and it lies inside of the envelope of
/// the level above.
static bool is_corner(const audit *a, bmr_corner corner, uint32_t level) {
    const bmr_hierarchy *h = a->h;
    if (!same_corner(corner, bmr_hierarchy_corner_before(h, corner.after, level)) ||
        !same_corner(corner, bmr_hierarchy_corner(h, corner.before, corner.after)))
        return false;
    const bmr_vec2 before = bmr_hierarchy_line(h, corner.before).normal;
    const bmr_vec2 after = bmr_hierarchy_line(h, corner.after).normal;
    if (!(bmr_cross(before, after) > 0.5 * BMR_MERGE_ANGLE))
        return false;
    const bmr_vec2 point = bmr_hierarchy_corner_point(h, corner);
    if (!is_on(a, corner.before, point) || !is_on(a, corner.after, point))
        return false;
    const bmr_vec2 middle = bmr_add(before, after);
    if (!same_corner(corner, bmr_hierarchy_extreme(h, middle, level)) ||
        !same_corner(corner, bmr_hierarchy_extreme(h, bmr_tree_normal(h, &h->nodes[corner.before]), level)))
        return false;
    if (level == 0)
        return true;
    const bmr_corner coarse = bmr_hierarchy_coarsen(h, corner, level);
    return same_corner(coarse, bmr_hierarchy_extreme(h, middle, level - 1)) &&
           same_corner(corner, bmr_hierarchy_refine(h, coarse, middle, level)) &&
           is_within(a, coarse.before, point) && is_within(a, coarse.after, point);
}

/// Checks a corner of the deepest level: nothing is left to cut. Either the corner is a vertex of the
/// polygon, or each of the polygon's edges between its two lines has the direction of one of them, up to
/// merging.
static bool is_finished(const bmr_hierarchy *h, bmr_corner corner) {
    const bmr_polygon *p = h->polygon;
    const bmr_vec2 before = bmr_hierarchy_line(h, corner.before).normal;
    const bmr_vec2 after = bmr_hierarchy_line(h, corner.after).normal;
    uint32_t i = bmr_tree_last_touch(h, &h->nodes[corner.before]);
    for (; i != h->nodes[corner.after].touch; i = i + 1 < p->count ? i + 1 : 0) {
        const bmr_vec2 n = bmr_polygon_normal(p, i);
        if (!(bmr_cross(before, n) <= AUDIT_MERGE_ANGLE || bmr_cross(n, after) <= AUDIT_MERGE_ANGLE))
            return false;
    }
    return corner.cut == BMR_NO_EDGE;
}

/// Walks once round P_level: all its edges, one turn in all.
static bool is_envelope(const audit *a, uint32_t level) {
    const bmr_hierarchy *h = a->h;
    uint32_t expected = 0;
    for (bmr_edge id = 0; id < h->count; ++id)
        expected += h->nodes[id].level <= level;
    uint32_t edges = 0, turns = 0;
    bmr_edge edge = 0;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(h, edge, level);
        if (edges++ == expected || !is_corner(a, corner, level) ||
            (level == h->depth && !is_finished(h, corner)))
            return false;
        turns += bmr_tree_quadrant(bmr_hierarchy_line(h, corner.after).normal) <
                 bmr_tree_quadrant(bmr_hierarchy_line(h, corner.before).normal);
        edge = corner.after;
    } while (edge != 0);
    return edges == expected && turns == 1;
}

bmr_error bmr_hierarchy_audit(const bmr_hierarchy *hierarchy) {
    if (!hierarchy)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_error error = bmr_polygon_audit(hierarchy->polygon);
    if (error != BMR_OK)
        return error;
    if (hierarchy->stamp != hierarchy->polygon->stamp || hierarchy->count < BMR_ROOTS ||
        hierarchy->kind >= BMR_HIERARCHY_KIND_COUNT || hierarchy->depth > bmr_tree_most_levels(hierarchy) ||
        hierarchy->count > bmr_tree_most_edges(hierarchy))
        return BMR_ERROR_INVALID_STRUCTURE;
    const audit a = {hierarchy, AUDIT_ROUNDING * hierarchy->polygon->extent};
    uint32_t deepest = 0;
    for (bmr_edge id = 0; id < hierarchy->count; ++id)
        if (!is_linked(hierarchy, id))
            return BMR_ERROR_INVALID_STRUCTURE;
    for (bmr_edge id = 0; id < hierarchy->count; ++id) {
        if (!(id < BMR_ROOTS || children_agree(hierarchy, id)) || !is_support_line(&a, id) ||
            !is_bisector(hierarchy, id))
            return BMR_ERROR_INVALID_STRUCTURE;
        if (hierarchy->nodes[id].level > deepest)
            deepest = (uint32_t)hierarchy->nodes[id].level;
    }
    if (deepest != hierarchy->depth)
        return BMR_ERROR_INVALID_STRUCTURE;
    for (uint32_t level = 0; level <= deepest; ++level)
        if (!is_envelope(&a, level))
            return BMR_ERROR_INVALID_STRUCTURE;
    return BMR_OK;
}
