// SPDX-License-Identifier: MIT
// The lazy structure of the paper's section 5: an edge of one envelope separates it from the other envelope
// of the same level, whose nearest corner is watched. What the paper leaves open is settled like this:
//
// - Walking, pushing, stabbing and coarsening are all one climb (walk.h), on one level or on one level after
//   the other: the local neighbourhood that the paper relies on does not always hold the new edge.
// - Above level 0 are two disks. Below the deepest level is the closest direction: between two corners no
//   edge's line separates by more than the distance over sqrt(2), so near the margin lines alone would not
//   be enough.
// - A climb can end on a false top when a pose has jumped through a body. So no pair is handed over before
//   the distance query agrees.
#include "certificate/walk.h"
#include "pair/step.h"

/// The repair of a lazy pair.
typedef struct repair {
    bmr_step *step;
    bmr_walk walk;
    bmr_failure failure;
    int level_before;
} repair;

static bmr_event_kind kind_of(const repair *r, int level_after) {
    if (r->failure == BMR_FAILURE_NEW)
        return BMR_EVENT_START;
    if (r->failure == BMR_FAILURE_CONTACT)
        return BMR_EVENT_LEAVE;
    return level_after > r->level_before ? BMR_EVENT_STAB : BMR_EVENT_PUSH;
}

/// Makes the pair's certificate of a candidate: its edge's line, and the facing corner with its cone as
/// window and bracket. False (which the bound of step->reach rules out) if it does not prove what is needed.
static bool certify(repair *r, const bmr_candidate *candidate, int level, double *gap) {
    bmr_pair *pair = r->step->pair;
    const int owner = candidate->owner;
    const bmr_hierarchy *own = r->walk.hierarchies[owner], *other = r->walk.hierarchies[1 - owner];
    const bmr_corner corner = candidate->corner[1 - owner];
    const bmr_line line = bmr_hierarchy_line(own, candidate->edge);
    const bmr_vec2 point = bmr_hierarchy_corner_point(other, corner);
    bmr_certificate_fill(&pair->certificate, line.normal, line.offset, &point, 1,
                         bmr_hierarchy_line(other, corner.before).normal,
                         bmr_hierarchy_line(other, corner.after).normal, bmr_hierarchy_polygon(own)->extent,
                         bmr_hierarchy_polygon(other)->extent);
    pair->owner = (uint8_t)owner;
    pair->level = (int8_t)level;
    pair->edge = candidate->edge;
    pair->other = corner.before;
    pair->other_after = corner.after;
    pair->free = 0;
    pair->state = BMR_PAIR_APART;
    return bmr_step_holds(r->step, r->step->need, gap);
}

/// What the disks must prove to replace a line of this gap.
static double worth_it(const bmr_step *step, double gap) {
    return step->need + BMR_COARSEN_PART * (gap - step->need);
}

/// A coarsening that the observer has not been told of yet: its line may still be replaced by a better one of
/// the same level.
typedef struct coarsening {
    repair *repair;
    double *gap;
    int told; ///< the level of the last event
} coarsening;

/// Tells of the level that the pair has gained, if it is one more than was told of.
static void tell_gain(coarsening *c) {
    const int level = c->repair->step->pair->level;
    if (level < c->told)
        bmr_step_tell(c->repair->step, BMR_EVENT_COARSEN, c->told, level, *c->gap);
    c->told = level;
}

static bool take(void *context, const bmr_candidate *candidate, int level) {
    coarsening *c = context;
    bmr_pair *pair = c->repair->step->pair;
    const bmr_pair finer = *pair;
    const double finer_gap = *c->gap;
    double coarser_gap;
    if (!certify(c->repair, candidate, level, &coarser_gap)) {
        *pair = finer;
        return false;
    }
    // The finer line stands: what comes next is of another level.
    if (level < finer.level && c->repair->step->observer) {
        const bmr_pair coarser = *pair;
        *pair = finer;
        *c->gap = finer_gap;
        tell_gain(c);
        *pair = coarser;
    }
    *c->gap = coarser_gap;
    return true;
}

/// From a candidate on the walk's level, which the pair holds, to coarser levels, and to the disks.
static void coarsen(repair *r, bmr_candidate candidate, double *gap) {
    bmr_step *step = r->step;
    coarsening c = {r, gap, step->pair->level};
    bmr_walk_ascend(&r->walk, candidate, step->need, step->reach, take, &c);
    tell_gain(&c);
    if (step->pair->level == 0 && bmr_disks_certify(step, worth_it(step, *gap), gap))
        tell_gain(&c);
}

/// Climbs the walk's level, and on to deeper ones until one separates.
static bool descend(repair *r, bmr_candidate *found) {
    const int deepest = bmr_walk_deepest(r->walk.hierarchies);
    for (;;) {
        const bool top = bmr_walk_climb(&r->walk, found);
        if (found->gap > r->step->reach)
            return true;
        if (!top || r->walk.level >= deepest)
            return false;
        bmr_walk_refine(&r->walk);
    }
}

/// The last resort below the deepest level, along the closest direction: an edge if there is one that will
/// do, and else that direction itself.
static bmr_answer from_closest(repair *r, const bmr_closest *closest, const bmr_simplex *simplex,
                               double *gap) {
    bmr_step *step = r->step;
    const int deepest = bmr_walk_deepest(r->walk.hierarchies);
    const bmr_event_kind kind = r->failure == BMR_FAILURE_ROLLED ? BMR_EVENT_ROLL : kind_of(r, deepest);
    bmr_candidate found;
    bmr_walk_start(&r->walk, closest->direction, deepest);
    bmr_walk_climb(&r->walk, &found);
    if (found.gap > step->reach && certify(r, &found, deepest, gap)) {
        bmr_step_tell(step, kind, r->level_before, deepest, *gap);
        coarsen(r, found, gap);
        return BMR_APART;
    }
    if (!bmr_free_certify(step, closest, gap))
        return bmr_contact_enter(step, simplex, deepest);
    step->pair->state = BMR_PAIR_APART;
    step->pair->level = (int8_t)deepest;
    step->pair->free = 1;
    bmr_step_tell(step, kind, r->level_before, deepest, *gap);
    return BMR_APART;
}

/// Asks for the distance itself, starting from two vertices.
static bmr_answer ask_distance(repair *r, uint32_t a, uint32_t b, double *gap) {
    bmr_simplex simplex = bmr_simplex_make(a, b);
    bmr_closest closest;
    if (!bmr_step_closest(r->step, &simplex, &closest))
        return bmr_contact_enter(r->step, &simplex, bmr_walk_deepest(r->walk.hierarchies));
    return from_closest(r, &closest, &simplex, gap);
}

/// The walk's level and all deeper ones, then the distance. `kind`: the event that this is.
static bmr_answer search(repair *r, double *gap) {
    bmr_candidate found;
    if (descend(r, &found)) {
        const int level = r->walk.level;
        if (certify(r, &found, level, gap)) {
            const bmr_event_kind kind = kind_of(r, level);
            bmr_step_tell(r->step, kind, r->level_before, level, *gap);
            if (kind == BMR_EVENT_PUSH)
                coarsen(r, found, gap);
            return BMR_APART;
        }
    }
    return ask_distance(r, bmr_hierarchy_touch(r->walk.hierarchies[0], r->walk.corner[0].before),
                        bmr_hierarchy_touch(r->walk.hierarchies[1], r->walk.corner[1].before), gap);
}

/// Top down: the disks, then the rectangles, then one level after the other.
static bmr_answer start(repair *r, bmr_vec2 direction, double *gap) {
    if (r->failure != BMR_FAILURE_DISKS && bmr_disks_certify(r->step, r->step->need, gap)) {
        bmr_step_tell(r->step, kind_of(r, BMR_LEVEL_DISKS), r->level_before, BMR_LEVEL_DISKS, *gap);
        return BMR_APART;
    }
    bmr_walk_start(&r->walk, direction, 0);
    return search(r, gap);
}

/// From A's centre to B's; any direction if they coincide.
static bmr_vec2 between_centers(const bmr_step *step) {
    const bmr_vec2 b = bmr_transform(step->pose, step->shapes[1]->polygon->center);
    const bmr_vec2 way = bmr_sub(b, step->shapes[0]->polygon->center);
    return way.x != 0.0 || way.y != 0.0 ? way : bmr_vec2_make(1.0, 0.0);
}

/// A roll: the edge stays, the corner becomes the one that is extreme now.
static bmr_answer roll(repair *r, double *gap) {
    const bmr_pair *pair = r->step->pair;
    const int owner = pair->owner, level = pair->level;
    const bmr_edge edge = pair->edge;
    bmr_walk_start(&r->walk, bmr_walk_normal(&r->walk, owner, edge), level);
    bmr_candidate candidate = {0.0, owner, edge, r->walk.direction, {r->walk.corner[0], r->walk.corner[1]}};
    const bmr_hierarchy *own = r->walk.hierarchies[owner];
    candidate.corner[owner] = bmr_hierarchy_corner_after(own, edge, bmr_walk_side_level(own, level));
    const bmr_vec2 p = bmr_walk_point(&r->walk, 0, candidate.corner[0]);
    const bmr_vec2 q = bmr_walk_point(&r->walk, 1, candidate.corner[1]);
    candidate.gap = bmr_dot(candidate.direction, bmr_sub(q, p));
    if (!(candidate.gap > r->step->reach) || !certify(r, &candidate, level, gap)) {
        bmr_walk_resume(&r->walk, owner, edge, candidate.corner[1 - owner], level);
        return search(r, gap);
    }
    bmr_step_tell(r->step, BMR_EVENT_ROLL, level, level, *gap);
    coarsen(r, candidate, gap);
    return BMR_APART;
}

static bmr_answer leave(repair *r, double *gap) {
    bmr_simplex simplex = bmr_contact_simplex(r->step->pair);
    bmr_closest closest;
    if (!bmr_step_closest(r->step, &simplex, &closest))
        return bmr_contact_enter(r->step, &simplex, r->level_before);
    return start(r, closest.direction, gap);
}

bmr_answer bmr_lazy_repair(bmr_step *step, bmr_failure failure, double *gap) {
    bmr_pair *pair = step->pair;
    repair r = {step,
                {.hierarchies = {step->shapes[0]->hierarchies[step->pair->structure],
                                 step->shapes[1]->hierarchies[step->pair->structure]},
                 .pose = step->pose},
                failure,
                failure == BMR_FAILURE_NEW ? BMR_LEVEL_DISKS : pair->level};
    bmr_answer answer;
    if (failure == BMR_FAILURE_NEW || failure == BMR_FAILURE_DISKS)
        answer = start(&r, between_centers(step), gap);
    else if (failure == BMR_FAILURE_CONTACT)
        answer = leave(&r, gap);
    else if (pair->free)
        answer = pair->owner == 0 ? ask_distance(&r, pair->edge, pair->other, gap)
                                  : ask_distance(&r, pair->other, pair->edge, gap);
    else if (failure == BMR_FAILURE_ROLLED)
        answer = roll(&r, gap);
    else {
        const bmr_hierarchy *other = r.walk.hierarchies[1 - pair->owner];
        bmr_walk_resume(&r.walk, pair->owner, pair->edge,
                        bmr_hierarchy_corner(other, pair->other, pair->other_after), pair->level);
        answer = search(&r, gap);
    }
    step->steps += r.walk.steps;
    return answer;
}
