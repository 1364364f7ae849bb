// SPDX-License-Identifier: MIT
#include "kds/chains.h"

static size_t bytes_for(const bmr_hierarchy *hierarchy) {
    const size_t count = bmr_hierarchy_edge_count(hierarchy);
    return (4 * count + 2) * sizeof(uint32_t);
}

size_t bmr_kds_chains_bytes_compass(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)b, (void)def;
    return bytes_for(a->hierarchies[BMR_HIERARCHY_COMPASS]);
}

size_t bmr_kds_chains_bytes_dudley(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)b, (void)def;
    return bytes_for(a->hierarchies[BMR_HIERARCHY_DUDLEY]);
}

/// Where, behind the head, the arrays of one end (0: before, 1: after) begin.
static size_t starts_at(const bmr_kds_chains *chains, int end) {
    return end ? chains->count + 1 : 0;
}
static size_t nodes_at(const bmr_kds_chains *chains, int end) {
    return 2 * ((size_t)chains->count + 1) + (end ? chains->count : 0);
}

/// Which edge a node cuts at that edge's end: at its clockwise end (0) the edge is the node's outer_after.
static bmr_edge cut_edge(const bmr_hierarchy *hierarchy, bmr_edge node, int end) {
    const bmr_boomerang b = bmr_hierarchy_boomerang(hierarchy, node);
    return end ? b.outer_before : b.outer_after;
}

/// By counting. Ids ascend with the levels, and so does each chain. Roots cut nothing.
static void fill(bmr_kds_chains *chains, const bmr_hierarchy *hierarchy, int end) {
    uint32_t *arrays = (uint32_t *)(void *)(chains + 1);
    uint32_t *start = arrays + starts_at(chains, end), *node = arrays + nodes_at(chains, end);
    const bmr_edge first = 4;
    for (uint32_t i = 0; i <= chains->count; ++i)
        start[i] = 0;
    for (bmr_edge id = first; id < chains->count; ++id)
        ++start[cut_edge(hierarchy, id, end) + 1];
    for (uint32_t i = 0; i < chains->count; ++i)
        start[i + 1] += start[i];
    for (bmr_edge id = first; id < chains->count; ++id)
        node[start[cut_edge(hierarchy, id, end)]++] = id;
    for (uint32_t i = chains->count; i > 0; --i) // filling moved each start to the next one's
        start[i] = start[i - 1];
    start[0] = 0;
}

bmr_error bmr_kds_chains_prepare(bmr_kds *kds) {
    bmr_point_prepare(kds);
    bmr_chained_state *state = (bmr_chained_state *)(void *)kds->state;
    state->chains.count = bmr_hierarchy_edge_count(state->point.hierarchy);
    for (int end = 0; end < 2; ++end)
        fill(&state->chains, state->point.hierarchy, end);
    return BMR_OK;
}

const bmr_kds_chains *bmr_kds_chains_of(const bmr_kds *kds) {
    const bmr_kds_class *class = kds->info->implementation;
    if (class->prepare != bmr_kds_chains_prepare)
        return NULL;
    return &((const bmr_chained_state *)(const void *)kds->state)->chains;
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
bmr_edge bmr_kds_chains_search(const bmr_kds_chains *chains, const bmr_hierarchy *hierarchy, bmr_edge edge,
                               bmr_vec2 x, double need, unsigned *steps) {
    const int end = bmr_point_is_after(hierarchy, edge, x);
    const uint32_t *arrays = (const uint32_t *)(const void *)(chains + 1);
    const uint32_t *start = arrays + starts_at(chains, end), *node = arrays + nodes_at(chains, end);
    // The point is beyond all of the chain from its triangle's node on, and beyond none before.
    uint32_t low = start[edge], high = start[edge + 1];
    const uint32_t last = high;
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
