// SPDX-License-Identifier: MIT
#include "checks.h"
#include "compass_fixture.h"
#include "mixed_scene.h"

/// @file
/// The mixed hierarchy against brute force over all tiles: what lies across each side. That they tile, and
/// which holds a point: tests/random/mixed.cpp. What section 4 says of their number: test_claims_mixed.c.

/// Brute force: in how many tiles is x, the last one, and how far is x from the border of any.
typedef struct cover {
    uint32_t count, tile;
    double clearance;
} cover;

static bool is_in_box(const bmr_vec2 *p, size_t count, bmr_vec2 x) {
    bmr_vec2 low = p[0], high = p[0];
    for (size_t k = 1; k < count; ++k) {
        low = bmr_vec2_make(fmin(low.x, p[k].x), fmin(low.y, p[k].y));
        high = bmr_vec2_make(fmax(high.x, p[k].x), fmax(high.y, p[k].y));
    }
    return low.x <= x.x && x.x <= high.x && low.y <= x.y && x.y <= high.y;
}

static cover cover_of(const scene *s, bmr_vec2 x) {
    cover c = {0, BMR_MIXED_NO_TILE, INFINITY};
    for (uint32_t i = 0; i < bmr_mixed_tiling_count(s->tiling); ++i) {
        bmr_vec2 p[BMR_MIXED_MAX_SIDES];
        const size_t count = bmr_mixed_polygon(&s->mixed, bmr_mixed_tiling_cell(s->tiling, i), p);
        // A sliver of nothing but rounding has no inside, but may have half planes that meet far away.
        bool inside = is_in_box(p, count, x);
        for (size_t k = 0; k < count; ++k) {
            const bmr_vec2 e = bmr_sub(p[(k + 1) % count], p[k]), r = bmr_sub(x, p[k]);
            const double length = hypot(e.x, e.y), along = bmr_dot(r, e);
            inside &= bmr_cross(e, r) > 0.0 || length == 0.0;
            if (length > 0.0 && along > -1e-9 && along < length * length + 1e-9)
                c.clearance = fmin(c.clearance, fabs(bmr_cross(e, r)) / length);
        }
        c.count += inside;
        c.tile = inside ? i : c.tile;
    }
    return c;
}

// --- neighbours ---

/// Lemma 4.3: the neighbour of a cell at a point of its border is found in O(log n).
TEST(across_each_side_lies_the_tile_that_brute_force_finds) {
    test_random random = {405};
    size_t compared = 0, inwards = 0, wrong_role = 0;
    unsigned most = 0;
    for (size_t round = 0; round < test_scaled(60); ++round) {
        const size_t n = 3 + test_random_below(&random, 30), m = 3 + test_random_below(&random, 30);
        own_scene s = random_scene(kinds[round % 2], n, m, &random);
        const uint32_t tiles = bmr_mixed_tiling_count(s.tiling);
        for (int k = 0; k < 100 && tiles > 0; ++k) {
            const uint32_t tile = test_random_below(&random, tiles);
            const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(s.tiling, tile);
            bmr_mixed_side sides[BMR_MIXED_MAX_SIDES];
            bmr_vec2 p[BMR_MIXED_MAX_SIDES];
            const size_t count = bmr_mixed_sides(&s.mixed, cell, sides);
            assert_int_equal(bmr_mixed_polygon(&s.mixed, cell, p), count);
            const size_t i = test_random_below(&random, (uint32_t)count);
            const bmr_vec2 e = bmr_sub(p[(i + 1) % count], p[i]);
            const double length = hypot(e.x, e.y);
            if (length < 1e-6 * size_of(&s))
                continue;
            const bmr_vec2 out = bmr_vec2_make(e.y / length, -e.x / length);
            const bmr_vec2 x = bmr_add(p[i], bmr_scale(test_random_uniform(&random, 0.001, 0.999), e));
            const bmr_vec2 beyond = bmr_add(x, bmr_scale(1e-9 * size_of(&s), out));
            assert_true(fabs(bmr_mixed_side_value(&s.mixed, &sides[i], x)) <= 1e-12 * size_of(&s));
            assert_true(bmr_mixed_side_value(&s.mixed, &sides[i], beyond) < 0.0);
            const cover c = cover_of(&s, beyond);
            if (c.clearance < 1e-12 * size_of(&s) || (c.count == 0 && sides[i].role == BMR_MIXED_INNER))
                continue; // on another border; or into the sum, or a sliver before it
            const bmr_mixed_ray ray = {x, out};
            const bmr_mixed_role role = (bmr_mixed_role)sides[i].role;
            unsigned touched = 0;
            const bmr_mixed_cell next = bmr_mixed_next(&s.mixed, cell, role, &ray, &touched);
            const uint32_t found = bmr_mixed_tiling_find(s.tiling, &next);
            if (found != c.tile) { // a sliver may lie between
                bmr_mixed_cell there = next;
                assert_true(bmr_mixed_walk(&s.mixed, &there, x, beyond, NULL));
                assert_int_equal(bmr_mixed_tiling_find(s.tiling, &there), c.tile);
                continue;
            }
            // O(j): not more stages than lie between the two.
            const int32_t from = bmr_mixed_stage(&s.mixed, cell), to = bmr_mixed_stage(&s.mixed, &next);
            assert_true((int32_t)touched <= 1 + (to > from ? to - from : 0));
            most = touched > most ? touched : most;
            if (role == BMR_MIXED_INNER) {
                uint32_t below;
                const uint32_t *list = bmr_mixed_tiling_below(s.tiling, tile, &below);
                bool listed = false;
                for (uint32_t j = 0; j < below; ++j)
                    listed |= list[j] == found;
                assert_true(listed);
                ++inwards;
            } else {
                assert_int_equal(bmr_mixed_tiling_across(s.tiling, tile, role), found);
                // control: through another side it would be another tile
                const bmr_mixed_role other = role == BMR_MIXED_LOW ? BMR_MIXED_HIGH : BMR_MIXED_LOW;
                wrong_role += bmr_mixed_tiling_across(s.tiling, tile, other) != found;
            }
            ++compared;
        }
    }
    printf("compared %zu sides, %zu of them inwards; at most %u stages looked at\n", compared, inwards, most);
    assert_true(inwards > 0 && compared > inwards && wrong_role > 0);
}
