// SPDX-License-Identifier: MIT
#include "geometry/bounding_disk.h"

#include <math.h>
#include <stdbool.h>

/// The farthest point is added to the points that span the disk, until it is outside of the disk by less than
/// this part of the radius.
#define PIVOT_TOLERANCE 1e-13
/// Each pivot enlarges the disk, so that the loop ends; 5 to 10 passes are usual. The cap guards against
/// rounding, and costs nothing but a slightly larger disk.
#define MAX_PIVOTS 64
/// The radius is rounded up by this: two differences, two squares, a sum, a root and this product are off by
/// less than 8 halves of an ulp.
#define ROUND_UP (1.0 + 8.0 * 2.220446049250313e-16)

/// Without hypot's care for overflow: coordinates are at most BMR_MAX_COORDINATE. What underflows is nothing
/// beside BMR_MIN_SIDE.
static inline double distance(bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 d = bmr_sub(a, b);
    return sqrt(bmr_dot(d, d));
}

static inline double larger(double a, double b) {
    return a > b ? a : b; // fmax is a call of the library
}

static bmr_disk disk_of_two(bmr_vec2 a, bmr_vec2 b) {
    bmr_disk disk;
    disk.center = bmr_vec2_make(0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y);
    disk.radius = larger(distance(disk.center, a), distance(disk.center, b));
    return disk;
}

/// The circle through three points; radius NaN or infinite if they are collinear.
static bmr_disk disk_of_three(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const bmr_vec2 p = bmr_sub(b, a), q = bmr_sub(c, a);
    const double twice = 2.0 * bmr_cross(p, q), pp = bmr_dot(p, p), qq = bmr_dot(q, q);
    bmr_disk disk;
    disk.center = bmr_vec2_make(a.x + (q.y * pp - p.y * qq) / twice, a.y + (p.x * qq - q.x * pp) / twice);
    disk.radius =
        larger(distance(disk.center, a), larger(distance(disk.center, b), distance(disk.center, c)));
    return disk;
}

static bool holds(const bmr_disk *disk, bmr_vec2 point) {
    return distance(disk->center, point) <= disk->radius * (1.0 + PIVOT_TOLERANCE);
}

/// The smallest disk of the basis and one more point; the basis becomes the points that span it.
static bmr_disk disk_with(bmr_vec2 basis[3], int *size, bmr_vec2 point) {
    const int n = *size;
    bmr_disk best = {point, INFINITY};
    int best_i = -1, best_j = -1;
    for (int i = 0; i < n; ++i) {
        // The new point is outside the old disk, hence on the border of the new one.
        const bmr_disk two = disk_of_two(point, basis[i]);
        bool all = true;
        for (int k = 0; k < n; ++k)
            all = all && holds(&two, basis[k]);
        if (all && two.radius < best.radius) {
            best = two;
            best_i = i;
            best_j = -1;
        }
        for (int j = i + 1; j < n; ++j) {
            const bmr_disk three = disk_of_three(point, basis[i], basis[j]);
            all = three.radius < best.radius;
            for (int k = 0; k < n; ++k)
                all = all && holds(&three, basis[k]);
            if (all) {
                best = three;
                best_i = i;
                best_j = j;
            }
        }
    }
    if (best_i >= 0) {
        const bmr_vec2 first = basis[best_i];
        int kept = 0;
        const bmr_vec2 second = best_j >= 0 ? basis[best_j] : first;
        basis[kept++] = first;
        if (best_j >= 0)
            basis[kept++] = second;
        basis[kept++] = point;
        *size = kept;
    }
    return best;
}

static size_t farthest_from(bmr_vec2 center, const bmr_vec2 *points, size_t count, double *length) {
    size_t farthest = 0;
    double most = -1.0;
    for (size_t i = 0; i < count; ++i) {
        const double dx = points[i].x - center.x, dy = points[i].y - center.y;
        const double square = dx * dx + dy * dy;
        if (square > most) {
            most = square;
            farthest = i;
        }
    }
    *length = distance(points[farthest], center);
    return farthest;
}

bmr_disk bmr_bounding_disk(const bmr_vec2 *points, size_t count) {
    bmr_vec2 basis[3] = {points[0], points[0], points[0]};
    int size = 1;
    bmr_disk disk = {points[0], 0.0};
    double length;
    size_t far = farthest_from(disk.center, points, count, &length);
    for (int i = 0; i < MAX_PIVOTS && length > disk.radius * (1.0 + PIVOT_TOLERANCE); ++i) {
        const bmr_disk next = disk_with(basis, &size, points[far]);
        if (!(next.radius > disk.radius && next.radius < INFINITY))
            break; // rounding: the disk does not grow any more
        disk = next;
        far = farthest_from(disk.center, points, count, &length);
    }
    disk.radius = length * ROUND_UP;
    return disk;
}
