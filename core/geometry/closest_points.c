// SPDX-License-Identifier: MIT
// The closest points of two convex polygons in O(log n + log m), without a hierarchy, whatever rounding does.
//
// First, the search over two chains (distance.c) leads to the vertices, or to the edge and the vertex,
// that are closest, or finds that the polygons overlap.
//
// Second, the closest points are looked for in the edges around the two vertices found. If neither polygon
// goes beyond them there, it goes nowhere beyond them: polygons are convex. Where rounding decided between
// two edges that are all but parallel, the nearest point is at the far end of an edge, and the search goes on
// from there for a few steps.
//
// Third, where that comes to no end: of vertices that lie together, and of polygons no thicker than rounding,
// neighbours tell nothing. For a unit direction u let s(u) = min over B of <u, .> - max over A of <u, .>, and
// w(u) the vector from A's vertex farthest in u to B's farthest in -u. Polygons that are apart have one u* at
// which s is largest. s(v) <= <v, w(u)> for every v, since w(u) is but one pair of points; so u* is within 90
// degrees of every w(u), and s grows from u towards the side of u on which w(u) lies. An arc that holds u* is
// halved until its ends are the same double. So what doubles cannot tell makes an answer slower by a
// constant, and never wrong.
#include <math.h>

#include "boomerang/distance.h"
#include "geometry/distance.h"
#include "geometry/length.h"

/// The sine of an angle by which rounding may turn the end of an edge beyond the line that it is behind.
#define ROUNDING 4e-15

/// Steps of the second part, before the third takes over: without vertices that lie together it takes one or
/// two.
#define SETTLING_STEPS 8

/// From 45 degrees to less than the rounding of a unit vector.
#define HALVINGS 53

/// B as A sees it. All computing is done in A's frame; the answers go to the world at the end.
typedef struct posed_polygons {
    const bmr_polygon *a, *b;
    bmr_pose pose_a; ///< with (c, s) of unit length
    bmr_pose b_in_a;
} posed_polygons;

/// A polygon as A sees it.
typedef struct side {
    const bmr_polygon *polygon;
    const bmr_pose *pose; ///< NULL: the vertices as they are
} side;

static bmr_vec2 vertex(const side *s, uint32_t i) {
    const bmr_vec2 v = s->polygon->vertices[i];
    return s->pose ? bmr_transform(s->pose, v) : v;
}

/// From vertex i to vertex j: the difference is taken in the polygon's own frame, where it is exact to half
/// an ulp however short the edge.
static bmr_vec2 edge(const side *s, uint32_t i, uint32_t j) {
    const bmr_vec2 e = bmr_sub(s->polygon->vertices[j], s->polygon->vertices[i]);
    return s->pose ? bmr_rotate(s->pose, e) : e;
}

// ---- second: the edges around ----

/// A vertex and its two neighbours, in A's frame; of a point all three are one, of a segment two.
typedef struct star {
    bmr_vec2 point[3]; ///< before, itself, after
    bmr_vec2 edge[2];  ///< to itself, and from itself to the one after
} star;

static star star_at(const side *s, uint32_t i) {
    const uint32_t before = bmr_vertex_before(s->polygon, i), after = bmr_vertex_after(s->polygon, i);
    const star made = {{vertex(s, before), vertex(s, i), vertex(s, after)},
                       {edge(s, before, i), edge(s, i, after)}};
    return made;
}

/// A vertex and one other, which need not be its neighbour.
static star star_between(const side *s, uint32_t i, uint32_t k) {
    const bmr_vec2 p = vertex(s, i), r = vertex(s, k);
    const star made = {{p, p, r}, {{0.0, 0.0}, bmr_sub(r, p)}};
    return made;
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
    const double slack = ROUNDING * bmr_length(way);
    return bmr_dot(back, way) >= -slack * bmr_length(back) && bmr_dot(on, way) <= slack * bmr_length(on);
}

/// The vertex that a point of the star at vertex i is.
static uint32_t neighbour(const bmr_polygon *polygon, uint32_t i, int at) {
    return at == 0 ? bmr_vertex_before(polygon, i) : at == 2 ? bmr_vertex_after(polygon, i) : i;
}

/// The closest points around two vertices, and around those that they lead to, each pair nearer than the one
/// before. False: they are not found, which is so where the polygons overlap.
static bool settle(const posed_polygons *q, uint32_t i, uint32_t j, unsigned *steps, nearest *found) {
    const side a = {q->a, NULL}, b = {q->b, &q->b_in_a};
    double square = INFINITY;
    for (int step = 0; step < SETTLING_STEPS; ++step, ++*steps) {
        const star sa = star_at(&a, i), sb = star_at(&b, j);
        *found = between(&sa, &sb);
        const uint32_t next_i = neighbour(q->a, i, found->at_a), next_j = neighbour(q->b, j, found->at_b);
        if ((next_i == i && next_j == j) || !(found->square < square))
            return is_behind(&sa, found->at_a, found->edge_a, found->way, q->a->count) &&
                   is_behind(&sb, found->at_b, found->edge_b, bmr_neg(found->way), q->b->count);
        square = found->square;
        i = next_i;
        j = next_j;
    }
    return false;
}

// ---- third: by halves of an arc ----

static bmr_vec2 unit(bmr_vec2 v) {
    const double length = bmr_length(v);
    return length > 0.0 ? bmr_scale(1.0 / length, v) : bmr_vec2_make(1.0, 0.0);
}

typedef struct arc {
    bmr_vec2 low, high; ///< unit vectors, `high` counter-clockwise of `low`
} arc;

static uint32_t support_a(const posed_polygons *q, bmr_vec2 u, unsigned *steps) {
    return bmr_support_counted(q->a, u, steps);
}

static uint32_t support_b(const posed_polygons *q, bmr_vec2 u, unsigned *steps) {
    return bmr_support_counted(q->b, bmr_unrotate(&q->b_in_a, bmr_neg(u)), steps);
}

/// w(u).
static bmr_vec2 difference(const posed_polygons *q, bmr_vec2 u, unsigned *steps) {
    return bmr_sub(bmr_transform(&q->b_in_a, q->b->vertices[support_b(q, u, steps)]),
                   q->a->vertices[support_a(q, u, steps)]);
}

/// An arc of at most 45 degrees that holds u*, if there is one.
static arc narrow(const posed_polygons *q, unsigned *steps) {
    const bmr_vec2 start = unit(bmr_sub(bmr_transform(&q->b_in_a, q->b->center), q->a->center));
    const bmr_vec2 w = difference(q, start, steps), right = unit(bmr_vec2_make(w.y, -w.x));
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
        if (bmr_dot(bmr_left(middle), difference(q, middle, steps)) > 0.0)
            found.low = middle;
        else
            found.high = middle;
    }
    return found;
}

/// The closest points in the vertices farthest at both ends of an arc that is halved until nothing is left of
/// it. False: no direction met on the way separates the polygons.
static bool halve(const posed_polygons *q, unsigned *steps, nearest *found) {
    const side a = {q->a, NULL}, b = {q->b, &q->b_in_a};
    arc directions = narrow(q, steps);
    bool apart = false;
    for (int halving = 0; halving < HALVINGS; ++halving) {
        const bmr_vec2 middle = unit(bmr_add(directions.low, directions.high)),
                       w = difference(q, middle, steps);
        apart = apart || bmr_dot(middle, w) > 0.0;
        // Against both ends of the arc, w is against all of it: s is negative there, and u* in no other
        // place.
        if (!apart && bmr_dot(directions.low, w) < 0.0 && bmr_dot(directions.high, w) < 0.0)
            return false;
        if (bmr_dot(bmr_left(middle), w) > 0.0)
            directions.low = middle;
        else
            directions.high = middle;
    }
    // An edge at right angles to what is left of the arc, to rounding, may have one end found from both ends
    // of it: beyond that rounding its two ends are found.
    directions.low = bmr_sub(directions.low, bmr_scale(ROUNDING, bmr_left(directions.low)));
    directions.high = bmr_add(directions.high, bmr_scale(ROUNDING, bmr_left(directions.high)));
    const star sa = star_between(&a, support_a(q, directions.low, steps),
                                 support_a(q, directions.high, steps)),
               sb = star_between(&b, support_b(q, directions.low, steps),
                                 support_b(q, directions.high, steps));
    *found = between(&sa, &sb);
    return apart;
}

/// The closest points. False: the polygons overlap or touch, and *closest is untouched.
static bool find_closest(const posed_polygons *q, unsigned *steps, bmr_closest_points *closest) {
    const bmr_simplex anywhere = bmr_simplex_make(0, 0);
    bmr_simplex start;
    nearest found;
    const bool apart = bmr_closest_start(q->a, q->b, &q->b_in_a, &anywhere, &start);
    *steps += start.steps;
    if (!apart)
        return false;
    if (!settle(q, start.a[0], start.b[0], steps, &found) && !halve(q, steps, &found))
        return false;
    if (!(found.square > 0.0))
        return false;
    closest->distance = bmr_length(found.way); // whose square may be a denormal, with few digits
    closest->point_a = bmr_transform(&q->pose_a, found.a);
    closest->point_b = bmr_transform(&q->pose_a, found.b);
    closest->normal = bmr_rotate(&q->pose_a, bmr_scale(1.0 / closest->distance, found.way));
    return true;
}

// ---- the two queries ----

/// The pose with a rotation of unit length; NULL is the identity.
static bmr_error unit_pose(const bmr_pose *pose, bmr_pose *unit) {
    *unit = pose ? *pose : bmr_pose_identity();
    const double x = unit->position.x, y = unit->position.y, c = unit->c, s = unit->s;
    if (!isfinite(x) || !isfinite(y) || !isfinite(c) || !isfinite(s))
        return BMR_ERROR_NOT_FINITE;
    const double square = c * c + s * s;
    if (!(fabs(square - 1.0) <= BMR_DISTANCE_UNIT) || !(fmax(fabs(x), fabs(y)) <= BMR_MAX_COORDINATE))
        return BMR_ERROR_OUT_OF_RANGE;
    const double length = sqrt(square);
    unit->c /= length;
    unit->s /= length;
    return BMR_OK;
}

/// Checks the arguments of both queries, of the pointer to the answer only that there is one. An error leaves
/// *posed untouched.
static bmr_error pose_both(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                           const bmr_pose *pose_b, const void *answer, posed_polygons *posed) {
    if (!a || !b || !answer)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_pose unit_a, unit_b;
    bmr_error error = unit_pose(pose_a, &unit_a);
    if (error == BMR_OK)
        error = unit_pose(pose_b, &unit_b);
    if (error != BMR_OK)
        return error;
    const posed_polygons made = {a, b, unit_a, bmr_pose_relative(&unit_a, &unit_b)};
    *posed = made;
    return BMR_OK;
}

bmr_error bmr_distance_counted(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                               const bmr_pose *pose_b, bmr_closest_points *closest, unsigned *steps) {
    posed_polygons q;
    const bmr_error error = pose_both(a, pose_a, b, pose_b, closest, &q);
    if (error != BMR_OK)
        return error;
    bmr_closest_points found = {0.0, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    find_closest(&q, steps, &found);
    *closest = found;
    return BMR_OK;
}

bmr_error bmr_distance(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                       const bmr_pose *pose_b, bmr_closest_points *closest) {
    unsigned unused = 0;
    return bmr_distance_counted(a, pose_a, b, pose_b, closest, &unused);
}

// ---- penetration ----
//
// B - A is a convex polygon whose edges have the normals of A's edges and of B's, and the shortest way out of
// it is across one of its edges.
//
// All edges are looked at, and no search by halves can do without. Where polygons are apart, the separation
// along a direction has one largest value, and what is downhill is left out. Inside, it has a smallest value
// for each edge that is nearer than its neighbours, and a regular polygon with a point at its centre has n of
// them, all equal. The levels of a hierarchy do not tell them apart either: every chain of edges there has
// the same bound as every other.

bmr_edge_gap bmr_best_edge(const bmr_polygon *own, const bmr_polygon *other, const bmr_pose *other_in_own) {
    bmr_edge_gap best = {-INFINITY, {0.0, 0.0}, {0.0, 0.0}};
    uint32_t deepest = 0;
    for (uint32_t i = 0; own->count > 1 && i < own->count; ++i) {
        const bmr_vec2 normal = bmr_polygon_normal(own, i);
        deepest = bmr_polygon_support_from(other, bmr_unrotate(other_in_own, bmr_neg(normal)), deepest);
        const bmr_vec2 deep = bmr_transform(other_in_own, other->vertices[deepest]);
        const double separation = bmr_dot(normal, bmr_sub(deep, own->vertices[i]));
        if (separation > best.separation) {
            const bmr_edge_gap found = {separation, normal, deep};
            best = found;
        }
    }
    return best;
}

bmr_error bmr_penetration(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                          const bmr_pose *pose_b, bmr_overlap *overlap) {
    posed_polygons q;
    const bmr_error error = pose_both(a, pose_a, b, pose_b, overlap, &q);
    if (error != BMR_OK)
        return error;
    const bmr_overlap none = {0.0, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    *overlap = none;
    bmr_closest_points closest;
    unsigned steps = 0;
    if (find_closest(&q, &steps, &closest))
        return BMR_OK;
    const bmr_pose a_in_b = bmr_pose_inverse(&q.b_in_a);
    const bmr_edge_gap of_a = bmr_best_edge(a, b, &q.b_in_a), of_b = bmr_best_edge(b, a, &a_in_b);
    bmr_vec2 normal, point_a, point_b; // in A's frame
    if (of_a.separation >= of_b.separation) {
        overlap->depth = fmax(0.0, -of_a.separation);
        normal = of_a.normal;
        point_b = of_a.nearest;
        point_a = bmr_add(point_b, bmr_scale(overlap->depth, normal));
    } else {
        overlap->depth = fmax(0.0, -of_b.separation);
        normal = bmr_neg(bmr_rotate(&q.b_in_a, of_b.normal));
        point_a = bmr_transform(&q.b_in_a, of_b.nearest);
        point_b = bmr_sub(point_a, bmr_scale(overlap->depth, normal));
    }
    if (a->count == 1 && b->count == 1) { // no edge at all
        overlap->depth = 0.0;
        normal = bmr_vec2_make(0.0, 0.0);
        point_a = point_b = a->vertices[0];
    }
    overlap->normal = bmr_rotate(&q.pose_a, normal);
    overlap->point_a = bmr_transform(&q.pose_a, point_a);
    overlap->point_b = bmr_transform(&q.pose_a, point_b);
    return BMR_OK;
}
