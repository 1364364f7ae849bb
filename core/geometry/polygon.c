// SPDX-License-Identifier: MIT
#include "boomerang/polygon.h"

#include <math.h>
#include <string.h>

#include "geometry/hull.h"
#include "geometry/memory.h"
#include "geometry/predicates.h"

/// The vertices begin at a multiple of their own size, so that none of them lies across two cache lines.
#define VERTICES_AT ((sizeof(bmr_polygon) + sizeof(bmr_vec2) - 1) / sizeof(bmr_vec2) * sizeof(bmr_vec2))

/// The farthest point is added to the points that span the disk, until it is outside of the disk by less than
/// this part of the radius.
#define PIVOT_TOLERANCE 1e-13
/// Each pivot enlarges the disk, so that the loop ends; 5 to 10 passes are usual. The cap guards against
/// rounding, and costs nothing but a slightly larger disk.
#define MAX_PIVOTS 64
/// The radius is rounded up by this: two differences, two squares, a sum, a root and this product are off by
/// less than 8 halves of an ulp.
#define ROUND_UP (1.0 + 8.0 * 2.220446049250313e-16)

size_t bmr_polygon_bytes(size_t count) {
    return count <= BMR_MAX_VERTICES ? VERTICES_AT + count * sizeof(bmr_vec2) : SIZE_MAX;
}

static bmr_vec2 *vertices_of(bmr_polygon *block) {
    return (bmr_vec2 *)(void *)((char *)block + VERTICES_AT);
}

static bmr_error check_range(const bmr_vec2 *points, size_t count) {
    bmr_error error = BMR_OK;
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(points[i].x) || !isfinite(points[i].y))
            return BMR_ERROR_NOT_FINITE;
        if (fabs(points[i].x) > BMR_MAX_COORDINATE || fabs(points[i].y) > BMR_MAX_COORDINATE)
            error = BMR_ERROR_OUT_OF_RANGE;
    }
    return error;
}

static bmr_error check_points(const bmr_vec2 *points, size_t count) {
    if (count == 0)
        return BMR_ERROR_NO_POINTS;
    return count > BMR_MAX_VERTICES ? BMR_ERROR_TOO_MANY_POINTS : check_range(points, count);
}

/// The larger side of the bounding box.
static double box_side(const bmr_vec2 *vertices, size_t count) {
    bmr_vec2 low = vertices[0], high = vertices[0];
    for (size_t i = 1; i < count; ++i) {
        low = bmr_vec2_make(fmin(low.x, vertices[i].x), fmin(low.y, vertices[i].y));
        high = bmr_vec2_make(fmax(high.x, vertices[i].x), fmax(high.y, vertices[i].y));
    }
    return fmax(high.x - low.x, high.y - low.y);
}

// ---- the bounding disk ----

typedef struct bounding_disk {
    bmr_vec2 center;
    double radius;
} bounding_disk;

/// Without hypot's care for overflow: coordinates are at most BMR_MAX_COORDINATE. What underflows is nothing
/// beside BMR_MIN_SIDE.
static inline double distance(bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 d = bmr_sub(a, b);
    return sqrt(bmr_dot(d, d));
}

static inline double larger(double a, double b) {
    return a > b ? a : b; // fmax is a call of the library
}

static bounding_disk disk_of_two(bmr_vec2 a, bmr_vec2 b) {
    bounding_disk disk;
    disk.center = bmr_vec2_make(0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y);
    disk.radius = larger(distance(disk.center, a), distance(disk.center, b));
    return disk;
}

/// The circle through three points; radius NaN or infinite if they are collinear.
static bounding_disk disk_of_three(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const bmr_vec2 p = bmr_sub(b, a), q = bmr_sub(c, a);
    const double twice = 2.0 * bmr_cross(p, q), pp = bmr_dot(p, p), qq = bmr_dot(q, q);
    bounding_disk disk;
    disk.center = bmr_vec2_make(a.x + (q.y * pp - p.y * qq) / twice, a.y + (p.x * qq - q.x * pp) / twice);
    disk.radius =
        larger(distance(disk.center, a), larger(distance(disk.center, b), distance(disk.center, c)));
    return disk;
}

static bool holds(const bounding_disk *disk, bmr_vec2 point) {
    return distance(disk->center, point) <= disk->radius * (1.0 + PIVOT_TOLERANCE);
}

/// The smallest disk of the basis and one more point; the basis becomes the points that span it.
static bounding_disk disk_with(bmr_vec2 basis[3], int *size, bmr_vec2 point) {
    const int n = *size;
    bounding_disk best = {point, INFINITY};
    int best_i = -1, best_j = -1;
    for (int i = 0; i < n; ++i) {
        // The new point is outside the old disk, hence on the border of the new one.
        const bounding_disk two = disk_of_two(point, basis[i]);
        bool all = true;
        for (int k = 0; k < n; ++k)
            all = all && holds(&two, basis[k]);
        if (all && two.radius < best.radius) {
            best = two;
            best_i = i;
            best_j = -1;
        }
        for (int j = i + 1; j < n; ++j) {
            const bounding_disk three = disk_of_three(point, basis[i], basis[j]);
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

/// A disk that holds all points (count >= 1), its radius rounded up; the smallest one up to rounding, so that
/// its centre lies in their hull and the diameter of the points is between sqrt(3) and 2 radii. O(n) in
/// practice.
static bounding_disk bound(const bmr_vec2 *points, size_t count) {
    bmr_vec2 basis[3] = {points[0], points[0], points[0]};
    int size = 1;
    bounding_disk disk = {points[0], 0.0};
    double length;
    size_t far = farthest_from(disk.center, points, count, &length);
    for (int i = 0; i < MAX_PIVOTS && length > disk.radius * (1.0 + PIVOT_TOLERANCE); ++i) {
        const bounding_disk next = disk_with(basis, &size, points[far]);
        if (!(next.radius > disk.radius && next.radius < INFINITY))
            break; // rounding: the disk does not grow any more
        disk = next;
        far = farthest_from(disk.center, points, count, &length);
    }
    disk.radius = length * ROUND_UP;
    return disk;
}

// ---- what is measured once ----

/// Mixes 64 bits into a hash. The multiplication carries each bit into all those above it, and the shift
/// takes the upper half down again, so that every bit of the vertices can change every bit of the stamp. (The
/// multiplier is one of Steele and Vigna's.)
static uint64_t mix(uint64_t hash, uint64_t bits) {
    hash = (hash ^ bits) * UINT64_C(0xd1342543de82ef95);
    return hash ^ hash >> 32;
}

/// The stamp that the vertices as they are now make. O(n).
static uint32_t stamp_of(const bmr_polygon *polygon) {
    uint64_t hash = mix(0, polygon->count);
    for (uint32_t i = 0; i < polygon->count; ++i) {
        uint64_t bits[2];
        memcpy(bits, &polygon->vertices[i], sizeof bits);
        hash = mix(mix(hash, bits[0]), bits[1]);
    }
    hash = mix(hash, 0);
    return (uint32_t)hash;
}

static void measure(bmr_polygon *polygon) {
    const bmr_vec2 *v = polygon->vertices;
    uint32_t lowest = 0, highest = 0;
    double extent = 0.0;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        if (bmr_hull_sweeps_before(v[i], v[lowest]))
            lowest = i;
        if (bmr_hull_sweeps_before(v[highest], v[i]))
            highest = i;
        extent = fmax(extent, fmax(fabs(v[i].x), fabs(v[i].y)));
    }
    const bounding_disk disk = bound(v, polygon->count);
    polygon->lowest = (uint16_t)lowest;
    polygon->highest = (uint16_t)highest;
    polygon->center = disk.center;
    polygon->radius = disk.radius;
    polygon->extent = extent;
    polygon->stamp = stamp_of(polygon);
}

// ---- making ----

/// One block from vertices that have passed every check.
static bmr_error make(const bmr_vec2 *vertices, size_t count, const bmr_allocator *allocator,
                      bmr_polygon **polygon) {
    if (count > 1 && !(box_side(vertices, count) >= BMR_MIN_SIDE))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_polygon *made = bmr_allocate(allocator, bmr_polygon_bytes(count));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *own = vertices_of(made);
    memcpy(own, vertices, count * sizeof *own);
    made->vertices = own;
    made->count = (uint32_t)count;
    measure(made);
    *polygon = made;
    return BMR_OK;
}

bmr_error bmr_polygon_create(const bmr_vec2 *points, size_t count, const bmr_allocator *allocator,
                             bmr_polygon **polygon) {
    if (!polygon || (!points && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = check_points(points, count);
    if (error != BMR_OK)
        return error;
    const size_t scratch_size = (2 * count + 1) * sizeof(bmr_vec2);
    bmr_vec2 *scratch = bmr_allocate(allocator, scratch_size);
    if (!scratch)
        return BMR_ERROR_NO_MEMORY;
    for (size_t i = 0; i < count;
         ++i) // -0 becomes +0: equal points shall give equal bits, whichever survives
        scratch[i] = bmr_vec2_make(points[i].x + 0.0, points[i].y + 0.0);
    bmr_vec2 *hull = scratch + count;
    const size_t hull_count = bmr_convex_hull(scratch, count, hull);
    error = make(hull, hull_count, allocator, polygon);
    bmr_release(allocator, scratch, scratch_size);
    return error;
}

bmr_error bmr_polygon_create_raw(const bmr_vec2 *vertices, size_t count, const bmr_allocator *allocator,
                                 bmr_polygon **polygon) {
    if (!polygon || (!vertices && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_error error = check_points(vertices, count);
    return error == BMR_OK ? make(vertices, count, allocator, polygon) : error;
}

void bmr_polygon_destroy(bmr_polygon *polygon, const bmr_allocator *allocator) {
    if (polygon)
        bmr_release(allocator, polygon, bmr_polygon_bytes(polygon->count));
}

// ---- auditing ----

/// Only left turns, and only one turn in all: exactly one vertex is lower than both its neighbours.
static bool is_strictly_convex(const bmr_polygon *p) {
    const bmr_vec2 *v = p->vertices;
    const uint32_t n = p->count;
    if (n == 1)
        return true;
    if (n == 2)
        return v[0].x != v[1].x || v[0].y != v[1].y;
    uint32_t bottoms = 0;
    for (uint32_t i = 0; i < n; ++i) {
        const bmr_vec2 a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
        if (bmr_orientation(a, b, c) <= 0)
            return false;
        bottoms += bmr_hull_sweeps_before(b, a) && bmr_hull_sweeps_before(b, c);
    }
    return bottoms == 1;
}

/// Does it say of itself what is measured once more?
static bool is_measured(const bmr_polygon *p) {
    bmr_polygon again = *p;
    measure(&again);
    return p->lowest == again.lowest && p->highest == again.highest && p->center.x == again.center.x &&
           p->center.y == again.center.y && p->radius == again.radius && p->extent == again.extent &&
           p->stamp == again.stamp;
}

bmr_error bmr_polygon_audit(const bmr_polygon *polygon) {
    if (!polygon || !polygon->vertices)
        return BMR_ERROR_NULL_ARGUMENT;
    if (polygon->count == 0 || polygon->count > BMR_MAX_VERTICES)
        return BMR_ERROR_INVALID_STRUCTURE;
    const bmr_error error = check_range(polygon->vertices, polygon->count);
    if (error != BMR_OK)
        return error;
    if (polygon->count > 1 && box_side(polygon->vertices, polygon->count) < BMR_MIN_SIDE)
        return BMR_ERROR_OUT_OF_RANGE;
    if (!is_strictly_convex(polygon))
        return BMR_ERROR_NOT_CONVEX;
    return is_measured(polygon) ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}
