// SPDX-License-Identifier: MIT
// The level above the bounding rectangles: two bounding disks. It has no direction, so that a pair spinning
// far apart costs nothing; the paper's rectangles alone would roll four times a turn for ever.
#include <math.h>

#include "pair/step.h"

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
