// SPDX-License-Identifier: MIT
#include "edge_search.h"

/// More than the length of a remembered direction, whose coordinates were rounded.
static const float longest_axis = 32768.0f;

/// Of the sum of all coordinates that go in, each of which is rounded five times at most on the way: 2^-24
/// each, and the sines and cosines are themselves off by as much.
static const float noise_of_size = 0x1p-21f;

typedef struct gap {
    float certain; ///< so much, times the direction's length, are they apart along it
    uint32_t vertex_a, vertex_b;
    bmr_vec32 between; ///< from a's vertex to b's, in the world
} gap;

/// Along a direction of about longest_axis, in the world.
static inline gap gap_along(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, bmr_vec32 axis, uint32_t hint_a, uint32_t hint_b) {
    gap g;
    g.vertex_a = farthest32(a, turn_back(pose_a, axis), hint_a);
    g.vertex_b = farthest32(b, turn_back(pose_b, negative(axis)), hint_b);
    const bmr_vec32 p = a->vertices[g.vertex_a], q = b->vertices[g.vertex_b];
    const bmr_vec32 way = minus(pose_b->p, pose_a->p);
    const bmr_vec32 from = turn(pose_a, p), to = turn(pose_b, q);
    g.between.x = (to.x - from.x) + way.x;
    g.between.y = (to.y - from.y) + way.y;
    const float size = convex32_size(p) + convex32_size(q) + convex32_size(way);
    g.certain = dot(axis, g.between) - (noise_of_size * longest_axis) * size;
    return g;
}

bool bmr_convex32_apart(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                        const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory) {
    const float enough = reach * longest_axis;
    if (!remembers_axis(memory))
        remember_axis(memory, direction(minus(move(pose_b, about_middle(b)), move(pose_a, about_middle(a)))));
    const gap first =
        gap_along(a, pose_a, b, pose_b, remembered_axis(memory), memory->support_a, memory->support_b);
    memory->support_a = (uint16_t)first.vertex_a;
    memory->support_b = (uint16_t)first.vertex_b;
    if (first.certain > enough)
        return true;

    // Two more directions: along the line between the two vertices, which is right where they are the closest
    // ones, and across the line between what the two looks found, which is right where that is part of an
    // edge or nearly so.
    bmr_vec32 axis = first.between;
    float most = first.certain;
    gap last = first;
    for (int looks = 0; looks < 2 && dot(last.between, last.between) > reach * reach; ++looks) {
        bmr_convex32_memory turned = *memory;
        remember_axis(&turned, direction(axis));
        const gap next =
            gap_along(a, pose_a, b, pose_b, remembered_axis(&turned), last.vertex_a, last.vertex_b);
        if (next.certain > most) {
            most = next.certain;
            *memory = turned;
            memory->support_a = (uint16_t)next.vertex_a;
            memory->support_b = (uint16_t)next.vertex_b;
        }
        if (next.certain > enough)
            return true;
        axis = quarter_right(minus(next.between, first.between));
        if (dot(axis, first.between) < 0.0f)
            axis = negative(axis);
        last = next;
    }
    return false;
}
