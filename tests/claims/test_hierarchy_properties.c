// SPDX-License-Identifier: MIT
#include "boomerang/hierarchy.h"
#include "checks.h"
#include "compass_fixture.h"
#include "hierarchies.h"
#include "hierarchy/tree.h"

/// @file
/// Hierarchies that random bytes do not reach: of many vertices, and with apexes a denormal number from an
/// edge's end. What holds for all others, tests/random/fuzz_hierarchy.cpp asks.

static const size_t all_sizes[] = {3, 4, 5, 7, 8, 13, 64, 257, 1000, 4096};

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
            own_polygon *p = test_polygon((test_family)family, all_sizes[i], &random);
            for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT && !merges_edges((test_family)family);
                 ++kind) {
                own_hierarchy *h = built(kind, p);
                envelope e = walk_round(h, bmr_hierarchy_depth(h));
                assert_true(is_the_polygon(&e, p));
                if (bmr_hierarchy_depth(h) > 0) { // control: the level above is not
                    envelope above = walk_round(h, bmr_hierarchy_depth(h) - 1);
                    assert_false(is_the_polygon(&above, p));
                    drop(&above);
                }
                drop(&e);
            }
        }
}

// --- the largest ---

TEST(polygons_of_65535_vertices_pass_the_audit) {
    const test_family families[] = {TEST_CIRCLE, TEST_NEEDLE, TEST_TINY_EDGES};
    test_random random = {119};
    for (size_t i = 0; i < COUNT_OF(families); ++i) {
        own_polygon *p = test_polygon(families[i], 65535, &random);
        assert_true(p->count > 60000);
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            own_hierarchy *h = built(kind, p);
            assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
            assert_true(bmr_hierarchy_bytes(h) + bmr_polygon_bytes(p->count) <= 160 * (size_t)p->count);
        }
    }
}

/// Also where an apex is so near the end of an edge: every product with what lies between them underflows.
TEST(what_is_beyond_an_end_by_a_denormal_distance) {
    const bmr_vec2 points[] = {{0.0, 0.0}, {0.4, -0.6}, {1.0, 1.0}};
    own_polygon *p = made_polygon(points, COUNT_OF(points));
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
}
