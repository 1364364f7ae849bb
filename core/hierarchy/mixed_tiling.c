// SPDX-License-Identifier: MIT
// The mixed hierarchy written out: all cells of one rotation, each with its neighbours.

#include <string.h>

#include "geometry/memory.h"
#include "hierarchy/mixed.h"
#include "hierarchy/tree.h"

/// Levels of a hierarchy are 6 bits.
#define LEVELS 64u
/// Sides of a cell that have one neighbour: all but the inner one.
#define LINKS 3u

/// The cells that one edge e made: its parallelograms and its triangle, in angular order.
typedef struct group {
    uint32_t first, count;
} group;

/// One block: this, then the arrays.
struct bmr_mixed_tiling {
    bmr_mixed mixed;
    size_t bytes;
    uint32_t count;
    uint32_t edges[2];
    bmr_mixed_cell *cells;
    group *groups;         ///< of A's edges, then of B's
    uint32_t *across;      ///< LINKS for each cell, by role - 1
    uint32_t *below_first; ///< count + 2: where the tiles below each begin in `below`; M_0 is the last
    uint32_t *below;
};

static size_t bytes_for(size_t cells, size_t edges) {
    return sizeof(bmr_mixed_tiling) + cells * sizeof(bmr_mixed_cell) + edges * sizeof(group) +
           (cells * LINKS + cells + 2 + cells * LINKS) * sizeof(uint32_t);
}

static void lay_out(bmr_mixed_tiling *tiling, size_t cells) {
    tiling->cells = (bmr_mixed_cell *)(tiling + 1);
    tiling->groups = (group *)(tiling->cells + cells);
    tiling->across = (uint32_t *)(tiling->groups + tiling->edges[0] + tiling->edges[1]);
    tiling->below_first = tiling->across + cells * LINKS;
    tiling->below = tiling->below_first + cells + 2;
}

static void count_levels(const bmr_hierarchy *h, uint32_t counts[LEVELS]) {
    memset(counts, 0, LEVELS * sizeof *counts);
    for (uint32_t i = 0; i < h->count; ++i)
        ++counts[h->nodes[i].level];
}

/// At each stage an edge of the other body lies in the chain of one new edge at most.
static size_t most_cells(const bmr_hierarchy *const hierarchies[2]) {
    uint32_t counts[2][LEVELS], so_far[2];
    size_t most = 0;
    for (int body = 0; body < 2; ++body) {
        count_levels(hierarchies[body], counts[body]);
        so_far[body] = counts[body][0];
    }
    for (uint32_t level = 1; level < LEVELS; ++level)
        for (int body = 0; body < 2; ++body) {
            most += counts[body][level] > 0 ? counts[body][level] + so_far[1 - body] : 0;
            so_far[body] += counts[body][level];
        }
    return most;
}

size_t bmr_mixed_tiling_most_bytes(const bmr_hierarchy *a, const bmr_hierarchy *b) {
    const bmr_hierarchy *const hierarchies[2] = {a, b};
    return bytes_for(most_cells(hierarchies), (size_t)a->count + b->count);
}

/// Writes the cells of one edge, in angular order; `cells` NULL: counts them only.
static uint32_t write_group(const bmr_mixed *mixed, int body, bmr_edge e, bmr_mixed_cell *cells) {
    const bmr_node *node = &mixed->hierarchies[body]->nodes[e];
    const bmr_edge l = (bmr_edge)node->outer_before, r = (bmr_edge)node->outer_after;
    const int other = 1 - body;
    const bmr_hierarchy *h = mixed->hierarchies[other];
    const uint32_t level = bmr_mixed_level(other, 2 * ((int32_t)node->level - 1) + body);
    const bmr_corner start = bmr_mixed_around(mixed, other, l, level);
    bmr_edge previous = start.before, y = start.after;
    uint32_t count = 0;
    bool past = false;
    for (;;) {
        if (!past && !bmr_mixed_precedes(mixed, other, y, e)) {
            if (cells)
                cells[count] = bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, body, e, previous, y);
            ++count;
            past = true;
        }
        if (!bmr_mixed_precedes(mixed, other, y, r))
            return count;
        if (cells)
            cells[count] =
                bmr_mixed_cell_make(past ? BMR_MIXED_AFTER : BMR_MIXED_BEFORE, body, e, y, BMR_NO_EDGE);
        ++count;
        previous = y;
        y = bmr_hierarchy_corner_after(h, y, level).after;
    }
}

/// Visits the edges in the order of the stages; cells NULL: counts.
static uint32_t write_cells(const bmr_mixed *mixed, bmr_mixed_cell *cells, group *groups) {
    uint32_t next[2] = {BMR_ROOTS, BMR_ROOTS}, count = 0; // nodes are in the order of their levels
    for (uint32_t level = 1; level < LEVELS; ++level)
        for (int body = 0; body < 2; ++body) {
            const bmr_hierarchy *h = mixed->hierarchies[body];
            for (; next[body] < h->count && h->nodes[next[body]].level == level; ++next[body]) {
                const uint32_t size = write_group(mixed, body, next[body], cells ? cells + count : NULL);
                if (groups)
                    groups[(body ? mixed->hierarchies[0]->count : 0) + next[body]] = (group){count, size};
                count += size;
            }
        }
    return count;
}

static void link_tiles(bmr_mixed_tiling *tiling) {
    const bmr_mixed *mixed = &tiling->mixed;
    uint32_t *first = tiling->below_first;
    memset(first, 0, (tiling->count + 2) * sizeof *first);
    for (uint32_t i = 0; i < tiling->count; ++i)
        for (int role = BMR_MIXED_OUTER; role <= BMR_MIXED_HIGH; ++role) {
            const bool has = role != BMR_MIXED_OUTER || tiling->cells[i].kind != BMR_MIXED_TRIANGLE;
            uint32_t other = BMR_MIXED_NO_TILE;
            if (has) {
                // Sideways and outwards no ray is asked for.
                const bmr_mixed_cell cell =
                    bmr_mixed_next(mixed, &tiling->cells[i], (bmr_mixed_role)role, NULL, NULL);
                other = bmr_mixed_tiling_find(tiling, &cell);
            }
            tiling->across[i * LINKS + (uint32_t)role - 1] = other;
        }
}

/// Is the neighbour across that side coarser, so that this cell is one of several below it?
static bool hangs_on(const bmr_mixed_tiling *tiling, uint32_t tile, uint32_t link, uint32_t *upper) {
    const bmr_mixed_cell *cell = &tiling->cells[tile];
    if (link == BMR_MIXED_OUTER - 1 && cell->kind == BMR_MIXED_TRIANGLE)
        return false;
    const uint32_t other = tiling->across[tile * LINKS + link];
    *upper = other == BMR_MIXED_NO_TILE ? tiling->count : other;
    return other == BMR_MIXED_NO_TILE || tiling->cells[other].edge != cell->edge ||
           tiling->cells[other].owner != cell->owner;
}

/// A counting sort of the tiles by those above them.
static void list_below(bmr_mixed_tiling *tiling) {
    uint32_t *first = tiling->below_first;
    uint32_t upper = 0;
    for (uint32_t i = 0; i < tiling->count; ++i)
        for (uint32_t link = 0; link < LINKS; ++link)
            if (hangs_on(tiling, i, link, &upper))
                ++first[upper + 1];
    for (uint32_t i = 0; i <= tiling->count; ++i)
        first[i + 1] += first[i];
    for (uint32_t i = 0; i < tiling->count; ++i)
        for (uint32_t link = 0; link < LINKS; ++link)
            if (hangs_on(tiling, i, link, &upper))
                tiling->below[first[upper]++] = i;
    // Each beginning has moved on to the next one's.
    memmove(first + 1, first, (tiling->count + 1) * sizeof *first);
    first[0] = 0;
}

void bmr_mixed_tiling_build(bmr_mixed_tiling *tiling, const bmr_mixed *mixed, size_t bytes) {
    memset(tiling, 0, sizeof *tiling);
    tiling->mixed = *mixed;
    tiling->mixed.steps = NULL;
    tiling->bytes = bytes;
    tiling->edges[0] = mixed->hierarchies[0]->count;
    tiling->edges[1] = mixed->hierarchies[1]->count;
    tiling->count = write_cells(mixed, NULL, NULL);
    lay_out(tiling, tiling->count);
    memset(tiling->groups, 0, ((size_t)tiling->edges[0] + tiling->edges[1]) * sizeof(group));
    (void)write_cells(mixed, tiling->cells, tiling->groups);
    link_tiles(tiling);
    list_below(tiling);
}

/// Lemma 4.1: the mixed hierarchy has O((n + m) log m) cells.
/// Lemma 4.4(a): O(sqrt(D/s) log(D/s)) and O(sqrt(D/s)) mixed cells are at least s high.
bmr_error bmr_mixed_tiling_create(const bmr_mixed *mixed, const bmr_allocator *allocator,
                                  bmr_mixed_tiling **tiling) {
    if (!mixed || !tiling || !mixed->hierarchies[0] || !mixed->hierarchies[1])
        return BMR_ERROR_NULL_ARGUMENT;
    const size_t edges = (size_t)mixed->hierarchies[0]->count + mixed->hierarchies[1]->count;
    const size_t bytes = bytes_for(write_cells(mixed, NULL, NULL), edges);
    bmr_mixed_tiling *made = bmr_allocate(allocator, bytes);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_mixed_tiling_build(made, mixed, bytes);
    *tiling = made;
    return BMR_OK;
}

void bmr_mixed_tiling_destroy(bmr_mixed_tiling *tiling, const bmr_allocator *allocator) {
    if (tiling)
        bmr_release(allocator, tiling, tiling->bytes);
}

uint32_t bmr_mixed_tiling_count(const bmr_mixed_tiling *tiling) {
    return tiling->count;
}
const bmr_mixed_cell *bmr_mixed_tiling_cell(const bmr_mixed_tiling *tiling, uint32_t tile) {
    return &tiling->cells[tile];
}

/// Where a cell is among those of its edge: before (-1), at (0) or after (1) another.
static int compare(const bmr_mixed *mixed, const bmr_mixed_cell *a, const bmr_mixed_cell *b) {
    if (bmr_mixed_same(a, b))
        return 0;
    if (a->kind != b->kind) // before, triangle, after
        return a->kind == BMR_MIXED_BEFORE || b->kind == BMR_MIXED_AFTER ? -1 : 1;
    const bmr_hierarchy *h = mixed->hierarchies[1 - a->owner];
    return bmr_cross(bmr_hierarchy_line(h, a->other[0]).normal, bmr_hierarchy_line(h, b->other[0]).normal) >
                   0.0
               ? -1
               : 1;
}

uint32_t bmr_mixed_tiling_find(const bmr_mixed_tiling *tiling, const bmr_mixed_cell *cell) {
    if (cell->kind == BMR_MIXED_OUTSIDE || cell->kind == BMR_MIXED_INSIDE || cell->owner > 1 ||
        cell->edge >= tiling->edges[cell->owner])
        return BMR_MIXED_NO_TILE;
    const group *g = &tiling->groups[(cell->owner ? tiling->edges[0] : 0) + cell->edge];
    uint32_t low = g->first, high = g->first + g->count;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const int order = compare(&tiling->mixed, cell, &tiling->cells[middle]);
        if (order == 0)
            return middle;
        if (order < 0)
            high = middle;
        else
            low = middle + 1;
    }
    return BMR_MIXED_NO_TILE;
}

uint32_t bmr_mixed_tiling_across(const bmr_mixed_tiling *tiling, uint32_t tile, bmr_mixed_role role) {
    return role == BMR_MIXED_INNER ? BMR_MIXED_NO_TILE : tiling->across[tile * LINKS + (uint32_t)role - 1];
}

const uint32_t *bmr_mixed_tiling_below(const bmr_mixed_tiling *tiling, uint32_t tile, uint32_t *count) {
    const uint32_t upper = tile == BMR_MIXED_NO_TILE ? tiling->count : tile;
    *count = tiling->below_first[upper + 1] - tiling->below_first[upper];
    return tiling->below + tiling->below_first[upper];
}

// --- walks ---

/// The tile of those below another through whose side on it the ray comes in.
static uint32_t enter_below(const bmr_mixed_tiling *tiling, const bmr_mixed *mixed, uint32_t upper,
                            const bmr_mixed_ray *ray, unsigned *touched) {
    uint32_t count;
    const uint32_t *list = bmr_mixed_tiling_below(tiling, upper, &count);
    for (uint32_t k = 0; k < count; ++k) {
        bmr_mixed_figure figure;
        bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
        bmr_mixed_draw(mixed, &tiling->cells[list[k]], &figure);
        bmr_mixed_figure_polygon(mixed, &tiling->cells[list[k]], &figure, corners);
        const size_t n = figure.sides;
        if (touched)
            ++*touched;
        for (size_t i = 0; i < n; ++i) {
            const bmr_mixed_role role = (bmr_mixed_role)figure.parts[i].role;
            if (role != BMR_MIXED_INNER && bmr_mixed_tiling_across(tiling, list[k], role) == upper &&
                bmr_mixed_left(ray, corners[i]) && !bmr_mixed_left(ray, corners[i + 1 < n ? i + 1 : 0]))
                return list[k];
        }
    }
    return BMR_MIXED_NO_TILE;
}

bool bmr_mixed_tiling_walk(const bmr_mixed_tiling *tiling, uint32_t *tile, bmr_mixed_kind *kind,
                           bmr_vec2 from, bmr_vec2 to, unsigned *touched) {
    bmr_mixed counted = tiling->mixed;
    counted.steps = touched;
    const bmr_mixed *mixed = &counted;
    const bmr_mixed_ray ray = {from, bmr_sub(to, from)};
    if (*tile == BMR_MIXED_NO_TILE) {
        *tile = enter_below(tiling, mixed, BMR_MIXED_NO_TILE, &ray, touched);
        if (*tile == BMR_MIXED_NO_TILE) {
            const bmr_mixed_cell met = bmr_mixed_enter(mixed, &ray, NULL);
            *kind = met.kind == BMR_MIXED_OUTSIDE ? BMR_MIXED_OUTSIDE : BMR_MIXED_INSIDE;
        }
    }
    for (uint32_t steps = tiling->count; *tile != BMR_MIXED_NO_TILE; --steps) {
        const bmr_mixed_cell *cell = &tiling->cells[*tile];
        bmr_mixed_figure figure;
        *kind = (bmr_mixed_kind)cell->kind;
        bmr_mixed_draw(mixed, cell, &figure);
        const size_t exit = bmr_mixed_exit(mixed, cell, &figure, &ray);
        if (exit == figure.sides || steps == 0)
            return false;
        if (bmr_mixed_figure_value(mixed, &figure, exit, to) >= 0.0)
            return true;
        if (touched)
            ++*touched;
        const bmr_mixed_role role = (bmr_mixed_role)figure.parts[exit].role;
        *kind = role == BMR_MIXED_INNER ? BMR_MIXED_INSIDE : BMR_MIXED_OUTSIDE;
        *tile = role == BMR_MIXED_INNER ? enter_below(tiling, mixed, *tile, &ray, touched)
                                        : bmr_mixed_tiling_across(tiling, *tile, role);
    }
    return true;
}
