// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_CLIP_LANES_H
#define BOOMERANG_EXACT32_CLIP_LANES_H

#include <string.h>

#include "clip.h"

/// @file
/// clip.h in lanes: the same bits, two points at a time.

/// Two points with their features, side by side: x0, y0, x1, y1.
typedef struct segment {
    float4 points;
    uint32_t features[2];
} segment;

/// Where the byte is in a word that lies in memory as bmr_feature32 does.
#if defined(__BYTE_ORDER__) && defined(__ORDER_BIG_ENDIAN__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#    define FEATURE_SHIFT(byte) (24 - 8 * (byte))
#else
#    define FEATURE_SHIFT(byte) (8 * (byte))
#endif

/// A feature as a word.
static inline uint32_t feature(int32_t index_a, int32_t index_b, uint32_t type_a, uint32_t type_b) {
    return (uint32_t)index_a << FEATURE_SHIFT(0) | (uint32_t)index_b << FEATURE_SHIFT(1) |
           type_a << FEATURE_SHIFT(2) | type_b << FEATURE_SHIFT(3);
}

static inline uint32_t swapped_feature(uint32_t f) {
    return (f & 0x00ff00ffu) << 8 | (f >> 8 & 0x00ff00ffu);
}

/// b, c of two vectors each: (a.x b.x + a.y b.y), in lanes 0 and 2, and again in 1 and 3.
static inline float4 dots(float4 a, float4 b) {
    const float4 products = mul4(a, b);
    return add4(products, swap4(products));
}

static inline float4 load_two(const bmr_vec32 *first, const bmr_vec32 *second) {
    return load_pairs4(&first->x, &second->x);
}

/// Two vectors turned by the pose's rotation.
static inline float4 turn_two(float4 pose, float4 vectors) {
    return add4(mul4(splat4(pose, 3), vectors), mul4(splat4(pose, 2), quarter_left(vectors)));
}

/// (y, -x) of (x, y), twice.
static inline float4 quarter_right_two(float4 vectors) {
    return flip_odd4(swap4(vectors));
}

/// Two vectors turned back.
static inline float4 turn_back_two(float4 pose, float4 vectors) {
    return add4(mul4(splat4(pose, 3), vectors), mul4(splat4(pose, 2), quarter_right_two(vectors)));
}

/// Cuts off what lies beyond the plane; false where less than two points are left. Sides are the distances
/// from it: where the segment crosses it a new point of vertex `index` of the reference takes the place of
/// the one that is lost, behind the one that stays.
static inline bool cut_segment(segment *s, float4 tangent, float sign, float offset, int32_t index) {
    float t[4], p[4];
    store4(t, tangent);
    store4(p, s->points);
    const float nx = sign * t[0], ny = sign * t[1];
    const float first = (nx * p[0] + ny * p[1]) - offset, second = (nx * p[2] + ny * p[3]) - offset;
    if (first <= 0.0f && second <= 0.0f)
        return true;
    if (!(first <= 0.0f || second <= 0.0f) || !(first * second < 0.0f))
        return false;
    const float along = first / (first - second);
    const float x = p[0] + along * (p[2] - p[0]), y = p[1] + along * (p[3] - p[1]);
    const int stays = first <= 0.0f ? 0 : 1;
    const uint32_t made = feature(index, (int32_t)(s->features[0] >> FEATURE_SHIFT(1) & 0xffu),
                                  BMR_FEATURE_VERTEX, BMR_FEATURE_FACE);
    s->points = of4(p[2 * stays], p[2 * stays + 1], x, y);
    s->features[0] = s->features[stays];
    s->features[1] = made;
    return true;
}

/// clip_edges_scalar.
static inline void clip_edges(bmr_manifold32 *manifold, edge_ends reference, float4 pose, edge_ends incident,
                              float4 incident_pose, float radius_sum, bool reference_is_b) {
    segment s;
    const float4 place = lows4(incident_pose, incident_pose);
    s.points = add4(turn_two(incident_pose, load_two(incident.first, incident.second)), place);
    s.features[0] = feature(reference.index, incident.index, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);
    s.features[1] = feature(reference.index, incident.next, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);

    // The reference edge: its ends, and its tangent in both halves.
    const float4 ends = load_two(reference.first, reference.second);
    const float4 others = exchange4(ends);
    const float4 along = sub4(others, ends), backwards = lows4(along, along);
    const float length = root_of4(first_of4(dots(backwards, backwards)));
    float4 tangent = backwards;
    if (!(length < FLT_EPSILON))
        tangent = mul4(tangent, all4(1.0f / length));
    const float4 middle = mul4(all4(0.5f), add4(ends, others));
    const float4 posed_tangent = turn_two(pose, tangent);
    const float4 posed_ends = add4(turn_two(pose, ends), lows4(pose, pose));
    const float4 normal = quarter_right_two(tangent), posed_normal = quarter_right_two(posed_tangent);

    const float4 front = dots(posed_normal, posed_ends), sides = dots(posed_tangent, posed_ends);
    const float first_offset = -first_of4(sides) + radius_sum;
    const float second_offset = first_of4(highs4(sides, sides)) + radius_sum;

    if (!cut_segment(&s, posed_tangent, -1.0f, first_offset, reference.index) ||
        !cut_segment(&s, posed_tangent, 1.0f, second_offset, reference.next))
        return;

    store_low4(&manifold->normal.x, normal);
    store_low4(&manifold->plane_point.x, middle);

    const float4 depth = sub4(dots(posed_normal, s.points), splat4(front, 0));
    const unsigned kept = bits4(at_most4(depth, all4(radius_sum)));
    const float4 local = turn_back_two(incident_pose, sub4(s.points, place));
    if (reference_is_b) {
        s.features[0] = swapped_feature(s.features[0]);
        s.features[1] = swapped_feature(s.features[1]);
    }
    bmr_manifold_point32 *point = manifold->points;
    if ((kept & 1u) != 0u) {
        store_low4(&point->point.x, local);
        memcpy(&point->feature, &s.features[0], sizeof point->feature);
        ++point;
    }
    if ((kept & 4u) != 0u) {
        store_high4(&point->point.x, local);
        memcpy(&point->feature, &s.features[1], sizeof point->feature);
        ++point;
    }
    manifold->count = (int32_t)(point - manifold->points);
}

#endif
