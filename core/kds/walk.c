// SPDX-License-Identifier: MIT
#include "kds/walk.h"

#include <math.h>

uint32_t bmr_walk_side_level(const bmr_hierarchy *hierarchy, int level) {
    const uint32_t depth = bmr_hierarchy_depth(hierarchy);
    return (uint32_t)level < depth ? (uint32_t)level : depth;
}

int bmr_walk_deepest(const bmr_hierarchy *const hierarchies[2]) {
    const uint32_t a = bmr_hierarchy_depth(hierarchies[0]), b = bmr_hierarchy_depth(hierarchies[1]);
    return (int)(a > b ? a : b);
}

bmr_vec2 bmr_walk_normal(const bmr_walk *walk, int side, bmr_edge edge) {
    const bmr_vec2 normal = bmr_hierarchy_line(walk->hierarchies[side], edge).normal;
    return side == 0 ? normal : bmr_neg(bmr_rotate(walk->pose, normal));
}

bmr_vec2 bmr_walk_point(const bmr_walk *walk, int side, bmr_corner corner) {
    const bmr_vec2 point = bmr_hierarchy_corner_point(walk->hierarchies[side], corner);
    return side == 0 ? point : bmr_transform(walk->pose, point);
}

/// The walk's direction as a body sees it in whose frame it is extreme: away from the body.
static bmr_vec2 outward(const bmr_walk *walk, int side) {
    return side == 0 ? walk->direction : bmr_unrotate(walk->pose, bmr_neg(walk->direction));
}

void bmr_walk_start(bmr_walk *walk, bmr_vec2 direction, int level) {
    walk->direction = direction;
    walk->level = level;
    for (int side = 0; side < 2; ++side) {
        const bmr_hierarchy *h = walk->hierarchies[side];
        walk->corner[side] = bmr_hierarchy_extreme(h, outward(walk, side), bmr_walk_side_level(h, level));
    }
}

void bmr_walk_resume(bmr_walk *walk, int owner, bmr_edge edge, bmr_corner other, int level) {
    const bmr_hierarchy *h = walk->hierarchies[owner];
    walk->direction = bmr_walk_normal(walk, owner, edge);
    walk->level = level;
    walk->corner[owner] = bmr_hierarchy_corner_after(h, edge, bmr_walk_side_level(h, level));
    walk->corner[1 - owner] = other;
}

void bmr_walk_refine(bmr_walk *walk) {
    ++walk->level;
    for (int side = 0; side < 2; ++side)
        walk->corner[side] = bmr_hierarchy_refine(walk->hierarchies[side], walk->corner[side],
                                                  outward(walk, side), (uint32_t)walk->level);
}

void bmr_walk_coarsen(bmr_walk *walk, const bmr_candidate *candidate) {
    walk->direction = candidate->direction;
    for (int side = 0; side < 2; ++side) {
        const bmr_hierarchy *h = walk->hierarchies[side];
        walk->corner[side] = candidate->corner[side];
        if ((uint32_t)walk->level <= bmr_hierarchy_depth(h))
            walk->corner[side] = bmr_hierarchy_coarsen(h, walk->corner[side], (uint32_t)walk->level);
    }
    --walk->level;
}

/// The points of the walk's corners, in A's frame.
typedef struct footing {
    bmr_vec2 point[2];
} footing;

/// The vector from A's corner to B's: F is its product with the direction, and the direction's uphill side is
/// its own.
static inline bmr_vec2 apart(const footing *f) {
    return bmr_sub(f->point[1], f->point[0]);
}

/// The first candidate that is met when the direction turns in `sense`, and the end of the stretch whose
/// corners the walk stands on.
static bmr_candidate next_candidate(const bmr_walk *walk, const footing *f, int sense) {
    bmr_edge edge[2];
    bmr_vec2 normal[2];
    for (int side = 0; side < 2; ++side) {
        edge[side] = sense > 0 ? walk->corner[side].after : walk->corner[side].before;
        normal[side] = bmr_walk_normal(walk, side, edge[side]);
    }
    // Both are within a right angle ahead (or behind by rounding, which counts as here).
    const int side = bmr_cross(normal[0], normal[1]) * sense >= 0.0 ? 0 : 1;
    const bmr_candidate c = {
        bmr_dot(normal[side], apart(f)), side, edge[side], normal[side], {walk->corner[0], walk->corner[1]}};
    return c;
}

/// Passes a candidate: its owner's corner is now the edge's other end.
static void pass(bmr_walk *walk, footing *f, const bmr_candidate *c, int sense) {
    const bmr_hierarchy *h = walk->hierarchies[c->owner];
    const uint32_t level = bmr_walk_side_level(h, walk->level);
    walk->corner[c->owner] = sense > 0 ? bmr_hierarchy_corner_after(h, c->edge, level)
                                       : bmr_hierarchy_corner_before(h, c->edge, level);
    f->point[c->owner] = bmr_walk_point(walk, c->owner, walk->corner[c->owner]);
    walk->direction = c->direction;
}

bool bmr_walk_climb(bmr_walk *walk, bmr_candidate *best) {
    footing f = {{bmr_walk_point(walk, 0, walk->corner[0]), bmr_walk_point(walk, 1, walk->corner[1])}};
    const int sense = bmr_cross(walk->direction, apart(&f)) > 0.0 ? 1 : -1;
    // The top may be between the first candidate ahead and the one behind.
    *best = next_candidate(walk, &f, -sense);
    for (int i = 0; i < BMR_WALK_STEPS; ++i) {
        const bmr_candidate ahead = next_candidate(walk, &f, sense);
        if (ahead.gap > best->gap)
            *best = ahead;
        pass(walk, &f, &ahead, sense);
        if (!(bmr_cross(walk->direction, apart(&f)) * sense > 0.0))
            return true; // downhill from here
    }
    return false;
}
