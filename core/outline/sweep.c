// SPDX-License-Identifier: MIT
#include "outline/sweep.h"

#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "geometry/predicates.h"

#define NONE BMR_OUTLINE_NONE

/// The strands that the sweep's line meets: a treap, ordered from below to above. O(log n) expected a call,
/// whatever the outline: priorities are a hash of the strand's number.
typedef struct bmr_status {
    const bmr_vec2 *points;
    bmr_strand *strands;
    uint32_t root;
} bmr_status;

/// Takes the tree apart at a point: strands below, through and above it. BMR_OUTLINE_NONE: an empty tree.
typedef struct bmr_status_parts {
    uint32_t below, through, above;
} bmr_status_parts;
/// On which side of a strand the point is: 1 above, 0 on its line, -1 below.
static int side_of(const bmr_status *s, uint32_t strand, bmr_vec2 point) {
    const bmr_strand *t = &s->strands[strand];
    return bmr_orientation(s->points[t->left], s->points[t->right], point);
}

/// Strands of which the point's side is at least `side` go to *below, the others to *above.
static void split(bmr_status *s, uint32_t tree, bmr_vec2 point, int side, uint32_t *below, uint32_t *above) {
    // Goes down one path, and hangs what it comes by to the open ends of the two trees.
    while (tree != NONE) {
        bmr_strand *t = &s->strands[tree];
        if (side_of(s, tree, point) >= side) {
            *below = tree;
            below = &t->upper;
            tree = t->upper;
        } else {
            *above = tree;
            above = &t->lower;
            tree = t->lower;
        }
    }
    *below = *above = NONE;
}

static bmr_status_parts bmr_status_split(bmr_status *status, bmr_vec2 point) {
    bmr_status_parts parts;
    uint32_t rest;
    split(status, status->root, point, 1, &parts.below, &rest);
    split(status, rest, point, 0, &parts.through, &parts.above);
    return parts;
}

/// The topmost and the lowest strand of a tree; BMR_OUTLINE_NONE of an empty one.
static uint32_t bmr_status_top(const bmr_status *status, uint32_t tree) {
    while (tree != NONE && status->strands[tree].upper != NONE)
        tree = status->strands[tree].upper;
    return tree;
}

static uint32_t bmr_status_bottom(const bmr_status *status, uint32_t tree) {
    while (tree != NONE && status->strands[tree].lower != NONE)
        tree = status->strands[tree].lower;
    return tree;
}

/// Writes the strands of a tree to `list`, from below; returns how many.
/// As deep as the tree: O(log n) expected.
static uint32_t bmr_status_list(const bmr_status *status, uint32_t tree, uint32_t *list) {
    if (tree == NONE)
        return 0;
    uint32_t count = bmr_status_list(status, status->strands[tree].lower, list);
    list[count++] = tree;
    return count + bmr_status_list(status, status->strands[tree].upper, list + count);
}

static uint32_t merge(bmr_status *s, uint32_t below, uint32_t above) {
    uint32_t root = NONE, *end = &root;
    while (below != NONE && above != NONE) {
        if (s->strands[below].priority >= s->strands[above].priority) {
            *end = below;
            end = &s->strands[below].upper;
            below = *end;
        } else {
            *end = above;
            end = &s->strands[above].lower;
            above = *end;
        }
    }
    *end = below != NONE ? below : above;
    return root;
}

/// Mixes the bits of a number; the constants are those of a 32-bit finalizer known to change every bit.
static uint32_t mixed(uint32_t x) {
    x = (x ^ x >> 16) * UINT32_C(0x7feb352d);
    x = (x ^ x >> 15) * UINT32_C(0x846ca68b);
    return x ^ x >> 16;
}

/// Makes the whole of what is below, of new strands from below to above, and of what is above.
static void bmr_status_join(bmr_status *status, uint32_t below, const uint32_t *strands, uint32_t count,
                            uint32_t above) {
    for (uint32_t i = 0; i < count; ++i) {
        bmr_strand *t = &status->strands[strands[i]];
        t->lower = t->upper = NONE;
        t->priority = mixed(strands[i]);
        below = merge(status, below, strands[i]);
    }
    status->root = merge(status, below, above);
}

/// One end of a strand at the place of the event.
typedef struct arm {
    uint32_t passage, edge;
} arm;

typedef struct sweep {
    const bmr_ring_links *links;
    bmr_strand *strands;
    uint32_t strand_count;
    bmr_status status;
    uint32_t *first; ///< of each point: the first of those in its place
    uint32_t *order; ///< all points, in the sweep's order
    uint32_t *ends, *starts, *scratch;
    uint32_t end_count, start_count;
    arm *arms;
    bool *ring_met;
    bmr_outline_fault *fault;
} sweep;

/// Where two edges meet, up to rounding; an end of the first where that is no number.
static bmr_vec2 meeting_of(const bmr_ring_links *l, uint32_t edge, uint32_t other) {
    const bmr_vec2 a = l->points[edge], b = l->points[l->next[edge]];
    const bmr_vec2 c = l->points[other], d = l->points[l->next[other]];
    const bmr_vec2 along = bmr_sub(b, a), across = bmr_sub(d, c);
    const double part = bmr_cross(bmr_sub(c, a), across) / bmr_cross(along, across);
    const bmr_vec2 where = bmr_add(a, bmr_scale(part, along));
    return part >= 0.0 && part <= 1.0 && isfinite(where.x) && isfinite(where.y) ? where : a;
}

static bmr_error fault_of(const sweep *s, bmr_error error, uint32_t edge, uint32_t other, bmr_vec2 where) {
    const bmr_ring_links *l = s->links;
    if (other < edge && error != BMR_ERROR_HOLE_OUTSIDE) {
        const uint32_t swap = edge;
        edge = other;
        other = swap;
    }
    const uint32_t other_ring = other == NONE ? NONE : l->ring[other];
    *s->fault = (bmr_outline_fault){error, {edge, other}, {l->ring[edge], other_ring}, where};
    return error;
}

static bool comes_before(const void *context, uint32_t a, uint32_t b) {
    const bmr_vec2 *p = context;
    const int order = bmr_sweep_compare(p[a], p[b]);
    return order != 0 ? order < 0 : a < b;
}

/// Of strands that start in one place: is a below b?
static bool starts_below(const void *context, uint32_t a, uint32_t b) {
    const bmr_status *s = context;
    const bmr_strand *t = &s->strands[a];
    return bmr_orientation(s->points[t->left], s->points[t->right], s->points[s->strands[b].right]) > 0;
}

static uint32_t new_strand(sweep *s, uint32_t edge, uint32_t left, uint32_t left_passage, uint32_t right,
                           uint32_t right_passage) {
    bmr_strand *t = &s->strands[s->strand_count];
    memset(t, 0, sizeof *t);
    t->edge = edge;
    t->left = left;
    t->left_passage = left_passage;
    t->right = right;
    t->right_passage = right_passage;
    return s->strand_count++;
}

/// The strands that start at the `count` points of a place: their edges that lead on, and what goes on of
/// strands that pass through. From below.
static void collect_starts(sweep *s, const uint32_t *points, uint32_t count) {
    const bmr_ring_links *l = s->links;
    const uint32_t place = points[0];
    s->start_count = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = points[i], next = l->next[p], previous = l->previous[p];
        if (bmr_sweep_compare(l->points[next], l->points[p]) > 0)
            s->starts[s->start_count++] = new_strand(s, p, place, p, s->first[next], next);
        if (bmr_sweep_compare(l->points[previous], l->points[p]) > 0)
            s->starts[s->start_count++] = new_strand(s, previous, place, p, s->first[previous], previous);
    }
    for (uint32_t i = 0; i < s->end_count; ++i) {
        bmr_strand *t = &s->strands[s->ends[i]];
        if (t->right == place)
            continue;
        const uint32_t passage = l->count + t->edge;
        s->starts[s->start_count++] = new_strand(s, t->edge, place, passage, t->right, t->right_passage);
        t->right = place;
        t->right_passage = passage;
    }
    bmr_sort_indices(s->starts, s->start_count, s->scratch, starts_below, &s->status);
}

/// Strands that start in one direction overlap. (Those that end from one have started somewhere.)
static bmr_error check_overlap(const sweep *s) {
    for (uint32_t i = 0; i + 1 < s->start_count; ++i)
        if (!starts_below(&s->status, s->starts[i], s->starts[i + 1])) {
            const bmr_strand *t = &s->strands[s->starts[i]];
            return fault_of(s, BMR_ERROR_OVERLAPPING_EDGES, t->edge, s->strands[s->starts[i + 1]].edge,
                            s->links->points[t->left]);
        }
    return BMR_OK;
}

/// Do two passages through the place cross? Once around it, each arm either opens a passage or closes the one
/// that was opened last, as brackets do.
static bmr_error check_passages(const sweep *s, bmr_vec2 place) {
    uint32_t open = 0;
    for (uint32_t i = 0; i < s->start_count + s->end_count; ++i) {
        const bool start = i < s->start_count;
        const bmr_strand *t =
            &s->strands[start ? s->starts[i] : s->ends[s->start_count + s->end_count - 1 - i]];
        const arm now = {start ? t->left_passage : t->right_passage, t->edge};
        if (open > 0 && s->arms[open - 1].passage == now.passage)
            --open;
        else
            s->arms[open++] = now;
    }
    return open == 0 ? BMR_OK
                     : fault_of(s, BMR_ERROR_CROSSING_EDGES, s->arms[0].edge, s->arms[1].edge, place);
}

/// The gaps above the strands that start here are solid and void in turn. The first strand of a ring has the
/// inside of the ring above it: of a hole that is void.
static bmr_error set_solid(const sweep *s, uint32_t below) {
    bool solid = below != NONE && s->strands[below].solid_above;
    for (uint32_t i = 0; i < s->start_count; ++i) {
        bmr_strand *t = &s->strands[s->starts[i]];
        solid = !solid;
        t->solid_above = solid;
        const uint32_t ring = s->links->ring[t->edge];
        if (s->ring_met[ring])
            continue;
        s->ring_met[ring] = true;
        if (ring == 0 || !solid)
            continue;
        const uint32_t under = i > 0 ? s->starts[i - 1] : below;
        return fault_of(s, BMR_ERROR_HOLE_OUTSIDE, t->edge, under == NONE ? NONE : s->strands[under].edge,
                        s->links->points[t->left]);
    }
    return BMR_OK;
}

/// Do two strands cross where neither has an end? (Where one has, the sweep will come to it.)
static bmr_error check_crossing(const sweep *s, uint32_t below, uint32_t above) {
    if (below == NONE || above == NONE)
        return BMR_OK;
    const bmr_vec2 *p = s->links->points;
    const bmr_strand *t = &s->strands[below], *u = &s->strands[above];
    if (bmr_orientation(p[t->left], p[t->right], p[u->left]) *
                bmr_orientation(p[t->left], p[t->right], p[u->right]) <
            0 &&
        bmr_orientation(p[u->left], p[u->right], p[t->left]) *
                bmr_orientation(p[u->left], p[u->right], p[t->right]) <
            0) {
        const uint32_t first = t->edge < u->edge ? t->edge : u->edge;
        const uint32_t second = t->edge < u->edge ? u->edge : t->edge;
        return fault_of(s, BMR_ERROR_CROSSING_EDGES, first, second, meeting_of(s->links, first, second));
    }
    return BMR_OK;
}

static bmr_error visit_place(sweep *s, const uint32_t *points, uint32_t count, bmr_sweep_visit *visit,
                             void *context) {
    const bmr_vec2 place = s->links->points[points[0]];
    const bmr_status_parts parts = bmr_status_split(&s->status, place);
    const uint32_t below = bmr_status_top(&s->status, parts.below);
    const uint32_t above = bmr_status_bottom(&s->status, parts.above);
    s->end_count = bmr_status_list(&s->status, parts.through, s->ends);
    collect_starts(s, points, count);
    bmr_error error = check_overlap(s);
    if (error == BMR_OK)
        error = check_passages(s, place);
    if (error == BMR_OK)
        error = set_solid(s, below);
    if (error == BMR_OK)
        error = check_crossing(s, below, s->start_count > 0 ? s->starts[0] : above);
    if (error == BMR_OK && s->start_count > 0)
        error = check_crossing(s, s->starts[s->start_count - 1], above);
    if (error != BMR_OK)
        return error;
    if (visit) {
        const bmr_sweep_event event = {points[0], below, s->ends, s->starts, s->end_count, s->start_count};
        visit(context, s->strands, &event);
    }
    bmr_status_join(&s->status, parts.below, s->starts, s->start_count, parts.above);
    return BMR_OK;
}

static bmr_error run(sweep *s, bmr_sweep_visit *visit, void *context) {
    const bmr_ring_links *l = s->links;
    for (uint32_t i = 0; i < l->count; ++i)
        s->order[i] = i;
    bmr_sort_indices(s->order, l->count, s->scratch, comes_before, l->points);
    for (uint32_t i = 0; i < l->count; ++i) {
        const uint32_t p = s->order[i];
        const bool same = i > 0 && bmr_sweep_compare(l->points[s->order[i - 1]], l->points[p]) == 0;
        s->first[p] = same ? s->first[s->order[i - 1]] : p;
    }
    for (uint32_t i = 0; i < l->count;) {
        uint32_t end = i + 1;
        while (end < l->count && s->first[s->order[end]] == s->order[i])
            ++end;
        const bmr_error error = visit_place(s, s->order + i, end - i, visit, context);
        if (error != BMR_OK)
            return error;
        i = end;
    }
    return BMR_OK;
}

bmr_error bmr_sweep(const bmr_ring_links *links, const bmr_allocator *allocator, bmr_sweep_visit *visit,
                    void *context, bmr_outline_fault *fault) {
    const size_t points = links->count, strands = bmr_sweep_most_strands(links->count);
    const size_t bytes = strands * (sizeof(bmr_strand) + 2 * sizeof(arm)) +
                         (2 * points + 3 * strands) * sizeof(uint32_t) + links->ring_count * sizeof(bool);
    bmr_strand *block = bmr_allocate(allocator, bytes);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    arm *arms = (arm *)(void *)(block + strands);
    uint32_t *indices = (uint32_t *)(void *)(arms + 2 * strands);
    uint32_t *strand_lists = indices + 2 * points;
    bool *ring_met = (bool *)(strand_lists + 3 * strands);
    memset(ring_met, 0, links->ring_count * sizeof(bool));
    sweep s = {.links = links,
               .status = {links->points, block, NONE},
               .strands = block,
               .arms = arms,
               .first = indices,
               .order = indices + points,
               .ends = strand_lists,
               .starts = strand_lists + strands,
               .scratch = strand_lists + 2 * strands,
               .ring_met = ring_met,
               .fault = fault};
    const bmr_error error = run(&s, visit, context);
    bmr_release(allocator, block, bytes);
    return error;
}
