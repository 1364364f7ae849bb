// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_CLIP_LANES_H
#define BOOMERANG_EXACT32_CLIP_LANES_H

#include <string.h>

#include "clip.h"

/// @file
/// clip.h in SSE2: the same bits, two points at a time.

#if defined(__SSE2__)

/// Two points with their features, side by side: x0, y0, x1, y1.
typedef struct segment {
    __m128 points;
    uint32_t features[2];
} segment;

/// A feature as a word: the bytes of bmr_feature32 from the lowest up, which is their order in memory on
/// every machine that has SSE2.
static inline uint32_t feature(int32_t index_a, int32_t index_b, uint32_t type_a, uint32_t type_b) {
    return (uint32_t)index_a | (uint32_t)index_b << 8 | type_a << 16 | type_b << 24;
}

static inline uint32_t swapped_feature(uint32_t f) {
    return (f & 0x00ff00ffu) << 8 | (f >> 8 & 0x00ff00ffu);
}

/// b, c of two vectors each: (a.x b.x + a.y b.y), in lanes 0 and 2, and again in 1 and 3.
static inline __m128 dots(__m128 a, __m128 b) {
    const __m128 products = _mm_mul_ps(a, b);
    return _mm_add_ps(products, _mm_shuffle_ps(products, products, _MM_SHUFFLE(2, 3, 0, 1)));
}

static inline __m128 load_two(const bmr_vec32 *first, const bmr_vec32 *second) {
    return _mm_loadh_pi(_mm_loadl_pi(_mm_setzero_ps(), (const __m64 *)(const void *)first),
                        (const __m64 *)(const void *)second);
}

/// Two vectors turned by the pose's rotation.
static inline __m128 turn_two(__m128 pose, __m128 vectors) {
    return _mm_add_ps(_mm_mul_ps(SPLAT(pose, 3), vectors), _mm_mul_ps(SPLAT(pose, 2), quarter_left(vectors)));
}

/// Two vectors turned back.
static inline __m128 turn_back_two(__m128 pose, __m128 vectors) {
    const __m128 quarter_right =
        _mm_xor_ps(_mm_shuffle_ps(vectors, vectors, _MM_SHUFFLE(2, 3, 0, 1)),
                   _mm_castsi128_ps(_mm_set_epi32((int)0x80000000u, 0, (int)0x80000000u, 0)));
    return _mm_add_ps(_mm_mul_ps(SPLAT(pose, 3), vectors), _mm_mul_ps(SPLAT(pose, 2), quarter_right));
}

/// Cuts off what lies beyond the plane; false where less than two points are left. Sides are the distances
/// from it: where the segment crosses it a new point of vertex `index` of the reference takes the place of
/// the one that is lost, behind the one that stays.
static inline bool cut_segment(segment *s, __m128 tangent, float sign, float offset, int32_t index) {
    float t[4], p[4];
    _mm_storeu_ps(t, tangent);
    _mm_storeu_ps(p, s->points);
    const float nx = sign * t[0], ny = sign * t[1];
    const float first = (nx * p[0] + ny * p[1]) - offset, second = (nx * p[2] + ny * p[3]) - offset;
    if (first <= 0.0f && second <= 0.0f)
        return true;
    if (!(first <= 0.0f || second <= 0.0f) || !(first * second < 0.0f))
        return false;
    const float along = first / (first - second);
    const float x = p[0] + along * (p[2] - p[0]), y = p[1] + along * (p[3] - p[1]);
    const int stays = first <= 0.0f ? 0 : 1;
    const uint32_t made =
        feature(index, (int32_t)(s->features[0] >> 8 & 0xffu), BMR_FEATURE_VERTEX, BMR_FEATURE_FACE);
    s->points = _mm_setr_ps(p[2 * stays], p[2 * stays + 1], x, y);
    s->features[0] = s->features[stays];
    s->features[1] = made;
    return true;
}

/// clip_edges_scalar.
static inline void clip_edges(bmr_manifold32 *manifold, edge_ends reference, __m128 pose, edge_ends incident,
                              __m128 incident_pose, float radius_sum, bool reference_is_b) {
    segment s;
    const __m128 place = _mm_movelh_ps(incident_pose, incident_pose);
    s.points = _mm_add_ps(turn_two(incident_pose, load_two(incident.first, incident.second)), place);
    s.features[0] = feature(reference.index, incident.index, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);
    s.features[1] = feature(reference.index, incident.next, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);

    // The reference edge: its ends, and its tangent in both halves.
    const __m128 ends = load_two(reference.first, reference.second);
    const __m128 others = _mm_shuffle_ps(ends, ends, _MM_SHUFFLE(1, 0, 3, 2));
    const __m128 along = _mm_sub_ps(others, ends), backwards = _mm_movelh_ps(along, along);
    const __m128 length = _mm_sqrt_ss(dots(backwards, backwards));
    __m128 tangent = backwards;
    if (!(_mm_cvtss_f32(length) < FLT_EPSILON)) {
        const __m128 inverse = _mm_div_ss(_mm_set_ss(1.0f), length);
        tangent = _mm_mul_ps(tangent, SPLAT(inverse, 0));
    }
    const __m128 middle = _mm_mul_ps(_mm_set1_ps(0.5f), _mm_add_ps(ends, others));
    const __m128 posed_tangent = turn_two(pose, tangent);
    const __m128 posed_ends = _mm_add_ps(turn_two(pose, ends), _mm_movelh_ps(pose, pose));
    // (y, -x) of (x, y): a quarter to the right.
    const __m128 odd_signs = _mm_castsi128_ps(_mm_set_epi32((int)0x80000000u, 0, (int)0x80000000u, 0));
    const __m128 normal = _mm_xor_ps(_mm_shuffle_ps(tangent, tangent, _MM_SHUFFLE(2, 3, 0, 1)), odd_signs);
    const __m128 posed_normal =
        _mm_xor_ps(_mm_shuffle_ps(posed_tangent, posed_tangent, _MM_SHUFFLE(2, 3, 0, 1)), odd_signs);

    const __m128 front = dots(posed_normal, posed_ends), sides = dots(posed_tangent, posed_ends);
    const float first_offset = -_mm_cvtss_f32(sides) + radius_sum;
    const float second_offset = _mm_cvtss_f32(_mm_movehl_ps(sides, sides)) + radius_sum;

    if (!cut_segment(&s, posed_tangent, -1.0f, first_offset, reference.index) ||
        !cut_segment(&s, posed_tangent, 1.0f, second_offset, reference.next))
        return;

    _mm_storel_pi((__m64 *)(void *)&manifold->normal, normal);
    _mm_storel_pi((__m64 *)(void *)&manifold->plane_point, middle);

    const __m128 depth = _mm_sub_ps(dots(posed_normal, s.points), SPLAT(front, 0));
    const int kept = _mm_movemask_ps(_mm_cmple_ps(depth, _mm_set1_ps(radius_sum)));
    const __m128 local = turn_back_two(incident_pose, _mm_sub_ps(s.points, place));
    if (reference_is_b) {
        s.features[0] = swapped_feature(s.features[0]);
        s.features[1] = swapped_feature(s.features[1]);
    }
    bmr_manifold_point32 *point = manifold->points;
    if (kept & 1) {
        _mm_storel_pi((__m64 *)(void *)&point->point, local);
        memcpy(&point->feature, &s.features[0], sizeof point->feature);
        ++point;
    }
    if (kept & 4) {
        _mm_storeh_pi((__m64 *)(void *)&point->point, local);
        memcpy(&point->feature, &s.features[1], sizeof point->feature);
        ++point;
    }
    manifold->count = (int32_t)(point - manifold->points);
}

#endif

#endif
