// SPDX-License-Identifier: MIT
#include "certificate/lazy.h"

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
    bmr_walk_start(walk, bmr_walk_normal(walk, at->owner, at->edge), at->level);
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
    bmr_walk_resume(&lazy->walk, at.owner, at.edge, at.corner, at.level);
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
