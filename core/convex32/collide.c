// SPDX-License-Identifier: MIT
#include "convex32_pieces.h"
#include "edge_points.h"

/// The products of one unit normal with two others may come out in the wrong order if they differ by less
/// than this: each is off by at most 4 times 2^-24, the turning included.
static const float noise_of_cosine = 0x1p-21f;

uint32_t bmr_convex32_edge_against(const bmr_convex32 *polygon, const bmr_transform32 *turned,
                                   bmr_vec32 normal, uint32_t hint) {
    const uint32_t start = edge_towards(polygon, turn_back(turned, negative(normal)), hint);
    uint32_t found = start;
    float least = dot(normal, turn(turned, polygon->normals[start]));
    for (int side = 0; side < 2; ++side) {
        uint32_t j = start;
        for (uint32_t steps = 1; steps < polygon->count; ++steps) {
            j = side == 0 ? convex32_next(polygon, j) : convex32_previous(polygon, j);
            const float d = dot(normal, turn(turned, polygon->normals[j]));
            if (d < least || (d == least && j < found)) {
                least = d;
                found = j;
            }
            if (!(d <= least + noise_of_cosine))
                break;
        }
    }
    return found;
}

/// `found` is an edge of the reference.
static void make_points(bmr_manifold32 *manifold, const bmr_convex32 *reference, const bmr_transform32 *pose,
                        const edge_view *found, const bmr_convex32 *incident,
                        const bmr_transform32 *incident_pose, float radius_sum, bool reference_is_b) {
    const uint32_t facing = edge_facing(reference, pose, found, incident, incident_pose);
    points_between(manifold, reference, pose, found->edge, incident, incident_pose, facing, radius_sum,
                   reference_is_b);
}

/// B's edges, from where A's best one was found.
static void seek_of_b(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                      const bmr_transform32 *pose_b, const edge_view *best_a, float floor, edge_found *of_b) {
    const edge_search search = edge_search_of(b, a, bmr_exact32_relative(pose_a, pose_b), 0.0f);
    bmr_convex32_seek(&search, best_a->vertex, best_a->edge, floor, of_b);
}

void bmr_convex32_collide(bmr_manifold32 *manifold, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                          const bmr_convex32 *b, const bmr_transform32 *pose_b, float radius_sum,
                          float tolerance, bmr_convex32_memory *memory) {
    if (a->seams || b->seams) {
        bmr_convex32_collide_pieces(manifold, a, pose_a, b, pose_b, radius_sum, tolerance, memory);
        return;
    }
    manifold->count = 0;
    const bmr_vec32 axis = axis_to_begin(a, pose_a, b, pose_b, memory);
    edge_found of_a, of_b;
    const edge_search edges_of_a = edge_search_of(a, b, bmr_exact32_relative(pose_b, pose_a), tolerance);
    bmr_convex32_seek(&edges_of_a, edge_towards(a, turn_back(pose_a, axis), memory->support_a),
                      memory->support_b, -FLT_MAX, &of_a);
    const edge_view *const best_a = &of_a.best;
    remember(memory, best_a->edge, best_a->vertex, turn(pose_a, a->normals[best_a->edge]));
    if (!(best_a->separation <= radius_sum))
        return;

    // B's edges matter only if one separates by more than the skins, or by `tolerance` more than A's best. An
    // edge of B that lies along A's best one separates by as much, up to rounding (`along`); of the others
    // `rest` is a bound.
    const float enough = best_a->separation + tolerance;
    const float floor = enough < radius_sum ? enough : radius_sum;
    const edge_view *const best_b = &of_b.best;
    const float along = best_a->separation + 2.0f * best_a->noise, rest = of_a.rest + 2.0f * best_a->noise;
    if (rest >= floor || along >= floor) {
        seek_of_b(a, pose_a, b, pose_b, best_a, floor, &of_b);
        const bool beyond = best_b->separation > radius_sum, reference = best_b->separation > enough;
        if (beyond || reference)
            remember(memory, best_b->vertex, best_b->edge, negative(turn(pose_b, b->normals[best_b->edge])));
        if (beyond)
            return;
        if (reference) {
            make_points(manifold, b, pose_b, best_b, a, pose_a, radius_sum, true);
            return;
        }
    }
    make_points(manifold, a, pose_a, best_a, b, pose_b, radius_sum, false);

    // No points: the short edge of B that faces A's face may lie beyond A's corner. With B's face as the
    // reference there are some.
    if (manifold->count == 0 && (a->count > 8 || b->count > 8)) {
        seek_of_b(a, pose_a, b, pose_b, best_a, -FLT_MAX, &of_b);
        make_points(manifold, b, pose_b, best_b, a, pose_a, radius_sum, true);
    }
}
