// SPDX-License-Identifier: MIT
// The active triangle of a point on the explicit Minkowski sum of two translating polygons (section 5, "Two
// Translating Polygons": what the paper starts from and finds unsatisfactory, because it needs O(n) space for
// every pair). The point is B's origin, the polygon is A - R B with a hierarchy of its own.
//
// The sum depends on B's rotation R, which is known at the first start. So creation sets the memory for any
// rotation aside, in the pair's own block, and start builds the sum there; while the rotation stays, later
// starts find it ready. At most 340 bytes for each vertex of the two polygons (n + m >= 64), of which 60
// hold the sum and its hierarchy and the rest is the builders' scratch.
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

static size_t bytes_for(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)def;
    const size_t n = (size_t)a->polygon->count + b->polygon->count;
    if (n > BMR_MAX_VERTICES)
        return 0; // creation fails
    // The merged list and its hull, twice where rounding asks for another hull, and the polygon.
    const size_t polygon = 2 * (2 * n + 1) * sizeof(bmr_vec2) + bmr_polygon_bytes(n);
    const size_t node = sizeof(bmr_node) + sizeof(bmr_vec2), cuts = bmr_most_cuts(2 * n, 0, 0);
    const size_t tree = (BMR_ROOTS + cuts) * (2 * node + QUEUED_BYTES) + sizeof(bmr_hierarchy);
    return polygon + n * DUDLEY_SCRATCH + tree + (size_t)MOST_BLOCKS * ALIGNMENT;
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
    bmr_error error =
        bmr_minkowski_difference(kds->shapes[0].polygon, kds->shapes[1].polygon, rotation, &allocator, &sum);
    if (error == BMR_OK)
        error = bmr_hierarchy_build_dudley(sum, &allocator, &hierarchy);
    if (error != BMR_OK)
        return false;
    bmr_kds_tally(kds, sum->count + bmr_hierarchy_edge_count(hierarchy));
    state->point.hierarchy = hierarchy;
    state->point.edge = BMR_NO_EDGE;
    state->point.turned = *b_in_a;
    state->point.turned.position = bmr_vec2_make(0.0, 0.0);
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    return turn(kds, &now->pose) && bmr_triangle_start(kds, now, report);
}

static const bmr_kds_class triangle = {.state_bytes = sizeof(sum_state),
                                       .extra_bytes = bytes_for,
                                       .prepare = prepare,
                                       .start = start,
                                       .conditions = bmr_triangle_conditions,
                                       .repair = bmr_triangle_repair,
                                       .proof = bmr_point_proof,
                                       .audit = bmr_triangle_audit};

BMR_KDS_INFO(sum_triangle_dudley, "sum-triangle-dudley", "explicit sum: active triangle, Dudley",
             "5, two translating polygons, on the explicit sum", BMR_KDS_TRANSLATION, BMR_KDS_CONTROL,
             -1, // it needs no hierarchy of the shapes
             &triangle);
