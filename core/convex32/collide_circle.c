// SPDX-License-Identifier: MIT
#include "piece_faces.h"

static void one_point(bmr_manifold32 *manifold, bmr_vec32 centre, bmr_vec32 normal, bmr_vec32 plane_point) {
    static const bmr_feature32 none = {0, 0, 0, 0};
    manifold->count = 1;
    manifold->type = BMR_MANIFOLD_FACE_A;
    manifold->normal = normal;
    manifold->plane_point = plane_point;
    manifold->points[0].point = centre;
    manifold->points[0].feature = none;
}

/// Unless the centre is farther than the radius from the vertex, or in a direction that is not the polygon's.
static void point_at_vertex(bmr_manifold32 *manifold, bmr_vec32 centre, bmr_vec32 local,
                            const bmr_convex32 *polygon, uint32_t at, float radius_sum) {
    const bmr_vec32 vertex = polygon->vertices[at], d = minus(local, vertex), normal = direction(d);
    if (!(dot(d, d) > radius_sum * radius_sum) && bmr_convex32_admits(polygon, at, normal, rounding_of_turn))
        one_point(manifold, centre, normal, vertex);
}

/// The centre is inside, nearest to the inner edge `inner`: the face of largest separation, unless it is
/// deeper by more than the radii; then the inner edge. polygon->count where there is no face. O(n).
static uint32_t edge_around(const edge_search *search, const edge_view *inner, float radius_sum) {
    uint32_t found = search->reference->count;
    float separation = -FLT_MAX;
    for (uint32_t i = 0; i < search->reference->count; ++i) {
        if (!is_face(search->reference, i))
            continue;
        const edge_view view = bmr_convex32_look(search, i, 0);
        if (view.separation > separation) {
            separation = view.separation;
            found = i;
        }
    }
    const bool far = inner->separation > separation + radius_sum;
    return far && found < search->reference->count ? inner->edge : found;
}

void bmr_convex32_collide_circle(bmr_manifold32 *manifold, const bmr_convex32 *polygon,
                                 const bmr_transform32 *pose_polygon, bmr_vec32 centre,
                                 const bmr_transform32 *pose_circle, float radius_sum,
                                 bmr_convex32_memory *memory) {
    manifold->count = 0;
    const bmr_vec32 local = move_back(pose_polygon, move(pose_circle, centre));
    const bmr_vec32 towards = remembers_axis(memory) ? turn_back(pose_polygon, remembered_axis(memory))
                                                     : minus(local, about_middle(polygon));
    const bmr_convex32 point = {&local, NULL, NULL, 1, 0, {0.0f, 0.0f}, NULL};
    const edge_search search = edge_search_of(polygon, &point, bmr_convex32_here, 0.0f);
    edge_found found;
    bmr_convex32_seek(&search, edge_towards(polygon, towards, memory->support_a), 0, -FLT_MAX, &found);
    uint32_t edge = found.best.edge;
    memory->support_a = (uint16_t)edge;
    remember_axis(memory, turn(pose_polygon, polygon->normals[edge]));
    if (!(found.best.separation <= radius_sum))
        return;

    const bool inside = found.best.separation < FLT_EPSILON;
    if (inside && !is_face(polygon, edge))
        edge = edge_around(&search, &found.best, radius_sum);
    if (edge == polygon->count)
        return;
    const uint32_t second = convex32_next(polygon, edge);
    const bmr_vec32 v1 = polygon->vertices[edge], v2 = polygon->vertices[second];
    const bmr_vec32 middle = {0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y)};
    if (!inside && dot(minus(local, v1), minus(v2, v1)) <= 0.0f) {
        point_at_vertex(manifold, centre, local, polygon, edge, radius_sum);
    } else if (!inside && dot(minus(local, v2), minus(v1, v2)) <= 0.0f) {
        point_at_vertex(manifold, centre, local, polygon, second, radius_sum);
    } else if (inside || (is_face(polygon, edge) &&
                          !(dot(minus(local, middle), polygon->normals[edge]) > radius_sum))) {
        one_point(manifold, centre, polygon->normals[edge], middle);
    }
}
