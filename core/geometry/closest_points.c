// SPDX-License-Identifier: MIT
// The closest points of two convex polygons in O(log n + log m), without a hierarchy.
//
// For a unit direction u let s(u) = min over B of <u, .> - max over A of <u, .>. Polygons that are apart have
// one u* at which s is largest, s(u*) is their distance, and u* leads from the closest point of A to that of
// B. Let a(u) be A's vertex farthest in u, b(u) B's vertex farthest in -u, and w(u) = b(u) - a(u). Then
// s(u) = <u, w(u)>, and s(v) <= <v, w(u)> for every v, since w(u) is but one pair of points.
//
// First, u* is caught in an arc of at most 45 degrees. The last fact bounds it: s(u*) > 0, so u* is within 90
// degrees of every w(u). And s grows from u towards the side of u on which w(u) lies.
//
// Second, the edges whose normals lie in the arc are left out, half by half. As u turns counter-clockwise
// through the arc, a(u) goes along the chain a_0 .. a_r and b(u) along b_0 .. b_t. Let E be the middle edge
// of A's chain, from a_(i-1) to a_i, with normal alpha, and F the middle edge of B's chain, from b_(j-1) to
// b_j, with -beta as its normal. Say alpha comes before beta, and let w = b_(j-1) - a_i.
//   - At alpha, b(u) is b_(j-1) or an earlier vertex, which lies farther along E. So <E, w> > 0 tells that s
//     still grows at alpha: u* is beyond it, and the first half of A's chain is left out.
//   - At beta, a(u) is a_i or a later vertex. So <F, w> > 0 tells that s falls at beta: the last half of B's
//     chain is left out.
//   - If neither is so, w is against a direction between alpha and beta. All of the arc is within 90 degrees
//     of that one, so <u, w> < 0, and s(u) with it, in all of it: the polygons overlap. (With alpha = beta w
//     may also be along them; then the two edges face each other, and hold closest points.)
// With beta first, the roles are exchanged. When one chain is a single vertex, the other is searched for the
// point nearest to it.
//
// Third, the closest points are looked for in the edges around the two vertices found. If neither polygon
// goes beyond them there, it goes nowhere beyond them: polygons are convex. Where rounding decided between
// two edges that are all but parallel, the nearest point is at the far end of an edge, and the search goes on
// from there for a few steps.
//
// Fourth, where that comes to no end: of vertices that lie together, and of polygons no thicker than
// rounding, neighbours tell nothing. The arc is halved again, as in the first part, until its ends are the
// same double. So what doubles cannot tell makes an answer slower by a constant, and never wrong.
#include <math.h>

#include "boomerang/distance.h"
#include "geometry/posed_polygons.h"

/// The sine of an angle by which rounding may turn the end of an edge beyond the line that it is behind.
#define ROUNDING 4e-15

/// Steps of the third part, before the fourth takes over: without vertices that lie together it takes one or
/// two.
#define SETTLING_STEPS 8

/// From 45 degrees to less than the rounding of a unit vector.
#define HALVINGS 53

/// Part of a chain of vertices: `first`, and the `edges` that follow it.
typedef struct chain {
    const bmr_polygon *polygon;
    const bmr_pose *pose; ///< NULL: the vertices as they are
    uint32_t first, edges;
} chain;

static bmr_vec2 vertex(const chain *c, uint32_t k) {
    const bmr_vec2 v = c->polygon->vertices[(c->first + k) % c->polygon->count];
    return c->pose ? bmr_transform(c->pose, v) : v;
}

/// The edge that ends in vertex k: the difference is taken in the polygon's own frame, where it is exact to
/// half an ulp however short the edge.
static bmr_vec2 edge_to(const chain *c, uint32_t k) {
    const bmr_vec2 *v = c->polygon->vertices;
    const uint32_t n = c->polygon->count;
    const bmr_vec2 e = bmr_sub(v[(c->first + k) % n], v[(c->first + k - 1) % n]);
    return c->pose ? bmr_rotate(c->pose, e) : e;
}

/// Keeps the vertices from `k` on.
static void keep_from(chain *c, uint32_t k) {
    c->first = (c->first + k) % c->polygon->count;
    c->edges -= k;
}

static bmr_vec2 unit(bmr_vec2 v) {
    const double length = hypot(v.x, v.y);
    return length > 0.0 ? bmr_scale(1.0 / length, v) : bmr_vec2_make(1.0, 0.0);
}

// ---- first: an arc ----

typedef struct arc {
    bmr_vec2 low, high; ///< unit vectors, `high` counter-clockwise of `low`
} arc;

static uint32_t support_a(const bmr_posed_polygons *q, bmr_vec2 u) {
    return bmr_polygon_support(q->a, u);
}

static uint32_t support_b(const bmr_posed_polygons *q, bmr_vec2 u) {
    return bmr_polygon_support(q->b, bmr_unrotate(&q->b_in_a, bmr_neg(u)));
}

/// w(u).
static bmr_vec2 difference(const bmr_posed_polygons *q, bmr_vec2 u) {
    return bmr_sub(bmr_transform(&q->b_in_a, q->b->vertices[support_b(q, u)]),
                   q->a->vertices[support_a(q, u)]);
}

/// An arc of at most 45 degrees that holds u*, if there is one. Four supports of each polygon.
static arc narrow(const bmr_posed_polygons *q) {
    const bmr_vec2 start = unit(bmr_sub(bmr_transform(&q->b_in_a, q->b->center), q->a->center));
    const bmr_vec2 w = difference(q, start), right = unit(bmr_vec2_make(w.y, -w.x));
    arc found = {right, bmr_neg(right)}; // within 90 degrees of w
    if (bmr_dot(start, w) > 0.0) {
        if (bmr_dot(bmr_left(start), w) > 0.0)
            found.low = start;
        else
            found.high = start;
    }
    for (int halving = 0; halving < 2; ++halving) {
        // The sum of the ends is as long as rounding where they are opposite.
        const bmr_vec2 sum = bmr_add(found.low, found.high);
        const bmr_vec2 middle =
            bmr_dot(sum, sum) > 1e-6 ? unit(sum) : unit(bmr_left(bmr_sub(found.low, found.high)));
        // Where s is positive it grows towards w. Where it is not, u* is more than 90 degrees from
        // everything on the other side of the middle than w.
        if (bmr_dot(bmr_left(middle), difference(q, middle)) > 0.0)
            found.low = middle;
        else
            found.high = middle;
    }
    return found;
}

// ---- second: half by half ----

/// The vertex of a chain nearest to a point, or the first one of the edge that holds the nearest point.
static void search_point(chain *c, bmr_vec2 point, unsigned *steps) {
    for (; c->edges > 0; ++*steps) {
        const uint32_t i = (c->edges + 1) / 2;
        const bmr_vec2 before = vertex(c, i - 1), after = vertex(c, i), edge = edge_to(c, i);
        if (bmr_dot(edge, bmr_sub(point, after)) > 0.0) {
            keep_from(c, i);
        } else {
            c->edges = i - 1;
            if (bmr_dot(edge, bmr_sub(point, before)) > 0.0) { // on this very edge
                keep_from(c, i - 1);
                return;
            }
        }
    }
}

/// False: the polygons overlap. True: if they are apart, both chains' first vertices are ends of what holds
/// the closest points.
static bool prune(chain *a, chain *b, unsigned *steps) {
    for (; a->edges > 0 && b->edges > 0; ++*steps) {
        const uint32_t i = (a->edges + 1) / 2, j = (b->edges + 1) / 2;
        const bmr_vec2 e = edge_to(a, i), f = edge_to(b, j);
        const bool a_first = bmr_cross(e, bmr_neg(f)) >= 0.0;
        const bmr_vec2 w =
            a_first ? bmr_sub(vertex(b, j - 1), vertex(a, i)) : bmr_sub(vertex(b, j), vertex(a, i - 1));
        const double along_e = bmr_dot(e, w), along_f = bmr_dot(f, w);
        if (a_first && along_e > 0.0) {
            keep_from(a, i);
        } else if (a_first && along_f > 0.0) {
            b->edges = j - 1;
        } else if (!a_first && along_e < 0.0) {
            a->edges = i - 1;
        } else if (!a_first && along_f < 0.0) {
            keep_from(b, j);
        } else if (bmr_cross(w, e) > 0.0) { // beyond E's line: two edges that face each other
            keep_from(a, i - 1);
            keep_from(b, j - 1);
            a->edges = b->edges = 0;
        } else {
            return false;
        }
    }
    search_point(a, vertex(b, 0), steps);
    search_point(b, vertex(a, 0), steps);
    return true;
}

// ---- third: the edges around ----

/// A vertex and its two neighbours, in A's frame; of a point all three are one, of a segment two.
typedef struct star {
    bmr_vec2 point[3]; ///< before, itself, after
    bmr_vec2 edge[2];  ///< to itself, and from itself to the one after
} star;

static star star_at(const chain *c, uint32_t i) {
    const uint32_t n = c->polygon->count;
    const chain around = {c->polygon, c->pose, i + n - 1, 2};
    const star s = {{vertex(&around, 0), vertex(&around, 1), vertex(&around, 2)},
                    {edge_to(&around, 1), edge_to(&around, 2)}};
    return s;
}

/// A vertex and one other, which need not be its neighbour.
static star star_between(const chain *c, uint32_t i, uint32_t k) {
    const chain first = {c->polygon, c->pose, i, 0}, second = {c->polygon, c->pose, k, 0};
    const bmr_vec2 p = vertex(&first, 0), r = vertex(&second, 0);
    const star s = {{p, p, r}, {{0.0, 0.0}, bmr_sub(r, p)}};
    return s;
}

/// The nearest two points of two stars so far.
typedef struct nearest {
    double square;
    bmr_vec2 a, b, way; ///< `way` leads from a to b: exact across an edge, however near the points are
    int at_a, at_b;     ///< which point of the star it is, 0 to 2; 3: within its edge
    int edge_a, edge_b; ///< the edge that it is within: 0 before, 1 after the vertex; -1: none
} nearest;

/// From `from` to an edge of a star: the way to the nearest point of it. *where: 0 is the edge's first end, 1
/// its second one, 2 between.
static bmr_vec2 way_to_edge(bmr_vec2 from, const star *s, int edge, int *where) {
    const bmr_vec2 e = s->edge[edge], to_p = bmr_sub(s->point[edge], from),
                   to_q = bmr_sub(s->point[edge + 1], from);
    const double length = bmr_dot(e, e);
    *where = !(bmr_dot(to_p, e) < 0.0) ? 0 : !(bmr_dot(to_q, e) > 0.0) ? 1 : 2;
    if (*where != 2)
        return *where == 0 ? to_p : to_q;
    // Across the segment, from the nearer end: no cancellation of what is along it.
    const bmr_vec2 near = bmr_dot(to_p, to_p) < bmr_dot(to_q, to_q) ? to_p : to_q;
    return bmr_scale(bmr_cross(near, e) / length, bmr_vec2_make(e.y, -e.x));
}

static void take_nearer(nearest *best, const nearest *other) {
    if (other->square < best->square)
        *best = *other;
}

/// Every vertex of one star against both edges of the other.
static nearest between(const star *a, const star *b) {
    nearest best = {INFINITY, {0, 0}, {0, 0}, {0, 0}, 1, 1, -1, -1};
    // Vertices first: where a vertex and an edge are equally near, the vertex is as good an answer, and the
    // search does not go on from the end of an edge for nothing.
    static const int order[3] = {1, 0, 2};
    for (int k = 0; k < 3; ++k)
        for (int edge = 0; edge < 2; ++edge) {
            const int i = order[k];
            int where;
            const bmr_vec2 to_b = way_to_edge(a->point[i], b, edge, &where);
            const nearest from_a = {
                bmr_dot(to_b, to_b),           a->point[i], bmr_add(a->point[i], to_b), to_b, i,
                where == 2 ? 3 : edge + where, -1,          where == 2 ? edge : -1};
            take_nearer(&best, &from_a);
            const bmr_vec2 to_a = way_to_edge(b->point[i], a, edge, &where);
            const nearest from_b = {bmr_dot(to_a, to_a),
                                    bmr_add(b->point[i], to_a),
                                    b->point[i],
                                    bmr_neg(to_a),
                                    where == 2 ? 3 : edge + where,
                                    i,
                                    where == 2 ? edge : -1,
                                    -1};
            take_nearer(&best, &from_b);
        }
    return best;
}

/// Is all of the polygon behind a line at right angles to `way` through a point of the star?
static bool is_behind(const star *s, int at, int edge, bmr_vec2 way, uint32_t count) {
    if (edge >= 0) // on an edge: the way must lead out. A segment has no inside
        return count == 2 || bmr_cross(way, s->edge[edge]) > 0.0;
    if (at != 1)
        return count == 1;
    const bmr_vec2 back = s->edge[0], on = s->edge[1];
    const double slack = ROUNDING * hypot(way.x, way.y);
    return bmr_dot(back, way) >= -slack * hypot(back.x, back.y) &&
           bmr_dot(on, way) <= slack * hypot(on.x, on.y);
}

/// The vertex that a point of the star at vertex i is.
static uint32_t neighbour(uint32_t i, int at, uint32_t n) {
    return at == 0 ? (i > 0 ? i - 1 : n - 1) : at == 2 ? (i + 1 < n ? i + 1 : 0) : i;
}

/// The closest points around two vertices, and around those that they lead to, each pair nearer than the one
/// before. False: they are not found, which is so where the polygons overlap.
static bool settle(const bmr_posed_polygons *q, const chain *a, const chain *b, unsigned *steps,
                   nearest *found) {
    uint32_t i = a->first, j = b->first;
    double square = INFINITY;
    for (int step = 0; step < SETTLING_STEPS; ++step, ++*steps) {
        const star sa = star_at(a, i), sb = star_at(b, j);
        *found = between(&sa, &sb);
        const uint32_t next_i = neighbour(i, found->at_a, q->a->count),
                       next_j = neighbour(j, found->at_b, q->b->count);
        if ((next_i == i && next_j == j) || !(found->square < square))
            return is_behind(&sa, found->at_a, found->edge_a, found->way, q->a->count) &&
                   is_behind(&sb, found->at_b, found->edge_b, bmr_neg(found->way), q->b->count);
        square = found->square;
        i = next_i;
        j = next_j;
    }
    return false;
}

// ---- fourth: by halves of the arc ----

/// The closest points in the vertices farthest at both ends of an arc that is halved until nothing is left of
/// it. False: no direction met on the way separates the polygons.
static bool halve(const bmr_posed_polygons *q, arc directions, const chain *a, const chain *b,
                  unsigned *steps, nearest *found) {
    bool apart = false;
    for (int halving = 0; halving < HALVINGS; ++halving, ++*steps) {
        const bmr_vec2 middle = unit(bmr_add(directions.low, directions.high)), w = difference(q, middle);
        apart = apart || bmr_dot(middle, w) > 0.0;
        if (bmr_dot(bmr_left(middle), w) > 0.0)
            directions.low = middle;
        else
            directions.high = middle;
    }
    const star sa = star_between(a, support_a(q, directions.low), support_a(q, directions.high)),
               sb = star_between(b, support_b(q, directions.low), support_b(q, directions.high));
    *found = between(&sa, &sb);
    return apart;
}

/// From the farthest vertex in the arc's low end to that in its high end. `high`: the latter direction.
static chain chain_between(const bmr_polygon *polygon, const bmr_pose *pose, uint32_t first, uint32_t last,
                           bmr_vec2 high) {
    chain c = {polygon, pose, first, (last + polygon->count - first) % polygon->count};
    // Of two vertices that lie together as far as doubles tell, the wrong one may have been found at either
    // end. Then the chain would go once around, and its first edge away from `high`.
    if (c.edges > 0 && bmr_dot(high, edge_to(&c, 1)) < 0.0)
        c.edges = 0;
    return c;
}

bool bmr_posed_polygons_closest(const bmr_posed_polygons *q, unsigned *steps, bmr_closest_points *closest) {
    const arc directions = narrow(q);
    chain a = chain_between(q->a, NULL, support_a(q, directions.low), support_a(q, directions.high),
                            directions.high),
          b = chain_between(q->b, &q->b_in_a, support_b(q, directions.low), support_b(q, directions.high),
                            bmr_neg(directions.high));
    nearest found;
    if (!prune(&a, &b, steps))
        return false;
    if (!settle(q, &a, &b, steps, &found) && !halve(q, directions, &a, &b, steps, &found))
        return false;
    if (!(found.square > 0.0))
        return false;
    closest->distance = sqrt(found.square);
    closest->point_a = bmr_transform(&q->pose_a, found.a);
    closest->point_b = bmr_transform(&q->pose_a, found.b);
    closest->normal = bmr_rotate(&q->pose_a, bmr_scale(1.0 / closest->distance, found.way));
    return true;
}

bmr_error bmr_distance(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                       const bmr_pose *pose_b, bmr_closest_points *closest) {
    if (!closest)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_posed_polygons q;
    const bmr_error error = bmr_posed_polygons_make(a, pose_a, b, pose_b, &q);
    if (error != BMR_OK)
        return error;
    bmr_closest_points found = {0.0, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    unsigned steps = 0;
    bmr_posed_polygons_closest(&q, &steps, &found);
    *closest = found;
    return BMR_OK;
}
