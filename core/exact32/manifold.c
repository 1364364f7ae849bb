// SPDX-License-Identifier: MIT
#include "boomerang/exact32.h"

#include <float.h>
#include <string.h>

#include "max_edge.h"

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

/// The edge of `incident` that faces `normal` (in its own frame, in both halves) most: the first of the least
/// products.
static inline int32_t find_incident_edge(const bmr_polygon32 *incident, __m128 normal) {
    const __m128 none = _mm_set1_ps(FLT_MAX), x = SPLAT(normal, 0), y = SPLAT(normal, 1);
    const int32_t count = incident->count;
    __m128 least[2] = {none, none};
    for (int32_t group = 0; 4 * group < count; ++group) {
        const int32_t left = count - 4 * group;
        const __m128 mask = lanes(left < 4 ? left : 4, 0);
        const quad n = load_quad(incident->normals + 4 * group, mask);
        const __m128 d = _mm_add_ps(_mm_mul_ps(x, n.x), _mm_mul_ps(y, n.y));
        least[group] = _mm_min_ps(blend(mask, d, none), none); // a NaN becomes "none"
    }
    __m128 m = _mm_min_ps(least[0], least[1]);
    m = _mm_min_ps(m, _mm_movehl_ps(m, m));
    m = _mm_min_ss(m, SPLAT(m, 1));
    const __m128 all = SPLAT(m, 0);
    // Where nothing is less than FLT_MAX, all lanes hit, and the first is what stays.
    const int hits =
        _mm_movemask_ps(_mm_cmpeq_ps(least[0], all)) | _mm_movemask_ps(_mm_cmpeq_ps(least[1], all)) << 4;
    return __builtin_ctz((unsigned)hits);
}

/// Cuts off what lies beyond the plane; false where less than two points are left. Sides are the distances
/// from it: where the segment crosses it a new point of vertex `index` of the reference takes the place of
/// the one that is lost, behind the one that stays.
static bool cut(segment *s, __m128 tangent, float sign, float offset, int32_t index) {
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

/// The part of the manifold that hangs on which polygon is the reference.
static inline void make_points(bmr_manifold32 *manifold, const bmr_polygon32 *reference, __m128 pose,
                               int32_t edge, const bmr_polygon32 *incident, __m128 incident_pose,
                               float radius_sum, bool reference_is_b) {
    manifold->type = reference_is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;

    const bmr_vec32 *const face = reference->normals + edge;
    const int32_t second = edge + 1 < reference->count ? edge + 1 : 0;
    const int32_t found =
        find_incident_edge(incident, turn_back_two(incident_pose, turn_two(pose, load_two(face, face))));
    const int32_t next = found + 1 < incident->count ? found + 1 : 0;

    segment s;
    const __m128 place = _mm_movelh_ps(incident_pose, incident_pose);
    s.points = _mm_add_ps(
        turn_two(incident_pose, load_two(incident->vertices + found, incident->vertices + next)), place);
    s.features[0] = feature(edge, found, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);
    s.features[1] = feature(edge, next, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);

    // The reference edge: its ends, and its tangent in both halves.
    const __m128 ends = load_two(reference->vertices + edge, reference->vertices + second);
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

    if (!cut(&s, posed_tangent, -1.0f, first_offset, edge) ||
        !cut(&s, posed_tangent, 1.0f, second_offset, second))
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

int32_t bmr_exact32_collide(bmr_manifold32 *manifold, const bmr_polygon32 *a, const bmr_transform32 *pose_a,
                            const bmr_polygon32 *b, const bmr_transform32 *pose_b, float radius_sum,
                            float tolerance) {
    manifold->count = 0;
    const __m128 at_a = _mm_loadu_ps(&pose_a->p.x), at_b = _mm_loadu_ps(&pose_b->p.x);
    const max_edge of_a = find_max_edge(a, b, relative(at_b, at_a));
    if (of_a.separation > radius_sum)
        return of_a.edge;
    const max_edge of_b = find_max_edge(b, a, relative(at_a, at_b));
    if (of_b.separation > radius_sum)
        return BMR_EDGES_OF_B32 + of_b.edge;
    if (of_b.separation > of_a.separation + tolerance)
        make_points(manifold, b, at_b, of_b.edge, a, at_a, radius_sum, true);
    else
        make_points(manifold, a, at_a, of_a.edge, b, at_b, radius_sum, false);
    return BMR_NO_EDGE32;
}

#else

int32_t bmr_exact32_collide(bmr_manifold32 *manifold, const bmr_polygon32 *a, const bmr_transform32 *pose_a,
                            const bmr_polygon32 *b, const bmr_transform32 *pose_b, float radius_sum,
                            float tolerance) {
    return bmr_exact32_collide_scalar(manifold, a, pose_a, b, pose_b, radius_sum, tolerance);
}

#endif
