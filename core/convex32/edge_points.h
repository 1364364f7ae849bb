// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_EDGE_POINTS_H
#define BOOMERANG_CONVEX32_EDGE_POINTS_H

#include "edge_search.h"
#include "exact32/clip_lanes.h"

/// @file
/// From two edges that face each other to a manifold: what collide.c and collide_pieces.c share.

static inline edge_ends edge_ends_of(const bmr_convex32 *polygon, uint32_t first, uint32_t second) {
    const edge_ends ends = {polygon->vertices + first, polygon->vertices + second, (int32_t)(first & 0xffu),
                            (int32_t)(second & 0xffu)};
    return ends;
}

/// The edge of the incident polygon that faces the edge `found` of the reference.
static inline uint32_t edge_facing(const bmr_convex32 *reference, const bmr_transform32 *pose,
                                   const edge_view *found, const bmr_convex32 *incident,
                                   const bmr_transform32 *incident_pose) {
    return bmr_convex32_edge_against(incident, &bmr_convex32_here,
                                     turn_back(incident_pose, turn(pose, reference->normals[found->edge])),
                                     found->vertex);
}

static inline void points_between(bmr_manifold32 *manifold, const bmr_convex32 *reference,
                                  const bmr_transform32 *pose, uint32_t edge, const bmr_convex32 *incident,
                                  const bmr_transform32 *incident_pose, uint32_t facing, float radius_sum,
                                  bool reference_is_b) {
    manifold->type = reference_is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;
    const uint32_t second = convex32_next(reference, edge), next = convex32_next(incident, facing);
    const edge_ends face = edge_ends_of(reference, edge, second),
                    facing_ends = edge_ends_of(incident, facing, next);
    clip_edges(manifold, face, load4(&pose->p.x), facing_ends, load4(&incident_pose->p.x), radius_sum,
               reference_is_b);
}

/// Where the search for the least separated edges begins: from a to b, in the world.
static inline bmr_vec32 axis_to_begin(const bmr_convex32 *a, const bmr_transform32 *pose_a,
                                      const bmr_convex32 *b, const bmr_transform32 *pose_b,
                                      const bmr_convex32_memory *memory) {
    return remembers_axis(memory) ? remembered_axis(memory)
                                  : minus(move(pose_b, about_middle(b)), move(pose_a, about_middle(a)));
}

/// `axis` points from a to b, in the world.
static inline void remember(bmr_convex32_memory *memory, uint32_t vertex_a, uint32_t vertex_b,
                            bmr_vec32 axis) {
    memory->support_a = (uint16_t)vertex_a;
    memory->support_b = (uint16_t)vertex_b;
    remember_axis(memory, axis);
}

#endif
