// SPDX-License-Identifier: MIT

#include <float.h>
#include <math.h>
#include <string.h>

#include "geometry/hull.h"
#include "geometry/memory.h"
#include "geometry/predicates.h"
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

/// How much the distance below may be off, as a part of the way from the segment's end to the point: two
/// differences, two products, a sum, a length and a quotient of half an ulp each are 4 epsilon at most.
#define CHORD_ERROR (8.0 * DBL_EPSILON)

/// What the distances below are made of: the vectors from a to b and to p, scaled so that products neither
/// overflow nor lose more than a denormal. All finite coordinates, but for those whose difference is none.
typedef struct chord {
    bmr_vec2 along, to;
    double length, way;
    int exponent;
} chord;

static chord chord_make(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    chord c = {bmr_sub(b, a), bmr_sub(p, a), 0.0, 0.0, 0};
    frexp(fmax(fmax(fabs(c.along.x), fabs(c.along.y)), fmax(fabs(c.to.x), fabs(c.to.y))), &c.exponent);
    c.along = bmr_vec2_make(ldexp(c.along.x, -c.exponent), ldexp(c.along.y, -c.exponent));
    c.to = bmr_vec2_make(ldexp(c.to.x, -c.exponent), ldexp(c.to.y, -c.exponent));
    c.length = hypot(c.along.x, c.along.y);
    c.way = hypot(c.to.x, c.to.y);
    return c;
}

/// A computed distance, rounded up; infinite where it is no number.
static double chord_up(const chord *c, double distance) {
    const double up = ldexp(distance + CHORD_ERROR * c->way + 4.0 * DBL_MIN, c->exponent) + 0x1p-1074;
    return up >= 0.0 ? up : (double)INFINITY;
}

/// At least the distance of p from the segment from a to b, and hardly more.
static double chord_distance(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const chord c = chord_make(p, a, b);
    const bmr_vec2 rest = bmr_sub(c.to, c.along);
    const double part = bmr_dot(c.to, c.along);
    if (!(part > 0.0))
        return chord_up(&c, c.way);
    return chord_up(&c, part < c.length * c.length ? fabs(bmr_cross(c.along, c.to)) / c.length
                                                   : hypot(rest.x, rest.y));
}

/// The same from the whole line through a and b; from a where the two are one.
static double chord_line_distance(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const chord c = chord_make(p, a, b);
    return chord_up(&c, c.length > 0.0 ? fabs(bmr_cross(c.along, c.to)) / c.length : c.way);
}

/// The points of an outline in cells over their bounding box, about one a cell, to find those in a triangle.
typedef struct point_grid {
    const bmr_vec2 *points;
    bmr_vec2 low, size; ///< halved, so that no difference of two coordinates overflows
    uint32_t side;      ///< cells in a row, and in a column
    uint32_t *first;    ///< point of each cell; NONE: it is empty
    uint32_t *next;     ///< of each point in its cell
} point_grid;

static uint32_t side_of(uint32_t points) {
    return (uint32_t)sqrt((double)points) + 1;
}

/// How many cells there are for so many points.
static uint32_t grid_cells(uint32_t points) {
    return side_of(points) * side_of(points);
}

/// Rounding moves a point to a neighbouring cell at most, and never one point past another: whatever is
/// between two coordinates is in a cell between theirs.
static uint32_t cell_of(double x, double low, double size, uint32_t cells) {
    const double part = size > 0.0 ? (0.5 * x - low) / size : 0.0;
    const uint32_t cell = (uint32_t)(part * cells);
    return cell < cells ? cell : cells - 1;
}

/// Into arrays of the caller's: grid_cells(count) and `count` numbers.
static void grid_make(point_grid *grid, const bmr_vec2 *points, uint32_t count, uint32_t *first,
                      uint32_t *next) {
    bmr_vec2 low = points[0], high = points[0];
    for (uint32_t i = 1; i < count; ++i) {
        low = bmr_vec2_make(fmin(low.x, points[i].x), fmin(low.y, points[i].y));
        high = bmr_vec2_make(fmax(high.x, points[i].x), fmax(high.y, points[i].y));
    }
    low = bmr_scale(0.5, low);
    const bmr_vec2 size = bmr_sub(bmr_scale(0.5, high), low);
    const uint32_t side = side_of(count);
    *grid = (point_grid){points, low, size, side, first, next};
    for (uint32_t c = 0; c < side * side; ++c)
        first[c] = NONE;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t cell =
            cell_of(points[i].y, low.y, size.y, side) * side + cell_of(points[i].x, low.x, size.x, side);
        next[i] = first[cell];
        first[cell] = i;
    }
}

/// Is p in the closed triangle, whose corners turn by `turn`?
static bool holds(const bmr_vec2 corners[3], int turn, bmr_vec2 p) {
    for (int i = 0; i < 3; ++i)
        if (bmr_orientation(corners[i], corners[(i + 1) % 3], p) * turn < 0)
            return false;
    return true;
}

/// Is a point in the closed triangle that is not `removed` and lies in none of its three corners' places, or
/// in that of `tip` without being it? (The triangle's corners are points tip, a and b.)
static bool grid_blocks(const point_grid *grid, const bool *removed, uint32_t tip, uint32_t a, uint32_t b) {
    const bmr_vec2 *p = grid->points;
    const bmr_vec2 corners[3] = {p[tip], p[a], p[b]};
    const int turn = bmr_orientation(corners[0], corners[1], corners[2]);
    const bmr_vec2 low = {fmin(fmin(p[tip].x, p[a].x), p[b].x), fmin(fmin(p[tip].y, p[a].y), p[b].y)};
    const bmr_vec2 high = {fmax(fmax(p[tip].x, p[a].x), p[b].x), fmax(fmax(p[tip].y, p[a].y), p[b].y)};
    const uint32_t left = cell_of(low.x, grid->low.x, grid->size.x, grid->side);
    const uint32_t right = cell_of(high.x, grid->low.x, grid->size.x, grid->side);
    const uint32_t bottom = cell_of(low.y, grid->low.y, grid->size.y, grid->side);
    const uint32_t top = cell_of(high.y, grid->low.y, grid->size.y, grid->side);
    for (uint32_t row = bottom; row <= top; ++row)
        for (uint32_t column = left; column <= right; ++column)
            for (uint32_t q = grid->first[row * grid->side + column]; q != NONE; q = grid->next[q]) {
                if (removed[q] || q == tip || bmr_sweep_compare(p[q], p[a]) == 0 ||
                    bmr_sweep_compare(p[q], p[b]) == 0)
                    continue;
                if (p[q].x >= low.x && p[q].x <= high.x && p[q].y >= low.y && p[q].y <= high.y &&
                    holds(corners, turn, p[q]))
                    return true;
            }
    return false;
}

typedef struct simplifier {
    const bmr_ring_links *links;
    double tolerance;
    uint32_t *next, *previous; ///< of those that are left
    uint32_t *left;            ///< of each ring: how many
    bool *removed, *touches;
    double *cost;
    uint32_t *heap, *place; ///< points by cost; NONE in `place`: it is not in the heap
    uint32_t heap_count;
    point_grid grid;
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
        most = fmax(most, chord_distance(p[k], p[a], p[b]));
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
            !turns_back(p, b, a, s->previous[a]) && !grid_blocks(&s->grid, s->removed, i, a, b));
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
        while (k < count && chord_line_distance(hull[(i + count / 2 + k) % count], a, b) <= width)
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

bmr_error bmr_simplify(const bmr_ring_links *links, double tolerance, const bmr_allocator *allocator,
                       uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault) {
    const size_t n = links->count, cells = grid_cells(links->count);
    const size_t bytes = n * sizeof(double) + (2 * n + 1) * sizeof(bmr_vec2) +
                         (5 * n + cells + links->ring_count) * sizeof(uint32_t) + 2 * n * sizeof(bool);
    double *block = bmr_allocate(allocator, bytes);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    memset(block, 0, bytes);
    bmr_vec2 *scratch = (bmr_vec2 *)(void *)(block + n);
    uint32_t *indices = (uint32_t *)(void *)(scratch + 2 * n + 1);
    uint32_t *left = indices + 5 * n + cells;
    bool *marks = (bool *)(left + links->ring_count);
    simplifier s = {.links = links,
                    .tolerance = tolerance,
                    .cost = block,
                    .next = indices,
                    .previous = indices + n,
                    .heap = indices + 2 * n,
                    .place = indices + 3 * n,
                    .left = left,
                    .removed = marks,
                    .touches = marks + n};
    grid_make(&s.grid, links->points, links->count, indices + 5 * n, indices + 4 * n);
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
