// SPDX-License-Identifier: MIT
#include <float.h>
#include <math.h>
#include <string.h>

#include "boomerang/polygon.h"
#include "convex32/build.h"
#include "geometry/hull.h"
#include "geometry/memory.h"
#include "geometry/predicates.h"

/// Below this part of the products, a cross product of rounded differences is not trusted: above, it is
/// within 4e-9 of its value.
#define FIRM 1e-7

/// Adds a number to an exact sum of `count` others, smallest first, none of which has bits where another has
/// (Shewchuk's expansions). There is room for one more. The new count.
static int add_exactly(double *sum, int count, double term) {
    for (int i = 0; i < count; ++i) {
        const double total = term + sum[i], part = total - term;
        sum[i] = (term - (total - part)) + (sum[i] - part);
        term = total;
    }
    sum[count] = term;
    return count + 1;
}

double convex32_twice_area(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c) {
    const double ax = (double)a.x, ay = (double)a.y, bx = (double)b.x, by = (double)b.y, cx = (double)c.x,
                 cy = (double)c.y;
    const double left = (bx - ax) * (cy - ay), right = (by - ay) * (cx - ax);
    if (fabs(left - right) >= FIRM * (fabs(left) + fabs(right)))
        return left - right;
    // A needle's area is lost in the rounding of the products. Those of the coordinates themselves are exact,
    // and summed so.
    const double terms[6] = {ax * by, -ay * bx, bx * cy, -by * cx, cx * ay, -cy * ax};
    double sum[6];
    int count = 0;
    for (int i = 0; i < 6; ++i)
        count = add_exactly(sum, count, terms[i]);
    double total = 0.0;
    for (int i = 0; i < count; ++i)
        total += sum[i];
    return total;
}

/// Mass of a convex polygon, however thin, and how far its vertices reach, in double, rounded once. Outputs
/// are written only without error: BMR_ERROR_OUT_OF_RANGE where the area or the inertia is no normal float.
static bmr_error measure(const bmr_convex32 *polygon, bmr_mass32 *mass, float *reach) {
    // A fan of triangles around vertex 0, so that a polygon far from the origin is as exact as one at it.
    const bmr_vec32 *v = polygon->vertices;
    const double x0 = (double)v[0].x, y0 = (double)v[0].y;
    double farthest = hypot(x0, y0), twice_area = 0.0, six_x = 0.0, six_y = 0.0, twelve_inertia = 0.0;
    for (uint32_t i = 1; i < polygon->count; ++i) {
        const double x = (double)v[i].x - x0, y = (double)v[i].y - y0;
        farthest = fmax(farthest, hypot((double)v[i].x, (double)v[i].y));
        if (i + 1 == polygon->count)
            break;
        const double next_x = (double)v[i + 1].x - x0, next_y = (double)v[i + 1].y - y0;
        const double cross = convex32_twice_area(v[0], v[i], v[i + 1]);
        twice_area += cross;
        six_x += cross * (x + next_x);
        six_y += cross * (y + next_y);
        twelve_inertia +=
            cross * (x * x + x * next_x + next_x * next_x + y * y + y * next_y + next_y * next_y);
    }
    const double area = 0.5 * twice_area;
    const double from_x = six_x / (6.0 * area), from_y = six_y / (6.0 * area);
    const double x = x0 + from_x, y = y0 + from_y;
    // From vertex 0 to the centroid, and from there to the origin.
    const double own = twelve_inertia / 12.0 - area * (from_x * from_x + from_y * from_y);
    const double inertia = own + area * (x * x + y * y);
    if (!(area >= (double)FLT_MIN) || !(inertia >= (double)FLT_MIN) || !(inertia <= (double)FLT_MAX))
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_mass32 made = {(float)area, {(float)x, (float)y}, (float)fmax(own, (double)FLT_MIN)};
    *mass = made;
    // No vertex may be farther: up, where rounding went down.
    *reach = (float)farthest;
    if ((double)*reach < farthest * (1.0 + DBL_EPSILON))
        *reach = nextafterf(*reach, INFINITY);
    return BMR_OK;
}

/// Two to four buckets a vertex; a table past 8 vertices alone.
static uint32_t bits_for(size_t count) {
    if (count <= 8)
        return 0;
    uint32_t bits = BMR_CONVEX32_LEAST_BITS;
    while (((size_t)1 << bits) < 2 * count)
        ++bits;
    return bits;
}

size_t bmr_convex32_bytes(size_t count) {
    if (count > BMR_CONVEX32_MOST)
        return SIZE_MAX;
    const uint32_t bits = bits_for(count);
    return sizeof(bmr_convex32_block) + 2 * count * sizeof(bmr_vec32) +
           (bits > 0 ? ((size_t)1 << bits) * sizeof(uint16_t) : 0);
}

bmr_error convex32_check_points(const bmr_vec32 *points, size_t count) {
    bmr_error error = BMR_OK;
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(points[i].x) || !isfinite(points[i].y))
            return BMR_ERROR_NOT_FINITE;
        if (fabs((double)points[i].x) > BMR_MAX_COORDINATE || fabs((double)points[i].y) > BMR_MAX_COORDINATE)
            error = BMR_ERROR_OUT_OF_RANGE;
    }
    return error;
}

double convex32_box_side(const bmr_vec32 *v, size_t count) {
    bmr_vec32 low = v[0], high = v[0];
    for (size_t i = 1; i < count; ++i) {
        low.x = fminf(low.x, v[i].x);
        low.y = fminf(low.y, v[i].y);
        high.x = fmaxf(high.x, v[i].x);
        high.y = fmaxf(high.y, v[i].y);
    }
    return fmax((double)high.x - (double)low.x, (double)high.y - (double)low.y);
}

size_t convex32_drop_straight(bmr_vec32 *v, uint32_t *numbers, size_t count) {
    size_t size = 0;
    for (size_t i = 0; i < count; ++i) {
        while (size >= 2 && !convex32_turns(v[size - 2], v[size - 1], v[i]))
            --size;
        if (numbers)
            numbers[size] = numbers[i];
        v[size++] = v[i];
    }
    size_t first = 0;
    for (bool changed = true; changed && size - first >= 3;) { // where the last meet the first
        changed = true;
        if (!convex32_turns(v[size - 2], v[size - 1], v[first]))
            --size;
        else if (!convex32_turns(v[size - 1], v[first], v[first + 1]))
            ++first;
        else
            changed = false;
    }
    size -= first;
    memmove(v, v + first, size * sizeof *v);
    if (numbers)
        memmove(numbers, numbers + first, size * sizeof *numbers);
    return size;
}

/// Turns the order around so that the rightmost vertex, of these the lowest, comes first. `scratch` has room
/// for all.
static void start_rightmost(bmr_vec32 *v, size_t count, bmr_vec32 *scratch) {
    size_t first = 0;
    for (size_t i = 1; i < count; ++i)
        if (v[i].x > v[first].x || (v[i].x == v[first].x && v[i].y < v[first].y))
            first = i;
    memcpy(scratch, v, count * sizeof *v);
    memcpy(v, scratch + first, (count - first) * sizeof *v);
    memcpy(v + (count - first), scratch, first * sizeof *v);
}

static void fill_buckets(const bmr_convex32 *polygon, uint16_t *buckets) {
    uint32_t vertex = 0;
    while (!convex32_leaves_at(polygon, vertex, convex32_bucket_begin(0, polygon->bucket_bits)))
        ++vertex;
    for (uint32_t b = 0; b < 1u << polygon->bucket_bits; ++b) {
        const bmr_vec32 begin = convex32_bucket_begin(b, polygon->bucket_bits);
        while (!(convex32_turn(begin, polygon->normals[vertex]) > 0.0))
            vertex = convex32_next(polygon, vertex);
        buckets[b] = (uint16_t)vertex;
    }
}

/// Convex in exact arithmetic, and do the normals turn, once around?
static bmr_error check_shape(const bmr_convex32 *p) {
    uint32_t rounds = 0;
    for (uint32_t i = 0; i < p->count; ++i) {
        const uint32_t j = convex32_next(p, i), k = convex32_next(p, j);
        const bmr_vec32 before = p->normals[i], after = p->normals[j];
        if (bmr_orientation(convex32_wide(p->vertices[i]), convex32_wide(p->vertices[j]),
                            convex32_wide(p->vertices[k])) <= 0 ||
            !(convex32_turn(before, after) > 0.0))
            return BMR_ERROR_NOT_CONVEX;
        // Once a round the normals pass from below to above.
        rounds += (before.y < 0.0f || (before.y == 0.0f && before.x < 0.0f)) &&
                  (after.y > 0.0f || (after.y == 0.0f && after.x > 0.0f));
    }
    return rounds == 1 ? BMR_OK : BMR_ERROR_NOT_CONVEX;
}

bmr_error convex32_make(const bmr_vec32 *vertices, size_t count, size_t more, const bmr_allocator *allocator,
                        bmr_convex32_block **block) {
    const size_t size = bmr_convex32_bytes(count) + more;
    bmr_convex32_block *made = bmr_allocate(allocator, size);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec32 *own = (bmr_vec32 *)(made + 1), *normals = own + count;
    uint16_t *buckets = (uint16_t *)(normals + count);
    memcpy(own, vertices, count * sizeof *own);
    bmr_vec32 extent = {0.0f, 0.0f};
    for (size_t i = 0; i < count; ++i) {
        normals[i] = convex32_edge_normal(own[i], own[i + 1 < count ? i + 1 : 0]);
        extent.x = fmaxf(extent.x, fabsf(own[i].x));
        extent.y = fmaxf(extent.y, fabsf(own[i].y));
    }
    const uint32_t bits = bits_for(count);
    const bmr_convex32 polygon = {own,    normals, bits > 0 ? buckets : NULL, (uint32_t)count, bits,
                                  extent, NULL};
    bmr_error error = check_shape(&polygon);
    if (error == BMR_OK)
        error = measure(&polygon, &made->mass, &made->reach);
    if (error != BMR_OK) {
        bmr_release(allocator, made, size);
        return error;
    }
    if (bits > 0)
        fill_buckets(&polygon, buckets);
    made->polygon = polygon;
    made->bytes = size;
    made->repeated = 0;
    memset(&made->seams, 0, sizeof made->seams);
    *block = made;
    return BMR_OK;
}

bmr_error bmr_convex32_create(const bmr_vec32 *points, size_t count, const bmr_allocator *allocator,
                              bmr_convex32_block **block) {
    if (!block || (!points && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (count > (SIZE_MAX / sizeof(bmr_vec2) - 1) / 2)
        return BMR_ERROR_TOO_MANY_POINTS;
    bmr_error error = convex32_check_points(points, count);
    if (error != BMR_OK)
        return error;
    const size_t scratch_size = (2 * count + 1) * sizeof(bmr_vec2); // and a hull that ends where it began
    bmr_vec2 *sorted = bmr_allocate(allocator, scratch_size);
    if (!sorted)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *hull = sorted + count;
    for (size_t i = 0; i < count; ++i) // -0 becomes +0: equal points shall give equal bits
        sorted[i] = bmr_vec2_make((double)points[i].x + 0.0, (double)points[i].y + 0.0);
    size_t kept = bmr_convex_hull(sorted, count, hull);
    // The points, sorted, have moved to the front, each once: what is behind the last is none after it.
    size_t distinct = 1;
    while (distinct < count && bmr_hull_sweeps_before(sorted[distinct - 1], sorted[distinct]))
        ++distinct;
    // The sorted points are done with: their room takes the floats, twice.
    bmr_vec32 *vertices = (bmr_vec32 *)sorted;
    for (size_t i = 0; i < kept; ++i) {
        const bmr_vec32 v = {(float)hull[i].x, (float)hull[i].y};
        vertices[i] = v;
    }
    if (kept >= 3)
        kept = convex32_drop_straight(vertices, NULL, kept);
    if (kept < 3)
        error = BMR_ERROR_TOO_FEW_POINTS;
    else if (kept > BMR_CONVEX32_MOST)
        error = BMR_ERROR_TOO_MANY_POINTS;
    else if (convex32_box_side(vertices, kept) < BMR_MIN_SIDE)
        error = BMR_ERROR_OUT_OF_RANGE;
    else {
        start_rightmost(vertices, kept, vertices + count);
        error = convex32_make(vertices, kept, 0, allocator, block);
        if (error == BMR_ERROR_NOT_CONVEX) // a needle, whose long sides have one direction
            error = BMR_ERROR_TOO_FEW_POINTS;
        if (error == BMR_OK)
            (*block)->repeated = (uint32_t)(count - distinct);
    }
    bmr_release(allocator, sorted, scratch_size);
    return error;
}

bmr_error bmr_convex32_create_raw(const bmr_vec32 *vertices, size_t count, const bmr_allocator *allocator,
                                  bmr_convex32_block **block) {
    if (!block || (!vertices && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (count > BMR_CONVEX32_MOST)
        return BMR_ERROR_TOO_MANY_POINTS;
    const bmr_error error = convex32_check_points(vertices, count);
    if (error != BMR_OK)
        return error;
    if (convex32_box_side(vertices, count) < BMR_MIN_SIDE)
        return BMR_ERROR_OUT_OF_RANGE;
    return convex32_make(vertices, count, 0, allocator, block);
}

void bmr_convex32_destroy(bmr_convex32_block *block, const bmr_allocator *allocator) {
    if (block)
        bmr_release(allocator, block, block->bytes);
}
