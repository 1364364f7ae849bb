// SPDX-License-Identifier: MIT
#include "hierarchy/tree.h"

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
