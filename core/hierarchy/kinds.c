// SPDX-License-Identifier: MIT
// The table of the kinds of hierarchies: one row is all that names a kind.
#include "hierarchy/builder.h"

static bmr_error build_dudley(const bmr_polygon *polygon, const bmr_compass *unused,
                              const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    (void)unused;
    return bmr_hierarchy_build_dudley(polygon, allocator, hierarchy);
}

static bmr_error build_dobkin_kirkpatrick(const bmr_polygon *polygon, const bmr_compass *unused,
                                          const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    (void)unused;
    return bmr_hierarchy_build_dobkin_kirkpatrick(polygon, allocator, hierarchy);
}

/// One row for each kind, in the order of bmr_hierarchy_kind.
static const struct kind {
    const char *name;
    bmr_error (*build)(const bmr_polygon *, const bmr_compass *, const bmr_allocator *, bmr_hierarchy **);
    bool uses_compass;
    uint32_t more_levels; ///< than a balanced tree of the polygon's edges, and the compass's own
    uint32_t edges_a_vertex, more_edges; ///< at most, the roots among them
} kinds[BMR_HIERARCHY_KIND_COUNT] = {
    {"compass", bmr_hierarchy_build_compass, true, 0, 5, 0},
    {"dudley", build_dudley, false, 1, 2, 4},
    {"dobkin-kirkpatrick", build_dobkin_kirkpatrick, false, 0, 1, 4},
};

static const struct kind *row_of(bmr_hierarchy_kind kind) {
    return (unsigned)kind < BMR_HIERARCHY_KIND_COUNT ? &kinds[kind] : NULL;
}

bmr_error bmr_hierarchy_build(bmr_hierarchy_kind kind, const bmr_polygon *polygon, const bmr_compass *compass,
                              const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    const struct kind *row = row_of(kind);
    return row ? row->build(polygon, compass, allocator, hierarchy) : BMR_ERROR_OUT_OF_RANGE;
}

const char *bmr_hierarchy_name(bmr_hierarchy_kind kind) {
    const struct kind *row = row_of(kind);
    return row ? row->name : NULL;
}

bool bmr_hierarchy_uses_compass(bmr_hierarchy_kind kind) {
    const struct kind *row = row_of(kind);
    return row && row->uses_compass;
}

uint32_t bmr_tree_most_levels(const bmr_hierarchy *hierarchy) {
    const uint32_t log = bmr_ceil_log2(hierarchy->polygon->count);
    const uint32_t by_compass = log > hierarchy->corner_levels ? log : hierarchy->corner_levels;
    const struct kind *row = &kinds[hierarchy->kind];
    return log + row->more_levels + (row->uses_compass ? by_compass : 0);
}

uint32_t bmr_tree_most_edges(const bmr_hierarchy *hierarchy) {
    const struct kind *row = &kinds[hierarchy->kind];
    const uint32_t corners = hierarchy->corner_levels > 0 ? 4u << hierarchy->corner_levels : 0;
    return row->edges_a_vertex * hierarchy->polygon->count + row->more_edges + corners;
}
