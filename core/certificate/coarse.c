// SPDX-License-Identifier: MIT
// The coarse line. What is proved of it (in real arithmetic; the words are those of docs/open-question.md,
// section 1), for m <= sigma:
//
// It exists. Normals of C's edges, axes included, are at most 90 degrees apart, so one is within 45 degrees
// of u. If the foot is inside an edge, that edge's normal is u. Otherwise the slack along the normal is at
// least 0.707 (g + m) >= 1.41 m: more than m.
//
// It is found in O(log N). The directions that separate form an interval around u, whose ends are inner
// common tangents (bmr_cone_end). If no axis separates, the interval is inside one quadrant, and each median
// that does not separate leaves one half.
//
// Lemma B. Let K picks of the coarse line be made along a convex path, each at a time when the one before
// does not separate. Then K <= d_P + d_Q + 5. Proof. W(t) is the interval of directions that separate, by
// more than m or any larger threshold. It is open and at most 180 degrees wide. A direction w of W has w.u >
// 0, as w.(x - c) is at least its slack. Suppose that w comes to separate and fails later. Then its slack
// rises and falls in between, so the tangent turns from w.t > 0 to w.t < 0, and on the side to which the path
// turns it passes a normal nu = -w while w separates. (On a stretch where w.t = 0 throughout, or at a corner,
// the same nu occurs; on a straight path slacks are linear.) There nu.u = -w.u < 0: not a convex path. So a
// direction that comes to separate never fails again. Let pick k be w_k at t_k. If w_(k+1) is not in W(t_k),
// it came later and is the last pick. Otherwise it is in W(t_k), in which w_k has the least rank: its rank is
// not lower. Nor is it equal, except for axes: between two edges of one body and depth lies one of less depth
// or an axis, in direction too, so it would be in W(t_k). Of one body's axes at most two are in W(t_k). So
// all picks but the last have the d_P + d_Q + 2 ranks in their order, P0 and Q0 up to twice (a third would
// have come later). A pick that is not the last fails; so there are at most d_P + d_Q + 4 failures. (If the
// last fails too, it had not come later, and K is one less.)
//
// Lemma C. Each failure of a coarse line ends at a zero of its own, or at a right angle. For a translation it
// is a zero of one of N + 8 heights. For an algebraic rigid motion it is a zero of one of O(n_P n_Q)
// functions, each with O(1) zeros: the heights of a body's vertices over the other's edges and axes, and the
// ends of the vertices' cones, which are parallel edges. Proof. A pick holds its conditions until one falls
// to zero. The same function may end another pick, but at a later zero. Only an end of the bracket that is
// farther than a right angle from the direction of the pick is no cone's: kds/windowed_line.c brings it in to
// the right angle. Picks that fail there take a right angle of turning each, in disjoint times: an algebraic
// motion of bounded degree turns by O(1) altogether, so they are O(1).
#include "certificate/coarse.h"

#include <math.h>

#include "geometry/distance.h"

// ---- the cone of directions that separate ----

/// An edge this nearly across the direction that the search begins with counts as across it: its sine.
#define LEVEL 1e-12

/// The vertices of one body from its support vertex in the first direction on, in the sense in which the
/// support moves when the direction turns. The support at the end is among `low` to `high`.
typedef struct chain {
    const bmr_polygon *polygon;
    const bmr_pose *pose; ///< of B; NULL: this is A
    uint32_t first, low, high;
    int side;
} chain;

static inline bmr_vec2 chain_vertex(const chain *c, uint32_t k) {
    const uint32_t n = c->polygon->count, i = c->side > 0 ? c->first + k : c->first + n - k;
    return c->polygon->vertices[i < n ? i : i - n];
}

static inline bmr_vec2 chain_point(const chain *c, uint32_t k) {
    const bmr_vec2 v = chain_vertex(c, k);
    return c->pose ? bmr_transform(c->pose, v) : v;
}

/// Does the support leave the middle vertex before the direction has turned to `end`? It does at the normal
/// of the next edge, which is `*edge` of the difference A - B. Edges of the far half, which lead back towards
/// `inside`, come after every end; up to rounding the first ones may seem to.
static inline bool leaves(const chain *c, bmr_vec2 inside, bmr_vec2 end, bmr_vec2 *edge) {
    const uint32_t n = c->polygon->count, k = c->low + (c->high - c->low) / 2;
    if (c->low == c->high)
        return false;
    const bmr_vec2 e = bmr_sub(chain_vertex(c, k + 1 < n ? k + 1 : 0), chain_vertex(c, k));
    *edge = c->pose ? bmr_neg(bmr_rotate(c->pose, e)) : e;
    const double level = LEVEL * (fabs(e.x) + fabs(e.y));
    return bmr_dot(*edge, end) > 0.0 && bmr_dot(*edge, inside) <= (2 * k > n ? -level : level);
}

/// Along the direction in which two points are `least` apart, `side` of the one between them; as long as
/// these are apart, squared.
static inline bmr_vec2 tilted(bmr_vec2 between, double least, int side) {
    const double across = bmr_dot(between, between) - least * least;
    const double turn = side * sqrt(across > 0.0 ? across : 0.0);
    return bmr_add(bmr_scale(least, between), bmr_scale(turn, bmr_left(between)));
}

/// An inner common tangent, by halving the two chains (Overmars and van Leeuwen's way). Let p and q be their
/// middle vertices and w the direction in which these are `least` apart. The bodies are no farther apart
/// there: the end comes before w, or is w. So a body whose support stays at its middle vertex until w has its
/// support at the end there, or before. Where the support of both moves on before w, let alpha be the
/// direction in which it does so first, say A's. Then the end is beyond alpha: alpha = l inside + m beta with
/// l, m >= 0, l + m >= 1, beta being B's. For every point z of B <inside, z - p> > least, and <beta, z - p>
/// >= <beta, q - p> > least. So <alpha, z - p> > least. And if only A's does, and q is known to be B's
/// support at the end, it is beyond alpha for the same reason. Each step halves a chain.
bmr_vec2 bmr_cone_end(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 inside,
                      double least, int side, const uint32_t support[2], unsigned *steps) {
    chain c = {a, NULL, bmr_support_near(a, inside, support[0] % a->count, steps), 0, a->count - 1, side};
    const bmr_vec2 back = bmr_unrotate(b_in_a, bmr_neg(inside));
    chain d = {b, b_in_a, bmr_support_near(b, back, support[1] % b->count, steps), 0, b->count - 1, side};
    while (c.low < c.high || d.low < d.high) {
        const uint32_t i = c.low + (c.high - c.low) / 2, j = d.low + (d.high - d.low) / 2;
        const bmr_vec2 w = tilted(bmr_sub(chain_point(&d, j), chain_point(&c, i)), least, side);
        bmr_vec2 edge_c = {0.0, 0.0}, edge_d = {0.0, 0.0};
        const bool on_c = leaves(&c, inside, w, &edge_c), on_d = leaves(&d, inside, w, &edge_d);
        const bool c_first = side * bmr_cross(edge_c, edge_d) >= 0.0;
        const bool past_c = on_c && (on_d ? c_first : d.low == d.high),
                   past_d = on_d && (on_c ? !c_first : c.low == c.high);
        ++*steps;
        if (past_c)
            c.low = i + 1;
        else if (!on_c)
            c.high = i;
        if (past_d)
            d.low = j + 1;
        else if (!on_d)
            d.high = j;
    }
    const bmr_vec2 between = bmr_sub(chain_point(&d, d.low), chain_point(&c, c.low));
    return bmr_scale(1.0 / bmr_dot(between, between), tilted(between, least, side));
}

/// The directions that separate, as one body sees them: outwards from it, less than half a turn wide.
typedef struct fan {
    bmr_vec2 low, high, closest;
} fan;

/// An edge's normal, or an axis, that separates; and how deep it is in the body's tree.
typedef struct pick {
    bmr_vec2 normal; ///< owner's frame
    uint32_t edge;   ///< or BMR_COARSE_AXIS + axis
    unsigned depth;
} pick;

static bool separates(const fan *f, bmr_vec2 normal) {
    return bmr_cross(f->low, normal) > 0.0 && bmr_cross(normal, f->high) > 0.0;
}

/// Axis `k` of a frame, counter-clockwise.
static bmr_vec2 axis(unsigned k) {
    static const bmr_vec2 axes[4] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    return axes[k & 3u];
}

/// The quadrant, counter-clockwise from axis `k`, that has the direction in it.
static unsigned quadrant(bmr_vec2 d) {
    if (d.x > 0.0 && d.y >= 0.0)
        return 0;
    if (d.x <= 0.0 && d.y > 0.0)
        return 1;
    return d.x < 0.0 ? 2 : 3;
}

/// Of two axes that separate (there are no more) the one nearer to the closest direction.
static bool pick_axis(const fan *f, pick *best) {
    double most = -2.0;
    for (unsigned k = 0; k < 4; ++k) {
        const double nearness = bmr_dot(axis(k), f->closest);
        if (nearness > most && separates(f, axis(k))) {
            most = nearness;
            *best = (pick){axis(k), BMR_COARSE_AXIS + k, 0};
        }
    }
    return most > -2.0;
}

/// Where no axis separates, all that do are in one quadrant, and down its tree one of two halves has them.
static bool pick_edge(const bmr_polygon *p, const fan *f, pick *best, unsigned *steps) {
    const unsigned k = quadrant(f->closest);
    const uint32_t n = p->count, first = bmr_support_counted(p, axis(k), steps),
                   last = bmr_support_counted(p, axis(k + 1), steps);
    uint32_t low = 0, high = last >= first ? last - first : last + n - first;
    for (unsigned depth = 1; low < high; ++depth) {
        ++*steps;
        const uint32_t middle = low + (high - low) / 2,
                       edge = first + middle < n ? first + middle : first + middle - n;
        const bmr_vec2 normal = bmr_polygon_normal(p, edge);
        if (separates(f, normal)) {
            *best = (pick){normal, edge, depth};
            return true;
        }
        if (bmr_cross(normal, f->closest) > 0.0)
            low = middle + 1;
        else
            high = middle;
    }
    return false;
}

bool bmr_coarse_pick(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 closest,
                     double least, const uint32_t support[2], bmr_coarse *coarse, unsigned *steps) {
    const bmr_vec2 low = bmr_cone_end(a, b, b_in_a, closest, least, -1, support, steps),
                   high = bmr_cone_end(a, b, b_in_a, closest, least, 1, support, steps);
    const fan seen[2] = {{low, high, closest},
                         {bmr_unrotate(b_in_a, bmr_neg(low)), bmr_unrotate(b_in_a, bmr_neg(high)),
                          bmr_unrotate(b_in_a, bmr_neg(closest))}};
    const bmr_polygon *const bodies[2] = {a, b};
    unsigned depth = 0;
    coarse->owner = -1;
    for (int body = 0; body < 2; ++body) {
        pick here;
        const bool found =
            pick_axis(&seen[body], &here) || pick_edge(bodies[body], &seen[body], &here, steps);
        if (!found || (coarse->owner >= 0 && depth <= here.depth))
            continue;
        depth = here.depth;
        *coarse = (bmr_coarse){body, here.edge, here.normal};
    }
    return coarse->owner >= 0;
}

bool bmr_coarse_normal(const bmr_polygon *owner, uint32_t edge, bmr_vec2 *normal) {
    const uint32_t k = edge - BMR_COARSE_AXIS; // wraps to 4 or more if `edge` is one of the polygon
    if (k >= 4 && edge >= owner->count)
        return false;
    *normal = k < 4 ? axis(k) : bmr_polygon_normal(owner, edge);
    return true;
}
