// SPDX-License-Identifier: MIT
// What the structures share in one advance of a pair: the disks, the quick check, contact, the observer.
#include "pair/step.h"

#include <math.h>

// ---- the level above the bounding rectangles: two bounding disks ----
//
// It has no direction, so that a pair spinning far apart costs nothing; the paper's rectangles alone would
// roll four times a turn for ever.

/// What evaluating the check of two disks in double may be off by, in parts of the extents: some roundings of
/// 2^-53, of values of at most 4 extents. For larger positions the check allows for rounding itself.
#define EVALUATION_ERROR 1.4210854715202004e-14 /* 2^-46 */

/// Distances above this count as this: their squares overflow, and the root of infinity would be no lower
/// bound of a distance. It is near the root of the largest double.
#define LARGEST_DISTANCE 1e154

static double round_center(bmr_vec2 center, float rounded[2]) {
    rounded[0] = (float)center.x;
    rounded[1] = (float)center.y;
    const double dx = center.x - (double)rounded[0], dy = center.y - (double)rounded[1];
    return fabs(dx) + fabs(dy);
}

/// What the pair's disks prove at a pose.
double bmr_disks_gap(const bmr_certificate *certificate, const bmr_pose *b_in_a) {
    const bmr_certificate *k = certificate;
    const bmr_vec2 b = bmr_transform(b_in_a, bmr_vec2_make((double)k->window[0][0], (double)k->window[0][1]));
    const double dx = b.x - (double)k->normal[0], dy = b.y - (double)k->normal[1];
    const double distance = fmin(sqrt(dx * dx + dy * dy), LARGEST_DISTANCE);
    return distance * (1.0 - 0x1p-49) - (double)k->offset;
}

bool bmr_disks_certify(bmr_step *step, double need, double *gap) {
    const bmr_polygon *a = step->shapes[0]->polygon, *b = step->shapes[1]->polygon;
    const bmr_vec2 way = bmr_sub(bmr_transform(step->pose, b->center), a->center);
    const double touching = a->radius + b->radius + need;
    if (!(bmr_dot(way, way) > touching * touching)) // mostly so: spare the rest
        return false;
    bmr_certificate k = {{0, 0}, 0, {{0, 0}, {0, 0}}, {0, 0}, {0, 0}};
    double reach = a->radius + b->radius;
    reach += round_center(a->center, k.normal) + round_center(b->center, k.window[0]);
    reach += EVALUATION_ERROR * (a->extent + b->extent);
    k.offset = (float)reach;
    if ((double)k.offset < reach)
        k.offset = nextafterf(k.offset, INFINITY);
    const double proved = bmr_disks_gap(&k, step->pose);
    if (!(proved > need))
        return false;
    step->pair->certificate = k;
    step->pair->level = BMR_LEVEL_DISKS;
    step->pair->state = BMR_PAIR_APART;
    step->pair->owner = 0;
    step->pair->free = 0;
    *gap = proved;
    return true;
}

static double farthest(const bmr_polygon *polygon, const float center[2]) {
    double distance = 0.0;
    for (uint32_t i = 0; i < polygon->count; ++i)
        distance = fmax(distance, hypot(polygon->vertices[i].x - (double)center[0],
                                        polygon->vertices[i].y - (double)center[1]));
    return distance;
}

bmr_error bmr_disks_audit(const bmr_certificate *certificate, const bmr_polygon *a, const bmr_polygon *b,
                          const bmr_pose *b_in_a) {
    const bmr_certificate *k = certificate;
    const double radii = farthest(a, k->normal) + farthest(b, k->window[0]);
    const bool covers = radii <= (double)k->offset;
    return covers && bmr_disks_gap(k, b_in_a) > 0.0 ? BMR_OK : BMR_ERROR_FALSE_CERTIFICATE;
}

// ---- contact, the quick check, the observer ----

void bmr_step_note(const bmr_step *step, bmr_event_kind kind, int level_before, int level_after, double gap) {
    const bmr_observer *observer = step->observer;
    if (!observer)
        return;
    if (observer->counters)
        ++observer->counters->events[kind];
    if (observer->on_event) {
        const bmr_event event = {kind, level_before, level_after, step->pair, step->pose, gap};
        observer->on_event(observer->context, &event);
    }
}

bmr_simplex bmr_contact_simplex(const bmr_pair *pair) {
    const uint32_t packed[3] = {pair->edge, pair->other, pair->other_after};
    bmr_simplex simplex = bmr_simplex_make(0, 0);
    simplex.count = pair->simplex;
    for (uint32_t i = 0; i < 3; ++i) { // past the count: read by nobody
        simplex.a[i] = packed[i] & 0xffffu;
        simplex.b[i] = packed[i] >> 16;
    }
    return simplex;
}

bmr_answer bmr_contact_enter(bmr_step *step, const bmr_simplex *simplex, int level) {
    bmr_pair *pair = step->pair;
    const bool entering = pair->state != BMR_PAIR_CONTACT;
    const int level_before = pair->state == BMR_PAIR_NEW ? BMR_LEVEL_DISKS : pair->level;
    uint32_t packed[3] = {0, 0, 0};
    for (uint32_t i = 0; i < simplex->count; ++i)
        packed[i] = simplex->a[i] | simplex->b[i] << 16;
    pair->edge = packed[0];
    pair->other = packed[1];
    pair->other_after = packed[2];
    pair->simplex = simplex->count & 3u;
    pair->state = BMR_PAIR_CONTACT;
    pair->level = (int8_t)level;
    pair->free = 0;
    if (entering)
        bmr_step_note(step, BMR_EVENT_CONTACT, level_before, level, 0.0);
    return BMR_STAB_POLYGON;
}

bool bmr_step_closest(bmr_step *step, bmr_simplex *simplex, bmr_closest *closest) {
    const bool apart = bmr_closest_direction(step->shapes[0]->polygon, step->shapes[1]->polygon, step->pose,
                                             step->reach, BMR_CLOSEST_SLACK, simplex, closest);
    step->steps += simplex->steps;
    simplex->steps = 0;
    return apart;
}

bool bmr_step_holds(const bmr_step *step, double need, double *gap) {
    return bmr_pair_quick_check(step->pair, step->pose, need, gap) == BMR_CHECK_HOLDS;
}
