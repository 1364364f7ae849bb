// SPDX-License-Identifier: MIT
#include "outline/optimal.h"

#include <string.h>

#include "geometry/memory.h"
#include "geometry/predicates.h"

/// @file
/// The parts of the programme are the polygons that a segment from corner i to corner k > i cuts off: i,
/// i + 1, .., k. The base of such a part is the piece beside the segment. What matters of it to whoever puts
/// a triangle to the other side of the segment is how wide it is at i and at k: its first corner behind i and
/// its last one before k. Of all ways to cut the part with the fewest cuts, only those are kept of which no
/// other is narrower at both ends. A triangle i, j, k either becomes one with the base of the part on its one
/// side, where that stays convex, or is cut off from it.
///
/// Of i and k one is a notch, since a cut that no notch needs can be left out. The triangles of a piece are a
/// fan around a notch, then: around i where that is one, else around k.
///
/// Corners on one line. A segment that touches further corners can be no cut, but its part can be one of
/// those that a piece is made of:
///   - LINKED: the corners on it are of the part, i < x < k. The piece on the other side goes straight on at
///     each of them, and the part is made of the parts of the segment's links, which are cuts or edges.
///   - BEHIND: none of them is. The piece on this side goes straight on at each of them. With the next one it
///     makes a triangle without an area, which has to become one with the part's base.
/// With corners from both sides on it, a segment is neither.

#define NO_CUTS UINT16_MAX
#define NO_BASE UINT32_MAX
/// How many bases fit at first.
#define FIRST_CAPACITY 4096u

typedef struct base {
    uint16_t first, last;
    uint32_t from; ///< the base that a triangle was put to; NO_BASE: none, it begins with the triangle
} base;

typedef enum part_kind { UNSEEN, EDGE, CUT, LINKED, BEHIND } part_kind;

typedef struct part {
    uint32_t begin; ///< its bases, by rising first and rising last corners
    uint16_t count;
    uint16_t cuts; ///< inside of it
    uint16_t link; ///< LINKED: one of the corners on the segment
    uint8_t kind;
} part;

struct bmr_optimal {
    const bmr_allocator *allocator;
    base *bases;
    uint32_t used, capacity;
    const bmr_loop *loop;
    bmr_cut *cuts;
    uint32_t cut_count;
    part parts[BMR_LOOP_MOST][BMR_LOOP_MOST];
};

bmr_error bmr_optimal_create(const bmr_allocator *allocator, bmr_optimal **optimal) {
    bmr_optimal *made = bmr_allocate(allocator, sizeof *made);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    made->allocator = allocator;
    made->capacity = FIRST_CAPACITY;
    made->bases = bmr_allocate(allocator, made->capacity * sizeof *made->bases);
    if (!made->bases) {
        bmr_release(allocator, made, sizeof *made);
        return BMR_ERROR_NO_MEMORY;
    }
    *optimal = made;
    return BMR_OK;
}

void bmr_optimal_destroy(bmr_optimal *optimal) {
    if (!optimal)
        return;
    bmr_release(optimal->allocator, optimal->bases, optimal->capacity * sizeof *optimal->bases);
    bmr_release(optimal->allocator, optimal, sizeof *optimal);
}

/// Memory for the bases of one more part.
static bmr_error reserve(bmr_optimal *o) {
    if (o->capacity - o->used >= BMR_LOOP_MOST)
        return BMR_OK;
    const uint32_t capacity = 2 * o->capacity;
    base *bases = bmr_allocate(o->allocator, capacity * sizeof *bases);
    if (!bases)
        return BMR_ERROR_NO_MEMORY;
    memcpy(bases, o->bases, o->used * sizeof *bases);
    bmr_release(o->allocator, o->bases, o->capacity * sizeof *o->bases);
    o->bases = bases;
    o->capacity = capacity;
    return BMR_OK;
}

/// At b, coming from a and going on to c: half a turn or less on the left?
static bool is_convex(const bmr_loop *l, uint32_t a, uint32_t b, uint32_t c) {
    return bmr_orientation(l->corners[a], l->corners[b], l->corners[c]) >= 0;
}

/// One more base of the part that is being made. They come with rising first or with rising last corners, and
/// so does what is kept of them.
static void add_base(bmr_optimal *o, part *p, uint32_t cuts, base added) {
    if (cuts > p->cuts)
        return;
    if (cuts < p->cuts) {
        p->cuts = (uint16_t)cuts;
        p->count = 0;
    }
    base *bases = o->bases + p->begin;
    if (p->count > 0 && bases[p->count - 1].first >= added.first)
        return;
    while (p->count > 0 && bases[p->count - 1].last >= added.last)
        --p->count;
    bases[p->count++] = added;
}

/// Cuts in and beside a part whose segment is one of them, or an edge.
static uint32_t cuts_beside(const part *p) {
    return p->cuts + (p->kind == CUT ? 1u : 0u);
}

/// Is it an edge, or can it be a cut?
static bool is_side(const part *p) {
    return p->kind == EDGE || p->kind == CUT;
}

/// Is x between a and b, on the segment?
static bool is_between(bmr_vec2 a, bmr_vec2 x, bmr_vec2 b) {
    if (bmr_orientation(a, x, b) != 0)
        return false;
    return a.x != b.x ? (a.x < x.x && x.x < b.x) || (b.x < x.x && x.x < a.x)
                      : (a.y < x.y && x.y < b.y) || (b.y < x.y && x.y < a.y);
}

/// The triangle i, j, k around its notch, i or else k: the side away from the notch is an edge or a cut, and
/// so is the one at the notch, or the base of its part goes on.
static void try_fan(bmr_optimal *o, uint32_t i, uint32_t j, uint32_t k) {
    const bmr_loop *l = o->loop;
    const bool around_first = l->is_notch[i];
    const part *side = around_first ? &o->parts[i][j] : &o->parts[j][k];
    const part *other = around_first ? &o->parts[j][k] : &o->parts[i][j];
    const uint32_t notch = around_first ? i : k, across = around_first ? k : i;
    if (side->kind == UNSEEN || !is_side(other) ||
        (side->kind == BEHIND && !is_between(l->corners[notch], l->corners[across], l->corners[j])))
        return;
    // Of the bases that stay convex at j, the narrowest at the notch.
    base added = {(uint16_t)j, (uint16_t)j, NO_BASE};
    for (uint32_t n = 0; n < side->count; ++n) {
        const uint32_t b = side->begin + (around_first ? n : side->count - 1 - n);
        const base *narrower = &o->bases[b];
        if (!(around_first ? is_convex(l, narrower->last, j, k) : is_convex(l, i, j, narrower->first)))
            break;
        added.from = b;
    }
    if (added.from != NO_BASE) {
        const base *goes_on = &o->bases[added.from];
        if (!(around_first ? is_convex(l, k, i, goes_on->first) : is_convex(l, goes_on->last, k, i)))
            added.from = NO_BASE;
        else if (around_first)
            added.first = goes_on->first;
        else
            added.last = goes_on->last;
    }
    if (added.from == NO_BASE && (side->kind == LINKED || side->kind == BEHIND))
        return;
    add_base(o, &o->parts[i][k],
             cuts_beside(other) + (added.from != NO_BASE ? side->cuts : cuts_beside(side)), added);
}

/// Corners on one ray from a notch, the farthest first.
typedef struct ray {
    const struct ray *nearer;
    uint32_t corner;
} ray;

/// LINKED, BEHIND, or UNSEEN where corners from both sides are on the segment.
static part_kind kind_of(const ray *between, uint32_t first, uint32_t last) {
    uint32_t inside = 0, count = 0;
    for (const ray *r = between; r; r = r->nearer) {
        inside += first < r->corner && r->corner < last;
        ++count;
    }
    return inside == count ? LINKED : inside == 0 ? BEHIND : UNSEEN;
}

/// Corners that a notch has behind those of a ray. Each is reached once: no deeper than the loop has corners.
static void find_behind(bmr_optimal *o, uint32_t eye, const ray *before, bool reached[BMR_LOOP_MOST]) {
    const bmr_loop *l = o->loop;
    const uint32_t x = before->corner;
    for (uint32_t y = 0; y < l->count; ++y) {
        if (y == eye || y == x || reached[y] || !is_side(&o->parts[x < y ? x : y][x < y ? y : x]) ||
            !is_between(l->corners[eye], l->corners[x], l->corners[y]))
            continue;
        reached[y] = true;
        const uint32_t first = eye < y ? eye : y, last = eye < y ? y : eye;
        part *p = &o->parts[first][last];
        if (p->kind == UNSEEN) {
            p->kind = (uint8_t)kind_of(before, first, last);
            p->link = (uint16_t)x;
        }
        const ray here = {before, y};
        find_behind(o, eye, &here, reached);
    }
}

/// What each segment is.
static void set_kinds(bmr_optimal *o) {
    const bmr_loop *l = o->loop;
    const uint32_t n = l->count;
    const part edge = {0, 0, 0, 0, EDGE};
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t k = i + 1; k < n; ++k) {
            const bool cut = l->sees[i][k] || (i == 0 && k == n - 1);
            o->parts[i][k] = k == i + 1 ? edge : (part){0, 0, NO_CUTS, 0, (uint8_t)(cut ? CUT : UNSEEN)};
        }
    for (uint32_t i = 0; i < n; ++i) {
        if (!l->has_line[i])
            continue;
        bool reached[BMR_LOOP_MOST] = {false};
        for (uint32_t x = 0; x < n; ++x) {
            const ray nearest = {NULL, x};
            if (x != i && is_side(&o->parts[x < i ? x : i][x < i ? i : x]))
                find_behind(o, i, &nearest, reached);
        }
    }
}

/// A segment through further corners: the parts of its links.
static void join_links(bmr_optimal *o, part *p, uint32_t i, uint32_t k) {
    const part *before = &o->parts[i][p->link], *behind = &o->parts[p->link][k];
    const uint32_t cuts = cuts_beside(before) + cuts_beside(behind);
    const base added = {before->kind == LINKED ? o->bases[before->begin].first : p->link,
                        behind->kind == LINKED ? o->bases[behind->begin].last : p->link, NO_BASE};
    add_base(o, p, cuts, added);
}

static void make_part(bmr_optimal *o, uint32_t i, uint32_t k) {
    part *p = &o->parts[i][k];
    p->begin = o->used;
    if (p->kind == LINKED)
        join_links(o, p, i, k);
    else if (p->kind != UNSEEN)
        for (uint32_t j = i + 1; j < k; ++j)
            try_fan(o, i, j, k);
    o->used += p->count;
}

static void write_part(bmr_optimal *o, uint32_t i, uint32_t k, uint32_t chosen);

/// What is beside a side of a piece: a cut, or links, and what lies behind it.
static void write_side(bmr_optimal *o, uint32_t i, uint32_t k) {
    const part *p = &o->parts[i][k];
    if (p->kind == EDGE)
        return;
    if (p->kind == CUT)
        o->cuts[o->cut_count++] = (bmr_cut){(uint16_t)i, (uint16_t)k};
    write_part(o, i, k, p->begin);
}

/// The cuts inside of a part with this base. Each call is for another part: at most as deep as the loop has
/// corners.
static void write_part(bmr_optimal *o, uint32_t i, uint32_t k, uint32_t chosen) {
    const part *p = &o->parts[i][k];
    const base b = o->bases[chosen];
    if (p->kind == LINKED) {
        write_side(o, i, p->link);
        write_side(o, p->link, k);
        return;
    }
    const bool around_first = o->loop->is_notch[i];
    const uint32_t j = around_first ? b.last : b.first;
    if (b.from != NO_BASE)
        write_part(o, around_first ? i : j, around_first ? j : k, b.from);
    else
        write_side(o, around_first ? i : j, around_first ? j : k);
    write_side(o, around_first ? j : i, around_first ? k : j);
}

bmr_error bmr_optimal_cuts(bmr_optimal *optimal, const bmr_loop *loop, bmr_cut *cuts, uint32_t *count) {
    *count = 0;
    optimal->loop = loop;
    optimal->used = 0;
    const uint32_t n = loop->count;
    set_kinds(optimal);
    for (uint32_t gap = 2; gap < n; ++gap)
        for (uint32_t i = 0; i + gap < n; ++i) {
            const bmr_error error = reserve(optimal);
            if (error != BMR_OK)
                return error;
            make_part(optimal, i, i + gap);
        }
    const part *whole = &optimal->parts[0][n - 1];
    if (whole->count == 0) { // never: but no loop, whatever it is, may make us read what was not written
        *count = n;
        return BMR_OK;
    }
    optimal->cuts = cuts;
    optimal->cut_count = 0;
    write_part(optimal, 0, n - 1, whole->begin);
    *count = optimal->cut_count;
    return BMR_OK;
}
