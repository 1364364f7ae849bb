// SPDX-License-Identifier: MIT
#include "outline/status.h"

#include "geometry/predicates.h"

#define NONE BMR_OUTLINE_NONE

/// On which side of a strand the point is: 1 above, 0 on its line, -1 below.
static int side_of(const bmr_status *s, uint32_t strand, bmr_vec2 point) {
    const bmr_strand *t = &s->strands[strand];
    return bmr_orientation(s->points[t->left], s->points[t->right], point);
}

/// Strands of which the point's side is at least `side` go to *below, the others to *above.
static void split(bmr_status *s, uint32_t tree, bmr_vec2 point, int side, uint32_t *below, uint32_t *above) {
    // Goes down one path, and hangs what it comes by to the open ends of the two trees.
    while (tree != NONE) {
        bmr_strand *t = &s->strands[tree];
        if (side_of(s, tree, point) >= side) {
            *below = tree;
            below = &t->upper;
            tree = t->upper;
        } else {
            *above = tree;
            above = &t->lower;
            tree = t->lower;
        }
    }
    *below = *above = NONE;
}

bmr_status_parts bmr_status_split(bmr_status *status, bmr_vec2 point) {
    bmr_status_parts parts;
    uint32_t rest;
    split(status, status->root, point, 1, &parts.below, &rest);
    split(status, rest, point, 0, &parts.through, &parts.above);
    return parts;
}

uint32_t bmr_status_top(const bmr_status *status, uint32_t tree) {
    while (tree != NONE && status->strands[tree].upper != NONE)
        tree = status->strands[tree].upper;
    return tree;
}

uint32_t bmr_status_bottom(const bmr_status *status, uint32_t tree) {
    while (tree != NONE && status->strands[tree].lower != NONE)
        tree = status->strands[tree].lower;
    return tree;
}

/// As deep as the tree: O(log n) expected.
uint32_t bmr_status_list(const bmr_status *status, uint32_t tree, uint32_t *list) {
    if (tree == NONE)
        return 0;
    uint32_t count = bmr_status_list(status, status->strands[tree].lower, list);
    list[count++] = tree;
    return count + bmr_status_list(status, status->strands[tree].upper, list + count);
}

static uint32_t merge(bmr_status *s, uint32_t below, uint32_t above) {
    uint32_t root = NONE, *end = &root;
    while (below != NONE && above != NONE) {
        if (s->strands[below].priority >= s->strands[above].priority) {
            *end = below;
            end = &s->strands[below].upper;
            below = *end;
        } else {
            *end = above;
            end = &s->strands[above].lower;
            above = *end;
        }
    }
    *end = below != NONE ? below : above;
    return root;
}

/// Mixes the bits of a number; the constants are those of a 32-bit finalizer known to change every bit.
static uint32_t mixed(uint32_t x) {
    x = (x ^ x >> 16) * UINT32_C(0x7feb352d);
    x = (x ^ x >> 15) * UINT32_C(0x846ca68b);
    return x ^ x >> 16;
}

void bmr_status_join(bmr_status *status, uint32_t below, const uint32_t *strands, uint32_t count,
                     uint32_t above) {
    for (uint32_t i = 0; i < count; ++i) {
        bmr_strand *t = &status->strands[strands[i]];
        t->lower = t->upper = NONE;
        t->priority = mixed(strands[i]);
        below = merge(status, below, strands[i]);
    }
    status->root = merge(status, below, above);
}
