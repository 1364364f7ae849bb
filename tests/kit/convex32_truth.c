// SPDX-License-Identifier: MIT
// What references are held against: separations and distances in double; and when two manifolds are the same.
#include "convex32_reference.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

typedef struct wide {
    double x, y;
} wide;

static wide placed_wide(const bmr_transform32 *t, bmr_vec32 v) {
    const double s = (double)t->s, c = (double)t->c, x = (double)v.x, y = (double)v.y;
    const wide r = {c * x - s * y + (double)t->p.x, s * x + c * y + (double)t->p.y};
    return r;
}

static wide *all_placed(const bmr_convex32 *p, const bmr_transform32 *pose) {
    wide *const points = malloc(p->count * sizeof *points);
    for (uint32_t i = 0; points && i < p->count; ++i)
        points[i] = placed_wide(pose, p->vertices[i]);
    if (!points)
        abort();
    return points;
}

static double widely_separated(const wide *v, uint32_t count, const wide *others, uint32_t other_count) {
    double most = -DBL_MAX;
    for (uint32_t i = 0; i < count; ++i) {
        const wide from = v[i], to = v[i + 1 < count ? i + 1 : 0];
        const double x = to.y - from.y, y = from.x - to.x, length = sqrt(x * x + y * y);
        double least = DBL_MAX;
        for (uint32_t j = 0; j < other_count; ++j) {
            const double s = x * (others[j].x - from.x) + y * (others[j].y - from.y);
            if (s < least)
                least = s;
        }
        if (least / length > most)
            most = least / length;
    }
    return most;
}

double reference_true_separation(const bmr_convex32 *reference, const bmr_transform32 *pose,
                                 const bmr_convex32 *other, const bmr_transform32 *other_pose) {
    wide *const v = all_placed(reference, pose), *const others = all_placed(other, other_pose);
    const double most = widely_separated(v, reference->count, others, other->count);
    free(v);
    free(others);
    return most;
}

/// Of all vertices of one from all edges of the other; they do not overlap.
static double nearest_of(const wide *v, uint32_t count, const wide *points, uint32_t points_count) {
    double least = DBL_MAX;
    for (uint32_t i = 0; i < count; ++i) {
        const wide from = v[i], to = v[i + 1 < count ? i + 1 : 0];
        const double x = to.x - from.x, y = to.y - from.y;
        for (uint32_t j = 0; j < points_count; ++j) {
            const double px = points[j].x - from.x, py = points[j].y - from.y;
            const double along = fmin(1.0, fmax(0.0, (px * x + py * y) / (x * x + y * y)));
            const double dx = px - along * x, dy = py - along * y;
            least = fmin(least, dx * dx + dy * dy);
        }
    }
    return sqrt(least);
}

double reference_distance(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                          const bmr_transform32 *pose_b) {
    wide *const v = all_placed(a, pose_a), *const w = all_placed(b, pose_b);
    double distance = 0.0;
    if (widely_separated(v, a->count, w, b->count) > 0.0 || widely_separated(w, b->count, v, a->count) > 0.0)
        distance = fmin(nearest_of(v, a->count, w, b->count), nearest_of(w, b->count, v, a->count));
    free(v);
    free(w);
    return distance;
}

static bool same_vec(bmr_vec32 a, bmr_vec32 b) {
    return a.x == b.x && a.y == b.y; // never NaN: poses and polygons are finite
}

bool reference_same_manifold(const bmr_manifold32 *a, const bmr_manifold32 *b) {
    if (a->count != b->count || a->type != b->type || !same_vec(a->normal, b->normal) ||
        !same_vec(a->plane_point, b->plane_point))
        return false;
    for (int i = 0; i < a->count; ++i) {
        const bmr_feature32 f = a->points[i].feature, g = b->points[i].feature;
        if (!same_vec(a->points[i].point, b->points[i].point) || f.index_a != g.index_a ||
            f.index_b != g.index_b || f.type_a != g.type_a || f.type_b != g.type_b)
            return false;
    }
    return true;
}
