// SPDX-License-Identifier: MIT
#include "geometry/hull.h"

#include "geometry/predicates.h"

bool bmr_hull_sweeps_before(bmr_vec2 a, bmr_vec2 b) {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

static void sift_down(bmr_vec2 *heap, size_t root, size_t count) {
    const bmr_vec2 moved = heap[root];
    for (;;) {
        size_t child = 2 * root + 1;
        if (child >= count)
            break;
        if (child + 1 < count && bmr_hull_sweeps_before(heap[child], heap[child + 1]))
            ++child;
        if (!bmr_hull_sweeps_before(moved, heap[child]))
            break;
        heap[root] = heap[child];
        root = child;
    }
    heap[root] = moved;
}

/// Heapsort: in place and O(n log n) for every input. (qsort may allocate behind the injected allocator's
/// back.)
static void sort_points(bmr_vec2 *points, size_t count) {
    for (size_t i = count / 2; i-- > 0;)
        sift_down(points, i, count);
    for (size_t end = count; end-- > 1;) {
        const bmr_vec2 last = points[0];
        points[0] = points[end];
        points[end] = last;
        sift_down(points, 0, end);
    }
}

static size_t drop_duplicates(bmr_vec2 *sorted, size_t count) {
    size_t kept = 1;
    for (size_t i = 1; i < count; ++i)
        if (sorted[i].x != sorted[kept - 1].x || sorted[i].y != sorted[kept - 1].y)
            sorted[kept++] = sorted[i];
    return kept;
}

size_t bmr_hull_append(bmr_vec2 *hull, size_t size, size_t fixed, bmr_vec2 point) {
    while (size > fixed && bmr_orientation(hull[size - 2], hull[size - 1], point) <= 0)
        --size;
    hull[size] = point;
    return size + 1;
}

size_t bmr_convex_hull(bmr_vec2 *points, size_t count, bmr_vec2 *hull) {
    sort_points(points, count);
    count = drop_duplicates(points, count);
    if (count == 1) {
        hull[0] = points[0];
        return 1;
    }
    size_t size = 0;
    for (size_t i = 0; i < count; ++i) // the right side, upwards
        size = bmr_hull_append(hull, size, 1, points[i]);
    const size_t top = size;
    for (size_t i = count - 1; i-- > 0;) // the left side, downwards
        size = bmr_hull_append(hull, size, top, points[i]);
    return size - 1; // the first point came back as the last
}
