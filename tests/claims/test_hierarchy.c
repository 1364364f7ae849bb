// SPDX-License-Identifier: MIT
#include "boomerang/hierarchy.h"
#include "boomerang/inflated.h"
#include "checks.h"
#include "failing_allocator.h"
#include "geometry/distance.h"
#include "hierarchies.h"
#include "hierarchy/builder.h"

static bmr_hierarchy *built_soundly(bmr_hierarchy_kind kind, const bmr_polygon *p) {
    bmr_hierarchy *h = test_hierarchy(kind, p);
    assert_int_equal(bmr_hierarchy_get_kind(h), kind);
    assert_ptr_equal(bmr_hierarchy_polygon(h), p);
    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    return h;
}

TEST(a_hierarchy_is_one_block_of_the_bytes_announced_and_none_is_none) {
    test_random random = test_random_from(3);
    own_polygon *p = test_polygon(TEST_CIRCLE, 50, &random);
    test_heap heap;
    test_heap_init(&heap, SIZE_MAX);
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        bmr_hierarchy *h = NULL;
        assert_int_equal(
            bmr_hierarchy_build((bmr_hierarchy_kind)kind, p, test_compass(), &heap.allocator, &h), BMR_OK);
        assert_int_equal(heap.blocks, 1); // scratch is given back
        assert_int_equal(heap.bytes, bmr_hierarchy_bytes(h));
        bmr_hierarchy_destroy(h, &heap.allocator);
    }
    bmr_compass *table = NULL;
    assert_int_equal(bmr_compass_create(64, &heap.allocator, &table), BMR_OK);
    assert_true(heap.blocks == 1 && heap.bytes >= 64 * 64 && heap.bytes <= 128 * 64);
    bmr_compass_destroy(table, &heap.allocator);
    bmr_hierarchy_destroy(NULL, NULL);
    bmr_compass_destroy(NULL, NULL);
}

// --- the compass ---

TEST(the_compass_directions_are_exact_and_symmetric) {
    bmr_vec2 points[64];
    test_regular_points(64, 1.0, 0.01, points);
    own_polygon *p = made_polygon(points, 64);
    own_hierarchy *h = built_soundly(BMR_HIERARCHY_COMPASS, p);
    const double r = sqrt(0.5);
    const bmr_vec2 expected[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {r, r}, {-r, r}, {-r, -r}, {r, -r}};
    for (bmr_edge id = 0; id < COUNT_OF(expected); ++id) { // breadth-first: NE, NW, SW, SE are the next four
        const bmr_line line = bmr_hierarchy_line(h, id);
        assert_true(line.normal.x == expected[id].x && line.normal.y == expected[id].y);
        assert_int_equal(bmr_hierarchy_level(h, id), id >= 4);
        assert_false(signbit(line.normal.x) && line.normal.x == 0.0);
    }
}

// --- small shapes ---

TEST(edges_that_agree_within_the_merge_angle_become_one) {
    // The bottom edges are within 1e-12 radians of direction S, and of each other; and 5e-11 off.
    const bmr_vec2 merged[] = {{0, 1}, {-1, 0}, {0, -1e-12}, {1, 0}},
                   kept[] = {{0, 1}, {-1, 0}, {0, -5e-11}, {1, 0}};
    own_polygon *p = made_polygon(merged, 4), *q = made_polygon(kept, 4);
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        own_hierarchy *h = built_soundly((bmr_hierarchy_kind)kind, p),
                      *k = built_soundly((bmr_hierarchy_kind)kind, q);
        uint32_t at_bottom[2] = {0, 0};
        for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id)
            at_bottom[0] += bmr_hierarchy_line(h, id).normal.y < -0.9999999999;
        for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(k); ++id)
            at_bottom[1] += bmr_hierarchy_line(k, id).normal.y < -0.9999999999;
        assert_int_equal(at_bottom[0], 1);
        assert_int_equal(at_bottom[1], 3);
    }
}

/// Is x one of n regular points on the circle of radius 2 D round the polygon, D the diameter of its disk?
static bool is_sample(const bmr_polygon *p, bmr_vec2 x) {
    const bmr_vec2 r = bmr_sub(x, p->center);
    const double turn = atan2(r.y, r.x) / 6.28318530717958647693 * p->count;
    return fabs(turn - round(turn)) < 1e-9 && fabs(hypot(r.x, r.y) / (4.0 * p->radius) - 1.0) < 1e-12;
}

TEST(dudley_adds_edges_whose_outer_normals_point_at_samples_of_the_circle) {
    test_random random = test_random_from(31);
    for (int round = 0; round < 50; ++round) {
        own_polygon *p = test_polygon(TEST_LENS, 40, &random);
        own_hierarchy *h = built_soundly(BMR_HIERARCHY_DUDLEY, p);
        uint32_t degenerate = 0, wrong = 0;
        for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
            if (h->nodes[id].own)
                continue;
            ++degenerate;
            // From the vertex along the outer normal to the circle.
            const bmr_vec2 n = bmr_hierarchy_line(h, id).normal, v = p->vertices[bmr_hierarchy_touch(h, id)];
            const bmr_vec2 r = bmr_sub(v, p->center);
            const double b = bmr_dot(r, n), radius = 4.0 * p->radius;
            const double t = -b + sqrt(b * b - bmr_dot(r, r) + radius * radius);
            assert_true(is_sample(p, bmr_add(v, bmr_scale(t, n))));
            wrong += !is_sample(p, bmr_add(v, bmr_scale(0.99 * t, n))); // control: not beside it
            wrong += !is_sample(p, bmr_sub(v, bmr_scale(t, n)));        // control: not inwards
        }
        assert_true(degenerate > 0);
        assert_int_equal(wrong, 2 * degenerate);
    }
}

// --- the audit must see what is wrong ---

enum { NODE_DAMAGES = 10 };

/// A node with something wrong, each time something else.
static void damage(const bmr_hierarchy *h, const bmr_node *right, bmr_node wrong[NODE_DAMAGES]) {
    const uint32_t vertices = h->polygon->count, last = h->count - 1u;
    for (int k = 0; k < NODE_DAMAGES; ++k)
        wrong[k] = *right;
    wrong[0].touch = (right->touch + vertices / 4 + 1) % vertices & 0xFFFFu;
    wrong[1].touch = vertices & 0xFFFFu;
    wrong[2].level = (right->level + 1u) & 63u;
    wrong[3].outer_before = right->outer_after;
    wrong[4].outer_after = right->outer_before;
    wrong[5].child_before = right->child_before ? 0u : last & 0xFFFFFu;
    wrong[6].child_after = right->child_after ? 0u : last & 0xFFFFFu;
    wrong[7].child_after = h->count & 0xFFFFFu;
    wrong[8].own = wrong[8].wide = !right->own;
    wrong[8].direction = 1;
    if (right->own)
        wrong[9].own = wrong[9].wide = 0;
    wrong[9].direction = right->direction > 4 ? 4u : 7u;
}

static void assert_refused(const bmr_hierarchy *h) {
    assert_int_equal(bmr_hierarchy_audit(h), BMR_ERROR_INVALID_STRUCTURE);
}

TEST(audit_refuses_every_kind_of_damage) {
    test_random random = test_random_from(15);
    own_polygon *p = test_polygon(TEST_ELLIPSE, 37, &random);
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        own_hierarchy *h = built_soundly((bmr_hierarchy_kind)kind, p);
        for (uint32_t id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
            const bmr_node right = h->nodes[id];
            bmr_node wrong[NODE_DAMAGES];
            damage(h, &right, wrong);
            for (int k = 0; k < NODE_DAMAGES; ++k) {
                h->nodes[id] = wrong[k];
                assert_refused(h);
            }
            h->nodes[id] = right;
        }
        ++h->depth;
        assert_refused(h);
        --h->depth;
        --h->count;
        assert_refused(h);
        ++h->count;
        h->kind = 7;
        assert_refused(h);
        h->kind = (uint8_t)kind;
        assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    }
    // No deeper than one of its own edges alone would be, but with more edges.
    own_hierarchy *h = built_soundly(BMR_HIERARCHY_DUDLEY, p);
    h->kind = BMR_HIERARCHY_DOBKIN_KIRKPATRICK;
    assert_true(h->depth <= bmr_tree_most_levels(h));
    assert_refused(h);
}

// --- inflated hierarchies (section 6; entries and widest edges: tests/random/fuzz_hierarchy.cpp) ---

TEST(offsets_shrink_by_the_ratio_and_levels_end_at_the_depth) {
    test_random random = test_random_from(5);
    own_polygon *p = test_polygon(TEST_CIRCLE, 64, &random);
    own_hierarchy *h = test_hierarchy(BMR_HIERARCHY_COMPASS, p);
    const uint32_t depth = bmr_hierarchy_depth(h);
    const bmr_inflation plain = bmr_inflation_make(8.0, 0.5, 0.5, 0);
    const bmr_inflation rich = bmr_inflation_make(8.0, 0.25, 0.8, 2);
    for (uint32_t j = 0; j < 40; ++j) {
        assert_true(bmr_inflation_offset(&plain, j) == ldexp(4.0, -(int)j));
        assert_true(fabs(bmr_inflation_offset(&rich, j) / (2.0 * pow(0.8, j)) - 1.0) < 1e-14);
        assert_int_equal(bmr_inflation_level(&plain, h, j), j < depth ? j : depth);
        assert_int_equal(bmr_inflation_level(&rich, h, j), j + 2 < depth ? j + 2 : depth);
    }
    assert_int_equal(bmr_inflation_last(&plain, h), depth);
    assert_int_equal(bmr_inflation_last(&rich, h), depth - 2);
    const bmr_inflation deep = bmr_inflation_make(8.0, 0.5, 0.5, 99);
    assert_int_equal(bmr_inflation_last(&deep, h), 0);
    assert_int_equal(bmr_inflation_level(&deep, h, 0), depth);
}
