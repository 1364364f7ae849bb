// SPDX-License-Identifier: MIT
// The mixed hierarchy's cells: their sides, corners and orders, and what lies across a side.
#include "hierarchy/mixed.h"

#include <math.h>

#include "hierarchy/tree.h"

/// A body's vector in A's frame, -B's for B.
static bmr_vec2 into_a(const bmr_mixed *mixed, int body, bmr_vec2 v) {
    if (body == 0)
        return v;
    return bmr_vec2_make(mixed->s * v.y - mixed->c * v.x, -(mixed->s * v.x + mixed->c * v.y));
}

static void count_steps(const bmr_mixed *mixed, unsigned steps) {
    if (mixed->steps)
        *mixed->steps += steps;
}

bmr_mixed bmr_mixed_make(const bmr_hierarchy *a, const bmr_hierarchy *b, double c, double s, double offset) {
    const bmr_mixed mixed = {{a, b}, c, s, offset, NULL};
    return mixed;
}

bmr_mixed_cell bmr_mixed_cell_make(bmr_mixed_kind kind, int owner, bmr_edge edge, bmr_edge first,
                                   bmr_edge second) {
    const bmr_mixed_cell cell = {edge, {first, second}, (uint8_t)kind, (uint8_t)owner, {0, 0}};
    return cell;
}

bool bmr_mixed_same(const bmr_mixed_cell *a, const bmr_mixed_cell *b) {
    return a->kind == b->kind && a->owner == b->owner && a->edge == b->edge && a->other[0] == b->other[0] &&
           a->other[1] == b->other[1];
}

static int32_t stage_of(const bmr_mixed *mixed, int body, bmr_edge edge) {
    const int32_t level = (int32_t)bmr_hierarchy_level(mixed->hierarchies[body], edge);
    return level == 0 ? -1 : 2 * (level - 1) + body;
}

int32_t bmr_mixed_stage(const bmr_mixed *mixed, const bmr_mixed_cell *cell) {
    if (cell->kind == BMR_MIXED_OUTSIDE)
        return -1;
    return cell->kind == BMR_MIXED_INSIDE ? INT32_MAX : stage_of(mixed, cell->owner, cell->edge);
}

// --- lines, corners, orders ---

/// The line of an edge in the frame of its own body, with the offset.
static bmr_line edge_line(const bmr_mixed *mixed, int body, bmr_edge edge) {
    bmr_line line = bmr_hierarchy_line(mixed->hierarchies[body], edge);
    line.offset += mixed->offset;
    return line;
}

/// The meeting point of two edges whose normals are known.
static bmr_vec2 meet(const bmr_mixed *mixed, int body, bmr_edge before, bmr_edge after, bmr_vec2 m,
                     bmr_vec2 n) {
    const bmr_hierarchy *h = mixed->hierarchies[body];
    const bmr_vec2 p = bmr_tree_meet(h, &h->nodes[before], &h->nodes[after]);
    if (!(mixed->offset > 0.0))
        return p;
    // Both lines move by the offset, the corner by k (m + n) with k (1 + <m, n>) = offset; the two are at
    // most a right angle apart.
    return bmr_add(p, bmr_scale(mixed->offset / (1.0 + bmr_dot(m, n)), bmr_add(m, n)));
}

static bmr_vec2 edge_corner(const bmr_mixed *mixed, int body, bmr_edge before, bmr_edge after) {
    const bmr_hierarchy *h = mixed->hierarchies[body];
    return meet(mixed, body, before, after, bmr_hierarchy_line(h, before).normal,
                bmr_hierarchy_line(h, after).normal);
}

/// The point of a corner of one body plus that of a corner of the other: the same bits for every caller.
static bmr_vec2 sum(const bmr_mixed *mixed, int body, bmr_edge before, bmr_edge after, bmr_edge other_before,
                    bmr_edge other_after) {
    const bmr_vec2 p = edge_corner(mixed, body, before, after);
    const bmr_vec2 q = edge_corner(mixed, 1 - body, other_before, other_after);
    // The sum of two doubles does not depend on their order: the bits are the same whichever body comes
    // first.
    return bmr_add(into_a(mixed, body, p), into_a(mixed, 1 - body, q));
}

bool bmr_mixed_precedes(const bmr_mixed *mixed, int body, bmr_edge f, bmr_edge g) {
    const bmr_hierarchy *h = mixed->hierarchies[body], *k = mixed->hierarchies[1 - body];
    const bmr_vec2 m = into_a(mixed, body, bmr_tree_normal(h, &h->nodes[f]));
    const bmr_vec2 n = into_a(mixed, 1 - body, bmr_tree_normal(k, &k->nodes[g]));
    const double turn = bmr_cross(m, n);
    return turn > 0.0 || (turn == 0.0 && body == 1);
}

bmr_corner bmr_mixed_around(const bmr_mixed *mixed, int body, bmr_edge edge, uint32_t level) {
    const bmr_hierarchy *h = mixed->hierarchies[body];
    bmr_edge root = 0;
    while (root + 1 < BMR_ROOTS && !(bmr_mixed_precedes(mixed, body, root, edge) &&
                                     bmr_mixed_precedes(mixed, 1 - body, edge, root + 1)))
        ++root;
    bmr_corner corner = bmr_hierarchy_corner(h, root, (root + 1) % BMR_ROOTS);
    count_steps(mixed, 1);
    while (corner.cut != BMR_NO_EDGE && h->nodes[corner.cut].level <= level) {
        const bmr_node *node = &h->nodes[corner.cut];
        count_steps(mixed, 1);
        if (bmr_mixed_precedes(mixed, body, corner.cut, edge)) {
            corner.before = corner.cut;
            corner.cut = bmr_tree_link(node->child_after);
        } else {
            corner.after = corner.cut;
            corner.cut = bmr_tree_link(node->child_before);
        }
    }
    return corner;
}

/// The edges that e was inserted between.
typedef struct outer {
    bmr_edge l, r;
} outer;

static outer outer_of(const bmr_mixed *mixed, const bmr_mixed_cell *cell) {
    const bmr_node *node = &mixed->hierarchies[cell->owner]->nodes[cell->edge];
    const outer o = {(bmr_edge)node->outer_before, (bmr_edge)node->outer_after};
    return o;
}

/// Section 5, collapse events: the point has left a cell before it collapses.
/// Lemma 4.2: a full turn of Q turns O(mn log m) pages.
void bmr_mixed_orders(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_order orders[2]) {
    const uint8_t x = cell->owner, y = (uint8_t)(1 - x);
    if (cell->kind == BMR_MIXED_TRIANGLE || cell->kind == BMR_MIXED_OUTSIDE) {
        orders[0] = (bmr_mixed_order){cell->other[0], cell->edge, y, 1};
        orders[1] = (bmr_mixed_order){cell->edge, cell->other[1], x, 1};
        return;
    }
    const outer o = outer_of(mixed, cell);
    const bool before = cell->kind == BMR_MIXED_BEFORE;
    orders[0] = (bmr_mixed_order){before ? o.l : cell->edge, cell->other[0], x, !before};
    orders[1] = (bmr_mixed_order){cell->other[0], before ? cell->edge : o.r, y, before};
}

bool bmr_mixed_exists(const bmr_mixed *mixed, const bmr_mixed_cell *cell) {
    bmr_mixed_order orders[2];
    if (cell->kind == BMR_MIXED_INSIDE)
        return false;
    bmr_mixed_orders(mixed, cell, orders);
    return bmr_mixed_precedes(mixed, orders[0].owner, orders[0].first, orders[0].second) &&
           bmr_mixed_precedes(mixed, orders[1].owner, orders[1].first, orders[1].second);
}

// --- sides ---

/// The other body's neighbours of a parallelogram's edge y, when e was inserted.
static void chain_corners(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_edge *before,
                          bmr_edge *after) {
    const int y = 1 - cell->owner;
    const uint32_t level = bmr_mixed_level(y, bmr_mixed_stage(mixed, cell));
    unsigned steps = 0;
    *before = bmr_tree_corner_before(mixed->hierarchies[y], cell->other[0], level, &steps).before;
    *after = bmr_tree_corner_after(mixed->hierarchies[y], cell->other[0], level, &steps).after;
    count_steps(mixed, steps);
}

/// Names for the places in a figure: lines and corners of the owner, and those of the other body.
enum { LINE_L, LINE_E, LINE_R };
enum { LINE_BEFORE, LINE_Y, LINE_AFTER };
enum { CORNER_A, CORNER_C, CORNER_B };
enum { CORNER_LOW, CORNER_HIGH, CORNER_V };

/// Counter-clockwise, from corner i of the polygon to corner i + 1.
static const bmr_mixed_part parts[][BMR_MIXED_MAX_SIDES] = {
    [BMR_MIXED_TRIANGLE] = {{BMR_MIXED_LOW, 0, LINE_L, CORNER_V, -1},
                            {BMR_MIXED_HIGH, 0, LINE_R, CORNER_V, -1},
                            {BMR_MIXED_INNER, 0, LINE_E, CORNER_V, 1}},
    [BMR_MIXED_BEFORE] = {{BMR_MIXED_LOW, 0, LINE_L, CORNER_LOW, -1},
                          {BMR_MIXED_OUTER, 1, LINE_Y, CORNER_C, -1},
                          {BMR_MIXED_HIGH, 0, LINE_L, CORNER_HIGH, 1},
                          {BMR_MIXED_INNER, 1, LINE_Y, CORNER_A, 1}},
    [BMR_MIXED_AFTER] = {{BMR_MIXED_OUTER, 1, LINE_Y, CORNER_C, -1},
                         {BMR_MIXED_HIGH, 0, LINE_R, CORNER_HIGH, -1},
                         {BMR_MIXED_INNER, 1, LINE_Y, CORNER_B, 1},
                         {BMR_MIXED_LOW, 0, LINE_R, CORNER_LOW, 1}},
    [BMR_MIXED_OUTSIDE] = {{BMR_MIXED_INNER, 0, LINE_E, CORNER_V, 1}}};
static const size_t part_counts[] = {
    [BMR_MIXED_TRIANGLE] = 3, [BMR_MIXED_BEFORE] = 4, [BMR_MIXED_AFTER] = 4, [BMR_MIXED_OUTSIDE] = 1};
/// The corners of the polygon: one of the owner's and one of the other's.
static const uint8_t vertices[][BMR_MIXED_MAX_SIDES][2] = {
    [BMR_MIXED_TRIANGLE] = {{CORNER_A, CORNER_V}, {CORNER_C, CORNER_V}, {CORNER_B, CORNER_V}},
    [BMR_MIXED_BEFORE] = {{CORNER_A, CORNER_LOW},
                          {CORNER_C, CORNER_LOW},
                          {CORNER_C, CORNER_HIGH},
                          {CORNER_A, CORNER_HIGH}},
    [BMR_MIXED_AFTER] = {
        {CORNER_C, CORNER_LOW}, {CORNER_C, CORNER_HIGH}, {CORNER_B, CORNER_HIGH}, {CORNER_B, CORNER_LOW}}};

/// The edges of a cell, in a figure's places; those that it has no use for are BMR_NO_EDGE.
static void name_edges(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_edge edges[2][3]) {
    const bool has_outer = cell->kind != BMR_MIXED_OUTSIDE;
    const outer o = has_outer ? outer_of(mixed, cell) : (outer){BMR_NO_EDGE, BMR_NO_EDGE};
    edges[0][LINE_L] = o.l;
    edges[0][LINE_E] = cell->edge;
    edges[0][LINE_R] = o.r;
    if (cell->other[1] == BMR_NO_EDGE) {
        edges[1][LINE_Y] = cell->other[0];
        chain_corners(mixed, cell, &edges[1][LINE_BEFORE], &edges[1][LINE_AFTER]);
    } else {
        edges[1][LINE_BEFORE] = cell->other[0];
        edges[1][LINE_Y] = BMR_NO_EDGE;
        edges[1][LINE_AFTER] = cell->other[1];
    }
}

static bmr_vec2 figure_corner(const bmr_mixed *mixed, const bmr_mixed_figure *f, int of, int i, int j) {
    return meet(mixed, of ? 1 - f->owner : f->owner, f->edges[of][i], f->edges[of][j], f->lines[of][i].normal,
                f->lines[of][j].normal);
}

void bmr_mixed_draw(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_figure *f) {
    count_steps(mixed, 1);
    f->parts = parts[cell->kind];
    f->sides = part_counts[cell->kind];
    f->owner = cell->owner;
    name_edges(mixed, cell, f->edges);
    for (int of = 0; of < 2; ++of)
        for (int i = 0; i < 3; ++i)
            if (f->edges[of][i] != BMR_NO_EDGE)
                f->lines[of][i] = edge_line(mixed, of ? 1 - f->owner : f->owner, f->edges[of][i]);
    if (cell->kind != BMR_MIXED_OUTSIDE) {
        f->corners[0][CORNER_C] = figure_corner(mixed, f, 0, LINE_L, LINE_R);
        if (cell->kind != BMR_MIXED_AFTER)
            f->corners[0][CORNER_A] = figure_corner(mixed, f, 0, LINE_L, LINE_E);
        if (cell->kind != BMR_MIXED_BEFORE)
            f->corners[0][CORNER_B] = figure_corner(mixed, f, 0, LINE_E, LINE_R);
    }
    if (cell->kind == BMR_MIXED_BEFORE || cell->kind == BMR_MIXED_AFTER) {
        f->corners[1][CORNER_LOW] = figure_corner(mixed, f, 1, LINE_BEFORE, LINE_Y);
        f->corners[1][CORNER_HIGH] = figure_corner(mixed, f, 1, LINE_Y, LINE_AFTER);
    } else
        f->corners[1][CORNER_V] = figure_corner(mixed, f, 1, LINE_BEFORE, LINE_AFTER);
}

double bmr_mixed_figure_value(const bmr_mixed *mixed, const bmr_mixed_figure *f, size_t i, bmr_vec2 x) {
    const bmr_mixed_part *part = &f->parts[i];
    const int body = part->of ? 1 - f->owner : f->owner;
    const bmr_line *line = &f->lines[part->of][part->line];
    const bmr_vec2 v = into_a(mixed, 1 - body, f->corners[1 - part->of][part->corner]);
    const double beyond = bmr_dot(into_a(mixed, body, line->normal), bmr_sub(x, v)) - line->offset;
    return (double)part->beyond * beyond;
}

void bmr_mixed_figure_polygon(const bmr_mixed *mixed, const bmr_mixed_cell *cell, const bmr_mixed_figure *f,
                              bmr_vec2 corners[BMR_MIXED_MAX_SIDES]) {
    for (size_t i = 0; i < f->sides; ++i) {
        const uint8_t *pair = vertices[cell->kind][i];
        corners[i] = bmr_add(into_a(mixed, f->owner, f->corners[0][pair[0]]),
                             into_a(mixed, 1 - f->owner, f->corners[1][pair[1]]));
    }
}

bool bmr_mixed_holds(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_vec2 x) {
    if (!bmr_mixed_exists(mixed, cell))
        return false;
    bmr_mixed_figure figure;
    bmr_mixed_draw(mixed, cell, &figure);
    size_t i = 0;
    while (i < figure.sides && bmr_mixed_figure_value(mixed, &figure, i, x) >= 0.0)
        ++i;
    return i == figure.sides;
}

size_t bmr_mixed_polygon(const bmr_mixed *mixed, const bmr_mixed_cell *cell,
                         bmr_vec2 corners[BMR_MIXED_MAX_SIDES]) {
    if (cell->kind == BMR_MIXED_INSIDE || cell->kind == BMR_MIXED_OUTSIDE)
        return 0;
    bmr_mixed_figure figure;
    bmr_mixed_draw(mixed, cell, &figure);
    bmr_mixed_figure_polygon(mixed, cell, &figure, corners);
    return figure.sides;
}

bmr_mixed_cell bmr_mixed_triangle(const bmr_mixed *mixed, int owner, bmr_edge edge) {
    const uint32_t level = bmr_mixed_level(1 - owner, stage_of(mixed, owner, edge));
    const bmr_corner v = bmr_mixed_around(mixed, 1 - owner, edge, level);
    return bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, owner, edge, v.before, v.after);
}

// --- across a side ---

/// The cell on the outer side of edge g of `body`, at the other body's corner between `before` and `after`.
/// Of these three edges the one that was inserted last made the cell: g a triangle, either of the others a
/// parallelogram.
static bmr_mixed_cell go_up(const bmr_mixed *mixed, int body, bmr_edge g, bmr_edge before, bmr_edge after) {
    const int other = 1 - body;
    const int32_t of_g = stage_of(mixed, body, g), of_before = stage_of(mixed, other, before),
                  of_after = stage_of(mixed, other, after);
    if (of_g < 0 && of_before < 0 && of_after < 0)
        return bmr_mixed_cell_make(BMR_MIXED_OUTSIDE, body, g, before, after);
    if (of_g > of_before && of_g > of_after)
        return bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, body, g, before, after);
    if (of_before > of_after)
        return bmr_mixed_cell_make(BMR_MIXED_AFTER, other, before, g, BMR_NO_EDGE);
    return bmr_mixed_cell_make(BMR_MIXED_BEFORE, other, after, g, BMR_NO_EDGE);
}

/// A step inwards across edge g, while the edges of one stage are inserted.
typedef struct descent {
    const bmr_mixed *mixed;
    const bmr_mixed_ray *ray;
    int body; ///< of g
    bmr_edge g;
    bmr_corner before, after, w; ///< the ends of g, and the other body's corner
} descent;

/// If an edge of g's own body is inserted at one of g's ends on this level, does it cut off the place where
/// the ray crosses g? True: *cell is the cell that it made there. False: g's ends are those that are left.
static bool cuts_own(descent *d, uint32_t level, bmr_mixed_cell *cell) {
    const bmr_mixed *m = d->mixed;
    const bmr_node *nodes = m->hierarchies[d->body]->nodes;
    const int other = 1 - d->body;
    const bmr_edge e = d->after.cut;
    if (e != BMR_NO_EDGE && nodes[e].level == level) {
        if (bmr_mixed_left(d->ray, sum(m, d->body, d->g, e, d->w.before, d->w.after))) {
            *cell = bmr_mixed_precedes(m, other, d->w.after, e)
                        ? bmr_mixed_cell_make(BMR_MIXED_BEFORE, d->body, e, d->w.after, BMR_NO_EDGE)
                        : bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, d->body, e, d->w.before, d->w.after);
            return true;
        }
        d->after = (bmr_corner){d->g, e, bmr_tree_link(nodes[e].child_before)};
    }
    const bmr_edge f = d->before.cut;
    if (f != BMR_NO_EDGE && nodes[f].level == level) {
        if (!bmr_mixed_left(d->ray, sum(m, d->body, f, d->g, d->w.before, d->w.after))) {
            *cell = bmr_mixed_precedes(m, other, d->w.before, f)
                        ? bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, d->body, f, d->w.before, d->w.after)
                        : bmr_mixed_cell_make(BMR_MIXED_AFTER, d->body, f, d->w.before, BMR_NO_EDGE);
            return true;
        }
        d->before = (bmr_corner){f, d->g, bmr_tree_link(nodes[f].child_after)};
    }
    return false;
}

/// If an edge of the other body cuts the corner w on this level, g is pushed inwards and leaves a
/// parallelogram, which becomes *cell.
static bool cuts_other(const descent *d, uint32_t level, bmr_mixed_cell *cell) {
    const bmr_edge e = d->w.cut;
    const int other = 1 - d->body;
    if (e == BMR_NO_EDGE || bmr_hierarchy_level(d->mixed->hierarchies[other], e) != level)
        return false;
    const bool before = bmr_mixed_precedes(d->mixed, d->body, d->g, e);
    *cell = bmr_mixed_cell_make(before ? BMR_MIXED_BEFORE : BMR_MIXED_AFTER, other, e, d->g, BMR_NO_EDGE);
    return true;
}

/// The cell inside of an edge g of body `body` with the other's corner w, both of M_s, where the ray crosses
/// it inwards.
static bmr_mixed_cell down(const bmr_mixed *mixed, int body, bmr_edge g, const bmr_edge w[2], int32_t stage,
                           const bmr_mixed_ray *ray, unsigned *touched) {
    const bmr_hierarchy *h = mixed->hierarchies[body];
    const uint32_t level = bmr_mixed_level(body, stage);
    unsigned steps = 0;
    descent d = {mixed,
                 ray,
                 body,
                 g,
                 bmr_tree_corner_before(h, g, level, &steps),
                 bmr_tree_corner_after(h, g, level, &steps),
                 bmr_hierarchy_corner(mixed->hierarchies[1 - body], w[0], w[1])};
    count_steps(mixed, steps);
    bmr_mixed_cell cell = bmr_mixed_cell_make(BMR_MIXED_INSIDE, 0, BMR_NO_EDGE, BMR_NO_EDGE, BMR_NO_EDGE);
    for (; d.before.cut != BMR_NO_EDGE || d.after.cut != BMR_NO_EDGE || d.w.cut != BMR_NO_EDGE; ++stage) {
        if (touched)
            ++*touched;
        const uint32_t inserted = (uint32_t)stage / 2u + 1u;
        if ((stage & 1) == body ? cuts_own(&d, inserted, &cell) : cuts_other(&d, inserted, &cell))
            break;
    }
    return cell;
}

/// Lemma 4.3: the neighbour of a cell at a point of its border is found in O(log n).
bmr_mixed_cell bmr_mixed_next(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_role role,
                              const bmr_mixed_ray *ray, unsigned *touched) {
    const int x = cell->owner, other = 1 - x;
    const bmr_edge e = cell->edge, y = cell->other[0];
    if (cell->kind == BMR_MIXED_OUTSIDE || cell->kind == BMR_MIXED_INSIDE)
        return *cell;
    if (touched)
        ++*touched;
    const outer o = outer_of(mixed, cell);
    const int32_t below = bmr_mixed_stage(mixed, cell) + 1;
    if (cell->kind == BMR_MIXED_TRIANGLE) {
        if (role == BMR_MIXED_INNER)
            return down(mixed, x, e, cell->other, below, ray, touched);
        const bool low = role == BMR_MIXED_LOW;
        const bmr_edge side = low ? o.l : o.r, next = low ? y : cell->other[1];
        const bool has_chain =
            low ? bmr_mixed_precedes(mixed, x, side, next) : bmr_mixed_precedes(mixed, other, next, side);
        return has_chain
                   ? bmr_mixed_cell_make(low ? BMR_MIXED_BEFORE : BMR_MIXED_AFTER, x, e, next, BMR_NO_EDGE)
                   : go_up(mixed, x, side, y, cell->other[1]);
    }
    const bool before = cell->kind == BMR_MIXED_BEFORE;
    if (role == BMR_MIXED_INNER) {
        const bmr_edge w[2] = {before ? o.l : e, before ? e : o.r};
        return down(mixed, other, y, w, below, ray, touched);
    }
    if (role == BMR_MIXED_OUTER)
        return go_up(mixed, other, y, o.l, o.r);
    bmr_edge low, high;
    chain_corners(mixed, cell, &low, &high);
    const bmr_edge next = role == BMR_MIXED_LOW ? low : high;
    if ((role == BMR_MIXED_LOW) != before) { // towards e: along the chain, then the triangle
        const bool more =
            before ? bmr_mixed_precedes(mixed, other, next, e) : bmr_mixed_precedes(mixed, x, e, next);
        if (!more)
            return before ? bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, x, e, y, next)
                          : bmr_mixed_cell_make(BMR_MIXED_TRIANGLE, x, e, next, y);
    } else { // away from e: along the chain, then out
        const bool more =
            before ? bmr_mixed_precedes(mixed, x, o.l, next) : bmr_mixed_precedes(mixed, other, next, o.r);
        if (!more)
            return before ? go_up(mixed, x, o.l, next, y) : go_up(mixed, x, o.r, y, next);
    }
    return bmr_mixed_cell_make((bmr_mixed_kind)cell->kind, x, e, next, BMR_NO_EDGE);
}

// ---- straight walks, and where they start ----

/// More steps than a straight walk can take: each cell is convex and met once. A cell has an edge of its own
/// and one of the other body's.
static uint32_t most_steps(const bmr_mixed *mixed) {
    return 64u + 8u * (bmr_hierarchy_edge_count(mixed->hierarchies[0]) +
                       bmr_hierarchy_edge_count(mixed->hierarchies[1]));
}

/// One of the eight edges of M_0, with its ends.
typedef struct top_edge {
    bmr_edge edge, corner[2];
    int owner;
    bmr_vec2 start, end;
} top_edge;
#define TOPS 8u
/// Fills in the edges of A, then those of B.
static void fill_tops(const bmr_mixed *mixed, top_edge tops[TOPS]) {
    for (uint32_t i = 0; i < TOPS; ++i) {
        top_edge *top = &tops[i];
        top->owner = i < BMR_ROOTS ? 0 : 1;
        top->edge = i % BMR_ROOTS;
        const bmr_corner w = bmr_mixed_around(mixed, 1 - top->owner, top->edge, 0);
        top->corner[0] = w.before;
        top->corner[1] = w.after;
        const bmr_edge before = (top->edge + BMR_ROOTS - 1) % BMR_ROOTS, after = (top->edge + 1) % BMR_ROOTS;
        top->start = sum(mixed, top->owner, before, top->edge, w.before, w.after);
        top->end = sum(mixed, top->owner, top->edge, after, w.before, w.after);
    }
}

bmr_mixed_cell bmr_mixed_outside(const bmr_mixed *mixed, bmr_vec2 x, double *slack) {
    bmr_mixed_cell best = {0};
    *slack = -INFINITY;
    for (uint32_t i = 0; i < TOPS; ++i) {
        const int owner = i < BMR_ROOTS ? 0 : 1;
        const bmr_corner w = bmr_mixed_around(mixed, 1 - owner, i % BMR_ROOTS, 0);
        const bmr_mixed_cell cell =
            bmr_mixed_cell_make(BMR_MIXED_OUTSIDE, owner, i % BMR_ROOTS, w.before, w.after);
        bmr_mixed_figure figure;
        bmr_mixed_draw(mixed, &cell, &figure);
        const double value = bmr_mixed_figure_value(mixed, &figure, 0, x);
        if (value > *slack) {
            *slack = value;
            best = cell;
        }
    }
    return best;
}

bmr_mixed_cell bmr_mixed_enter(const bmr_mixed *mixed, const bmr_mixed_ray *ray, unsigned *touched) {
    top_edge tops[TOPS];
    fill_tops(mixed, tops);
    for (uint32_t i = 0; i < TOPS; ++i)
        if (bmr_mixed_left(ray, tops[i].start) && !bmr_mixed_left(ray, tops[i].end))
            return down(mixed, tops[i].owner, tops[i].edge, tops[i].corner, 0, ray, touched);
    return bmr_mixed_cell_make(BMR_MIXED_OUTSIDE, 0, 0, BMR_NO_EDGE, BMR_NO_EDGE);
}

size_t bmr_mixed_exit(const bmr_mixed *mixed, const bmr_mixed_cell *cell, const bmr_mixed_figure *figure,
                      const bmr_mixed_ray *ray) {
    bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
    const size_t count = figure->sides;
    bmr_mixed_figure_polygon(mixed, cell, figure, corners);
    size_t exit = 0;
    while (exit < count && !(!bmr_mixed_left(ray, corners[exit]) &&
                             bmr_mixed_left(ray, corners[exit + 1 < count ? exit + 1 : 0])))
        ++exit;
    return exit;
}

/// The rest of a walk whose ray is known: from a cell that the ray meets.
static bool follow(const bmr_mixed *mixed, bmr_mixed_cell *cell, const bmr_mixed_ray *ray, bmr_vec2 to,
                   unsigned *touched) {
    for (uint32_t step = most_steps(mixed); step > 0; --step) {
        if (cell->kind == BMR_MIXED_OUTSIDE || cell->kind == BMR_MIXED_INSIDE)
            return true;
        bmr_mixed_figure figure;
        bmr_mixed_draw(mixed, cell, &figure);
        const size_t exit = bmr_mixed_exit(mixed, cell, &figure, ray);
        if (exit == figure.sides)
            return false;
        if (bmr_mixed_figure_value(mixed, &figure, exit, to) >= 0.0)
            return true;
        *cell = bmr_mixed_next(mixed, cell, (bmr_mixed_role)figure.parts[exit].role, ray, touched);
    }
    return false;
}

/// Lemma 4.4(b): a convex curve meets O(log(D/s)) and O(sqrt(D/s)) mixed triangles.
bool bmr_mixed_walk(const bmr_mixed *mixed, bmr_mixed_cell *cell, bmr_vec2 from, bmr_vec2 to,
                    unsigned *touched) {
    const bmr_mixed_ray ray = {from, bmr_sub(to, from)};
    if (ray.direction.x == 0.0 && ray.direction.y == 0.0)
        return true;
    return follow(mixed, cell, &ray, to, touched);
}

bool bmr_mixed_locate(const bmr_mixed *mixed, bmr_vec2 x, bmr_vec2 direction, bmr_mixed_cell *cell,
                      unsigned *touched) {
    double slack;
    *cell = bmr_mixed_outside(mixed, x, &slack);
    if (slack > 0.0)
        return true;
    const bmr_mixed_ray ray = {x, bmr_neg(direction)};
    *cell = bmr_mixed_enter(mixed, &ray, touched);
    return cell->kind != BMR_MIXED_OUTSIDE && follow(mixed, cell, &ray, x, touched);
}
