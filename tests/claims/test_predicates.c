// SPDX-License-Identifier: MIT
#include "checks.h"
#include "geometry/predicates.h"
#include "polygons.h"
#include "test_scale.h"

static int naive_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const double d = bmr_cross(bmr_sub(b, a), bmr_sub(c, a));
    return (d > 0.0) - (d < 0.0);
}

typedef int (*orientation_function)(bmr_vec2, bmr_vec2, bmr_vec2);

/// Points a few ulps around (1/2, 1/2) against the line y = x: the sign is that of j - i.
static int wrong_signs_near_diagonal(orientation_function orientation, double scale) {
    const double ulp = 0x1p-53;
    const bmr_vec2 b = {12.0 * scale, 12.0 * scale}, c = {24.0 * scale, 24.0 * scale};
    int wrong = 0;
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) {
            const bmr_vec2 a = {scale * (0.5 + (double)i * ulp), scale * (0.5 + (double)j * ulp)};
            wrong += orientation(a, b, c) != (j > i) - (j < i);
        }
    return wrong;
}

TEST(orientation_is_exact_where_rounding_decides) {
    // 2^-1000 and 2^1000 make every product underflow or overflow.
    const double scales[] = {1.0, 0x1p25, 0x1p-200, 0x1p-1000, 0x1p1000};
    for (size_t i = 0; i < COUNT_OF(scales); ++i)
        assert_int_equal(wrong_signs_near_diagonal(bmr_orientation, scales[i]), 0);
    // Control: the plain formula fails the same check.
    assert_true(wrong_signs_near_diagonal(naive_orientation, 1.0) > 100);
}

TEST(orientation_sees_denormals) {
    const double tiny = 0x1p-1074;
    const bmr_vec2 o = {0.0, 0.0}, far = {1.0, 1.0};
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(tiny, 2.0 * tiny)), 1);
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(2.0 * tiny, tiny)), -1);
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(3.0 * tiny, 3.0 * tiny)), 0);
    assert_int_equal(bmr_orientation(bmr_vec2_make(1e9, tiny), o, bmr_vec2_make(-1e9, 0.0)), -1);
    assert_int_equal(bmr_orientation(bmr_vec2_make(tiny, 0.0), bmr_vec2_make(0.0, tiny), o), 1);
    assert_int_equal(naive_orientation(bmr_vec2_make(tiny, 0.0), bmr_vec2_make(0.0, tiny), o), 0); // control
}

TEST(orientation_is_cyclic_and_antisymmetric) {
    test_random random = {7};
    for (size_t round = 0; round < test_scaled(20000); ++round) {
        bmr_vec2 p[3];
        for (int i = 0; i < 3; ++i) // coarse mantissas make collinear triples common, exponents wild
            p[i] = bmr_vec2_make(
                ldexp((double)test_random_below(&random, 16) - 8.0, (int)test_random_below(&random, 4)),
                ldexp((double)test_random_below(&random, 16) - 8.0, (int)test_random_below(&random, 4)));
        const int o = bmr_orientation(p[0], p[1], p[2]);
        assert_int_equal(o,
                         naive_orientation(p[0], p[1], p[2])); // small integers: the plain formula is exact
        assert_int_equal(o, bmr_orientation(p[1], p[2], p[0]));
        assert_int_equal(o, -bmr_orientation(p[1], p[0], p[2]));
        assert_int_equal(bmr_orientation(p[0], p[1], p[1]), 0);
    }
}
