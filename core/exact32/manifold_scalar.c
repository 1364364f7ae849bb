// SPDX-License-Identifier: MIT
#include "boomerang/exact32.h"

#include <float.h>
#include <math.h>

#include "lanes.h"

/// A point of the incident edge on its way through the cuts.
typedef struct corner {
    bmr_vec32 v;
    bmr_feature32 feature;
} corner;

static float dot(bmr_vec32 a, bmr_vec32 b) {
    return a.x * b.x + a.y * b.y;
}

static bmr_vec32 minus(bmr_vec32 a, bmr_vec32 b) {
    const bmr_vec32 r = {a.x - b.x, a.y - b.y};
    return r;
}

/// A quarter turn to the right: the outward normal of an edge that runs along v.
static bmr_vec32 quarter_right(bmr_vec32 v) {
    const bmr_vec32 r = {v.y, -v.x};
    return r;
}

static bmr_vec32 turn_back(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x + t->s * v.y, -t->s * v.x + t->c * v.y};
    return r;
}

static int32_t after(int32_t index, int32_t count) {
    return index + 1 < count ? index + 1 : 0;
}

/// Its unit vector; too short an edge is left as it is.
static bmr_vec32 direction(bmr_vec32 v) {
    const float length = sqrtf(v.x * v.x + v.y * v.y);
    if (length < FLT_EPSILON)
        return v;
    const float inverse = 1.0f / length;
    const bmr_vec32 r = {v.x * inverse, v.y * inverse};
    return r;
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

/// Keeps of two corners what lies behind the plane and puts in the point where they cross it; false where
/// less than two are left.
static bool cut(corner corners[2], bmr_vec32 normal, float offset, int32_t index) {
    const corner first = corners[0], second = corners[1];
    const float d0 = dot(normal, first.v) - offset, d1 = dot(normal, second.v) - offset;
    int count = 0;
    if (d0 <= 0.0f)
        corners[count++] = first;
    if (d1 <= 0.0f)
        corners[count++] = second;
    if (count < 2 && d0 * d1 < 0.0f) {
        const float along = d0 / (d0 - d1);
        corners[count].v.x = first.v.x + along * (second.v.x - first.v.x);
        corners[count].v.y = first.v.y + along * (second.v.y - first.v.y);
        corners[count].feature.index_a = (uint8_t)index;
        corners[count].feature.index_b = first.feature.index_b;
        corners[count].feature.type_a = BMR_FEATURE_VERTEX;
        corners[count].feature.type_b = BMR_FEATURE_FACE;
        ++count;
    }
    return count == 2;
}

static corner corner_of(const bmr_polygon32 *incident, const bmr_transform32 *pose, int32_t index,
                        int32_t edge) {
    const corner c = {move(pose, incident->vertices[index]),
                      {(uint8_t)edge, (uint8_t)index, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX}};
    return c;
}

static void keep(bmr_manifold32 *manifold, const corner *c, const bmr_transform32 *incident_pose, bool swap) {
    bmr_manifold_point32 *point = manifold->points + manifold->count++;
    const bmr_feature32 f = c->feature, swapped = {f.index_b, f.index_a, f.type_b, f.type_a};
    point->point = turn_back(incident_pose, minus(c->v, incident_pose->p));
    point->feature = swap ? swapped : f;
}

static void make_points(bmr_manifold32 *manifold, const bmr_polygon32 *reference, const bmr_transform32 *pose,
                        int32_t edge, const bmr_polygon32 *incident, const bmr_transform32 *incident_pose,
                        float radius_sum, bool reference_is_b) {
    manifold->type = reference_is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;
    const int32_t found =
        find_incident_edge(incident, turn_back(incident_pose, turn(pose, reference->normals[edge])));
    corner corners[2] = {corner_of(incident, incident_pose, found, edge),
                         corner_of(incident, incident_pose, after(found, incident->count), edge)};

    const int32_t second = after(edge, reference->count);
    const bmr_vec32 from = reference->vertices[edge], to = reference->vertices[second];
    const bmr_vec32 tangent = direction(minus(to, from));
    const bmr_vec32 posed_tangent = turn(pose, tangent), posed_normal = quarter_right(posed_tangent);
    const bmr_vec32 backwards = {-posed_tangent.x, -posed_tangent.y};
    const bmr_vec32 posed_from = move(pose, from), posed_to = move(pose, to);
    if (!cut(corners, backwards, -dot(posed_tangent, posed_from) + radius_sum, edge) ||
        !cut(corners, posed_tangent, dot(posed_tangent, posed_to) + radius_sum, second))
        return;

    manifold->normal = quarter_right(tangent);
    manifold->plane_point.x = 0.5f * (from.x + to.x);
    manifold->plane_point.y = 0.5f * (from.y + to.y);
    const float front = dot(posed_normal, posed_from);
    for (int i = 0; i < 2; ++i)
        if (dot(posed_normal, corners[i].v) - front <= radius_sum)
            keep(manifold, &corners[i], incident_pose, reference_is_b);
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
