// SPDX-License-Identifier: MIT
#include "exact32/exact32.h"

#include <float.h>

#include "clip.h"

static int32_t after(int32_t index, int32_t count) {
    return index + 1 < count ? index + 1 : 0;
}

/// The edge whose normal has the least product with `normal`, the first of equals.
static int32_t find_incident_edge(const bmr_polygon32 *incident, bmr_vec32 normal) {
    int32_t found = 0;
    float least = FLT_MAX;
    for (int32_t i = 0; i < incident->count; ++i) {
        const float d = dot(normal, incident->normals[i]);
        if (d < least) {
            least = d;
            found = i;
        }
    }
    return found;
}

static void make_points(bmr_manifold32 *manifold, const bmr_polygon32 *reference, const bmr_transform32 *pose,
                        int32_t edge, const bmr_polygon32 *incident, const bmr_transform32 *incident_pose,
                        float radius_sum, bool reference_is_b) {
    manifold->type = reference_is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;
    const int32_t found =
        find_incident_edge(incident, turn_back(incident_pose, turn(pose, reference->normals[edge])));
    const int32_t next = after(found, incident->count), second = after(edge, reference->count);
    const edge_ends face = {reference->vertices + edge, reference->vertices + second, edge, second};
    const edge_ends facing = {incident->vertices + found, incident->vertices + next, found, next};
    clip_edges_scalar(manifold, face, pose, facing, incident_pose, radius_sum, reference_is_b);
}

int32_t bmr_exact32_collide_scalar(bmr_manifold32 *manifold, const bmr_polygon32 *a,
                                   const bmr_transform32 *pose_a, const bmr_polygon32 *b,
                                   const bmr_transform32 *pose_b, float radius_sum, float tolerance) {
    manifold->count = 0;
    const bmr_transform32 a_in_b = bmr_exact32_relative(pose_b, pose_a);
    int32_t edge_a, edge_b;
    const float of_a = bmr_exact32_max_separation_scalar(a, b, &a_in_b, &edge_a);
    if (of_a > radius_sum)
        return edge_a;
    const bmr_transform32 b_in_a = bmr_exact32_relative(pose_a, pose_b);
    const float of_b = bmr_exact32_max_separation_scalar(b, a, &b_in_a, &edge_b);
    if (of_b > radius_sum)
        return BMR_EDGES_OF_B32 + edge_b;
    if (of_b > of_a + tolerance)
        make_points(manifold, b, pose_b, edge_b, a, pose_a, radius_sum, true);
    else
        make_points(manifold, a, pose_a, edge_a, b, pose_b, radius_sum, false);
    return BMR_NO_EDGE32;
}
