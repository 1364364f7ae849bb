// SPDX-License-Identifier: MIT
// What is no line of a budget. (Budgets, motions and lines with numbers of any kind: random/fuzz_budget.cpp.)
#include "checks.h"
#include <float.h>

#include "boomerang/budget.h"

#define UNITS 65536.0

static const bmr_vec2 origin = {0.0, 0.0};
static const double bad_numbers[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, 1e300};
static bmr_pose pose_at(double x, double y) {
    const bmr_pose pose = {{x, y}, 1.0, 0.0};
    return pose;
}

static bmr_mover mover_at(double x, double y, double reach) {
    const bmr_pose pose = pose_at(x, y);
    bmr_mover mover;
    bmr_mover_start(&mover, &pose, origin, reach, UNITS);
    return mover;
}

static void update(bmr_mover *mover, double x, double y) {
    const bmr_pose pose = pose_at(x, y);
    bmr_mover_update(mover, &pose, UNITS);
}

TEST(the_structures_are_as_small_as_they_say) {
    assert_int_equal(sizeof(bmr_mover), 64);
    assert_int_equal(sizeof(bmr_budget_line), 12);
}

/// Two bodies `apart` from pivot to pivot along x, disks of these reaches.
typedef struct pair {
    bmr_mover a, b;
} pair;
static pair pair_at(double apart, double reach) {
    const pair two = {mover_at(0.0, 0.0, reach), mover_at(apart, 0.0, reach)};
    return two;
}
static bmr_budget_line line_of(const pair *two, bmr_vec2 d, double gap) {
    return bmr_budget_line_make(d, gap, &two->a, &two->b, UNITS);
}
static double gap_of(const bmr_budget_line *line, const pair *two) {
    return bmr_budget_line_gap(line, &two->a, &two->b, UNITS);
}
static bool is_none(bmr_budget_line line) {
    return line.normal[0] == 0.0f && line.normal[1] == 0.0f;
}

TEST(there_is_no_line_of_what_no_line_holds) {
    const pair two = pair_at(10.0, 1.0), far = pair_at(2048.5, 1.0), near = pair_at(2047.5, 1.0);
    const bmr_vec2 d = {1.0, 0.0};
    assert_false(is_none(line_of(&two, d, 8.0)));
    assert_true(is_none(line_of(&two, origin, 8.0)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(0x1p-501, 0.0), 0x1p-498)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(0x1p501, 0.0), 0x1p504)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(1e-320, 1e-320), 8.0)));
    for (size_t i = 0; i < COUNT_OF(bad_numbers); ++i) {
        const double bad = bad_numbers[i];
        assert_true(is_none(line_of(&two, bmr_vec2_make(bad, 0.0), 8.0)));
        assert_true(is_none(line_of(&two, bmr_vec2_make(0.0, bad), 8.0)));
        assert_true(is_none(line_of(&two, d, bad)));
        const pair lost = {two.a, mover_at(10.0, bad, 1.0)}, endless = pair_at(10.0, bad);
        assert_true(is_none(line_of(&lost, d, 8.0)));
        assert_true(is_none(line_of(&endless, d, 8.0)));
    }
    assert_true(is_none(line_of(&far, d, 2046.5)));
    assert_false(is_none(line_of(&near, d, 2045.5)));
    assert_true(is_none(line_of(&two, d, 1e6))); // nothing proves that
    assert_true(is_none(line_of(&two, d, -1e6)));
    const bmr_budget_line none = {{0.0f, 0.0f}, 12345u};
    assert_true(gap_of(&none, &two) == 0.0);
    // Nor does a line prove anything of bodies that went too far, or to nowhere.
    pair gone = two;
    const bmr_budget_line line = line_of(&gone, d, 8.0);
    update(&gone.b, 2049.0, 0.0);
    assert_true(gap_of(&line, &gone) == 0.0);
    update(&gone.b, NAN, 0.0);
    assert_true(gap_of(&line, &gone) == 0.0);
}
