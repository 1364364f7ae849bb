// SPDX-License-Identifier: MIT
// The eager structure for a point (section 5): the active triangle, the cell of the hierarchy's tiling that
// the point is in. A triangle is named by the node whose edge is its inner edge; its outer edges are the
// node's. The outside of P_0 is four pinwheel cells: beyond root k and not beyond root k + 1, named by the
// root.
//
// Cells overlap by twice the tolerance: a side is left only when the point is that far beyond it, and an
// inner edge is taken only from one tolerance on. So a point that runs along a side, or through an apex, is
// never between cells and never thrown back.
#include <math.h>

#include "geometry/memory.h"
#include "hierarchy/tree.h"
#include "kds/point.h"
#include "kds/registry.h"

/// The search for the new active triangle by halves (section 5: O(log(log n - i)) after crossing the inner
/// edge).
///
/// The nodes that cut an edge at one of its ends follow each other in the tree, one level deeper each: a
/// chain. The triangles along the edge, from its end to where it touches the polygon, are those of the chain
/// in order. A search needs the chain as an array. Every node is in two chains: 16 bytes a node.
///
/// The search gallops: from the chain's start in steps that double, then by halves. So it takes the logarithm
/// of the levels passed, which are at most log n and, where the point is at distance s, O(log D/s): the
/// minimum of Theorem ptpoly, and less.

struct bmr_chains {
    const bmr_hierarchy *hierarchy;
    uint32_t count; ///< of nodes
    uint32_t reserved;
    uint32_t arrays[]; ///< start[2 (count + 1)], node[2 count]
};

typedef struct chained_state {
    bmr_point_state point;
    const bmr_chains *chains; ///< the polygon's, or those behind this state
} chained_state;

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

static size_t chains_bytes(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def) {
    (void)b, (void)def;
    const bmr_hierarchy_kind kind = BMR_HIERARCHY_DUDLEY;
    return a->chains[kind] ? 0 : bytes_for(bmr_hierarchy_edge_count(a->hierarchies[kind]));
}

/// As bmr_point_prepare, and makes the chains if the shape has none. WRONG_HIERARCHY: it has another
/// hierarchy's. O(n), O(1) with the shape's.
static bmr_error chains_prepare(bmr_kds *kds) {
    bmr_point_prepare(kds);
    chained_state *state = (chained_state *)(void *)kds->state;
    const bmr_chains *shared = kds->shapes[0].chains[kds->info->hierarchy];
    if (shared && shared->hierarchy != state->point.hierarchy)
        return BMR_ERROR_WRONG_HIERARCHY;
    bmr_chains *own = (bmr_chains *)(void *)(state + 1);
    if (!shared)
        make(own, state->point.hierarchy);
    state->chains = shared ? shared : own;
    return BMR_OK;
}

/// NULL: the structure has none.
static const bmr_chains *chains_of(const bmr_kds *kds) {
    const bmr_kds_class *class = kds->info->implementation;
    if (class->prepare != chains_prepare)
        return NULL;
    return ((const chained_state *)(const void *)kds->state)->chains;
}

/// What bmr_point_descend does, galloping. O(log levels passed).
/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
static bmr_edge chains_search(const bmr_chains *chains, bmr_edge edge, bmr_vec2 x, double need,
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

enum { INNER, OUTER_BEFORE, OUTER_AFTER };

/// More moves than this between cells that follow each other is no motion but a jump.
#define MOST_MOVES 128

/// The slack beyond an outer edge at which the cell is left.
static double outer_limit(const bmr_kds *kds) {
    return kds->def.margin + 2.0 * bmr_point_tolerance(kds);
}

/// The outer side that the point is beyond by more than `limit`, the farther of two; BMR_NO_EDGE: none.
static bmr_edge beyond_outer(const bmr_kds *kds, bmr_vec2 x, double limit) {
    const bmr_point_state *state = bmr_point_view(kds);
    const bmr_boomerang b = bmr_hierarchy_boomerang(state->hierarchy, state->edge);
    const double after = bmr_edge_slack(state->hierarchy, b.outer_after, x);
    double before = -INFINITY;
    if (b.level > 0) // a pinwheel cell has no side there: the one before ends at this root's line
        before = bmr_edge_slack(state->hierarchy, b.outer_before, x);
    if (!((before > after ? before : after) > limit))
        return BMR_NO_EDGE;
    return before > after ? b.outer_before : b.outer_after;
}

static bool in_cell(const bmr_kds *kds, bmr_vec2 x) {
    const double limit = outer_limit(kds) - bmr_point_failing(kds);
    return bmr_point_holds(kds, x) && beyond_outer(kds, x, limit) == BMR_NO_EDGE;
}

/// From a cell nearby to the one that the point is in. False: not found.
static bool settle(bmr_kds *kds, bmr_vec2 x, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const double need = bmr_point_need(kds);
    for (int moves = 0; moves < MOST_MOVES; ++moves) {
        ++*touched;
        const bmr_edge outer = beyond_outer(kds, x, need);
        if (outer != BMR_NO_EDGE) {
            state->edge = outer;
            continue;
        }
        if (bmr_edge_slack(state->hierarchy, state->edge, x) > need)
            return true;
        const bmr_chains *chains = chains_of(kds);
        const bmr_edge inner = chains ? chains_search(chains, state->edge, x, need, touched)
                                      : bmr_point_descend(state->hierarchy, state->edge, x, need, touched);
        if (inner == BMR_NO_EDGE)
            return false;
        state->edge = inner;
    }
    return false;
}

/// From scratch: the closest direction leads down the tree to the boomerang, and the first node that the
/// point is beyond is its triangle's.
static bool locate(bmr_kds *kds, const bmr_pose *b_in_a, unsigned *touched) {
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_hierarchy *h = state->hierarchy;
    bmr_vec2 u;
    if (!bmr_point_closest(kds, b_in_a, &u))
        return false;
    const bmr_vec2 x = bmr_point_at(kds, b_in_a);
    const double need = bmr_point_need(kds);
    const bmr_corner top = bmr_tree_extreme(h, u, 0, touched);
    double slack;
    bmr_edge edge = bmr_corner_widest_edge(h, top, x, &slack);
    bmr_edge cut = top.cut;
    while (!(slack > need) && cut != BMR_NO_EDGE) {
        ++*touched;
        edge = cut;
        slack = bmr_edge_slack(h, cut, x);
        const bmr_boomerang b = bmr_hierarchy_boomerang(h, cut);
        cut = bmr_cross(bmr_hierarchy_line(h, cut).normal, u) >= 0.0 ? b.child_after : b.child_before;
    }
    state->edge = edge;
    if (slack > need && settle(kds, x, touched) && in_cell(kds, x))
        return true;
    return bmr_point_take_free(kds, b_in_a);
}

bool bmr_triangle_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const bool apart = locate(kds, &now->pose, &report->touched);
    report->level_after = apart ? bmr_point_level(kds) : 0;
    return apart;
}

/// Lemma 3.2: a convex curve beside P meets at most one triangle of a level.
/// Lemma 3.3(c): a convex curve at distance s meets O(log(D/s)) compass triangles.
/// Lemma 3.4(c): a convex curve at distance s meets O(log(D/s)) Dudley triangles.
/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
bool bmr_triangle_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    bmr_point_state *state = bmr_point_get(kds);
    const bmr_vec2 x = bmr_point_at(kds, &now->pose);
    const bmr_edge edge_before = state->edge;
    report->level_before = report->level_after = bmr_point_level(kds);
    const bool certified = bmr_point_holds(kds, x);
    const bool is_free = edge_before == BMR_NO_EDGE;
    if (is_free ? certified : in_cell(kds, x))
        return true;
    const bool found = !is_free && settle(kds, x, &report->touched) && in_cell(kds, x);
    if (!found && !locate(kds, &now->pose, &report->touched))
        return false;
    report->level_after = bmr_point_level(kds);
    report->kind = !certified && report->level_after > report->level_before ? BMR_KDS_STAB : BMR_KDS_CROSS;
    report->line_changed = is_free || state->edge != edge_before;
    return true;
}

/// The condition of not being beyond an outer side.
static bmr_condition behind(const bmr_kds *kds, bmr_edge edge, int label) {
    const bmr_point_state *state = bmr_point_view(kds);
    const bmr_line line = bmr_hierarchy_line(state->hierarchy, edge);
    return bmr_condition_beyond(0, bmr_neg(line.normal), -(line.offset + outer_limit(kds)), state->point,
                                label);
}

size_t bmr_triangle_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    const bmr_point_state *state = bmr_point_view(kds);
    size_t count = bmr_point_conditions(kds, conditions);
    if (state->edge == BMR_NO_EDGE)
        return count;
    const bmr_boomerang b = bmr_hierarchy_boomerang(state->hierarchy, state->edge);
    conditions[count++] = behind(kds, b.outer_after, OUTER_AFTER);
    if (b.level > 0)
        conditions[count++] = behind(kds, b.outer_before, OUTER_BEFORE);
    return count;
}

/// The point is in the triangle, whose sides are those of the tiling.
bmr_error bmr_triangle_audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const bmr_point_state *state = bmr_point_view(kds);
    if (state->edge == BMR_NO_EDGE)
        return BMR_OK;
    if (state->edge >= bmr_hierarchy_edge_count(state->hierarchy))
        return BMR_ERROR_INVALID_STRUCTURE;
    const double slop = bmr_point_tolerance(kds);
    const bmr_edge outer = beyond_outer(kds, bmr_point_at(kds, b_in_a), outer_limit(kds) + slop);
    return outer == BMR_NO_EDGE ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

static const bmr_kds_class by_levels = {.state_bytes = sizeof(bmr_point_state),
                                        .prepare = bmr_point_prepare,
                                        .start = bmr_triangle_start,
                                        .conditions = bmr_triangle_conditions,
                                        .repair = bmr_triangle_repair,
                                        .proof = bmr_point_proof,
                                        .audit = bmr_triangle_audit};
/// The chains lie behind the state, unless the shape has them.
static const bmr_kds_class by_bisection = {.state_bytes = sizeof(chained_state),
                                           .extra_bytes = chains_bytes,
                                           .prepare = chains_prepare,
                                           .start = bmr_triangle_start,
                                           .conditions = bmr_triangle_conditions,
                                           .repair = bmr_triangle_repair,
                                           .proof = bmr_point_proof,
                                           .audit = bmr_triangle_audit};

BMR_KDS_INFO(triangle_levels_compass, "triangle-levels-compass",
             "point: active triangle, level by level, compass", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_COMPASS, &by_levels);
BMR_KDS_INFO(triangle_levels_dudley, "triangle-levels-dudley",
             "point: active triangle, level by level, Dudley", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY, &by_levels);
BMR_KDS_INFO(triangle_binary_dudley, "triangle-binary-dudley",
             "point: active triangle, binary search, Dudley", "5, one point, one polygon", BMR_KDS_POINT,
             BMR_KDS_CONTROL, BMR_HIERARCHY_DUDLEY, &by_bisection);
