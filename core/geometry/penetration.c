// SPDX-License-Identifier: MIT
// The penetration depth of two convex polygons: B - A is a convex polygon whose edges have the normals of
// A's edges and of B's, and the shortest way out of it is across one of its edges.
//
// All edges are looked at, and no search by halves can do without. Where polygons are apart, the separation
// along a direction has one largest value, and what is downhill is left out. Inside, it has a smallest value
// for each edge that is nearer than its neighbours, and a regular polygon with a point at its centre has n of
// them, all equal. The levels of a hierarchy do not tell them apart either: every chain of edges there has
// the same bound as every other.
#include <math.h>

#include "boomerang/distance.h"
#include "geometry/posed_polygons.h"

/// The best edge so far.
typedef struct side {
    double separation; ///< of the other polygon from the edge's line; < 0: it is beyond it
    bmr_vec2 normal;   ///< the edge's, outwards, its polygon's frame
    bmr_vec2 nearest;  ///< the other polygon's vertex that is deepest, the same frame
} side;

/// Goes through the edges of `own`; the other polygon's deepest vertex moves along with them.
static side best_side(const bmr_polygon *own, const bmr_polygon *other, const bmr_pose *other_in_own) {
    side best = {-INFINITY, {0.0, 0.0}, {0.0, 0.0}};
    uint32_t deepest = 0;
    for (uint32_t i = 0; own->count > 1 && i < own->count; ++i) {
        const bmr_vec2 normal = bmr_polygon_normal(own, i);
        deepest = bmr_polygon_support_from(other, bmr_unrotate(other_in_own, bmr_neg(normal)), deepest);
        const bmr_vec2 nearest = bmr_transform(other_in_own, other->vertices[deepest]);
        const double separation = bmr_dot(normal, bmr_sub(nearest, own->vertices[i]));
        if (separation > best.separation) {
            const side found = {separation, normal, nearest};
            best = found;
        }
    }
    return best;
}

bmr_error bmr_penetration(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                          const bmr_pose *pose_b, bmr_overlap *overlap) {
    bmr_posed_polygons q;
    const bmr_error error = bmr_posed_polygons_make(a, pose_a, b, pose_b, overlap, &q);
    if (error != BMR_OK)
        return error;
    const bmr_overlap none = {0.0, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    *overlap = none;
    bmr_closest_points closest;
    unsigned steps = 0;
    if (bmr_posed_polygons_closest(&q, &steps, &closest))
        return BMR_OK;
    const bmr_pose a_in_b = bmr_pose_inverse(&q.b_in_a);
    const side of_a = best_side(a, b, &q.b_in_a), of_b = best_side(b, a, &a_in_b);
    bmr_vec2 normal, point_a, point_b; // in A's frame
    if (of_a.separation >= of_b.separation) {
        overlap->depth = fmax(0.0, -of_a.separation);
        normal = of_a.normal;
        point_b = of_a.nearest;
        point_a = bmr_add(point_b, bmr_scale(overlap->depth, normal));
    } else {
        overlap->depth = fmax(0.0, -of_b.separation);
        normal = bmr_neg(bmr_rotate(&q.b_in_a, of_b.normal));
        point_a = bmr_transform(&q.b_in_a, of_b.nearest);
        point_b = bmr_sub(point_a, bmr_scale(overlap->depth, normal));
    }
    if (a->count == 1 && b->count == 1) { // no edge at all
        overlap->depth = 0.0;
        normal = bmr_vec2_make(0.0, 0.0);
        point_a = point_b = a->vertices[0];
    }
    overlap->normal = bmr_rotate(&q.pose_a, normal);
    overlap->point_a = bmr_transform(&q.pose_a, point_a);
    overlap->point_b = bmr_transform(&q.pose_a, point_b);
    return BMR_OK;
}
