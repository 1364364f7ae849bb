// SPDX-License-Identifier: MIT
// The free-direction structure and two-lines, for the open question of the paper's section 7. At an event the
// closest direction is fixed in one of the two bodies; the other is represented by a window of two corners
// that stays an outer bound while the direction turns within a bracket. Two-lines also remembers the coarse
// line of that moment (certificate/coarse.h), as one number. When the free direction fails and the coarse
// line separates, the pair takes that, with the other body's nearest vertex and that vertex's cone for a
// window (a handover). When the coarse line fails, too, both are made anew. Both structures need only the two
// sorted polygons and the pair's cache line.
#include "certificate/window.h"
#include "pair/step.h"

/// The finest level there is: the polygons themselves.
#define LEVEL_POLYGONS 0

/// other_after of two-lines: an edge, or BMR_COARSE_AXIS and an axis, and this bit if it is B's.
#define SPARE_OF_B UINT32_C(0x80000000)
#define NO_SPARE (SPARE_OF_B - 1)

/// Which way B turned when a certificate rolled.
static int spin_of(const bmr_pair *pair, const bmr_pose *b_in_a) {
    const bmr_certificate *k = &pair->certificate;
    const bmr_vec2 normal = bmr_vec2_make((double)k->normal[0], (double)k->normal[1]);
    const bmr_pose other_in_owner = pair->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    const bmr_vec2 direction = bmr_neg(bmr_unrotate(&other_in_owner, normal));
    const bmr_vec2 middle =
        bmr_vec2_make((double)k->low[0] + (double)k->high[0], (double)k->low[1] + (double)k->high[1]);
    // As the other body turns, the direction turns the opposite way in its frame.
    const int other_spin = bmr_cross(middle, direction) > 0.0 ? -1 : 1;
    return pair->owner == 0 ? other_spin : -other_spin;
}

/// Fills the pair's certificate with the line of `owner` and a window of the other body.
static bool certify_with(bmr_step *step, const bmr_closest *closest, int owner, const bmr_window *window,
                         double *gap) {
    const bmr_polygon *own = step->shapes[owner]->polygon, *other = step->shapes[1 - owner]->polygon;
    const bmr_vec2 normal =
        owner == 0 ? closest->direction : bmr_unrotate(step->pose, bmr_neg(closest->direction));
    const uint32_t support[2] = {closest->a, closest->b};
    const double offset = bmr_dot(normal, own->vertices[support[owner]]);
    bmr_pair *pair = step->pair;
    bmr_certificate_fill(&pair->certificate, normal, offset, window->corner, 2, window->low, window->high,
                         own->extent, other->extent);
    pair->owner = (uint8_t)owner;
    pair->edge = support[owner];
    pair->other = support[1 - owner];
    if (pair->structure != BMR_TWO_LINES)
        pair->other_after = support[1 - owner];
    // The certificate is a line. (BMR_LEVEL_DISKS would have bmr_pair_check take it for two disks.)
    pair->level = LEVEL_POLYGONS;
    return bmr_step_holds(step, step->need, gap);
}

bool bmr_free_certify(bmr_step *step, const bmr_closest *closest, double *gap) {
    const bmr_vec2 u = closest->direction, v = bmr_unrotate(step->pose, bmr_neg(u));
    const double limit = BMR_WINDOW_PART * (closest->separation - step->reach);
    // B turning one way, the direction turns the other way in B's frame, and with B in A's.
    const int spin = step->pair->spin;
    bmr_window of_a, of_b;
    bmr_window_make(step->shapes[1]->polygon, v, closest->b, limit, -spin, &of_b);
    bmr_window_make(step->shapes[0]->polygon, u, closest->a, limit, spin, &of_a);
    // Always the wider of the two brackets: to keep the last owner where the line was crossed saves half of
    // this work, and costs twice the events on a tumbling orbit.
    const int owner = of_a.life < of_b.life ? 1 : 0;
    step->steps += of_a.steps + of_b.steps;
    return certify_with(step, closest, owner, owner == 0 ? &of_b : &of_a, gap);
}

bool bmr_spare_line(const bmr_pair *pair, const bmr_polygon *a, const bmr_polygon *b, bmr_coarse *spare) {
    spare->owner = (pair->other_after & SPARE_OF_B) != 0;
    spare->edge = pair->other_after & ~SPARE_OF_B;
    return bmr_coarse_normal(spare->owner == 0 ? a : b, spare->edge, &spare->normal);
}

/// The coarse line at the step's pose becomes the pair's spare.
static void remember_coarse(bmr_step *step, const bmr_closest *closest) {
    const uint32_t support[2] = {closest->a, closest->b};
    bmr_coarse coarse;
    const bool found = bmr_coarse_pick(step->shapes[0]->polygon, step->shapes[1]->polygon, step->pose,
                                       closest->direction, step->reach, support, &coarse, &step->steps);
    step->pair->other_after = found ? coarse.edge | (coarse.owner == 1 ? SPARE_OF_B : 0) : NO_SPARE;
}

/// Its nearest vertex stands for a body while the direction is in that vertex's cone.
static bmr_window window_of_vertex(const bmr_polygon *p, uint32_t v) {
    bmr_window window = {{p->vertices[v], p->vertices[v]}, {0.0, 0.0}, {0.0, 0.0}, -2.0, 0};
    if (p->count == 2)
        window.corner[1] = p->vertices[1 - v];
    if (p->count > 2) {
        window.low = bmr_polygon_normal(p, v > 0 ? v - 1 : p->count - 1);
        window.high = bmr_polygon_normal(p, v);
    }
    return window;
}

/// From the free direction, which failed, to the coarse line of the last repair. False: that does not
/// separate here, and the pair is as before.
static bool hand_over(bmr_step *step, double *gap) {
    bmr_pair *pair = step->pair;
    const bmr_pair before = *pair;
    const bmr_polygon *const p[2] = {step->shapes[0]->polygon, step->shapes[1]->polygon};
    bmr_coarse spare;
    if (!pair->free || !bmr_spare_line(pair, p[0], p[1], &spare))
        return false;
    const bool same = spare.owner == pair->owner;
    const uint32_t hint[2] = {same ? pair->edge : pair->other, same ? pair->other : pair->edge};
    const int owner = spare.owner;
    const bmr_vec2 direction = owner == 0 ? spare.normal : bmr_neg(bmr_rotate(step->pose, spare.normal));
    const bmr_vec2 facing = owner == 0 ? bmr_unrotate(step->pose, bmr_neg(direction)) : bmr_neg(direction);
    bmr_closest at = {direction, 0.0, 0, 0};
    const uint32_t own = bmr_support_near(p[owner], spare.normal, hint[0], &step->steps),
                   other = bmr_support_near(p[1 - owner], facing, hint[1], &step->steps);
    at.a = owner == 0 ? own : other;
    at.b = owner == 0 ? other : own;
    const bmr_window window = window_of_vertex(p[1 - owner], other);
    if (!certify_with(step, &at, owner, &window, gap)) {
        *pair = before;
        return false;
    }
    pair->free = 0;
    return true;
}

static bmr_event_kind kind_of(bmr_failure failure) {
    switch (failure) {
    case BMR_FAILURE_NEW:
        return BMR_EVENT_START;
    case BMR_FAILURE_DISKS:
        return BMR_EVENT_STAB;
    case BMR_FAILURE_CROSSED:
        return BMR_EVENT_PUSH;
    case BMR_FAILURE_ROLLED:
        return BMR_EVENT_ROLL;
    case BMR_FAILURE_CONTACT:
        break;
    }
    return BMR_EVENT_LEAVE;
}

/// Where the distance query starts: at the vertices of the last state, or at the first ones of the polygons.
static bmr_simplex start_of(const bmr_pair *pair, bmr_failure failure) {
    switch (failure) {
    case BMR_FAILURE_CROSSED:
    case BMR_FAILURE_ROLLED:
        return pair->owner == 0 ? bmr_simplex_make(pair->edge, pair->other)
                                : bmr_simplex_make(pair->other, pair->edge);
    case BMR_FAILURE_CONTACT:
        return bmr_contact_simplex(pair);
    case BMR_FAILURE_NEW:
    case BMR_FAILURE_DISKS:
        break;
    }
    return bmr_simplex_make(0, 0);
}

bmr_answer bmr_free_repair(bmr_step *step, bmr_failure failure, double *gap) {
    bmr_pair *pair = step->pair;
    const int level_before = failure == BMR_FAILURE_NEW ? BMR_LEVEL_DISKS : pair->level;
    bmr_simplex simplex = start_of(pair, failure);
    const bool two = pair->structure == BMR_TWO_LINES,
               failed = failure == BMR_FAILURE_ROLLED || failure == BMR_FAILURE_CROSSED;
    if (failure == BMR_FAILURE_ROLLED)
        pair->spin = spin_of(pair, step->pose) > 0 ? 1 : -1;
    if (failure == BMR_FAILURE_NEW && bmr_disks_certify(step, step->need, gap)) {
        bmr_step_note(step, BMR_EVENT_START, level_before, BMR_LEVEL_DISKS, *gap);
        return BMR_APART;
    }
    if (two && failed && hand_over(step, gap)) {
        bmr_step_note(step, BMR_EVENT_HANDOVER, level_before, LEVEL_POLYGONS, *gap);
        return BMR_APART;
    }
    bmr_closest closest;
    if (!bmr_step_closest(step, &simplex, &closest) || !bmr_free_certify(step, &closest, gap))
        return bmr_contact_enter(step, &simplex, LEVEL_POLYGONS);
    pair->state = BMR_PAIR_APART;
    pair->level = LEVEL_POLYGONS;
    if (two) {
        pair->free = 1;
        remember_coarse(step, &closest);
    }
    bmr_step_note(step, kind_of(failure), level_before, LEVEL_POLYGONS, *gap);
    const double coarse = step->need + BMR_COARSEN_PART * (*gap - step->need);
    if (bmr_disks_certify(step, coarse, gap))
        bmr_step_note(step, BMR_EVENT_COARSEN, LEVEL_POLYGONS, BMR_LEVEL_DISKS, *gap);
    return BMR_APART;
}
