// SPDX-License-Identifier: MIT
// The structures for a point on the explicit Minkowski sum of two translating polygons (section 5, "Two
// Translating Polygons": what the paper starts from and finds unsatisfactory, because it needs O(n) space for
// every pair). The point is B's origin, the polygon is A - R B with a hierarchy of its own.
//
// The sum depends on B's rotation R, which is known at the first start. So creation sets the memory for any
// rotation aside, in the pair's own block, and start builds the sum there; while the rotation stays, later
// starts find it ready. At most 720 bytes for each vertex of the two polygons with a compass hierarchy and
// 340 with Dudley's (n + m >= 64), of which 220 and 60 hold the sum, its directions and its hierarchy and the
// rest is the builders' scratch.
#include <math.h>

#include "boomerang/minkowski.h"
#include "hierarchy/builder.h"
#include "kds/point.h"
#include "kds/registry.h"

/// Rotations whose difference has a smaller sine than this count as the same: the sum is off by less than the
/// tolerance of lines.
#define SAME_ROTATION 1e-12

/// Bytes that a builder needs for each cut beside the node and its normal, at most: for a boomerang in its
/// queue.
#define QUEUED_BYTES 32
/// Dudley's builder lists two items and one feature a vertex.
#define DUDLEY_SCRATCH (2 * sizeof(bmr_item) + sizeof(uint32_t))
/// Every block is aligned to this and begins at a multiple of it.
#define ALIGNMENT 16
/// A root polygon of more directions than this (4 * 2^12) is like one with so many.
#define MOST_CORNER_LEVELS 12u
/// More blocks than the builders ask for.
#define MOST_BLOCKS 16

/// Memory handed out from bottom to top; a block that is given back on top is free again.
typedef struct arena {
    unsigned char *bytes;
    size_t size, used;
} arena;

typedef struct sum_state {
    bmr_point_state point;
    arena memory; ///< behind this state
} sum_state;

/// One of the structures: a class, and the hierarchy that is built.
typedef struct sum_class {
    bmr_kds_class class;
    bmr_hierarchy_kind kind;
} sum_class;

static sum_state *get(bmr_kds *kds) {
    return (sum_state *)(void *)kds->state;
}

static size_t aligned(size_t size) {
    return (size + (ALIGNMENT - 1)) & ~(size_t)(ALIGNMENT - 1);
}

static void *take(void *context, size_t size) {
    arena *memory = context;
    if (aligned(size) > memory->size - memory->used)
        return NULL;
    void *block = memory->bytes + memory->used;
    memory->used += aligned(size);
    return block;
}

static void give_back(void *context, void *block, size_t size) {
    arena *memory = context;
    if ((unsigned char *)block + aligned(size) == memory->bytes + memory->used)
        memory->used -= aligned(size);
}

/// Levels of the sum's compass hierarchy that cut its vertices: those of section 6's root polygon.
static uint32_t corner_levels(const bmr_kds_def *def) {
    return def->root_level < MOST_CORNER_LEVELS ? def->root_level : MOST_CORNER_LEVELS;
}

/// Directions that the table of a compass is made for.
static size_t table_size(size_t vertices, uint32_t corners) {
    const size_t most = (size_t)1 << corners;
    return vertices > most ? vertices : most;
}

static size_t bytes_for(const bmr_shape *a, const bmr_shape *b, bmr_hierarchy_kind kind, uint32_t corners) {
    const size_t n = (size_t)a->polygon->count + b->polygon->count;
    if (n > BMR_MAX_VERTICES)
        return 0; // creation fails
    const uint32_t levels = bmr_ceil_log2((uint32_t)table_size(n, corners));
    const bool compass = kind == BMR_HIERARCHY_COMPASS;
    // The merged list and its hull, twice where rounding asks for another hull, and the polygon.
    const size_t polygon = 2 * (2 * n + 1) * sizeof(bmr_vec2) + bmr_polygon_bytes(n);
    const size_t table = compass ? sizeof(bmr_compass) + ((size_t)BMR_ROOTS << levels) * sizeof(bmr_vec2) : 0;
    const size_t items = n * (compass ? sizeof(bmr_item) : DUDLEY_SCRATCH);
    const size_t cuts = compass ? bmr_most_cuts(n, levels, corners) : bmr_most_cuts(2 * n, 0, 0);
    const size_t node = sizeof(bmr_node) + sizeof(bmr_vec2);
    const size_t tree = (BMR_ROOTS + cuts) * (2 * node + QUEUED_BYTES) + sizeof(bmr_hierarchy);
    return table + polygon + items + tree + (size_t)MOST_BLOCKS * ALIGNMENT;
}

static size_t bytes_compass(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    return bytes_for(a, b, BMR_HIERARCHY_COMPASS, corner_levels(def));
}
static size_t bytes_dudley(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)def;
    return bytes_for(a, b, BMR_HIERARCHY_DUDLEY, 0);
}

static bmr_error prepare(bmr_kds *kds) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const bool too_many = (size_t)a->count + b->count > BMR_MAX_VERTICES;
    if (too_many || a->extent + sqrt(2.0) * b->extent > BMR_MAX_COORDINATE)
        return BMR_ERROR_OUT_OF_RANGE;
    sum_state *state = get(kds);
    state->memory.bytes = kds->state + aligned(sizeof *state);
    state->memory.size = kds->bytes - sizeof *kds - aligned(sizeof *state);
    return BMR_OK;
}

/// Builds the sum for B's rotation unless it is there. False: it does not fit, which the bounds above rule
/// out.
static bool turn(bmr_kds *kds, const bmr_pose *b_in_a) {
    sum_state *state = get(kds);
    const bmr_pose *old = &state->point.turned;
    if (state->point.hierarchy && fabs(old->c - b_in_a->c) + fabs(old->s - b_in_a->s) <= SAME_ROTATION)
        return true;
    state->point.hierarchy = NULL;
    state->memory.used = 0;
    const bmr_allocator allocator = {take, give_back, &state->memory};
    const bmr_vec2 rotation = {b_in_a->c, b_in_a->s};
    bmr_polygon *sum = NULL;
    bmr_hierarchy *hierarchy = NULL;
    bmr_compass *compass = NULL;
    bmr_error error =
        bmr_minkowski_difference(kds->shapes[0].polygon, kds->shapes[1].polygon, rotation, &allocator, &sum);
    if (error == BMR_OK && ((const sum_class *)kds->info->implementation)->kind == BMR_HIERARCHY_COMPASS) {
        const uint32_t corners = corner_levels(&kds->def);
        error = bmr_compass_create(table_size(sum->count, corners), &allocator, &compass);
        if (error == BMR_OK)
            error = bmr_hierarchy_build_compass_with_corners(sum, compass, corners, &allocator, &hierarchy);
    } else if (error == BMR_OK) {
        error = bmr_hierarchy_build_dudley(sum, &allocator, &hierarchy);
    }
    if (error != BMR_OK)
        return false;
    bmr_kds_tally(kds, sum->count + bmr_hierarchy_edge_count(hierarchy));
    state->point.hierarchy = hierarchy;
    state->point.edge = BMR_NO_EDGE;
    state->point.turned = *b_in_a;
    state->point.turned.position = bmr_vec2_make(0.0, 0.0);
    return true;
}

static bool triangle_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    return turn(kds, &now->pose) && bmr_triangle_start(kds, now, report);
}
static bool lazy_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    return turn(kds, &now->pose) && bmr_point_lazy_start(kds, now, report);
}
static bool inflated_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    return turn(kds, &now->pose) && bmr_point_inflated_start(kds, now, report);
}

#define SUM_CLASS(extra, begin, waits, mend, check, of_kind)                                                 \
    {                                                                                                        \
        {.state_bytes = sizeof(sum_state),                                                                   \
         .extra_bytes = (extra),                                                                             \
         .prepare = prepare,                                                                                 \
         .start = (begin),                                                                                   \
         .conditions = (waits),                                                                              \
         .repair = (mend),                                                                                   \
         .proof = bmr_point_proof,                                                                           \
         .audit = (check)},                                                                                  \
            of_kind                                                                                          \
    }
#define TRIANGLE_CLASS(extra, of_kind)                                                                       \
    SUM_CLASS(extra, triangle_start, bmr_triangle_conditions, bmr_triangle_repair, bmr_triangle_audit,       \
              of_kind)
#define LAZY_CLASS(extra, of_kind)                                                                           \
    SUM_CLASS(extra, lazy_start, bmr_point_conditions, bmr_point_lazy_repair, NULL, of_kind)
static const sum_class triangle_compass = TRIANGLE_CLASS(bytes_compass, BMR_HIERARCHY_COMPASS),
                       triangle_dudley = TRIANGLE_CLASS(bytes_dudley, BMR_HIERARCHY_DUDLEY),
                       lazy_compass = LAZY_CLASS(bytes_compass, BMR_HIERARCHY_COMPASS),
                       lazy_dudley = LAZY_CLASS(bytes_dudley, BMR_HIERARCHY_DUDLEY),
                       inflated_compass = SUM_CLASS(bytes_compass, inflated_start, bmr_point_conditions,
                                                    bmr_point_inflated_repair, NULL, BMR_HIERARCHY_COMPASS);

#define NO_HIERARCHY (-1) // of the shapes' own
#define SUM_INFO(name, title, class)                                                                         \
    {                                                                                                        \
        name, title, "5, two translating polygons, on the explicit sum", BMR_KDS_TRANSLATION,                \
            BMR_KDS_CONTROL, NO_HIERARCHY, class                                                             \
    }
const bmr_kds_info bmr_kds_sum_triangle_compass =
    SUM_INFO("sum-triangle-compass", "explicit sum: active triangle, compass", &triangle_compass);
const bmr_kds_info bmr_kds_sum_triangle_dudley =
    SUM_INFO("sum-triangle-dudley", "explicit sum: active triangle, Dudley", &triangle_dudley);
const bmr_kds_info bmr_kds_sum_lazy_compass =
    SUM_INFO("sum-lazy-compass", "explicit sum: separating edge, compass", &lazy_compass);
const bmr_kds_info bmr_kds_sum_lazy_dudley =
    SUM_INFO("sum-lazy-dudley", "explicit sum: separating edge, Dudley", &lazy_dudley);
const bmr_kds_info bmr_kds_sum_inflated_compass =
    SUM_INFO("sum-inflated-compass", "explicit sum: inflated, entry of the old line", &inflated_compass);
