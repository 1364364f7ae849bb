// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_CLIP_H
#define BOOMERANG_EXACT32_CLIP_H

#include <float.h>
#include <math.h>

#include "lanes.h"

/// @file
/// How Box2D makes points of an incident edge and a reference edge, one float after the other.

/// A point of the incident edge on its way through the cuts.
typedef struct corner {
    bmr_vec32 v;
    bmr_feature32 feature;
} corner;

static inline float dot(bmr_vec32 a, bmr_vec32 b) {
    return a.x * b.x + a.y * b.y;
}

static inline bmr_vec32 minus(bmr_vec32 a, bmr_vec32 b) {
    const bmr_vec32 r = {a.x - b.x, a.y - b.y};
    return r;
}

/// A quarter turn to the right: the outward normal of an edge that runs along v.
static inline bmr_vec32 quarter_right(bmr_vec32 v) {
    const bmr_vec32 r = {v.y, -v.x};
    return r;
}

static inline bmr_vec32 turn_back(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x + t->s * v.y, -t->s * v.x + t->c * v.y};
    return r;
}

/// From a point in the world to the frame of the pose.
static inline bmr_vec32 move_back(const bmr_transform32 *t, bmr_vec32 v) {
    return turn_back(t, minus(v, t->p));
}

/// Its unit vector; too short an edge is left as it is.
static inline bmr_vec32 direction(bmr_vec32 v) {
    const float length = sqrtf(v.x * v.x + v.y * v.y);
    if (length < FLT_EPSILON)
        return v;
    const float inverse = 1.0f / length;
    const bmr_vec32 r = {v.x * inverse, v.y * inverse};
    return r;
}

/// Keeps of two corners what lies behind the plane and puts in the point where they cross it; false where
/// less than two are left.
static inline bool cut(corner corners[2], bmr_vec32 normal, float offset, int32_t index) {
    const corner first = corners[0], second = corners[1];
    const float d0 = dot(normal, first.v) - offset, d1 = dot(normal, second.v) - offset;
    int count = 0;
    if (d0 <= 0.0f)
        corners[count++] = first;
    if (d1 <= 0.0f)
        corners[count++] = second;
    if (count < 2 && d0 * d1 < 0.0f) {
        const float along = d0 / (d0 - d1);
        corners[count].v.x = first.v.x + along * (second.v.x - first.v.x);
        corners[count].v.y = first.v.y + along * (second.v.y - first.v.y);
        corners[count].feature.index_a = (uint8_t)index;
        corners[count].feature.index_b = first.feature.index_b;
        corners[count].feature.type_a = BMR_FEATURE_VERTEX;
        corners[count].feature.type_b = BMR_FEATURE_FACE;
        ++count;
    }
    return count == 2;
}

/// Adds a point, which is given in the frame that it belongs to.
static inline void keep(bmr_manifold32 *manifold, bmr_vec32 local, bmr_feature32 f, bool swap) {
    bmr_manifold_point32 *point = manifold->points + manifold->count++;
    const bmr_feature32 swapped = {f.index_b, f.index_a, f.type_b, f.type_a};
    point->point = local;
    point->feature = swap ? swapped : f;
}

/// An edge of a polygon by its place in the arrays.
typedef struct edge_ends {
    const bmr_vec32 *first, *second;
    int32_t index, next; ///< numbers of these for the features: 0 to 255
} edge_ends;

static inline corner corner_of(bmr_vec32 place, int32_t vertex, int32_t edge) {
    const corner c = {place, {(uint8_t)edge, (uint8_t)vertex, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX}};
    return c;
}

/// Points where the incident edge lies above the reference edge: `normal` and `plane_point` where the cuts
/// leave two, and as many points as are within the skins.
static inline void clip_edges_scalar(bmr_manifold32 *manifold, edge_ends reference,
                                     const bmr_transform32 *pose, edge_ends incident,
                                     const bmr_transform32 *incident_pose, float radius_sum,
                                     bool reference_is_b) {
    corner corners[2] = {corner_of(move(incident_pose, *incident.first), incident.index, reference.index),
                         corner_of(move(incident_pose, *incident.second), incident.next, reference.index)};
    const bmr_vec32 from = *reference.first, to = *reference.second;
    const bmr_vec32 tangent = direction(minus(to, from));
    const bmr_vec32 posed_tangent = turn(pose, tangent), posed_normal = quarter_right(posed_tangent);
    const bmr_vec32 backwards = {-posed_tangent.x, -posed_tangent.y};
    const bmr_vec32 posed_from = move(pose, from), posed_to = move(pose, to);
    if (!cut(corners, backwards, -dot(posed_tangent, posed_from) + radius_sum, reference.index) ||
        !cut(corners, posed_tangent, dot(posed_tangent, posed_to) + radius_sum, reference.next))
        return;

    manifold->normal = quarter_right(tangent);
    manifold->plane_point.x = 0.5f * (from.x + to.x);
    manifold->plane_point.y = 0.5f * (from.y + to.y);
    const float front = dot(posed_normal, posed_from);
    for (int i = 0; i < 2; ++i)
        if (dot(posed_normal, corners[i].v) - front <= radius_sum)
            keep(manifold, move_back(incident_pose, corners[i].v), corners[i].feature, reference_is_b);
}

#endif
