// SPDX-License-Identifier: MIT
// Inflated compass hierarchies of two polygons (section 6). At an event the coarsest level is taken at which
// some edge has a slack of eps_j: translational hysteresis. Where the bodies rotate, three consecutive
// corners of the other envelope stand for it in the cone of their four edges, so that neither a small motion
// nor a small rotation leaves the window: rotational hysteresis, which the paper announces and omits.
#include "boomerang/inflated.h"
#include "certificate/walk.h"
#include "hierarchy/tree.h"
#include "kds/registry.h"
#include "kds/windowed_line.h"

/// A level's line is taken if it proves at least this part of the distance beyond the margin. One that keeps
/// its promise has more, 1 / (2 + 2 sqrt 2); less is possible only with a margin as large as the polygons,
/// and for points, which have no edges.
#define EDGE_PART 0.125

/// Where a level promises no more than this many margins, its line is not taken: the distance itself is asked
/// for.
#define MARGINS 4.0

/// What a proof has of the other envelope.
typedef enum inflated_window {
    WINDOW_FIXED,  ///< the nearest corner; the direction never turns
    WINDOW_CORNER, ///< the nearest corner, in its own cone: no rotational hysteresis
    WINDOW_THREE   ///< and its neighbours, in the cone of all three
} inflated_window;

typedef struct inflated_class {
    bmr_kds_class class; ///< first: an info's implementation is a pointer to it
    inflated_window window;
} inflated_class;

typedef struct inflated_state {
    bmr_windowed_line now;
    bmr_inflation inflation;
} inflated_state;

static inflated_window window_of(const bmr_kds *kds) {
    return ((const inflated_class *)kds->info->implementation)->window;
}

static inflated_state *state_of(bmr_kds *kds) {
    return (inflated_state *)(void *)kds->state;
}

static bmr_error prepare(bmr_kds *kds) {
    const double diameter =
        bmr_inflation_diameter(kds->shapes[0].polygon) + bmr_inflation_diameter(kds->shapes[1].polygon);
    state_of(kds)->inflation =
        bmr_inflation_make(diameter, kds->def.alpha, kds->def.offset_ratio, kds->def.root_level);
    return BMR_OK;
}

/// Section 6, rotational hysteresis: after an event P moves Omega(d) or turns by Omega(d/D).
/// The window around a corner of the other body's envelope.
static void make_window(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *pose, bmr_corner corner,
                        int level) {
    const int other = 1 - w->owner;
    const bmr_hierarchy *h = bmr_kds_hierarchy(kds, other);
    const uint32_t side_level = bmr_walk_side_level(h, level);
    w->point[0] = bmr_hierarchy_corner_point(h, corner);
    w->count = 1;
    bmr_edge low = corner.before, high = corner.after;
    if (window_of(kds) == WINDOW_THREE) {
        unsigned steps = 0;
        const bmr_corner before = bmr_tree_corner_before(h, low, side_level, &steps),
                         after = bmr_tree_corner_after(h, high, side_level, &steps);
        bmr_kds_tally(kds, steps);
        w->point[1] = bmr_hierarchy_corner_point(h, before);
        w->point[2] = bmr_hierarchy_corner_point(h, after);
        w->count = 3;
        low = before.before;
        high = after.after;
    }
    bmr_windowed_bracket(w, pose, bmr_hierarchy_line(h, low).normal, bmr_hierarchy_line(h, high).normal);
    if (window_of(kds) == WINDOW_FIXED)
        bmr_windowed_fix(w);
    else if (!bmr_windowed_inside(w, pose)) // edges whose directions differ by next to nothing
        bmr_windowed_exact(w, kds, pose, 0);
}

static void take_edge(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *pose, int level,
                      const bmr_candidate *best) {
    const int owner = best->owner, other = 1 - owner;
    w->owner = (uint8_t)owner;
    w->line = bmr_hierarchy_line(bmr_kds_hierarchy(kds, owner), best->edge);
    w->level = level;
    w->support[owner] = bmr_hierarchy_touch(bmr_kds_hierarchy(kds, owner), best->edge);
    w->support[other] = bmr_hierarchy_touch(bmr_kds_hierarchy(kds, other), best->corner[other].before);
    make_window(w, kds, pose, best->corner[other], level);
}

/// From level to level, the edge of most slack on each, to the coarsest at which it has the slack eps_j that
/// the level promises. `from` is within a right angle of where the slack is largest, on the side `side` of it
/// (0: on either); a climb that leaves that right angle, which it may where the envelopes of its level
/// overlap, is done again from there on the next level. True: there is such a level. False: `best` is that of
/// the deepest. One climb on each level passed.
static bool descend(const bmr_kds *kds, bmr_walk *walk, bmr_vec2 from, int side, bmr_candidate *best) {
    const bmr_inflation *inflation = &((const inflated_state *)(const void *)kds->state)->inflation;
    const int deepest = bmr_walk_deepest(walk->hierarchies);
    const int root = (int)inflation->root_level < deepest ? (int)inflation->root_level : deepest;
    bmr_walk_start(walk, from, root);
    for (int level = root;; ++level) {
        const bool climbed = bmr_walk_climb(walk, best);
        if (climbed && best->gap >= bmr_inflation_offset(inflation, (uint32_t)(level - root)))
            return true;
        if (level == deepest)
            return false;
        const bool strayed =
            bmr_dot(from, walk->direction) < 0.0 || side * bmr_cross(from, walk->direction) < 0.0;
        if (climbed && !strayed)
            bmr_walk_refine(walk);
        else
            bmr_walk_start(walk, from, level + 1);
    }
}

static bmr_walk walk_of(const bmr_kds *kds, const bmr_pose *pose) {
    const bmr_walk walk = {.hierarchies = {bmr_kds_hierarchy(kds, 0), bmr_kds_hierarchy(kds, 1)},
                           .pose = pose};
    return walk;
}

/// From the line that failed, which separates up to the margin: so the closest direction is within a right
/// angle of it, on the side to which it leads uphill. False: no level has the slack that it promises, or it
/// is so little that the margin matters. O(level).
static bool select_near(bmr_kds *kds, const bmr_pose *pose) {
    inflated_state *s = state_of(kds);
    bmr_walk walk = walk_of(kds, pose);
    const bmr_vec2 from = bmr_windowed_direction(&s->now, pose);
    bmr_walk_start(&walk, from, s->now.level);
    const bmr_vec2 p = bmr_walk_point(&walk, 0, walk.corner[0]), q = bmr_walk_point(&walk, 1, walk.corner[1]);
    bmr_candidate best;
    const bool found = descend(kds, &walk, from, bmr_cross(from, bmr_sub(q, p)) > 0.0 ? 1 : -1, &best) &&
                       best.gap > MARGINS * kds->def.margin;
    bmr_kds_tally(kds, walk.steps);
    if (found)
        take_edge(&s->now, kds, pose, walk.level, &best);
    return found;
}

/// In the annulus, where no level keeps its promise, near the polygons: the coarse line, of which a convex
/// path needs no more than both trees are deep (that of most slack would fail at each edge of polygons that
/// it comes geometrically nearer to); and where no edge clears the margin, the closest direction, which does.
static void take_coarse(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *pose, bmr_vec2 u,
                        int deepest) {
    const uint32_t support[2] = {w->support[0], w->support[1]};
    if (!bmr_coarse_line(kds, pose, u, support, w)) {
        bmr_windowed_line_set(w, kds, pose, 0, u, support);
        bmr_windowed_exact(w, kds, pose, 0);
    }
    w->level = deepest;
    if (window_of(kds) == WINDOW_FIXED)
        bmr_windowed_fix(w);
}

/// Lemma 6.1: after an event P moves d/beta before the next, beta = 2 (1 + sqrt 2).
/// Section 6, two polygons: the new edge is of the inflated envelope that holds the vertex.
/// From the closest direction. O(log n).
static bool select_line(bmr_kds *kds, const bmr_pose *pose) {
    inflated_state *s = state_of(kds);
    bmr_windowed_line w = s->now;
    bmr_vec2 u;
    double distance;
    if (!bmr_windowed_closest(kds, pose, w.support, &u, &distance))
        return false;
    bmr_walk walk = walk_of(kds, pose);
    bmr_candidate best;
    const uint32_t deepest = (uint32_t)bmr_walk_deepest(walk.hierarchies);
    const bool far = descend(kds, &walk, u, 0, &best) ||
                     best.gap - kds->def.margin >= bmr_coarse_below(&s->inflation, deepest);
    bmr_kds_tally(kds, walk.steps);
    if (far && best.gap > kds->def.margin + EDGE_PART * (distance - kds->def.margin))
        take_edge(&w, kds, pose, walk.level, &best);
    else
        take_coarse(&w, kds, pose, u, (int)deepest);
    s->now = w;
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const bool apart = select_line(kds, &now->pose);
    report->level_before = report->level_after = state_of(kds)->now.level;
    return apart;
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed; // others may have failed at the same time
    inflated_state *s = state_of(kds);
    const bmr_windowed_line old = s->now;
    const bmr_windowed_failure failure = bmr_windowed_fails(&old, kds, now);
    if (!failure.crossed && failure.rolled == 0)
        return true; // NONE
    report->level_before = report->level_after = old.level;
    if (!select_near(kds, &now->pose) && !select_line(kds, &now->pose))
        return false;
    report->level_after = s->now.level;
    report->line_changed = !bmr_windowed_same_line(&old, &s->now);
    report->kind = !failure.crossed ? BMR_KDS_ROLL : s->now.level > old.level ? BMR_KDS_STAB : BMR_KDS_PUSH;
    return true;
}

#define INFLATED_CLASS(window)                                                                               \
    { {BMR_WINDOWED_CLASS(inflated_state, start, repair), .prepare = prepare}, window }
static const inflated_class translation = INFLATED_CLASS(WINDOW_FIXED), window = INFLATED_CLASS(WINDOW_THREE),
                            no_window = INFLATED_CLASS(WINDOW_CORNER);

BMR_KDS_INFO(inflated_translation, "inflated-translation", "Inflated compass, translational hysteresis", "6",
             BMR_KDS_TRANSLATION, BMR_KDS_RECOMMENDED, BMR_HIERARCHY_COMPASS, &translation);
BMR_KDS_INFO(inflated_window, "inflated-window", "Inflated compass, three-vertex window",
             "6, rotational hysteresis", BMR_KDS_RIGID, BMR_KDS_RECOMMENDED, BMR_HIERARCHY_COMPASS, &window);
BMR_KDS_INFO(inflated_nowindow, "inflated-nowindow", "Inflated compass, no window",
             "the control of section 6's rotational hysteresis", BMR_KDS_RIGID, BMR_KDS_CONTROL,
             BMR_HIERARCHY_COMPASS, &no_window);
