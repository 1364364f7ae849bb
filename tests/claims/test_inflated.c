// SPDX-License-Identifier: MIT
// The geometry of inflated hierarchies (section 6). Entries and widest edges:
// tests/random/fuzz_hierarchy.cpp.
#include "boomerang/inflated.h"
#include "checks.h"
#include "compass_fixture.h"
#include "geometry/distance.h"
#include "test_scale.h"

TEST(offsets_shrink_by_the_ratio_and_levels_end_at_the_depth) {
    test_random random = {5};
    own_polygon *p = test_polygon(TEST_CIRCLE, 64, &random);
    own_hierarchy *h = built(BMR_HIERARCHY_COMPASS, p);
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

/// Lemma compass (a), as section 6 uses it.
TEST(compass_offsets_cover_the_heights) {
    test_random random = {9};
    bool half_is_needed = false;
    for (size_t round = 0; round < test_scaled(3); ++round)
        for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
            for (size_t n = 4; n <= 256; n *= 4) {
                own_polygon *p = test_polygon((test_family)family, n, &random);
                own_hierarchy *h = built(BMR_HIERARCHY_COMPASS, p);
                const double diameter = bmr_inflation_diameter(p);
                assert_true(diameter >= test_diameter(p) * (1.0 - 1e-12));
                assert_true(diameter <= test_diameter(p) * 1.1548);
                const bmr_inflation half = bmr_inflation_make(diameter, 0.5, 0.5, 0);
                for (uint32_t j = 0; j <= bmr_hierarchy_depth(h) && (1u << j) <= p->count; ++j) {
                    const double height = bmr_envelope_height(h, j);
                    assert_true(height <= bmr_inflation_offset(&half, j) * (1.0 + 1e-9));
                    // The control: with alpha a quarter it is false somewhere.
                    half_is_needed = half_is_needed || height > 0.5 * bmr_inflation_offset(&half, j);
                }
            }
    assert_true(half_is_needed);
}
