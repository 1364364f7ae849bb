// SPDX-License-Identifier: MIT
#include "kds/chains.h"

#include "geometry/memory.h"
#include "hierarchy/tree.h"

static size_t bytes_for(uint32_t edges) {
    return sizeof(bmr_chains) + (4 * (size_t)edges + 2) * sizeof(uint32_t);
}

/// Where the arrays of one end (0: before, 1: after) begin.
static size_t starts_at(const bmr_chains *chains, int end) {
    return end ? (size_t)chains->count + 1 : 0;
}
static size_t nodes_at(const bmr_chains *chains, int end) {
    return 2 * ((size_t)chains->count + 1) + (end ? chains->count : 0);
}

/// Which edge a node cuts at that edge's end: at its clockwise end (0) the edge is the node's outer_after.
static bmr_edge cut_edge(const bmr_hierarchy *hierarchy, bmr_edge node, int end) {
    const bmr_boomerang b = bmr_hierarchy_boomerang(hierarchy, node);
    return end ? b.outer_before : b.outer_after;
}

/// By counting. Ids ascend with the levels, and so does each chain. Roots cut nothing.
static void fill(bmr_chains *chains, int end) {
    const bmr_hierarchy *hierarchy = chains->hierarchy;
    uint32_t *start = chains->arrays + starts_at(chains, end), *node = chains->arrays + nodes_at(chains, end);
    for (uint32_t i = 0; i <= chains->count; ++i)
        start[i] = 0;
    for (bmr_edge id = BMR_ROOTS; id < chains->count; ++id)
        ++start[cut_edge(hierarchy, id, end) + 1];
    for (uint32_t i = 0; i < chains->count; ++i)
        start[i + 1] += start[i];
    for (bmr_edge id = BMR_ROOTS; id < chains->count; ++id)
        node[start[cut_edge(hierarchy, id, end)]++] = id;
    for (uint32_t i = chains->count; i > 0; --i) // filling moved each start to the next one's
        start[i] = start[i - 1];
    start[0] = 0;
}

static void make(bmr_chains *chains, const bmr_hierarchy *hierarchy) {
    chains->hierarchy = hierarchy;
    chains->count = bmr_hierarchy_edge_count(hierarchy);
    chains->reserved = 0;
    for (int end = 0; end < 2; ++end)
        fill(chains, end);
}

bmr_error bmr_chains_create(const bmr_hierarchy *hierarchy, const bmr_allocator *allocator,
                            bmr_chains **chains) {
    if (!hierarchy || !chains)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_chains *made = bmr_allocate(allocator, bytes_for(bmr_hierarchy_edge_count(hierarchy)));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    make(made, hierarchy);
    *chains = made;
    return BMR_OK;
}

void bmr_chains_destroy(bmr_chains *chains, const bmr_allocator *allocator) {
    if (chains)
        bmr_release(allocator, chains, bmr_chains_bytes(chains));
}

size_t bmr_chains_bytes(const bmr_chains *chains) {
    return bytes_for(chains->count);
}

size_t bmr_kds_chains_bytes(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)b, (void)def;
    const bmr_hierarchy_kind kind = BMR_HIERARCHY_DUDLEY;
    return a->chains[kind] ? 0 : bytes_for(bmr_hierarchy_edge_count(a->hierarchies[kind]));
}

bmr_error bmr_kds_chains_prepare(bmr_kds *kds) {
    bmr_point_prepare(kds);
    bmr_chained_state *state = (bmr_chained_state *)(void *)kds->state;
    const bmr_chains *shared = kds->shapes[0].chains[kds->info->hierarchy];
    if (shared && shared->hierarchy != state->point.hierarchy)
        return BMR_ERROR_WRONG_HIERARCHY;
    bmr_chains *own = (bmr_chains *)(void *)(state + 1);
    if (!shared)
        make(own, state->point.hierarchy);
    state->chains = shared ? shared : own;
    return BMR_OK;
}

const bmr_chains *bmr_kds_chains_of(const bmr_kds *kds) {
    const bmr_kds_class *class = kds->info->implementation;
    if (class->prepare != bmr_kds_chains_prepare)
        return NULL;
    return ((const bmr_chained_state *)(const void *)kds->state)->chains;
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
bmr_edge bmr_kds_chains_search(const bmr_chains *chains, bmr_edge edge, bmr_vec2 x, double need,
                               unsigned *steps) {
    const bmr_hierarchy *hierarchy = chains->hierarchy;
    const int end = bmr_point_is_after(hierarchy, edge, x);
    const uint32_t *start = chains->arrays + starts_at(chains, end),
                   *node = chains->arrays + nodes_at(chains, end);
    // The point is beyond all of the chain from its triangle's node on, and beyond none before.
    uint32_t low = start[edge], high = start[edge + 1];
    const uint32_t last = high;
    for (uint32_t step = 1; low < high; step *= 2) {
        ++*steps;
        const uint32_t probe = high - low > step ? low + (step - 1) : high - 1;
        if (bmr_edge_slack(hierarchy, node[probe], x) > need) {
            high = probe;
            break;
        }
        low = probe + 1;
    }
    while (low < high) {
        ++*steps;
        const uint32_t middle = low + (high - low) / 2;
        if (bmr_edge_slack(hierarchy, node[middle], x) > need)
            high = middle;
        else
            low = middle + 1;
    }
    return low < last ? node[low] : BMR_NO_EDGE;
}
