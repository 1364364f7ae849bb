// SPDX-License-Identifier: MIT
#include "exact32/exact32.h"

#include <float.h>

#include "clip_lanes.h"
#include "max_edge.h"

/// The edge of `incident` that faces `normal` (in its own frame, in both halves) most: the first of the least
/// products.
static inline int32_t find_incident_edge(const bmr_polygon32 *incident, float4 normal) {
    const float4 none = all4(FLT_MAX), x = splat4(normal, 0), y = splat4(normal, 1);
    const int32_t count = incident->count;
    float4 least[2] = {none, none};
    for (int32_t group = 0; 4 * group < count; ++group) {
        const int32_t left = count - 4 * group;
        const mask4 mask = first_lanes4(left < 4 ? left : 4, 0);
        const quad n = load_quad(incident->normals + 4 * group, mask);
        const float4 d = add4(mul4(x, n.x), mul4(y, n.y));
        least[group] = min4(select4(mask, d, none), none); // a NaN becomes "none"
    }
    const float4 all = all4(least_of4(min4(least[0], least[1])));
    // Where nothing is less than FLT_MAX, all lanes hit, and the first is what stays.
    const unsigned hits = bits4(equal4(least[0], all)) | bits4(equal4(least[1], all)) << 4;
    return lowest_bit(hits);
}

/// The part of the manifold that hangs on which polygon is the reference.
static inline void make_points(bmr_manifold32 *manifold, const bmr_polygon32 *reference, float4 pose,
                               int32_t edge, const bmr_polygon32 *incident, float4 incident_pose,
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
    const float4 at_a = load4(&pose_a->p.x), at_b = load4(&pose_b->p.x);
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
