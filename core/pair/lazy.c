// SPDX-License-Identifier: MIT
// The lazy structure (certificate/walk.h) of a sampled pair. What the paper leaves open is settled like this:
//
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
    bmr_lazy lazy;
    double *gap; ///< what the last proof proves
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
static bool certify(void *context, const bmr_candidate *candidate, int level) {
    repair *r = context;
    bmr_pair *pair = r->step->pair;
    const bmr_pair before = *pair;
    const int owner = candidate->owner;
    const bmr_hierarchy *own = r->lazy.walk.hierarchies[owner], *other = r->lazy.walk.hierarchies[1 - owner];
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
    if (bmr_step_holds(r->step, r->step->need, r->gap))
        return true;
    *pair = before;
    return false;
}

/// What the disks must prove to replace a line of this gap.
static double worth_it(const bmr_step *step, double gap) {
    return step->need + BMR_COARSEN_PART * (gap - step->need);
}

/// A coarsening of which the observer does not know yet: its line may still be replaced by a better one of
/// the same level.
typedef struct coarsening {
    repair *repair;
    int noted; ///< the level of the last event
} coarsening;

/// Notes the level that the pair has gained, if it is one more than at the last event.
static void note_gain(coarsening *c) {
    const int level = c->repair->step->pair->level;
    if (level < c->noted)
        bmr_step_note(c->repair->step, BMR_EVENT_COARSEN, c->noted, level, *c->repair->gap);
    c->noted = level;
}

static bool take(void *context, const bmr_candidate *candidate, int level) {
    coarsening *c = context;
    bmr_pair *pair = c->repair->step->pair;
    const bmr_pair finer = *pair;
    const double finer_gap = *c->repair->gap;
    if (!certify(c->repair, candidate, level)) {
        *c->repair->gap = finer_gap;
        return false;
    }
    // The finer line stands: what comes next is of another level.
    if (level < finer.level && c->repair->step->observer) {
        const bmr_pair coarser = *pair;
        const double coarser_gap = *c->repair->gap;
        *pair = finer;
        *c->repair->gap = finer_gap;
        note_gain(c);
        *pair = coarser;
        *c->repair->gap = coarser_gap;
    }
    return true;
}

/// From the edge that was found, which the pair holds, to coarser levels, and to the disks.
static void coarsen(repair *r) {
    bmr_step *step = r->step;
    coarsening c = {r, step->pair->level};
    bmr_walk_ascend(&r->lazy.walk, r->lazy.found, step->need, step->reach, take, &c);
    note_gain(&c);
    if (step->pair->level == 0 && bmr_disks_certify(step, worth_it(step, *r->gap), r->gap))
        note_gain(&c);
}

static bmr_answer note(const repair *r, bmr_event_kind kind) {
    bmr_step_note(r->step, kind, r->level_before, r->step->pair->level, *r->gap);
    return BMR_APART;
}

/// The last resort below the deepest level, along the closest direction: an edge if there is one that will
/// do, and else that direction itself.
static bmr_answer from_closest(repair *r, const bmr_closest *closest, const bmr_simplex *simplex) {
    bmr_pair *pair = r->step->pair;
    const int deepest = bmr_walk_deepest(r->lazy.walk.hierarchies);
    const bmr_event_kind kind = r->failure == BMR_FAILURE_ROLLED ? BMR_EVENT_ROLL : kind_of(r, deepest);
    if (bmr_lazy_start(&r->lazy, closest->direction, deepest)) {
        note(r, kind);
        coarsen(r);
        return BMR_APART;
    }
    if (!bmr_free_certify(r->step, closest, r->gap))
        return bmr_contact_enter(r->step, simplex, deepest);
    pair->state = BMR_PAIR_APART;
    pair->level = (int8_t)deepest;
    pair->free = 1;
    return note(r, kind);
}

/// Asks for the distance itself, starting from two vertices.
static bmr_answer ask_distance(repair *r, uint32_t a, uint32_t b) {
    bmr_simplex simplex = bmr_simplex_make(a, b);
    bmr_closest closest;
    if (!bmr_step_closest(r->step, &simplex, &closest))
        return bmr_contact_enter(r->step, &simplex, bmr_walk_deepest(r->lazy.walk.hierarchies));
    return from_closest(r, &closest, &simplex);
}

/// The distance, starting from where the walk ended.
static bmr_answer ask_here(repair *r) {
    const bmr_walk *walk = &r->lazy.walk;
    return ask_distance(r, bmr_hierarchy_touch(walk->hierarchies[0], walk->corner[0].before),
                        bmr_hierarchy_touch(walk->hierarchies[1], walk->corner[1].before));
}

/// Top down: the disks, then the rectangles, then one level after the other, then the distance.
static bmr_answer start(repair *r, bmr_vec2 direction) {
    if (r->failure != BMR_FAILURE_DISKS && bmr_disks_certify(r->step, r->step->need, r->gap))
        return note(r, kind_of(r, BMR_LEVEL_DISKS));
    if (bmr_lazy_start(&r->lazy, direction, 0))
        return note(r, kind_of(r, r->lazy.walk.level));
    return ask_here(r);
}

/// From A's centre to B's; any direction if they coincide.
static bmr_vec2 between_centers(const bmr_step *step) {
    const bmr_vec2 b = bmr_transform(step->pose, step->shapes[1]->polygon->center);
    const bmr_vec2 way = bmr_sub(b, step->shapes[0]->polygon->center);
    return way.x != 0.0 || way.y != 0.0 ? way : bmr_vec2_make(1.0, 0.0);
}

static bmr_answer leave(repair *r) {
    bmr_simplex simplex = bmr_contact_simplex(r->step->pair);
    bmr_closest closest;
    if (!bmr_step_closest(r->step, &simplex, &closest))
        return bmr_contact_enter(r->step, &simplex, r->level_before);
    return start(r, closest.direction);
}

/// Rolls, pushes or stabs from the pair's edge, then the distance.
static bmr_answer from_edge(repair *r) {
    const bmr_pair *pair = r->step->pair;
    const bmr_hierarchy *other = r->lazy.walk.hierarchies[1 - pair->owner];
    const bmr_lazy_place at = {bmr_hierarchy_corner(other, pair->other, pair->other_after), pair->edge,
                               pair->level, pair->owner};
    const bmr_lazy_end end = bmr_lazy_repair(&r->lazy, at, r->failure == BMR_FAILURE_ROLLED);
    if (end == BMR_LAZY_NONE)
        return ask_here(r);
    note(r, end == BMR_LAZY_ROLL ? BMR_EVENT_ROLL : kind_of(r, pair->level));
    if (end != BMR_LAZY_STAB)
        coarsen(r);
    return BMR_APART;
}

bmr_answer bmr_lazy_pair_repair(bmr_step *step, bmr_failure failure, double *gap) {
    const bmr_pair *pair = step->pair;
    repair r = {step,
                {.walk = {.hierarchies = {step->shapes[0]->hierarchies[pair->structure],
                                          step->shapes[1]->hierarchies[pair->structure]},
                          .pose = step->pose},
                 .reach = step->reach,
                 .roll_reach = step->reach,
                 .roll_after = true,
                 .take = certify},
                gap,
                failure,
                failure == BMR_FAILURE_NEW ? BMR_LEVEL_DISKS : pair->level};
    r.lazy.context = &r;
    bmr_answer answer;
    if (failure == BMR_FAILURE_NEW || failure == BMR_FAILURE_DISKS)
        answer = start(&r, between_centers(step));
    else if (failure == BMR_FAILURE_CONTACT)
        answer = leave(&r);
    else if (pair->free)
        answer = pair->owner == 0 ? ask_distance(&r, pair->edge, pair->other)
                                  : ask_distance(&r, pair->other, pair->edge);
    else
        answer = from_edge(&r);
    step->steps += r.lazy.walk.steps;
    return answer;
}
