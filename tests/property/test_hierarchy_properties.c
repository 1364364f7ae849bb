// SPDX-License-Identifier: MIT
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <math.h>

#include "boomerang/hierarchy.h"
#include "hierarchy/tree.h"
#include "polygons.h"
#include "test_scale.h"

/// @file
/// The theorems of section 3, and the structure they stand on, against brute force. Every check is a function
/// that says yes or no, and every test hands it something wrong as well.

#define KINDS 3
/// Ten roundings of a coordinate.
#define ROUNDING 2e-15
/// Directions closer than this are one edge (hierarchy.h).
#define MERGE_ANGLE 1e-11

static bmr_compass *compass;

static int make_compass(void **state) {
    (void)state;
    return bmr_compass_create(BMR_MAX_VERTICES, NULL, &compass) == BMR_OK ? 0 : -1;
}

static int drop_compass(void **state) {
    (void)state;
    bmr_compass_destroy(compass, NULL);
    return 0;
}

static bmr_hierarchy *built(int kind, const bmr_polygon *p) {
    bmr_hierarchy *h = NULL;
    bmr_error error = BMR_ERROR_COUNT;
    if (kind == BMR_HIERARCHY_COMPASS)
        error = bmr_hierarchy_build_compass(p, compass, NULL, &h);
    else if (kind == BMR_HIERARCHY_DUDLEY)
        error = bmr_hierarchy_build_dudley(p, NULL, &h);
    else
        error = bmr_hierarchy_build_dobkin_kirkpatrick(p, NULL, &h);
    assert_int_equal(error, BMR_OK);
    return h;
}

/// Runs a check on hierarchies of all kinds over all families.
typedef void (*visitor)(const bmr_hierarchy *h, test_family family, test_random *random, void *context);
static void for_all(const size_t *sizes, size_t size_count, size_t rounds, uint64_t seed, visitor visit,
                    void *context) {
    test_random random = {seed};
    for (size_t round = 0; round < rounds; ++round)
        for (size_t i = 0; i < size_count; ++i)
            for (int family = 0; family < TEST_FAMILY_COUNT; ++family) {
                bmr_polygon *p = test_polygon((test_family)family, sizes[i], &random);
                assert_non_null(p);
                for (int kind = 0; kind < KINDS; ++kind) {
                    bmr_hierarchy *h = built(kind, p);
                    visit(h, (test_family)family, &random, context);
                    bmr_hierarchy_destroy(h, NULL);
                }
                bmr_polygon_destroy(p, NULL);
            }
}
#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const size_t small_sizes[] = {3, 4, 5, 7, 8, 13, 32, 64, 150};
static const size_t all_sizes[] = {3, 4, 5, 7, 8, 13, 64, 257, 1000, 4096};

static double diameter_of(const bmr_polygon *p) {
    double most = 0.0;
    for (uint32_t i = 0; i < p->count; ++i)
        for (uint32_t j = 0; j < i; ++j) {
            const bmr_vec2 d = bmr_sub(p->vertices[i], p->vertices[j]);
            most = fmax(most, bmr_dot(d, d));
        }
    return sqrt(most);
}

static bmr_vec2 any_direction(const bmr_hierarchy *h, test_random *random) {
    if (test_random_below(random, 3) == 0) // ties
        return bmr_hierarchy_line(h, test_random_below(random, bmr_hierarchy_edge_count(h))).normal;
    const double angle = test_random_uniform(random, 0.0, 6.3);
    return bmr_vec2_make(cos(angle), sin(angle));
}

static double slack(const bmr_hierarchy *h) {
    return ROUNDING * bmr_hierarchy_polygon(h)->extent;
}

static bool same_corner(bmr_corner a, bmr_corner b) {
    return a.before == b.before && a.after == b.after && a.cut == b.cut;
}

// --- lines ---

static bool is_support_line(const bmr_hierarchy *h, bmr_line line, uint32_t touch) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    double most = -INFINITY;
    for (uint32_t i = 0; i < p->count; ++i)
        most = fmax(most, bmr_dot(line.normal, p->vertices[i]));
    return fabs(hypot(line.normal.x, line.normal.y) - 1.0) <= 4e-16 && fabs(most - line.offset) <= slack(h) &&
           fabs(bmr_dot(line.normal, p->vertices[touch]) - line.offset) <= slack(h);
}

static void visit_lines(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)family;
    (void)random;
    (void)context;
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id) {
        bmr_line line = bmr_hierarchy_line(h, id);
        const uint32_t touch = bmr_hierarchy_touch(h, id);
        assert_true(is_support_line(h, line, touch));
        // Controls: an offset wrong by a little, a normal that points inwards.
        line.offset -= 1e-13 * p->extent;
        assert_false(is_support_line(h, line, touch));
        line.offset += 2e-13 * p->extent;
        assert_false(is_support_line(h, line, touch));
        line = bmr_hierarchy_line(h, id);
        line.normal = bmr_neg(line.normal);
        assert_false(is_support_line(h, line, touch));
    }
}

static void every_edge_lies_on_a_support_line_of_the_polygon(void **state) {
    (void)state;
    for_all(small_sizes, COUNT_OF(small_sizes), test_scaled(2), 101, visit_lines, NULL);
}

// --- envelopes ---

typedef struct envelope {
    bmr_corner *corners;
    bmr_vec2 *points;
    uint32_t count;
} envelope;

/// The corners of P_level by walking round; count 0 if the walk does not close.
static envelope walk_round(const bmr_hierarchy *h, uint32_t level) {
    const uint32_t most = bmr_hierarchy_edge_count(h);
    envelope e = {malloc(most * sizeof(bmr_corner)), malloc(most * sizeof(bmr_vec2)), 0};
    assert_true(e.corners && e.points);
    bmr_edge edge = 0;
    do {
        if (e.count == most) {
            e.count = 0;
            break;
        }
        e.corners[e.count] = bmr_hierarchy_corner_after(h, edge, level);
        e.points[e.count] = bmr_hierarchy_corner_point(h, e.corners[e.count]);
        edge = e.corners[e.count++].after;
    } while (edge != 0);
    return e;
}

static void drop(envelope *e) {
    free(e->corners);
    free(e->points);
}

/// Every edge of a level <= i once, corners seen alike from both sides, turning by 2 pi in all.
static bool is_ring(const bmr_hierarchy *h, const envelope *e, uint32_t level) {
    uint32_t expected = 0;
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id)
        expected += bmr_hierarchy_level(h, id) <= level;
    double turning = 0.0;
    for (uint32_t i = 0; i < e->count; ++i) {
        const bmr_corner corner = e->corners[i];
        if (!same_corner(corner, bmr_hierarchy_corner_before(h, corner.after, level)) ||
            !same_corner(corner, bmr_hierarchy_corner(h, corner.before, corner.after)))
            return false;
        const bmr_vec2 a = bmr_hierarchy_line(h, corner.before).normal,
                       b = bmr_hierarchy_line(h, corner.after).normal;
        const double turn = atan2(bmr_cross(a, b), bmr_dot(a, b));
        if (!(turn > 0.5 * MERGE_ANGLE))
            return false;
        turning += turn;
    }
    return e->count == expected && fabs(turning - 6.28318530717958647693) < 1e-9;
}

static double farthest(const bmr_vec2 *points, uint32_t count, bmr_vec2 d) {
    double most = -INFINITY;
    for (uint32_t i = 0; i < count; ++i)
        most = fmax(most, bmr_dot(d, points[i]));
    return most;
}

static bool is_extreme(const bmr_hierarchy *h, const envelope *e, bmr_corner corner, bmr_vec2 d) {
    return bmr_dot(d, bmr_hierarchy_corner_point(h, corner)) >=
           farthest(e->points, e->count, d) - 2.0 * slack(h);
}

/// Between P and the envelope before it, as seen from direction d.
static bool is_between(const bmr_hierarchy *h, const envelope *e, const envelope *outer, bmr_vec2 d) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const double here = farthest(e->points, e->count, d);
    return here >= farthest(p->vertices, p->count, d) - slack(h) &&
           (!outer || here <= farthest(outer->points, outer->count, d) + slack(h));
}

typedef struct controls {
    size_t tried, rejected;
} controls;

static void visit_levels(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)family;
    controls *c = context;
    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    envelope outer = {NULL, NULL, 0};
    for (uint32_t level = 0; level <= bmr_hierarchy_depth(h) + 1; ++level) {
        envelope e = walk_round(h, level);
        assert_true(is_ring(h, &e, level));
        for (int i = 0; i < 12; ++i) {
            const bmr_vec2 d = any_direction(h, random);
            const bmr_corner corner = bmr_hierarchy_extreme(h, d, level);
            assert_true(is_extreme(h, &e, corner, d));
            assert_true(is_between(h, &e, outer.points ? &outer : NULL, d));
            // Refining from any level above gives the same; coarsening goes back.
            const uint32_t from = test_random_below(random, level + 1);
            assert_true(
                same_corner(corner, bmr_hierarchy_refine(h, bmr_hierarchy_extreme(h, d, from), d, level)));
            if (level > 0)
                assert_true(same_corner(bmr_hierarchy_coarsen(h, corner, level),
                                        bmr_hierarchy_extreme(h, d, level - 1)));
            // Control: the corner half way round is not extreme.
            ++c->tried;
            c->rejected += !is_extreme(h, &e, bmr_hierarchy_extreme(h, bmr_neg(d), level), d);
        }
        // Controls: a ring with an edge left out, or of another level.
        --e.count;
        assert_false(is_ring(h, &e, level));
        ++e.count;
        if (level > 0 && level <= bmr_hierarchy_depth(h))
            assert_false(is_ring(h, &e, level - 1));
        drop(&outer);
        outer = e;
    }
    drop(&outer);
}

static void
envelopes_are_rings_nested_around_the_polygon_and_their_extremes_those_of_brute_force(void **state) {
    (void)state;
    controls c = {0, 0};
    for_all(small_sizes, COUNT_OF(small_sizes), test_scaled(3), 103, visit_levels, &c);
    const size_t large[] = {1000};
    for_all(large, 1, 1, 105, visit_levels, &c);
    assert_true(c.rejected * 10 > c.tried * 9);
}

static void an_envelope_that_cuts_into_the_polygon_is_noticed(void **state) {
    (void)state;
    test_random random = {107};
    bmr_polygon *p = test_polygon(TEST_CIRCLE, 100, &random);
    bmr_hierarchy *h = built(BMR_HIERARCHY_COMPASS, p);
    envelope e = walk_round(h, 2), deeper = walk_round(h, 3);
    size_t inside = 0, outside = 0;
    for (int i = 0; i < 200; ++i) {
        const bmr_vec2 d = any_direction(h, &random);
        assert_true(is_between(h, &deeper, &e, d));
        outside += !is_between(h, &e, &deeper, d); // the wrong way round
    }
    for (uint32_t i = 0; i < e.count; ++i)
        e.points[i] = bmr_scale(0.9, e.points[i]);
    for (int i = 0; i < 200; ++i)
        inside += !is_between(h, &e, NULL, any_direction(h, &random));
    assert_true(inside > 50 && outside > 50);
    drop(&e);
    drop(&deeper);
    bmr_hierarchy_destroy(h, NULL);
    bmr_polygon_destroy(p, NULL);
}

/// The deepest envelope is P itself: its corners are P's vertices bit for bit, in order, none left out.
static bool is_the_polygon(const envelope *e, const bmr_polygon *p) {
    if (e->count == 0)
        return false;
    uint32_t at = p->count;
    for (uint32_t i = 0; i < p->count; ++i)
        if (p->vertices[i].x == e->points[0].x && p->vertices[i].y == e->points[0].y)
            at = i;
    if (at == p->count)
        return false;
    uint32_t steps = 0;
    for (uint32_t i = 1; i <= e->count; ++i) {
        const bmr_vec2 x = e->points[i % e->count], here = p->vertices[at],
                       next = p->vertices[(at + 1) % p->count];
        if (x.x == here.x && x.y == here.y)
            continue; // an edge of length 0
        if (x.x != next.x || x.y != next.y)
            return false;
        at = (at + 1) % p->count;
        ++steps;
    }
    return steps == p->count;
}

/// No two neighbouring edges, and no edge and compass or sample direction, are near the merging angle but not
/// on it.
static bool merges_edges(test_family family) {
    return family == TEST_NEARLY_FLAT;
}

static void the_deepest_envelope_is_the_polygon_bit_for_bit(void **state) {
    (void)state;
    test_random random = {109};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t i = 0; i < COUNT_OF(all_sizes); ++i) {
            bmr_polygon *p = test_polygon((test_family)family, all_sizes[i], &random);
            for (int kind = 0; kind < KINDS && !merges_edges((test_family)family); ++kind) {
                bmr_hierarchy *h = built(kind, p);
                envelope e = walk_round(h, bmr_hierarchy_depth(h));
                assert_true(is_the_polygon(&e, p));
                if (bmr_hierarchy_depth(h) > 0) { // control: the level above is not
                    envelope above = walk_round(h, bmr_hierarchy_depth(h) - 1);
                    assert_false(is_the_polygon(&above, p));
                    drop(&above);
                }
                drop(&e);
                bmr_hierarchy_destroy(h, NULL);
            }
            bmr_polygon_destroy(p, NULL);
        }
}

// --- heights ---

static double distance_to_segment(bmr_vec2 x, bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 e = bmr_sub(b, a), r = bmr_sub(x, a);
    const double square = bmr_dot(e, e),
                 t = square > 0.0 ? fmin(fmax(bmr_dot(r, e) / square, 0.0), 1.0) : 0.0;
    return hypot(r.x - t * e.x, r.y - t * e.y);
}

static double brute_height(const bmr_hierarchy *h, bmr_edge edge) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const bmr_vec2 apex = bmr_hierarchy_apex(h, edge);
    double least = INFINITY;
    for (uint32_t i = 0; i < p->count; ++i)
        least = fmin(least, distance_to_segment(apex, p->vertices[i], p->vertices[(i + 1) % p->count]));
    return least;
}

static void visit_heights(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)family;
    (void)random;
    (void)context;
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
        const double height = bmr_hierarchy_height(h, id), expected = brute_height(h, id);
        assert_true(fabs(height - expected) <= 2.0 * slack(h));
        assert_true(height > 0.0); // pruned otherwise
        const bmr_boomerang b = bmr_hierarchy_boomerang(h, id);
        const double level_before = bmr_hierarchy_level(h, b.outer_before),
                     level_after = bmr_hierarchy_level(h, b.outer_after);
        assert_true(fmax(level_before, level_after) + 1.0 == b.level);
        if (b.child_before != BMR_NO_EDGE) // a part is no higher than the whole
            assert_true(bmr_hierarchy_height(h, b.child_before) <= height + slack(h));
        if (b.child_after != BMR_NO_EDGE)
            assert_true(bmr_hierarchy_height(h, b.child_after) <= height + slack(h));
    }
}

static void heights_are_distances_from_the_polygon_and_shrink_downwards(void **state) {
    (void)state;
    for_all(small_sizes, COUNT_OF(small_sizes), test_scaled(2), 111, visit_heights, NULL);
}

// --- the paper's bounds ---

static uint32_t ceil_log2(double x) {
    return x <= 1.0 ? 0 : (uint32_t)ceil(log2(x));
}

/// Depth and size: the constants of the paper's text, and of the layout.
static bool is_small(const bmr_hierarchy *h, uint32_t n) {
    const uint32_t depth = bmr_hierarchy_depth(h), nodes = bmr_hierarchy_edge_count(h);
    switch (bmr_hierarchy_get_kind(h)) {
    case BMR_HIERARCHY_COMPASS:
        return depth <= 2 * ceil_log2(n) && nodes <= 5 * n;
    case BMR_HIERARCHY_DUDLEY:
        return depth <= ceil_log2(2.0 * n) && nodes <= 2 * n + 4 && (n < 8 || 2 * nodes <= 5 * n);
    default:
        return depth <= ceil_log2(n) && nodes <= n + 4;
    }
}

/// The tallest boomerang of each level, times the factor^level, over the diameter; levels up to `last`.
static double tallest(const bmr_hierarchy *h, double diameter, double factor, uint32_t last) {
    double most = 0.0;
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
        const uint32_t level = bmr_hierarchy_level(h, id) - 1; // of the boomerang; its cut is one level below
        if (level <= last)
            most = fmax(most, bmr_hierarchy_height(h, id) * pow(factor, level) / diameter);
    }
    return most;
}

static bool has_compass_heights(const bmr_hierarchy *h, double diameter) {
    return tallest(h, diameter, 2.0, ceil_log2(bmr_hierarchy_polygon(h)->count)) <= 0.5 + 1e-12;
}
/// The constant of Dudley's lemma: 6, but for polygons made to defeat the median. With all n edges at one end
/// of a quadrant the median of edges and samples needs some levels to reach the samples, which are a share of
/// at least 0.17 n (61 of 360 degrees: the circle's 14.5 degrees of parallax off either end). Level i then
/// still has (1 + 0.17) / (0.17 * 2^i) of the quadrant's angle, and the height, D / 2 at most in a right
/// angle, goes with the square: 24.
static double dudley_constant(test_family family) {
    return family == TEST_CLUSTER ? 24.0 : 6.0;
}

static bool has_dudley_heights(const bmr_hierarchy *h, double diameter, double constant) {
    return tallest(h, diameter, 4.0, UINT32_MAX) <= constant;
}

/// At most 2 sqrt(D / s) boomerangs of height >= s on each level, for s = D / 4^k.
static bool has_few_tall(const bmr_hierarchy *h, double diameter) {
    enum { POWERS = 24, LEVELS = 64 };
    uint32_t taller[LEVELS][POWERS] = {{0}};
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
        const double height = bmr_hierarchy_height(h, id);
        for (int k = 0; k < POWERS; ++k)
            taller[bmr_hierarchy_level(h, id)][k] += height >= diameter * pow(4.0, -k);
    }
    for (int level = 0; level < LEVELS; ++level)
        for (int k = 0; k < POWERS; ++k)
            if (taller[level][k] > 2.0 * pow(2.0, k))
                return false;
    return true;
}

typedef struct bounds {
    size_t compass_failed_by_dk, dudley_failed_by_dk, few_tall_failed, small_failed;
} bounds;

static void visit_bounds(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)random;
    bounds *b = context;
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const double diameter = diameter_of(p);
    assert_true(is_small(h, p->count));
    b->small_failed += !is_small(h, p->count / 4 + 1); // control: not those of a smaller polygon
    assert_true(has_few_tall(h, diameter));
    b->few_tall_failed += !has_few_tall(h, diameter / 1e4); // control: as if the polygon were smaller
    switch (bmr_hierarchy_get_kind(h)) {
    case BMR_HIERARCHY_COMPASS:
        assert_true(has_compass_heights(h, diameter));
        break;
    case BMR_HIERARCHY_DUDLEY:
        assert_true(has_dudley_heights(h, diameter, dudley_constant(family)));
        break;
    default: // controls: a hierarchy without the paper's extra edges has neither bound
        b->compass_failed_by_dk += !has_compass_heights(h, diameter);
        b->dudley_failed_by_dk += !has_dudley_heights(h, diameter, dudley_constant(family));
    }
}

static void heights_depths_and_sizes_keep_the_constants_of_the_lemmas(void **state) {
    (void)state;
    bounds b = {0};
    for_all(all_sizes, COUNT_OF(all_sizes) - 1, test_scaled(3), 113, visit_bounds, &b);
    for_all(all_sizes + COUNT_OF(all_sizes) - 1, 1, 1, 115, visit_bounds, &b);
    assert_true(b.compass_failed_by_dk > 0 && b.dudley_failed_by_dk > 0);
    assert_true(b.few_tall_failed > 0 && b.small_failed > 0);
}

/// Below level ceil(log2 n) the height of a compass hierarchy stops halving: a cone of the last compass level
/// holds n - 3 tiny edges, then a long one. The median always leaves the long one whole.
static void the_compass_lemma_fails_in_the_median_tail_and_holds_with_the_capped_level(void **state) {
    (void)state;
    enum { TINY = 348, N = TINY + 3 };
    const double cone = 1.57079632679489661923 / 512.0; // ceil(log2 351) = 9
    bmr_vec2 points[N];
    bmr_vec2 at = {0.0, 0.0};
    for (int i = 0; i <= TINY; ++i) {
        points[i] = at;
        const double angle = i < TINY ? 1e-6 + 1e-9 * i : 0.5 * cone;
        at = bmr_add(at, bmr_scale(i < TINY ? 1e-6 : 0.5, bmr_vec2_make(-sin(angle), cos(angle))));
    }
    points[TINY + 1] = at;
    points[TINY + 2] = bmr_vec2_make(-0.4, 0.2);
    bmr_polygon *p = NULL;
    assert_int_equal(bmr_polygon_create(points, N, NULL, &p), BMR_OK);
    assert_int_equal(p->count, N);
    bmr_hierarchy *h = built(BMR_HIERARCHY_COMPASS, p);
    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    const double diameter = diameter_of(p);
    assert_true(tallest(h, diameter, 2.0, UINT32_MAX) > 18.0); // the lemma as printed
    assert_true(has_compass_heights(h, diameter));
    double most = 0.0;
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id)
        most = fmax(most, bmr_hierarchy_height(h, id) * pow(2.0, fmin(bmr_hierarchy_level(h, id) - 1, 9)) /
                              diameter);
    assert_true(most <= 0.5);
    bmr_hierarchy_destroy(h, NULL);
    bmr_polygon_destroy(p, NULL);
}

// --- disjoint approximations ---

/// Cuts corners of P_0 until none is beyond the line <y, x> = h_P(y) + gap; returns the number of edges of
/// that approximation of P, or 0 if even P is beyond. Only the corner farthest in direction y need ever be
/// cut.
static uint32_t edges_below(const bmr_hierarchy *h, bmr_vec2 y, double gap) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const double limit = farthest(p->vertices, p->count, y) + gap;
    uint32_t edges = 4;
    for (uint32_t level = 0;; ++level) {
        const bmr_corner corner = bmr_hierarchy_extreme(h, y, level);
        if (bmr_dot(y, bmr_hierarchy_corner_point(h, corner)) <= limit)
            return edges;
        if (level == bmr_hierarchy_depth(h))
            return 0;
        edges += corner.cut != BMR_NO_EDGE && bmr_hierarchy_level(h, corner.cut) == level + 1;
    }
}

typedef struct approximations {
    size_t tried, dk_failed;
} approximations;

static uint32_t edge_bound(int kind, double ratio) {
    // Height <= D / 2^(i+1), resp. 6 D / 4^i, must come below s / 2.
    return 4 + (kind == BMR_HIERARCHY_DUDLEY ? ceil_log2(12.0 * ratio) / 2 + 1 : ceil_log2(ratio));
}

static void visit_pair(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)family;
    approximations *a = context;
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const double diameter = 2.0 * p->radius;
    const int kind = (int)bmr_hierarchy_get_kind(h);
    for (int k = 1; k <= 20; ++k) {
        const double ratio = pow(2.0, k); // D / s
        if (kind == BMR_HIERARCHY_COMPASS && ceil_log2(ratio) > ceil_log2(p->count))
            continue; // below the compass levels the lemma does not hold
        // A second polygon at distance s along y: its own approximation is asked on the other side.
        const bmr_vec2 y = any_direction(h, random);
        const double half_gap = 0.5 * diameter / ratio;
        const uint32_t mine = edges_below(h, y, half_gap), other = edges_below(h, bmr_neg(y), half_gap);
        assert_true(mine > 0 && other > 0);
        if (kind == BMR_HIERARCHY_DOBKIN_KIRKPATRICK) { // control: it has no such bound
            a->dk_failed += mine > edge_bound(BMR_HIERARCHY_DUDLEY, ratio) ||
                            other > edge_bound(BMR_HIERARCHY_DUDLEY, ratio);
        } else {
            assert_true(mine <= edge_bound(kind, ratio));
            assert_true(other <= edge_bound(kind, ratio));
            ++a->tried;
        }
    }
}

static void polygons_at_distance_s_have_disjoint_approximations_of_few_edges(void **state) {
    (void)state;
    approximations a = {0, 0};
    for_all(all_sizes, COUNT_OF(all_sizes), test_scaled(3), 117, visit_pair, &a);
    assert_true(a.tried > 1000 || test_scaled(3) < 3);
    assert_true(a.dk_failed > 0);
}

// --- the largest ---

static void polygons_of_65535_vertices_pass_the_audit(void **state) {
    (void)state;
    const test_family families[] = {TEST_CIRCLE, TEST_NEEDLE, TEST_TINY_EDGES};
    test_random random = {119};
    for (size_t i = 0; i < COUNT_OF(families); ++i) {
        bmr_polygon *p = test_polygon(families[i], 65535, &random);
        assert_true(p->count > 60000);
        for (int kind = 0; kind < KINDS; ++kind) {
            bmr_hierarchy *h = built(kind, p);
            assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
            assert_true(is_small(h, p->count));
            assert_false(is_small(h, p->count / 8));
            assert_true(bmr_hierarchy_bytes(h) + bmr_polygon_bytes(p->count) <= 160 * (size_t)p->count);
            bmr_hierarchy_destroy(h, NULL);
        }
        bmr_polygon_destroy(p, NULL);
    }
}

/// The same polygon far from the origin and at the ends of the range.
static void scale_and_place_do_not_matter(void **state) {
    (void)state;
    const double scales[] = {1e-9, 1e-3, 1e3, 2e8};
    test_random random = {121};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t i = 0; i < COUNT_OF(scales); ++i)
            for (int away = 0; away < 2; ++away) {
                bmr_vec2 points[132];
                const size_t count = test_points((test_family)family, 120, &random, points);
                bmr_polygon *p = NULL;
                const double x = away ? scales[i] * 2.5 : 0.0;
                const double unit =
                    family == TEST_PARALLEL || family == TEST_GRID ? scales[i] / 1e5 : scales[i];
                for (size_t j = 0; j < count; ++j)
                    points[j] = bmr_add(bmr_scale(unit, points[j]), bmr_vec2_make(x, -x));
                const bmr_error error = bmr_polygon_create(points, count, NULL, &p);
                if (error == BMR_ERROR_OUT_OF_RANGE && unit < 2e-9)
                    continue; // smaller than BMR_MIN_EXTENT
                assert_int_equal(error, BMR_OK);
                for (int kind = 0; kind < KINDS; ++kind) {
                    bmr_hierarchy *h = built(kind, p);
                    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
                    bmr_hierarchy_destroy(h, NULL);
                }
                bmr_polygon_destroy(p, NULL);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_edge_lies_on_a_support_line_of_the_polygon),
        cmocka_unit_test(
            envelopes_are_rings_nested_around_the_polygon_and_their_extremes_those_of_brute_force),
        cmocka_unit_test(an_envelope_that_cuts_into_the_polygon_is_noticed),
        cmocka_unit_test(the_deepest_envelope_is_the_polygon_bit_for_bit),
        cmocka_unit_test(heights_are_distances_from_the_polygon_and_shrink_downwards),
        cmocka_unit_test(heights_depths_and_sizes_keep_the_constants_of_the_lemmas),
        cmocka_unit_test(the_compass_lemma_fails_in_the_median_tail_and_holds_with_the_capped_level),
        cmocka_unit_test(polygons_at_distance_s_have_disjoint_approximations_of_few_edges),
        cmocka_unit_test(polygons_of_65535_vertices_pass_the_audit),
        cmocka_unit_test(scale_and_place_do_not_matter),
    };
    return cmocka_run_group_tests(tests, make_compass, drop_compass);
}
