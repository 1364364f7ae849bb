// SPDX-License-Identifier: MIT
#include "boomerang/exact32.h"

#include <float.h>

#include "clip_lanes.h"
#include "max_edge.h"

#if defined(__SSE2__)

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

    const edge_ends face_ends = {reference->vertices + edge, reference->vertices + second, edge, second};
    const edge_ends facing_ends = {incident->vertices + found, incident->vertices + next, found, next};
    clip_edges(manifold, face_ends, pose, facing_ends, incident_pose, radius_sum, reference_is_b);
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
