// SPDX-License-Identifier: MIT
#include "certificate/walk.h"

#include <math.h>

#include "hierarchy/tree.h"

uint32_t bmr_walk_side_level(const bmr_hierarchy *hierarchy, int level) {
    const uint32_t depth = bmr_hierarchy_depth(hierarchy);
    return (uint32_t)level < depth ? (uint32_t)level : depth;
}

int bmr_walk_deepest(const bmr_hierarchy *const hierarchies[2]) {
    const uint32_t a = bmr_hierarchy_depth(hierarchies[0]), b = bmr_hierarchy_depth(hierarchies[1]);
    return (int)(a > b ? a : b);
}

/// The normal of an edge, in A's frame, from A to B.
static bmr_vec2 normal_of(const bmr_walk *walk, int side, bmr_edge edge) {
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
        walk->corner[side] =
            bmr_tree_extreme(h, outward(walk, side), bmr_walk_side_level(h, level), &walk->steps);
    }
}

/// Puts the walk on the normal of an edge that is on `level`, facing the other body's corner, which is
/// extreme there.
static void resume(bmr_walk *walk, int owner, bmr_edge edge, bmr_corner other, int level) {
    const bmr_hierarchy *h = walk->hierarchies[owner];
    walk->direction = normal_of(walk, owner, edge);
    walk->level = level;
    walk->corner[owner] = bmr_tree_corner_after(h, edge, bmr_walk_side_level(h, level), &walk->steps);
    walk->corner[1 - owner] = other;
}

void bmr_walk_refine(bmr_walk *walk) {
    ++walk->level;
    for (int side = 0; side < 2; ++side)
        walk->corner[side] = bmr_tree_refine(walk->hierarchies[side], walk->corner[side], outward(walk, side),
                                             (uint32_t)walk->level, &walk->steps);
}

/// From a candidate of the walk's level back to the level above, at the same direction. O(1).
static void coarsen(bmr_walk *walk, const bmr_candidate *candidate) {
    walk->direction = candidate->direction;
    for (int side = 0; side < 2; ++side) {
        const bmr_hierarchy *h = walk->hierarchies[side];
        walk->corner[side] = candidate->corner[side];
        ++walk->steps;
        if ((uint32_t)walk->level <= bmr_hierarchy_depth(h))
            walk->corner[side] = bmr_hierarchy_coarsen(h, walk->corner[side], (uint32_t)walk->level);
    }
    --walk->level;
}

/// The corners where the walk stands and the next edges, all in A's frame.
typedef struct surroundings {
    bmr_vec2 point[2];  ///< of the corners
    bmr_edge edge[2];   ///< the next edge of either body when the direction turns on
    bmr_vec2 normal[2]; ///< the directions in which these are reached
} surroundings;

static void see_next_edge(const bmr_walk *walk, surroundings *o, int side, int sense) {
    o->edge[side] = sense > 0 ? walk->corner[side].after : walk->corner[side].before;
    o->normal[side] = normal_of(walk, side, o->edge[side]);
}

/// The vector from A's corner to B's: F is its product with the direction, and uphill is the side it points
/// to.
static inline bmr_vec2 apart(const surroundings *o) {
    return bmr_sub(o->point[1], o->point[0]);
}

/// The first candidate that is met when the direction turns in `sense`: the end of the stretch of directions
/// that have the corners of the walk for their extremes.
static bmr_candidate next_candidate(const bmr_walk *walk, const surroundings *o, int sense) {
    // Both are within a right angle ahead (or behind by rounding, which counts as here).
    const int side = bmr_cross(o->normal[0], o->normal[1]) * sense >= 0.0 ? 0 : 1;
    const bmr_candidate c = {bmr_dot(o->normal[side], apart(o)),
                             side,
                             o->edge[side],
                             o->normal[side],
                             {walk->corner[0], walk->corner[1]}};
    return c;
}

/// Passes a candidate: its owner's corner is now the edge's other end.
static void pass(bmr_walk *walk, surroundings *o, int side, int sense) {
    const bmr_hierarchy *h = walk->hierarchies[side];
    const uint32_t level = bmr_walk_side_level(h, walk->level);
    walk->corner[side] = sense > 0 ? bmr_tree_corner_after(h, o->edge[side], level, &walk->steps)
                                   : bmr_tree_corner_before(h, o->edge[side], level, &walk->steps);
    walk->direction = o->normal[side];
    o->point[side] = bmr_walk_point(walk, side, walk->corner[side]);
}

/// The candidate behind the first stretch, as seen from the corners where the walk began.
static bmr_candidate behind(bmr_walk start, const surroundings *first, int sense) {
    surroundings o = *first;
    for (int side = 0; side < 2; ++side)
        see_next_edge(&start, &o, side, -sense);
    return next_candidate(&start, &o, -sense);
}

/// bmr_walk_climb, but it ends at the first candidate of a larger gap than `enough`.
static bool climb_until(bmr_walk *walk, double enough, bmr_candidate *best) {
    const bmr_walk start = *walk;
    surroundings o;
    for (int side = 0; side < 2; ++side)
        o.point[side] = bmr_walk_point(walk, side, walk->corner[side]);
    const int sense = bmr_cross(walk->direction, apart(&o)) > 0.0 ? 1 : -1;
    for (int side = 0; side < 2; ++side)
        see_next_edge(walk, &o, side, sense);
    const surroundings first = o;
    best->gap = -INFINITY;
    for (int i = 0; i < BMR_WALK_STEPS; ++i) {
        const bmr_candidate ahead = next_candidate(walk, &o, sense);
        if (i == 0 || ahead.gap > best->gap)
            *best = ahead;
        ++walk->steps;
        if (best->gap > enough)
            return true;
        pass(walk, &o, ahead.owner, sense);
        if (!(bmr_cross(walk->direction, apart(&o)) * sense > 0.0)) { // downhill from here
            // Then the top may be on the first stretch, and the better of its ends the one behind.
            const bmr_candidate other = i == 0 ? behind(start, &first, sense) : ahead;
            if (other.gap > best->gap)
                *best = other;
            return true;
        }
        see_next_edge(walk, &o, ahead.owner, sense);
    }
    return false;
}

bool bmr_walk_climb(bmr_walk *walk, bmr_candidate *best) {
    return climb_until(walk, INFINITY, best);
}

void bmr_walk_ascend(bmr_walk *walk, bmr_candidate candidate, double need, double reach, bmr_walk_take *take,
                     void *context) {
    const int from = walk->level;
    int level = from;
    while (level > 0) {
        bmr_candidate coarser;
        coarsen(walk, &candidate);
        const double enough = fmax(reach, need + BMR_COARSEN_PART * (candidate.gap - need));
        climb_until(walk, enough, &coarser);
        if (!(coarser.gap > enough) || !take(context, &coarser, level - 1))
            break;
        candidate = coarser;
        --level;
    }
    if (level == from)
        return;
    resume(walk, candidate.owner, candidate.edge, candidate.corner[1 - candidate.owner], level);
    bmr_candidate best;
    bmr_walk_climb(walk, &best);
    if (best.gap > candidate.gap)
        take(context, &best, level);
}

// ---- the lazy structure ----

/// Climbs the walk's level, and on to deeper ones until one separates.
static bool descend(bmr_lazy *lazy) {
    const int deepest = bmr_walk_deepest(lazy->walk.hierarchies);
    for (;;) {
        const bool top = bmr_walk_climb(&lazy->walk, &lazy->found);
        if (lazy->found.gap > lazy->reach && lazy->take(lazy->context, &lazy->found, lazy->walk.level))
            return true;
        if (!top || lazy->walk.level >= deepest)
            return false;
        bmr_walk_refine(&lazy->walk);
    }
}

bool bmr_lazy_start(bmr_lazy *lazy, bmr_vec2 direction, int level) {
    bmr_walk_start(&lazy->walk, direction, level);
    return descend(lazy);
}

/// The edge stays, the corner becomes the one that is extreme now.
static bmr_candidate rolled(bmr_lazy *lazy, const bmr_lazy_place *at) {
    bmr_walk *walk = &lazy->walk;
    const bmr_hierarchy *own = walk->hierarchies[at->owner];
    bmr_walk_start(walk, normal_of(walk, at->owner, at->edge), at->level);
    bmr_candidate c = {0.0, at->owner, at->edge, walk->direction, {walk->corner[0], walk->corner[1]}};
    if (lazy->roll_after)
        c.corner[at->owner] = bmr_hierarchy_corner_after(own, at->edge, bmr_walk_side_level(own, at->level));
    const bmr_vec2 p = bmr_walk_point(walk, 0, c.corner[0]), q = bmr_walk_point(walk, 1, c.corner[1]);
    c.gap = bmr_dot(c.direction, bmr_sub(q, p));
    return c;
}

bmr_lazy_end bmr_lazy_repair(bmr_lazy *lazy, bmr_lazy_place at, bool turned) {
    if (turned) {
        lazy->found = rolled(lazy, &at);
        if (lazy->found.gap > lazy->roll_reach && lazy->take(lazy->context, &lazy->found, at.level))
            return BMR_LAZY_ROLL;
        at.corner = lazy->found.corner[1 - at.owner];
    }
    resume(&lazy->walk, at.owner, at.edge, at.corner, at.level);
    if (!descend(lazy))
        return BMR_LAZY_NONE;
    return lazy->walk.level > at.level ? BMR_LAZY_STAB : BMR_LAZY_PUSH;
}

bool bmr_lazy_is_place(const bmr_hierarchy *const hierarchies[2], const bmr_lazy_place *at) {
    const bmr_hierarchy *own = hierarchies[at->owner], *other = hierarchies[1 - at->owner];
    const uint32_t level = bmr_walk_side_level(other, at->level), before = at->corner.before;
    return at->edge < bmr_hierarchy_edge_count(own) &&
           bmr_hierarchy_level(own, at->edge) <= bmr_walk_side_level(own, at->level) &&
           before < bmr_hierarchy_edge_count(other) && bmr_hierarchy_level(other, before) <= level &&
           bmr_hierarchy_corner_after(other, before, level).after == at->corner.after;
}
