// SPDX-License-Identifier: MIT
#include "certificate/cone.h"

#include <math.h>

#include "geometry/distance.h"

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
