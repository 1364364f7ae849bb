// SPDX-License-Identifier: MIT
#include "outline/simplify.h"

#include <math.h>
#include <string.h>

#include "geometry/hull.h"
#include "geometry/memory.h"
#include "geometry/predicates.h"
#include "outline/chord.h"
#include "outline/grid.h"
#include "outline/sweep.h"

/// @file
/// Points are taken away one by one, the one that costs least first. What a point costs is how far the points
/// between its two neighbours that are left, all that were given, are from the chord between these: so each
/// stretch of a ring is within the tolerance of the chord that stands for it.
///
/// Why that is enough for the solid. What is between a stretch and its chord is no farther than the tolerance
/// from the chord, since all of that lies in a convex set. And it is no farther from the stretch: go from it
/// away from the chord, at a right angle; the stretch is met before the tolerance is used up.
///
/// A point may go where nothing is left in the closed triangle that it makes with its two neighbours: then no
/// edge comes through the chord. Only an edge on the line of the chord could run along it, and that only from
/// a place in which rings touch to another one, or as the next edge of the ring itself.

#define NONE BMR_OUTLINE_NONE

typedef struct simplifier {
    const bmr_ring_links *links;
    double tolerance;
    uint32_t *next, *previous; ///< of those that are left
    uint32_t *left;            ///< of each ring: how many
    bool *removed, *touches;
    double *cost;
    uint32_t *heap, *place; ///< points by cost; NONE in `place`: it is not in the heap
    uint32_t heap_count;
    bmr_grid grid;
} simplifier;

/// All points of places where more than two edges meet.
static void note_touches(void *context, bmr_strand *strands, const bmr_sweep_event *e) {
    simplifier *s = context;
    if (e->end_count + e->start_count == 2)
        return;
    for (uint32_t i = 0; i < e->end_count; ++i)
        if (strands[e->ends[i]].right_passage < s->links->count)
            s->touches[strands[e->ends[i]].right_passage] = true;
    for (uint32_t i = 0; i < e->start_count; ++i)
        if (strands[e->starts[i]].left_passage < s->links->count)
            s->touches[strands[e->starts[i]].left_passage] = true;
}

/// Does the ring turn back onto the chord from a to b where it goes on from b to c?
static bool turns_back(const bmr_vec2 *p, uint32_t a, uint32_t b, uint32_t c) {
    return bmr_orientation(p[a], p[b], p[c]) == 0 &&
           bmr_sweep_compare(p[a], p[b]) != bmr_sweep_compare(p[b], p[c]);
}

/// Is a point on the straight way from the one before it to the one behind it?
static bool is_flat(const simplifier *s, uint32_t i) {
    const bmr_vec2 *p = s->links->points;
    const uint32_t a = s->previous[i], b = s->next[i];
    return bmr_orientation(p[a], p[i], p[b]) == 0 &&
           bmr_sweep_compare(p[a], p[i]) == bmr_sweep_compare(p[i], p[b]);
}

/// What it costs to take a point away; infinite where that is more than the tolerance.
static double cost_of(const simplifier *s, uint32_t i) {
    const bmr_vec2 *p = s->links->points;
    const uint32_t a = s->previous[i], b = s->next[i];
    if (is_flat(s, i))
        return 0.0;
    if (s->tolerance == 0.0)
        return (double)INFINITY;
    double most = 0.0;
    for (uint32_t k = s->links->next[a]; k != b; k = s->links->next[k]) {
        most = fmax(most, bmr_chord_distance(p[k], p[a], p[b]));
        if (!(most <= s->tolerance))
            return (double)INFINITY;
    }
    return most;
}

/// Would the outline be one without the point? What is asked here changes with points that are no neighbours:
/// it cannot be a part of the cost.
static bool may_go(const simplifier *s, uint32_t i) {
    const bmr_vec2 *p = s->links->points;
    const uint32_t a = s->previous[i], b = s->next[i];
    if (s->left[s->links->ring[i]] <= 3)
        return false;
    return is_flat(s, i) ||
           (!(s->touches[a] && s->touches[b]) && !turns_back(p, a, b, s->next[b]) &&
            !turns_back(p, b, a, s->previous[a]) && !bmr_grid_blocks(&s->grid, s->removed, i, a, b));
}

static bool is_cheaper(const simplifier *s, uint32_t a, uint32_t b) {
    return s->cost[a] < s->cost[b] || (a < b && s->cost[a] == s->cost[b]);
}

static void put(simplifier *s, uint32_t at, uint32_t point) {
    s->heap[at] = point;
    s->place[point] = at;
}

/// Finds the place of a point that belongs at `at`, or higher, or lower.
static void settle(simplifier *s, uint32_t at, uint32_t point) {
    while (at > 0 && is_cheaper(s, point, s->heap[(at - 1) / 2])) {
        put(s, at, s->heap[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    for (;;) {
        uint32_t child = 2 * at + 1;
        if (child + 1 < s->heap_count && is_cheaper(s, s->heap[child + 1], s->heap[child]))
            ++child;
        if (child >= s->heap_count || !is_cheaper(s, s->heap[child], point))
            break;
        put(s, at, s->heap[child]);
        at = child;
    }
    put(s, at, point);
}

static void take_out(simplifier *s, uint32_t point) {
    const uint32_t at = s->place[point];
    s->place[point] = NONE;
    const uint32_t last = s->heap[--s->heap_count];
    if (last != point)
        settle(s, at, last);
}

static void update(simplifier *s, uint32_t point) {
    if (s->place[point] != NONE)
        take_out(s, point);
    s->cost[point] = cost_of(s, point);
    if (s->cost[point] <= s->tolerance)
        settle(s, s->heap_count++, point);
}

/// Takes away what may go at once; true where anything went.
static bool take_away(simplifier *s) {
    bool any = false;
    s->heap_count = 0;
    for (uint32_t i = 0; i < s->links->count; ++i)
        s->place[i] = NONE;
    for (uint32_t i = 0; i < s->links->count; ++i)
        if (!s->removed[i])
            update(s, i);
    while (s->heap_count > 0) {
        const uint32_t i = s->heap[0], a = s->previous[i], b = s->next[i];
        take_out(s, i);
        if (!may_go(s, i))
            continue;
        s->removed[i] = any = true;
        s->next[a] = b;
        s->previous[b] = a;
        --s->left[s->links->ring[i]];
        update(s, a);
        update(s, b);
    }
    return any;
}

/// Does a convex polygon lie between two parallel lines `width` apart, one of them along an edge of it?
static bool is_narrow(const bmr_vec2 *hull, size_t count, double width) {
    for (size_t i = 0; i < count; ++i) {
        const bmr_vec2 a = hull[i], b = hull[(i + 1) % count];
        // A point that is too far off is most likely opposite: begin there.
        size_t k = 0;
        while (k < count && bmr_chord_line_distance(hull[(i + count / 2 + k) % count], a, b) <= width)
            ++k;
        if (k == count)
            return true;
    }
    return false;
}

/// Fills the holes that are narrow enough.
static void fill_holes(simplifier *s, bmr_vec2 *scratch) {
    const bmr_ring_links *l = s->links;
    uint32_t end;
    for (uint32_t begin = 0; begin < l->count; begin = end) {
        end = l->previous[begin] + 1;
        const uint32_t ring = l->ring[begin], count = end - begin;
        s->left[ring] = count;
        if (ring == 0 || s->tolerance == 0.0)
            continue;
        memcpy(scratch, l->points + begin, count * sizeof *scratch);
        const size_t hull = bmr_convex_hull(scratch, count, scratch + count);
        if (is_narrow(scratch + count, hull, 2.0 * s->tolerance)) {
            s->left[ring] = 0;
            memset(s->removed + begin, true, count * sizeof *s->removed);
        }
    }
}

static void run(simplifier *s, bmr_vec2 *scratch) {
    const bmr_ring_links *l = s->links;
    memcpy(s->next, l->next, l->count * sizeof *s->next);
    memcpy(s->previous, l->previous, l->count * sizeof *s->previous);
    fill_holes(s, scratch);
    // What was in the way of one point may be gone later.
    while (take_away(s)) {
    }
}

/// One block for all that a simplification needs. False where its size is no size_t.
static bool lay_out(simplifier *s, char *block, size_t *bytes, bmr_vec2 **scratch) {
    const size_t n = s->links->count;
    const size_t sizes[][2] = {{n, sizeof(double)},
                               {2 * n + 1, sizeof(bmr_vec2)},
                               {n, sizeof(uint32_t)},
                               {n, sizeof(uint32_t)},
                               {n, sizeof(uint32_t)},
                               {n, sizeof(uint32_t)},
                               {n, sizeof(uint32_t)},
                               {bmr_grid_cells((uint32_t)n), sizeof(uint32_t)},
                               {n, sizeof(bool)},
                               {n, sizeof(bool)},
                               {s->links->ring_count, sizeof(uint32_t)}};
    enum { PARTS = sizeof sizes / sizeof *sizes };
    size_t at[PARTS];
    *bytes = 0;
    for (size_t i = 0; i < PARTS; ++i)
        if (!bmr_size_add(bytes, sizes[i][0], sizes[i][1], sizeof(double), SIZE_MAX, &at[i]))
            return false;
    if (!block)
        return true;
    memset(block, 0, *bytes);
    s->cost = (double *)(void *)(block + at[0]);
    *scratch = (bmr_vec2 *)(void *)(block + at[1]);
    s->next = (uint32_t *)(void *)(block + at[2]);
    s->previous = (uint32_t *)(void *)(block + at[3]);
    s->heap = (uint32_t *)(void *)(block + at[4]);
    s->place = (uint32_t *)(void *)(block + at[5]);
    bmr_grid_make(&s->grid, s->links->points, s->links->count, (uint32_t *)(void *)(block + at[7]),
                  (uint32_t *)(void *)(block + at[6]));
    s->removed = (bool *)(block + at[8]);
    s->touches = (bool *)(block + at[9]);
    s->left = (uint32_t *)(void *)(block + at[10]);
    return true;
}

bmr_error bmr_simplify(const bmr_ring_links *links, double tolerance, const bmr_allocator *allocator,
                       uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault) {
    simplifier s = {.links = links, .tolerance = tolerance};
    bmr_vec2 *scratch;
    size_t bytes;
    if (!lay_out(&s, NULL, &bytes, &scratch))
        return BMR_ERROR_NO_MEMORY;
    char *block = bmr_allocate(allocator, bytes);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    lay_out(&s, block, &bytes, &scratch);
    const bmr_error error = bmr_sweep(links, allocator, note_touches, &s, fault);
    if (error == BMR_OK) {
        run(&s, scratch);
        memcpy(counts, s.left, links->ring_count * sizeof *counts);
        for (uint32_t i = 0; i < links->count; ++i)
            if (!s.removed[i])
                *kept++ = i;
    }
    bmr_release(allocator, block, bytes);
    return error;
}
