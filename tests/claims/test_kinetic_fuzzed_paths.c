// SPDX-License-Identifier: MIT
// The fuzzers' motions keep the contract of motion.h: rotations whose a and b have a common root are taken
// out, wherever in the range it is, and those that only come near to one are left in.
#include "../random/paths.h"
#include "boomerang/failure.h"
#include "checks.h"

/// Looks are 0.04 apart here.
static const fuzz_motion_range within = {.reach = 3.0, .speed = 2.0, .spin = 6.0, .begin = 0.0, .end = 4.0};

/// a and b from the highest coefficient to the lowest, as long as `degree` says; counted from `origin`.
static bmr_motion_piece rotation(double origin, size_t degree, const double *a, const double *b) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = origin;
    piece.as.algebraic.start_c = 1.0;
    piece.as.algebraic.rotation_degree = degree;
    for (size_t k = 0; k <= degree; k++) {
        piece.as.algebraic.a[degree - k] = a[k];
        piece.as.algebraic.b[degree - k] = b[k];
    }
    return piece;
}

/// a = root - u, and b the same times `ratio`, but for a miss.
static bmr_motion_piece passing(double origin, double root, double ratio, double miss) {
    const double a[] = {-1.0, root}, b[] = {-ratio, ratio * root + miss};
    return rotation(origin, 1, a, b);
}

static bool stays(bmr_motion_piece piece, const fuzz_motion_range *range) {
    const bmr_algebraic_piece before = piece.as.algebraic, *const w = &piece.as.algebraic;
    fuzz_tame(&piece, range);
    bool same = w->rotation_degree == before.rotation_degree;
    for (size_t k = 0; k <= BMR_MOTION_MAX_DEGREE; k++)
        same = same && w->a[k] == before.a[k] && w->b[k] == before.b[k];
    assert_true(same || (w->rotation_degree == 0 && w->a[0] == 1.0 && w->b[0] == 0.0));
    return same;
}

TEST(a_common_root_is_taken_out_wherever_it_is) {
    const double roots[] = {0.0, 1e-9, 0.01, 0.0863, 0.1, 0.25, 0.34, 1.234, 3.99, 4.0};
    const double ratios[] = {0.0, 1.0, -1.0, 0.3, -7.7, 1e-7};
    for (size_t i = 0; i < sizeof roots / sizeof *roots; i++)
        for (size_t j = 0; j < sizeof ratios / sizeof *ratios; j++)
            for (int k = 0; k < 5; k++)
                assert_false(stays(passing(0.7 * k, roots[i] - 0.7 * k, ratios[j], 0.0), &within));
}

/// (u - r)^2 (u + 1) and (u - r)^2 (u + 2); (u - r)(u - 9) and (u - r)(u + 9).
TEST(so_is_one_of_many) {
    for (int i = 0; i < 30; i++) {
        const double r = 0.0137 * i;
        const double twice_a[] = {1.0, 1.0 - 2.0 * r, r * r - 2.0 * r, r * r};
        const double twice_b[] = {1.0, 2.0 - 2.0 * r, r * r - 4.0 * r, 2.0 * r * r};
        assert_false(stays(rotation(0.0, 3, twice_a, twice_b), &within));
        const double once_a[] = {1.0, -r - 9.0, 9.0 * r}, once_b[] = {1.0, 9.0 - r, -9.0 * r};
        assert_false(stays(rotation(0.0, 2, once_a, once_b), &within));
    }
}

/// The control: without the rule the looks see only what is near to one of them.
TEST(looks_alone_miss_it) {
    fuzz_motion_range without = within;
    without.roots = true;
    assert_true(stays(passing(0.0, 0.0863, 1.0, 0.0), &without));
    assert_false(stays(passing(0.0, 0.08, 1.0, 0.0), &without));
}

/// What the contract allows stays, and the search for a failure past it ends without an error.
TEST(what_only_comes_near_is_left_in) {
    const bmr_motion_piece spin = bmr_piece_screw(0.0, bmr_pose_identity(), bmr_vec2_make(-1.0, 0.0), 5.0);
    const bmr_condition k =
        bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), -9.0, bmr_vec2_make(0.3, 0.2), 0);
    const bmr_failure_options options = bmr_default_failure_options();
    for (int power = -10; power <= -2; power++) {
        const bmr_motion_piece piece = passing(0.0, 0.0863, 1.0, pow(10.0, power));
        assert_true(stays(piece, &within));
        own_motion *a = made_motion(piece), *b = made_motion(spin);
        double time = -1.0;
        assert_int_equal(bmr_failure_time(&k, a, b, 0.0, 4.0, &options, &time), BMR_OK);
        assert_int_equal(bmr_failure_time(&k, b, a, 0.0, 4.0, &options, &time), BMR_OK);
    }
    // Roots outside the range, a root of one alone, no rotation.
    assert_true(stays(passing(0.0, -0.5, 1.0, 0.0), &within));
    assert_true(stays(passing(0.0, 4.5, 1.0, 0.0), &within));
    assert_true(stays(passing(2.0, -2.5, 1.0, 0.0), &within));
    assert_true(stays(passing(2.0, 2.5, 1.0, 0.0), &within));
    assert_true(stays(passing(0.0, 0.0863, 0.0, 1.0), &within));
    const double fixed_a = 0.6, fixed_b = 0.8;
    assert_true(stays(rotation(0.0, 0, &fixed_a, &fixed_b), &within));
}
