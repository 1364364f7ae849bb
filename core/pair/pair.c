// SPDX-License-Identifier: MIT
#include "boomerang/pair.h"

#include <string.h>

#include "certificate/walk.h"
#include "hierarchy/tree.h"
#include "pair/step.h"

/// The part of a gap that rounding to floats (2^-22) and the tolerance of the distance query (2e-8) may hide,
/// with room for their squares. A pair must be apart by this much more than it needs.
#define NEED_LOSS 4e-7

const char *bmr_structure_name(bmr_structure structure) {
    switch (structure) {
    case BMR_LAZY_COMPASS:
        return "lazy-compass";
    case BMR_LAZY_DUDLEY:
        return "lazy-dudley";
    case BMR_FREE_DIRECTION:
        return "free-direction";
    case BMR_TWO_LINES:
        return "two-lines";
    case BMR_STRUCTURE_COUNT:
        break;
    }
    return NULL;
}

const char *bmr_event_name(bmr_event_kind kind) {
    switch (kind) {
    case BMR_EVENT_START:
        return "start";
    case BMR_EVENT_PUSH:
        return "push";
    case BMR_EVENT_STAB:
        return "stab";
    case BMR_EVENT_ROLL:
        return "roll";
    case BMR_EVENT_COARSEN:
        return "coarsen";
    case BMR_EVENT_CONTACT:
        return "contact";
    case BMR_EVENT_LEAVE:
        return "leave";
    case BMR_EVENT_HANDOVER:
        return "handover";
    case BMR_EVENT_KIND_COUNT:
        break;
    }
    return NULL;
}

bmr_pair_def bmr_default_pair_def(void) {
    const bmr_pair_def def = {BMR_LAZY_COMPASS, 0.0, 0.0};
    return def;
}

void bmr_pair_init(bmr_pair *pair) {
    memset(pair, 0, sizeof *pair);
    pair->state = BMR_PAIR_NEW;
}

_Static_assert((int)BMR_LAZY_COMPASS == (int)BMR_HIERARCHY_COMPASS &&
                   (int)BMR_LAZY_DUDLEY == (int)BMR_HIERARCHY_DUDLEY,
               "a lazy structure has the number of its hierarchy");
_Static_assert(BMR_STRUCTURE_COUNT <= 4, "a pair has two bits for its structure");

/// Has the shape a hierarchy that this structure can walk on?
static bool walks(const bmr_shape *shape, bmr_structure structure) {
    const bmr_hierarchy *h = (unsigned)structure < BMR_FREE_DIRECTION ? shape->hierarchies[structure] : NULL;
    return h && bmr_tree_is_of(h, (int)structure, shape->polygon);
}

bmr_structure bmr_pair_structure(const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b) {
    if (def->structure == BMR_TWO_LINES)
        return BMR_TWO_LINES;
    return walks(a, def->structure) && walks(b, def->structure) ? def->structure : BMR_FREE_DIRECTION;
}

static bool simplex_fits(const bmr_pair *pair, uint32_t count_a, uint32_t count_b) {
    const bmr_simplex simplex = bmr_contact_simplex(pair);
    for (uint32_t i = 0; i < simplex.count; ++i)
        if (simplex.a[i] >= count_a || simplex.b[i] >= count_b)
            return false;
    return simplex.count > 0;
}

/// Do all the indices that the pair remembers exist in these shapes? They do if the pair was left by an
/// advance with these polygons and this structure. It is asked because one polygon in 2^32 has the stamp of
/// another.
static bool remembers_what_is_there(const bmr_pair *pair, const bmr_shape *a, const bmr_shape *b) {
    if (pair->state == BMR_PAIR_CONTACT)
        return simplex_fits(pair, a->polygon->count, b->polygon->count);
    if (pair->level == BMR_LEVEL_DISKS)
        return true;
    const bmr_shape *owner = pair->owner == 0 ? a : b, *other = pair->owner == 0 ? b : a;
    if (pair->structure >= BMR_FREE_DIRECTION || pair->free)
        return pair->edge < owner->polygon->count && pair->other < other->polygon->count;
    const bmr_hierarchy *const hierarchies[2] = {owner->hierarchies[pair->structure],
                                                 other->hierarchies[pair->structure]};
    const uint32_t count = bmr_hierarchy_edge_count(hierarchies[1]);
    return pair->edge < bmr_hierarchy_edge_count(hierarchies[0]) && pair->other < count &&
           pair->other_after < count && pair->level >= 0 && pair->level <= bmr_walk_deepest(hierarchies);
}

/// Starts the pair anew if its state is of another structure, or of other shapes though the stamp agrees.
static void take_up(bmr_pair *pair, bmr_structure structure, const bmr_shape *a, const bmr_shape *b) {
    const bool known = pair->state == BMR_PAIR_APART || pair->state == BMR_PAIR_CONTACT;
    if (!known || pair->owner > 1 || pair->structure != structure || !remembers_what_is_there(pair, a, b)) {
        const uint32_t stamp = pair->stamp;
        bmr_pair_init(pair);
        pair->stamp = stamp;
        pair->structure = structure & 3u;
    }
}

static bmr_failure failure_of(const bmr_pair *pair, bmr_check check) {
    if (pair->state == BMR_PAIR_NEW)
        return BMR_FAILURE_NEW;
    if (pair->state == BMR_PAIR_CONTACT)
        return BMR_FAILURE_CONTACT;
    if (pair->level == BMR_LEVEL_DISKS)
        return BMR_FAILURE_DISKS;
    return check == BMR_CHECK_ROLLED ? BMR_FAILURE_ROLLED : BMR_FAILURE_CROSSED;
}

/// Out of line: what is done when the quick check says no.
static bmr_answer repair(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                         const bmr_pose *b_in_a, const bmr_observer *observer, bmr_check check, double *gap) {
    const bmr_structure structure = bmr_pair_structure(def, a, b);
    take_up(pair, structure, a, b);
    bmr_step step = {pair, def, {a, b}, b_in_a, observer, def->margin, 0.0, 1};
    if (pair->state == BMR_PAIR_CONTACT)
        step.need += def->hysteresis;
    step.reach =
        step.need * (1.0 + NEED_LOSS) + BMR_CERTIFICATE_LOSS * (a->polygon->extent + b->polygon->extent);
    const bmr_failure failure = failure_of(pair, check);
    *gap = 0.0;
    const bmr_answer answer = structure >= BMR_FREE_DIRECTION ? bmr_free_repair(&step, failure, gap)
                                                              : bmr_lazy_pair_repair(&step, failure, gap);
    if (answer != BMR_APART)
        *gap = 0.0;
    if (observer && observer->counters)
        observer->counters->steps += step.steps;
    return answer;
}

bmr_answer bmr_pair_advance(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                            const bmr_pose *b_in_a, const bmr_observer *observer, double *gap) {
    double unwanted;
    if (!gap)
        gap = &unwanted;
    if (observer && observer->counters)
        ++observer->counters->checks;
    if (!bmr_pair_takes(b_in_a)) {
        bmr_pair_init(pair);
        *gap = 0.0;
        return BMR_STAB_POLYGON;
    }
    const uint32_t stamp = bmr_pair_stamp(a->polygon, b->polygon);
    if (pair->stamp != stamp) {
        bmr_pair_init(pair);
        pair->stamp = stamp;
    }
    bmr_check check = BMR_CHECK_CROSSED;
    if (pair->state == BMR_PAIR_APART) {
        check = bmr_pair_quick_check(pair, b_in_a, def->margin, gap);
        if (check == BMR_CHECK_HOLDS)
            return BMR_APART;
    }
    return repair(pair, def, a, b, b_in_a, observer, check, gap);
}
