// SPDX-License-Identifier: MIT
#include <stdlib.h>

#include "checks.h"
#include <math.h>

#include "boomerang/hierarchy.h"
#include "compass_fixture.h"
#include "hierarchies.h"
#include "hierarchy/tree.h"
#include "test_scale.h"

/// @file
/// The structure that the theorems of section 3 stand on, against brute force. Every check is a function that
/// says yes or no, and every test hands it something wrong as well.

/// Ten roundings of a coordinate.
#define ROUNDING 2e-15
/// Directions closer than this are one edge (hierarchy.h).
#define MERGE_ANGLE 1e-11

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const size_t all_sizes[] = {3, 4, 5, 7, 8, 13, 64, 257, 1000, 4096};
static const size_t small_sizes[] = {3, 4, 5, 7, 8, 13, 32, 64, 150};

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
        if (h->nodes[id].wide) // neither end of the edge sticks out, not even by rounding
            assert_true(bmr_dot(line.normal, p->vertices[(touch + 1) % p->count]) <= line.offset &&
                        bmr_dot(line.normal, p->vertices[touch]) <= line.offset);
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

TEST(every_edge_lies_on_a_support_line_of_the_polygon) {
    assert_true(test_visit_hierarchies(compass, small_sizes, COUNT_OF(small_sizes), test_scaled(2), 101,
                                       visit_lines, NULL));
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

static bool is_extreme(const bmr_hierarchy *h, const envelope *e, bmr_corner corner, bmr_vec2 d) {
    return bmr_dot(d, bmr_hierarchy_corner_point(h, corner)) >=
           test_farthest(e->points, e->count, d) - 2.0 * slack(h);
}

/// Between P and the envelope before it, as seen from direction d.
static bool is_between(const bmr_hierarchy *h, const envelope *e, const envelope *outer, bmr_vec2 d) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const double here = test_farthest(e->points, e->count, d);
    return here >= test_farthest(p->vertices, p->count, d) - slack(h) &&
           (!outer || here <= test_farthest(outer->points, outer->count, d) + slack(h));
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
            const bmr_vec2 d = test_direction(h, random);
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

TEST(envelopes_are_rings_nested_around_the_polygon_and_their_extremes_those_of_brute_force) {
    controls c = {0, 0};
    assert_true(test_visit_hierarchies(compass, small_sizes, COUNT_OF(small_sizes), test_scaled(3), 103,
                                       visit_levels, &c));
    const size_t large[] = {1000};
    assert_true(test_visit_hierarchies(compass, large, 1, 1, 105, visit_levels, &c));
    assert_true(c.rejected * 10 > c.tried * 9);
}

TEST(an_envelope_that_cuts_into_the_polygon_is_noticed) {
    test_random random = {107};
    bmr_polygon *p = test_polygon(TEST_CIRCLE, 100, &random);
    bmr_hierarchy *h = built(BMR_HIERARCHY_COMPASS, p);
    envelope e = walk_round(h, 2), deeper = walk_round(h, 3);
    size_t inside = 0, outside = 0;
    for (int i = 0; i < 200; ++i) {
        const bmr_vec2 d = test_direction(h, &random);
        assert_true(is_between(h, &deeper, &e, d));
        outside += !is_between(h, &e, &deeper, d); // the wrong way round
    }
    for (uint32_t i = 0; i < e.count; ++i)
        e.points[i] = bmr_scale(0.9, e.points[i]);
    for (int i = 0; i < 200; ++i)
        inside += !is_between(h, &e, NULL, test_direction(h, &random));
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

TEST(the_deepest_envelope_is_the_polygon_bit_for_bit) {
    test_random random = {109};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t i = 0; i < COUNT_OF(all_sizes); ++i) {
            bmr_polygon *p = test_polygon((test_family)family, all_sizes[i], &random);
            for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT && !merges_edges((test_family)family);
                 ++kind) {
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

static void check_height(const bmr_hierarchy *h, bmr_edge id) {
    assert_true(fabs(bmr_hierarchy_height(h, id) - brute_height(h, id)) <= 2.0 * slack(h));
}

static void visit_heights(const bmr_hierarchy *h, test_family family, test_random *random, void *context) {
    (void)family;
    (void)random;
    (void)context;
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
        const double height = bmr_hierarchy_height(h, id);
        check_height(h, id);
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

TEST(heights_are_distances_from_the_polygon_and_shrink_downwards) {
    assert_true(test_visit_hierarchies(compass, small_sizes, COUNT_OF(small_sizes), test_scaled(2), 111,
                                       visit_heights, NULL));
}

// --- the largest ---

TEST(polygons_of_65535_vertices_pass_the_audit) {
    const test_family families[] = {TEST_CIRCLE, TEST_NEEDLE, TEST_TINY_EDGES};
    test_random random = {119};
    for (size_t i = 0; i < COUNT_OF(families); ++i) {
        bmr_polygon *p = test_polygon(families[i], 65535, &random);
        assert_true(p->count > 60000);
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            bmr_hierarchy *h = built(kind, p);
            assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
            assert_true(bmr_hierarchy_bytes(h) + bmr_polygon_bytes(p->count) <= 160 * (size_t)p->count);
            bmr_hierarchy_destroy(h, NULL);
        }
        bmr_polygon_destroy(p, NULL);
    }
}

/// Edges of a few ulps, corners of 1e-16 radians, polygons thinner than rounding.
TEST(polygons_bent_by_ulps_pass_the_audit) {
    test_random random = {123};
    size_t polygons = 0;
    for (size_t round = 0; round < test_scaled(10000); ++round) {
        bmr_vec2 points[64];
        bmr_polygon *p = NULL;
        if (bmr_polygon_create(points, test_hard_points(&random, points), NULL, &p) != BMR_OK)
            continue; // smaller than BMR_MIN_SIDE
        polygons += p->count > 2;
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            bmr_hierarchy *h = built(kind, p);
            assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
            bmr_hierarchy_destroy(h, NULL);
        }
        bmr_polygon_destroy(p, NULL);
    }
    assert_true(2 * polygons > test_scaled(10000));
}

/// Two vertices that only denormal numbers tell apart, at an edge whose direction is neither axis'.
TEST(edges_as_short_as_double_has_them_pass_the_audit) {
    for (int k = 1; k <= 64; ++k) {
        const double tiny = 0x1p-1074;
        const bmr_vec2 points[] = {{4 * tiny * k, -5 * tiny * k}, {0.0, 0.0}, {-0.65, 0.75}, {-0.87, 0.49}};
        bmr_polygon *p = NULL;
        assert_int_equal(bmr_polygon_create(points, COUNT_OF(points), NULL, &p), BMR_OK);
        assert_int_equal(p->count, 4);
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            bmr_hierarchy *h = built(kind, p);
            assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
            bmr_hierarchy_destroy(h, NULL);
        }
        bmr_polygon_destroy(p, NULL);
    }
}

/// The nearest point of the chain is looked for along edges whose products with anything underflow.
TEST(heights_over_edges_as_short_as_double_has_them) {
    for (int k = 1; k <= 64; ++k) {
        const double tiny = 0x1p-1074 * k;
        const bmr_vec2 points[] = {{0.0, -15.0 * tiny},
                                   {5.0 * tiny, -8.0 * tiny},
                                   {5.0 * tiny, -5.0 * tiny},
                                   {-5.0 * tiny, 5.0 * tiny},
                                   {-1.0, 0.0105}};
        bmr_polygon *p = NULL;
        assert_int_equal(bmr_polygon_create(points, COUNT_OF(points), NULL, &p), BMR_OK);
        assert_int_equal(p->count, COUNT_OF(points));
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            bmr_hierarchy *h = built(kind, p);
            for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id)
                check_height(h, id);
            bmr_hierarchy_destroy(h, NULL);
        }
        bmr_polygon_destroy(p, NULL);
    }
}

/// Also where an apex is so near the end of an edge: every product with what lies between them underflows.
TEST(what_is_beyond_an_end_by_a_denormal_distance) {
    const bmr_vec2 points[] = {{0.0, 0.0}, {0.4, -0.6}, {1.0, 1.0}};
    bmr_polygon *p = NULL;
    assert_int_equal(bmr_polygon_create(points, COUNT_OF(points), NULL, &p), BMR_OK);
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 e = bmr_tree_edge_vector(p, i);
        for (int x = -6; x <= 6; ++x)
            for (int y = -6; y <= 6; ++y) {
                const double along = e.x * x + e.y * y;
                if (fabs(along) < 1e-9)
                    continue;
                for (double unit = 0x1p-1074; unit < 1.0; unit *= 0x1p100)
                    assert_int_equal(bmr_tree_beyond(p, i, bmr_vec2_make(unit * x, unit * y)), along > 0.0);
            }
    }
    bmr_polygon_destroy(p, NULL);
}

/// The same polygon far from the origin and at the ends of the range.
TEST(scale_and_place_do_not_matter) {
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
                    continue; // smaller than BMR_MIN_SIDE
                assert_int_equal(error, BMR_OK);
                for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
                    bmr_hierarchy *h = built(kind, p);
                    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
                    bmr_hierarchy_destroy(h, NULL);
                }
                bmr_polygon_destroy(p, NULL);
            }
}
