// SPDX-License-Identifier: MIT
#include "geometry/distance.h"

#include <math.h>

#include "geometry/length.h"

/// Steps of a climb before it gives way to the binary search, which costs about as much as this many.
#define CLIMB_STEPS 12

/// Iterations before the search over two chains is asked where to go on. From the last closest points most
/// queries take one to four.
#define ITERATIONS_BEFORE_SEARCH 8

/// From the last closest points random and hard motions take 12 at most, vertices that crowd 24 and more.
/// Each iteration adds a vertex pair that no iteration before had, so that the loop ends without a cap too:
/// this one is for what rounding might think of.
#define MAX_ITERATIONS 100

/// A climb's answer must lie this far (relative to the extent) above the centre: at the bottom, both edges
/// can be level up to rounding.
#define CLIMB_ROUNDING 1e-15

static inline bool ascends(const bmr_polygon *p, uint32_t from, uint32_t to, bmr_vec2 direction) {
    return bmr_ascends(bmr_sub(p->vertices[to], p->vertices[from]), direction);
}

uint32_t bmr_support_near(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint, unsigned *steps) {
    const uint32_t n = polygon->count;
    if (n <= 2)
        return bmr_support_counted(polygon, direction, steps);
    uint32_t i = hint, climbed = 0;
    for (; climbed < CLIMB_STEPS; ++climbed) {
        const uint32_t next = i + 1 < n ? i + 1 : 0;
        if (!ascends(polygon, i, next, direction))
            break;
        i = next;
    }
    if (climbed == 0)
        for (; climbed < CLIMB_STEPS; ++climbed) {
            const uint32_t next = i > 0 ? i - 1 : n - 1;
            if (!ascends(polygon, i, next, direction))
                break;
            i = next;
        }
    const double rise = bmr_dot(direction, bmr_sub(polygon->vertices[i], polygon->center));
    const bool believed = rise > CLIMB_ROUNDING * polygon->extent * (fabs(direction.x) + fabs(direction.y));
    *steps += 1 + climbed;
    return climbed < CLIMB_STEPS && believed ? i : bmr_support_counted(polygon, direction, steps);
}

bmr_simplex bmr_simplex_make(uint32_t a, uint32_t b) {
    const bmr_simplex simplex = {1, {a, a, a}, {b, b, b}, 0};
    return simplex;
}

// ---- the search over two chains ----
//
// Edelsbrunner's search for the closest points of two convex polygons. For a direction y let p(y) be A's
// vertex that is farthest in y, q(y) B's that is farthest against it, F(y) = <y, q(y) - p(y)> the separation
// along y and G(y) = <y turned left, q(y) - p(y)>. The closest direction u is where F is largest. Two facts
// do the work:
//
// - F(y) <= <y, w> for the vector w from any vertex of A to any of B: F is a least and a greatest of such
//   products. So F is positive only ahead of w.
// - Within a right angle of u, G(y) > 0 says that u lies counter-clockwise of y, and G(y) < 0 clockwise. For
//   if F(y) > 0, F is concave there and G its slope. And else w = q(y) - p(y) has <y, w> <= 0, so that what
//   is ahead of w begins within a right angle of y on the side that G tells, and on the other side only
//   beyond one.
//
// So one or two directions leave an arc of at most a right angle that holds u, and one chain of each
// polygon's edges whose normals are in it. The middle edges of both chains then decide about half of one of
// them, though the search has neither q at A's middle normal nor p at B's: see `halve`.

/// An arc of less than this (radians) has no edge's normal in it that rounding could tell from its ends.
#define LEAST_ARC 1e-14

/// One polygon in the search. Everything is in A's frame, and B's edges are turned round: so both polygons'
/// edge vectors are the directions in question, turned left.
typedef struct chain {
    const bmr_polygon *polygon;
    const bmr_pose *pose; ///< NULL for A
    uint32_t first;       ///< the vertex at the start of the chain
    uint32_t edges;       ///< of the chain: from `first` on, counter-clockwise
} chain;

/// An end of the arc that has become an edge's normal.
typedef struct arc_end {
    int owner; ///< -1: it is no edge's
    bmr_vec2 edge;
} arc_end;

typedef struct search {
    chain chains[2]; ///< of A and of B
    arc_end low, high;
    unsigned steps;
} search;

static uint32_t nth(const chain *c, uint32_t steps) {
    const uint32_t n = c->polygon->count;
    return c->first + steps < n ? c->first + steps : c->first + steps - n;
}

static bmr_vec2 vertex(const chain *c, uint32_t steps) {
    const bmr_vec2 v = c->polygon->vertices[nth(c, steps)];
    return c->pose ? bmr_transform(c->pose, v) : v;
}

static bmr_vec2 edge(const chain *c, uint32_t steps) {
    const bmr_vec2 *v = c->polygon->vertices;
    const bmr_vec2 e = bmr_scale_up_if_tiny(bmr_sub(v[nth(c, steps + 1)], v[nth(c, steps)]));
    return c->pose ? bmr_neg(bmr_rotate(c->pose, e)) : e;
}

/// u is not clockwise of the edge's normal.
static void drop_up_to(search *s, int owner, uint32_t steps, bmr_vec2 e) {
    chain *c = &s->chains[owner];
    c->first = nth(c, steps + 1);
    c->edges -= steps + 1;
    s->low = (arc_end){owner, e};
}

/// u is not counter-clockwise of the edge's normal.
static void drop_from(search *s, int owner, uint32_t steps, bmr_vec2 e) {
    s->chains[owner].edges = steps;
    s->high = (arc_end){owner, e};
}

/// The vector from A's vertex to B's, of which `of` is that of the chain `owner`.
static bmr_vec2 between(int owner, bmr_vec2 of, bmr_vec2 other) {
    return owner == 0 ? bmr_sub(other, of) : bmr_sub(of, other);
}

/// Halves one of the two chains. False: the polygons overlap.
///
/// Let the middle normals be a, of the chain `first`, and b, counter-clockwise of it. Of the chain of a take
/// the vertex after its edge, of that of b the one before: these are on the inner sides, the vertices of
/// directions between a and b. w is the vector between them, and what lies between each of them and its
/// chain's true vertex at the other normal are edges whose directions are within a right angle of both:
///   G(b) <= <b turned left, w> and G(a) >= <a turned left, w>.
/// If the first is not positive, u is not beyond b; if the second is not negative, u is not before a. If
/// neither, w points against some direction between a and b, and nothing in the arc is ahead of it: F is
/// positive nowhere.
static bool halve(search *s) {
    const chain *c = s->chains;
    uint32_t middle[2] = {c[0].edges / 2, c[1].edges / 2};
    s->steps += 2;
    if (c[0].edges == 0 || c[1].edges == 0) {
        const int owner = c[0].edges > 0 ? 0 : 1;
        const bmr_vec2 e = edge(&c[owner], middle[owner]);
        const bmr_vec2 w = between(owner, vertex(&c[owner], middle[owner]), vertex(&c[1 - owner], 0));
        if (bmr_dot(e, w) > 0.0)
            drop_up_to(s, owner, middle[owner], e);
        else
            drop_from(s, owner, middle[owner], e);
        return true;
    }
    const bmr_vec2 e[2] = {edge(&c[0], middle[0]), edge(&c[1], middle[1])};
    const int first = bmr_cross(e[0], e[1]) >= 0.0 ? 0 : 1, second = 1 - first;
    const bmr_vec2 w =
        between(first, vertex(&c[first], middle[first] + 1), vertex(&c[second], middle[second]));
    if (bmr_dot(e[second], w) <= 0.0)
        drop_from(s, second, middle[second], e[second]);
    else if (bmr_dot(e[first], w) >= 0.0)
        drop_up_to(s, first, middle[first], e[first]);
    else
        return false;
    return true;
}

/// The support vertices in a direction (from A to B), near those known, and the vector between them.
static bmr_vec2 move_supports(search *s, bmr_vec2 direction, uint32_t at[2]) {
    const chain *c = s->chains;
    at[0] = bmr_support_near(c[0].polygon, direction, at[0], &s->steps);
    at[1] = bmr_support_near(c[1].polygon, bmr_unrotate(c[1].pose, bmr_neg(direction)), at[1], &s->steps);
    const bmr_vec2 p = c[0].polygon->vertices[at[0]], q = c[1].polygon->vertices[at[1]];
    return bmr_sub(bmr_transform(c[1].pose, q), p);
}

/// The same from nowhere near.
static void set_supports(search *s, bmr_vec2 direction, uint32_t at[2]) {
    const chain *c = s->chains;
    at[0] = bmr_support_counted(c[0].polygon, direction, &s->steps);
    at[1] = bmr_support_counted(c[1].polygon, bmr_unrotate(c[1].pose, bmr_neg(direction)), &s->steps);
}

/// Puts the chains on the arc up to the direction `end`, counter-clockwise, from the support vertices at its
/// beginning to those in `end`.
static void set_arc(search *s, const uint32_t low[2], const uint32_t high[2], bmr_vec2 end) {
    for (int i = 0; i < 2; ++i) {
        chain *c = &s->chains[i];
        const uint32_t n = c->polygon->count;
        c->first = low[i];
        c->edges = high[i] >= low[i] ? high[i] - low[i] : high[i] + n - low[i];
        // Of two vertices that lie together as far as doubles tell, either search may have found the other
        // one. Then the chain would go once around the polygon, and its first edge away from `end`.
        if (c->edges > 0 && bmr_dot(end, edge(c, 0)) < 0.0)
            c->edges = 0;
    }
}

/// Puts the chains on an arc that holds u, of at most a right angle, from y at one end. `w` is between the
/// support vertices in y, ahead of y: so u is within a right angle of y, on the side of w. And F(y) = <y, w>
/// <= F(u) <= <u, w>, so u is no farther from w than y is: the arc ends at y mirrored in w.
static void arc_from(search *s, bmr_vec2 y, bmr_vec2 w, const uint32_t at[2]) {
    const int sense = bmr_cross(y, w) >= 0.0 ? 1 : -1;
    const double ahead = bmr_dot(y, w), square = bmr_dot(w, w);
    bmr_vec2 end = bmr_sub(bmr_scale(2.0 * ahead / square, w), y);
    if (!(bmr_dot(end, y) > 0.0))
        end = bmr_scale(sense, bmr_left(y));
    uint32_t other[2] = {at[0], at[1]};
    if (sense * bmr_cross(y, end) > LEAST_ARC)
        set_supports(s, end, other);
    set_arc(s, sense > 0 ? at : other, sense > 0 ? other : at, sense > 0 ? end : y);
}

/// The arc that holds u, if the polygons are apart.
static bool find_arc(search *s, bmr_vec2 y, uint32_t at[2]) {
    // Where y does not separate, u is ahead of w. Where w does not separate either, u is ahead of the next w
    // too: what is ahead of both is no more than a right angle, and its middle is within half of one of u.
    bmr_vec2 w = move_supports(s, y, at);
    if (bmr_dot(y, w) > 0.0) {
        arc_from(s, y, w, at);
        return true;
    }
    double length = sqrt(bmr_dot(w, w));
    if (!(length > 0.0))
        return false;
    const bmr_vec2 ahead = bmr_scale(1.0 / length, w);
    w = move_supports(s, ahead, at);
    if (bmr_dot(ahead, w) > 0.0) {
        arc_from(s, ahead, w, at);
        return true;
    }
    // From the right angle beside `ahead`, on the side of w, back to the one beside w.
    const int sense = bmr_cross(ahead, w) >= 0.0 ? 1 : -1;
    length = sqrt(bmr_dot(w, w));
    if (!(sense * bmr_cross(ahead, w) > LEAST_ARC * length))
        return false;
    const bmr_vec2 far = bmr_scale(sense, bmr_left(ahead)), near = bmr_scale(-sense / length, bmr_left(w));
    uint32_t low[2] = {at[0], at[1]}, high[2] = {at[0], at[1]};
    set_supports(s, sense > 0 ? near : far, low);
    set_supports(s, sense > 0 ? far : near, high);
    set_arc(s, low, high, sense > 0 ? far : near);
    return true;
}

/// With one vertex of each left: is the closest point on the edge at an end of the arc? Adds its other end.
static void add_edge(search *s, bmr_simplex *simplex) {
    const chain *c = s->chains;
    const bmr_vec2 w = bmr_sub(vertex(&c[1], 0), vertex(&c[0], 0));
    const bool low = s->low.owner >= 0 && bmr_dot(s->low.edge, w) < 0.0,
               high = !low && s->high.owner >= 0 && bmr_dot(s->high.edge, w) > 0.0;
    if (!low && !high)
        return;
    const int owner = low ? s->low.owner : s->high.owner;
    const chain *o = &c[owner];
    const uint32_t n = o->polygon->count;
    const uint32_t end = low ? (o->first > 0 ? o->first - 1 : n - 1) : (o->first + 1 < n ? o->first + 1 : 0);
    simplex->count = 2;
    if (owner == 0)
        simplex->a[1] = end;
    else
        simplex->b[1] = end;
}

bool bmr_closest_start(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a,
                       const bmr_simplex *near, bmr_simplex *start) {
    uint32_t at[2] = {near->a[0] % a->count, near->b[0] % b->count};
    search s = {.chains = {{a, NULL, at[0], 0}, {b, b_in_a, at[1], 0}},
                .low = {-1, {0.0, 0.0}},
                .high = {-1, {0.0, 0.0}},
                .steps = near->steps};
    const bmr_vec2 y = bmr_sub(vertex(&s.chains[1], 0), vertex(&s.chains[0], 0));
    const double length = sqrt(bmr_dot(y, y));
    bool apart = length > 0.0 && find_arc(&s, bmr_scale(1.0 / length, y), at);
    while (apart && s.chains[0].edges + s.chains[1].edges > 0)
        apart = halve(&s);
    *start = bmr_simplex_make(s.chains[0].first, s.chains[1].first);
    if (apart)
        add_edge(&s, start);
    start->steps = s.steps;
    return apart;
}

// ---- Gilbert, Johnson and Keerthi's descent ----

/// The search at work: the simplex with its points, and the point of it that is nearest to the origin.
typedef struct descent {
    bmr_simplex simplex;
    bmr_vec2 point[3];
    bmr_vec2 nearest;
    double square; ///< of the distance of `nearest`
} descent;

static void keep(descent *s, uint32_t i, uint32_t j) {
    const descent old = *s;
    s->simplex.a[0] = old.simplex.a[i], s->simplex.b[0] = old.simplex.b[i], s->point[0] = old.point[i];
    s->simplex.a[1] = old.simplex.a[j], s->simplex.b[1] = old.simplex.b[j], s->point[1] = old.point[j];
    s->simplex.count = i == j ? 1 : 2;
}

/// The point of the segment p q nearest to the origin: 0 = p itself, 1 = q itself, 2 = between them.
static int nearest_on_segment(bmr_vec2 p, bmr_vec2 q, bmr_vec2 *nearest) {
    const bmr_vec2 e = bmr_sub(q, p);
    const double along = -bmr_dot(p, e), length = bmr_dot(e, e);
    if (!(along > 0.0)) {
        *nearest = p;
        return 0;
    }
    if (along >= length) {
        *nearest = q;
        return 1;
    }
    // Across the segment rather than along it, and from both points as they are, for their difference has the
    // rounding of the farther one: no cancellation however near the origin is to the nearer one.
    *nearest = bmr_scale(bmr_cross(p, q) / length, bmr_vec2_make(e.y, -e.x));
    return 2;
}

/// Shrinks the simplex to the least face that holds its point nearest to the origin. False: the origin is
/// inside, and the simplex stays a triangle.
static bool reduce(descent *s) {
    const uint32_t n = s->simplex.count;
    if (n == 3) {
        const double c01 = bmr_cross(s->point[0], s->point[1]), c12 = bmr_cross(s->point[1], s->point[2]),
                     c20 = bmr_cross(s->point[2], s->point[0]);
        if ((c01 > 0.0 && c12 > 0.0 && c20 > 0.0) || (c01 < 0.0 && c12 < 0.0 && c20 < 0.0))
            return false;
    }
    uint32_t first = 0, second = 0;
    s->nearest = s->point[0];
    s->square = bmr_dot(s->nearest, s->nearest);
    for (uint32_t j = 1; j < n; ++j)
        for (uint32_t i = 0; i < j; ++i) {
            bmr_vec2 nearest;
            const int where = nearest_on_segment(s->point[i], s->point[j], &nearest);
            const double square = bmr_dot(nearest, nearest);
            if (square < s->square || (i + j == 1 && square <= s->square)) {
                s->nearest = nearest;
                s->square = square;
                first = where == 1 ? j : i;
                second = where == 0 ? i : j;
            }
        }
    keep(s, first, second);
    return true;
}

static bool holds(const bmr_simplex *simplex, uint32_t a, uint32_t b) {
    for (uint32_t i = 0; i < simplex->count; ++i)
        if (simplex->a[i] == a && simplex->b[i] == b)
            return true;
    return false;
}

static void add(descent *s, const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, uint32_t i,
                uint32_t j) {
    const uint32_t k = s->simplex.count++;
    s->simplex.a[k] = i;
    s->simplex.b[k] = j;
    s->point[k] = bmr_sub(bmr_transform(b_in_a, b->vertices[j]), a->vertices[i]);
}

/// From the origin towards the simplex, unit length; across it where it is a segment, which is exact to the
/// rounding of its points even where the distance is nearly nothing.
static bmr_vec2 direction_of(const descent *s) {
    bmr_vec2 u = s->nearest;
    if (s->simplex.count == 2) {
        const bmr_vec2 e = bmr_sub(s->point[1], s->point[0]);
        u = bmr_vec2_make(e.y, -e.x);
        if (bmr_cross(s->point[0], s->point[1]) < 0.0)
            u = bmr_neg(u);
    }
    return bmr_scale(1.0 / sqrt(bmr_dot(u, u)), u);
}

/// Replaces the simplex by the one that the search over two chains finds, where that is nearer.
static void go_on_from_search(descent *s, const bmr_polygon *a, const bmr_polygon *b,
                              const bmr_pose *b_in_a) {
    bmr_simplex start;
    const bool apart = bmr_closest_start(a, b, b_in_a, &s->simplex, &start);
    s->simplex.steps = start.steps;
    if (!apart)
        return;
    descent found = {.simplex = {.count = 0, .steps = start.steps}};
    for (uint32_t i = 0; i < start.count; ++i)
        add(&found, a, b, b_in_a, start.a[i], start.b[i]);
    if (reduce(&found) && found.square < s->square)
        *s = found;
}

bool bmr_closest_direction(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, double reach,
                           double slack, bmr_simplex *simplex, bmr_closest *closest) {
    // No simplex at all is as good a start as any vertices.
    const bmr_simplex start = simplex->count - 1u < 3u ? *simplex : bmr_simplex_make(0, 0);
    descent s = {.simplex = {.count = 0, .steps = start.steps}};
    for (uint32_t i = 0; i < start.count; ++i)
        add(&s, a, b, b_in_a, start.a[i], start.b[i]);
    bool outside = reduce(&s);
    bmr_closest best = {{1.0, 0.0}, -1.0, 0, 0};
    for (int iteration = 0; outside && iteration < MAX_ITERATIONS; ++iteration) {
        if (iteration == ITERATIONS_BEFORE_SEARCH)
            go_on_from_search(&s, a, b, b_in_a);
        if (s.square <= reach * reach)
            break; // two points of the polygons are that near
        const bmr_vec2 u = direction_of(&s);
        const uint32_t i = bmr_support_near(a, u, s.simplex.a[0], &s.simplex.steps);
        const uint32_t j =
            bmr_support_near(b, bmr_unrotate(b_in_a, bmr_neg(u)), s.simplex.b[0], &s.simplex.steps);
        const bmr_vec2 w = bmr_sub(bmr_transform(b_in_a, b->vertices[j]), a->vertices[i]);
        const double separation = bmr_dot(u, w);
        if (separation > best.separation) {
            best.direction = u;
            best.separation = separation;
            best.a = i;
            best.b = j;
        }
        // If the goal is not less than the distance, the separation is good enough.
        const double goal = (separation + slack * (separation - reach)) * (1.0 + BMR_DISTANCE_TOLERANCE);
        if (separation > reach && goal * goal >= s.square)
            break;
        if (holds(&s.simplex, i, j))
            break;
        const double square = s.square;
        add(&s, a, b, b_in_a, i, j);
        outside = reduce(&s);
        if (outside && !(s.square < square))
            break; // rounding: no nearer, and never will be
    }
    *simplex = s.simplex;
    if (!outside || !(best.separation > reach))
        return false;
    *closest = best;
    return true;
}
