// SPDX-License-Identifier: MIT
#include "hierarchy/tree.h"

size_t bmr_hierarchy_bytes(const bmr_hierarchy *hierarchy) {
    return sizeof *hierarchy + hierarchy->count * sizeof(bmr_node) +
           hierarchy->direction_count * sizeof(bmr_vec2);
}

bmr_hierarchy_kind bmr_hierarchy_get_kind(const bmr_hierarchy *hierarchy) {
    return (bmr_hierarchy_kind)hierarchy->kind;
}

const bmr_polygon *bmr_hierarchy_polygon(const bmr_hierarchy *hierarchy) {
    return hierarchy->polygon;
}
uint32_t bmr_hierarchy_edge_count(const bmr_hierarchy *hierarchy) {
    return hierarchy->count;
}
uint32_t bmr_hierarchy_depth(const bmr_hierarchy *hierarchy) {
    return hierarchy->depth;
}

uint32_t bmr_hierarchy_level(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    return (uint32_t)hierarchy->nodes[edge].level;
}

uint32_t bmr_hierarchy_touch(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    return (uint32_t)hierarchy->nodes[edge].touch;
}

bmr_boomerang bmr_hierarchy_boomerang(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    const bmr_node *node = &hierarchy->nodes[edge];
    bmr_boomerang b;
    b.outer_before = (bmr_edge)node->outer_before;
    b.outer_after = (bmr_edge)node->outer_after;
    b.child_before = bmr_tree_link(node->child_before);
    b.child_after = bmr_tree_link(node->child_after);
    b.level = (uint32_t)node->level;
    return b;
}

bmr_corner bmr_hierarchy_corner(const bmr_hierarchy *hierarchy, bmr_edge before, bmr_edge after) {
    const bmr_node *a = &hierarchy->nodes[before], *b = &hierarchy->nodes[after];
    // The deeper edge cut the corner that the other one is an outer edge of, and knows what comes next on
    // that side. Of two roots, either knows.
    const uint64_t cut = a->level >= b->level ? a->child_after : b->child_before;
    const bmr_corner corner = {before, after, bmr_tree_link(cut)};
    return corner;
}

bmr_corner bmr_tree_corner_after(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level,
                                 unsigned *steps) {
    const bmr_node *nodes = hierarchy->nodes;
    uint64_t after = nodes[edge].outer_after, cut = nodes[edge].child_after;
    ++*steps;
    while (cut != BMR_NO_CHILD && nodes[cut].level <= level) {
        ++*steps;
        after = cut;
        cut = nodes[cut].child_before;
    }
    const bmr_corner corner = {edge, (bmr_edge)after, bmr_tree_link(cut)};
    return corner;
}

bmr_corner bmr_tree_corner_before(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level,
                                  unsigned *steps) {
    const bmr_node *nodes = hierarchy->nodes;
    uint64_t before = nodes[edge].outer_before, cut = nodes[edge].child_before;
    ++*steps;
    while (cut != BMR_NO_CHILD && nodes[cut].level <= level) {
        ++*steps;
        before = cut;
        cut = nodes[cut].child_after;
    }
    const bmr_corner corner = {(bmr_edge)before, edge, bmr_tree_link(cut)};
    return corner;
}

bmr_corner bmr_tree_refine(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 direction,
                           uint32_t to_level, unsigned *steps) {
    ++*steps;
    while (corner.cut != BMR_NO_EDGE) {
        const bmr_node *node = &hierarchy->nodes[corner.cut];
        if (node->level > to_level)
            break;
        ++*steps;
        // A tie goes to the corner after the cut, which has the tied edge as its `before`.
        if (bmr_cross(bmr_tree_normal(hierarchy, node), direction) >= 0.0) {
            corner.before = corner.cut;
            corner.cut = bmr_tree_link(node->child_after);
        } else {
            corner.after = corner.cut;
            corner.cut = bmr_tree_link(node->child_before);
        }
    }
    return corner;
}

bmr_corner bmr_tree_extreme(const bmr_hierarchy *hierarchy, bmr_vec2 direction, uint32_t level,
                            unsigned *steps) {
    const bmr_edge root = bmr_tree_quadrant(direction);
    const bmr_corner top = {root, (root + 1) % BMR_ROOTS, bmr_tree_link(hierarchy->nodes[root].child_after)};
    return bmr_tree_refine(hierarchy, top, direction, level, steps);
}

bmr_corner bmr_hierarchy_corner_after(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level) {
    unsigned unused = 0;
    return bmr_tree_corner_after(hierarchy, edge, level, &unused);
}

bmr_corner bmr_hierarchy_corner_before(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level) {
    unsigned unused = 0;
    return bmr_tree_corner_before(hierarchy, edge, level, &unused);
}

bmr_corner bmr_hierarchy_refine(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 direction,
                                uint32_t to_level) {
    unsigned unused = 0;
    return bmr_tree_refine(hierarchy, corner, direction, to_level, &unused);
}

/// Lemma 3.3(d): at distance s, compass envelopes of O(log(D/s)) edges are disjoint.
/// Lemma 3.4(d): at distance s, Dudley envelopes of O(log(D/s)) edges are disjoint.
bmr_corner bmr_hierarchy_extreme(const bmr_hierarchy *hierarchy, bmr_vec2 direction, uint32_t level) {
    unsigned unused = 0;
    return bmr_tree_extreme(hierarchy, direction, level, &unused);
}

bmr_corner bmr_hierarchy_coarsen(const bmr_hierarchy *hierarchy, bmr_corner corner, uint32_t level) {
    const bmr_node *a = &hierarchy->nodes[corner.before], *b = &hierarchy->nodes[corner.after];
    const bmr_edge deeper = a->level >= b->level ? corner.before : corner.after;
    const bmr_node *node = &hierarchy->nodes[deeper];
    if (node->level < level || node->level == 0)
        return corner; // it was there before
    const bmr_corner coarse = {(bmr_edge)node->outer_before, (bmr_edge)node->outer_after, deeper};
    return coarse;
}

bmr_line bmr_hierarchy_line(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    const bmr_polygon *p = hierarchy->polygon;
    const bmr_node *node = &hierarchy->nodes[edge];
    bmr_line line;
    line.normal =
        node->own ? bmr_polygon_normal(p, (uint32_t)node->touch) : hierarchy->directions[node->direction];
    line.offset = bmr_dot(line.normal, p->vertices[node->touch]);
    if (node->wide) // its normal is rounded: of the edge's two ends the one that lies farther out
        line.offset =
            fmax(line.offset, bmr_dot(line.normal, p->vertices[bmr_tree_last_touch(hierarchy, node)]));
    return line;
}

static bmr_vec2 tangent(const bmr_hierarchy *h, const bmr_node *node) {
    return bmr_left(bmr_tree_normal(h, node));
}

bmr_vec2 bmr_tree_meet(const bmr_hierarchy *h, const bmr_node *a, const bmr_node *b) {
    const uint32_t first = bmr_tree_last_touch(h, a), last = (uint32_t)b->touch;
    const bmr_vec2 p = h->polygon->vertices[first];
    if (first == last)
        return p;
    const bmr_vec2 ta = tangent(h, a), tb = tangent(h, b);
    const bmr_vec2 pq = bmr_sub(h->polygon->vertices[last], p);
    // X = p + s ta with (q - X) x tb = 0. Adjacent directions differ by more than BMR_MERGE_ANGLE, so the
    // divisor has at least five good digits; what s is off by shifts X along line a, and away from line b by
    // that angle's part of it only.
    const double s = bmr_cross(pq, tb) / bmr_cross(ta, tb);
    return s > 0.0 ? bmr_add(p, bmr_scale(s, ta)) : p;
}

bmr_vec2 bmr_hierarchy_corner_point(const bmr_hierarchy *hierarchy, bmr_corner corner) {
    return bmr_tree_meet(hierarchy, &hierarchy->nodes[corner.before], &hierarchy->nodes[corner.after]);
}

bmr_vec2 bmr_hierarchy_apex(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    if (edge < BMR_ROOTS)
        return bmr_vec2_make(0.0, 0.0);
    const bmr_node *node = &hierarchy->nodes[edge];
    return bmr_tree_meet(hierarchy, &hierarchy->nodes[node->outer_before],
                         &hierarchy->nodes[node->outer_after]);
}

/// Lemma 3.1: in one level O(sqrt(D/s)) boomerangs are at least s high.
double bmr_hierarchy_height(const bmr_hierarchy *hierarchy, bmr_edge edge) {
    if (edge < BMR_ROOTS)
        return 0.0;
    const bmr_polygon *p = hierarchy->polygon;
    const bmr_node *nodes = hierarchy->nodes, *node = &nodes[edge];
    const uint32_t first = bmr_tree_last_touch(hierarchy, &nodes[node->outer_before]);
    const uint32_t last = (uint32_t)nodes[node->outer_after].touch;
    const bmr_vec2 apex = bmr_hierarchy_apex(hierarchy, edge);
    // The apex sees the whole chain. "It projects past the end of edge i" holds for the edges before the
    // nearest point, and for none after it.
    uint32_t low = 0, high = last >= first ? last - first : last + p->count - first;
    const uint32_t edges = high;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const uint32_t i = (first + middle) % p->count;
        const bmr_vec2 end = p->vertices[i + 1 < p->count ? i + 1 : 0];
        if (bmr_tree_beyond(p, i, bmr_sub(apex, end)))
            low = middle + 1;
        else
            high = middle;
    }
    const uint32_t i = first + low < p->count ? first + low : first + low - p->count;
    const bmr_vec2 r = bmr_sub(apex, p->vertices[i]);
    if (low < edges && bmr_tree_beyond(p, i, r))
        return fabs(bmr_dot(bmr_polygon_normal(p, i), r));
    return hypot(r.x, r.y);
}
