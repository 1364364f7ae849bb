// SPDX-License-Identifier: MIT
// What sticks together moves as one: were the two of a contact alone to get one velocity, a third one that
// sticks to them would come nearer again, and so on, at ever smaller speeds.
#include <math.h>

#include "world/parts.h"

/// All that stick together with the two of a couple, linked by `gathered`, which ends with the last one
/// itself. Whatever has an infinite mass is one of them, but who sticks to it on the other side is not: what
/// happens here does not move it.
static bmr_resident *gather(bmr_couple *c) {
    bmr_resident *const first = c->side[0], *last = c->side[1];
    first->gathered = last;
    last->gathered = last;
    bmr_resident *r = first;
    for (bool more = true; more; r = r->gathered) {
        for (bmr_couple *link = isinf(r->mass) ? NULL : r->first; link;
             link = link->after[bmr_couple_side(link, r)]) {
            bmr_resident *const other = link->side[1 - bmr_couple_side(link, r)];
            if (!link->stuck || other->gathered)
                continue;
            last->gathered = other;
            other->gathered = other;
            last = other;
        }
        more = r != r->gathered;
    }
    return first;
}

static bmr_resident *next(const bmr_resident *r) {
    return r->gathered == r ? NULL : r->gathered;
}

/// Two lists, each by birth, in one. Either may be empty.
static bmr_resident *merge(bmr_resident *a, bmr_resident *b) {
    bmr_resident *first = NULL, *last = NULL;
    while (a || b) {
        bmr_resident **const from = !b || (a && a->birth < b->birth) ? &a : &b;
        bmr_resident *const r = *from;
        *from = next(r);
        if (last)
            last->gathered = r;
        else
            first = r;
        last = r;
        r->gathered = r;
    }
    return first;
}

/// The list by birth. The order in which couples were linked depends on who found whom when: a sum of
/// momenta in that order would have other roundings in a world without cells.
static bmr_resident *by_birth(bmr_resident *list) {
    bmr_resident *runs[8 * sizeof(size_t)] = {NULL}; // runs[i]: empty, or 2^i long
    for (bmr_resident *r = list, *after; r; r = after) {
        after = next(r);
        r->gathered = r;
        bmr_resident *run = r;
        size_t i = 0;
        for (; runs[i]; runs[i++] = NULL)
            run = merge(runs[i], run);
        runs[i] = run;
    }
    bmr_resident *sorted = NULL;
    for (size_t i = 0; i < 8 * sizeof(size_t); i++)
        sorted = merge(runs[i], sorted);
    return sorted;
}

static bmr_pose pose_of(const bmr_world *w, bmr_resident *r, bmr_vec2 *velocity) {
    const bmr_motion motion = bmr_motion_of_piece(&r->now);
    return bmr_motion_pose(&motion, w->time, velocity, NULL);
}

/// The velocity of the common centre of mass, or of who has an infinite one. False: two of those that go
/// different ways, or one that is nowhere.
static bool common_velocity(const bmr_world *w, bmr_resident *first, bmr_vec2 *velocity) {
    double mass = 0.0;
    bmr_vec2 momentum = {0.0, 0.0};
    bool fixed = false;
    for (bmr_resident *r = first; r; r = next(r)) {
        bmr_vec2 own;
        const bmr_pose pose = pose_of(w, r, &own);
        if (!isfinite(pose.position.x) || !isfinite(pose.position.y) || !isfinite(pose.c) ||
            !isfinite(pose.s) || !isfinite(own.x) || !isfinite(own.y))
            return false;
        if (isfinite(r->mass)) {
            mass += r->mass;
            momentum = bmr_add(momentum, bmr_scale(r->mass, own));
        } else if (!fixed) {
            fixed = true;
            *velocity = own;
        } else if (own.x != velocity->x || own.y != velocity->y)
            return false;
    }
    if (!fixed)
        *velocity = bmr_scale(1.0 / mass, momentum);
    return mass > 0.0 && isfinite(velocity->x) && isfinite(velocity->y);
}

bool bmr_stick(bmr_world *w, bmr_couple *c) {
    bmr_resident *const first = by_birth(gather(c));
    bmr_vec2 velocity;
    const bool can = common_velocity(w, first, &velocity);
    w->sticking = true;
    for (bmr_resident *r = first, *after; r; r = after) {
        after = next(r);
        r->gathered = NULL;
        if (!can || (isinf(r->mass) && isinf(r->inertia)))
            continue;
        const bmr_motion_piece piece = bmr_piece_screw(w->time, pose_of(w, r, NULL), velocity, 0.0);
        bmr_resident_move(w, r, &piece, INFINITY, NULL); // from where it is: no memory is asked for
    }
    w->sticking = false;
    c->stuck = can;
    return can;
}
