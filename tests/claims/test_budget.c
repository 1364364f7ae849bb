// SPDX-License-Identifier: MIT
// Budgets where sums wrap, and what is no line. (Motions of every kind, with numbers of any kind:
// random/fuzz_budget.cpp.)
#include "checks.h"
#include <float.h>

#include "boomerang/budget.h"

#define UNITS 65536.0

static const bmr_vec2 origin = {0.0, 0.0};
static const double bad_numbers[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, 1e300};
/// Where sums begin: at 0, before they wrap, before they would become negative if they were signed.
static const uint32_t beginnings[] = {0u, 1u, UINT32_MAX, UINT32_MAX - 5u, 0x7fffffffu, 0x80000000u};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static bmr_pose pose_at(double x, double y, double angle) {
    const bmr_pose pose = {{x, y}, cos(angle), sin(angle)};
    return pose;
}

static bmr_mover mover_at(double x, double y, double reach) {
    const bmr_pose pose = pose_at(x, y, 0.0);
    bmr_mover mover;
    bmr_mover_start(&mover, &pose, origin, reach, UNITS);
    return mover;
}

static uint32_t look(bmr_mover *mover, double x, double y, double angle) {
    const bmr_pose pose = pose_at(x, y, angle);
    return bmr_mover_look(mover, &pose, UNITS);
}

TEST(the_structures_are_as_small_as_they_say) {
    assert_int_equal(sizeof(bmr_mover), 64);
    assert_int_equal(sizeof(bmr_budget_line), 12);
}

/// Sums a and b, which begin anywhere, go on by `by` together: is the deadline passed?
static bool due_after(double slack, uint32_t a, uint32_t b, uint32_t by) {
    const uint32_t deadline = bmr_budget_deadline(slack, a, b, UNITS);
    return bmr_budget_is_due(deadline, a + by / 3u, b + (by - by / 3u));
}

TEST(a_pair_is_due_when_its_budget_is_used_up_and_stays_so_for_2_to_the_31) {
    const uint32_t budgets[] = {1u, 2u, 3u, 1000u, 1u << 20, BMR_BUDGET_MOST - 1u, BMR_BUDGET_MOST};
    for (size_t i = 0; i < COUNT(beginnings); ++i)
        for (size_t j = 0; j < COUNT(beginnings); ++j)
            for (size_t k = 0; k < COUNT(budgets); ++k) {
                const uint32_t a = beginnings[i], b = beginnings[j], budget = budgets[k];
                // A slack of half a unit more: whole units count.
                const double slack = ((double)budget + 0.5) / UNITS;
                assert_false(due_after(slack, a, b, 0u));
                assert_false(due_after(slack, a, b, budget - 1u));
                assert_true(due_after(slack, a, b, budget));
                for (uint32_t by = 1u; by <= 1u << 30; by <<= 1)
                    assert_true(due_after(slack, a, b, budget + by));
                assert_true(due_after(slack, a, b, 0x80000000u));
                // The header's limit is a limit: a deadline that nobody asked for comes round again.
                assert_false(due_after(slack, a, b, 0x80000000u + budget + 1u));
            }
}

TEST(what_does_not_move_adds_nothing_and_what_does_adds_its_way_and_its_turning) {
    bmr_mover mover = mover_at(1.0, 2.0, 3.0);
    const uint32_t begin = mover.moved = mover.turned = UINT32_MAX - 1000u;
    assert_int_equal(look(&mover, 1.0, 2.0, 0.0), 0);
    const bmr_pose signs = {{1.0, 2.0}, 1.0, -0.0};
    assert_int_equal(bmr_mover_look(&mover, &signs, UNITS), 0);
    assert_int_equal(mover.moved, begin);
    assert_int_equal(look(&mover, 4.0, 6.0, 0.0), 5 * 65536 + 1);
    assert_int_equal(mover.turned, begin); // a way is no turning
    // By half a turn all of it goes to the other side of its pivot.
    const bmr_pose half = {{4.0, 6.0}, -1.0, 0.0};
    assert_int_equal(bmr_mover_look(&mover, &half, UNITS), 6 * 65536 + 1);
    assert_int_equal(mover.turned - begin, 6 * 65536 + 1);
    assert_int_equal(mover.moved - begin, 11 * 65536 + 2);
    // A hair: nothing is too small to count.
    for (uint32_t i = 1; i <= 1000; ++i)
        assert_int_equal(look(&mover, 4.0, 6.0 + 1e-12 * i, i == 1 ? 0.0 : 1e-15 * i), i == 1 ? 393217 : 1);
}

/// Two bodies `apart` from pivot to pivot along x, disks of these reaches.
typedef struct couple {
    bmr_mover a, b;
} couple;
static couple couple_at(double apart, double reach) {
    const couple two = {mover_at(0.0, 0.0, reach), mover_at(apart, 0.0, reach)};
    return two;
}
static bmr_budget_line line_of(const couple *two, bmr_vec2 d, double gap) {
    return bmr_budget_line_make(d, gap, &two->a, &two->b, UNITS);
}
static double gap_of(const bmr_budget_line *line, const couple *two) {
    return bmr_budget_line_gap(line, &two->a, &two->b, UNITS);
}
static bool is_none(bmr_budget_line line) {
    return line.normal[0] == 0.0f && line.normal[1] == 0.0f;
}

TEST(there_is_no_line_of_what_no_line_holds) {
    const couple two = couple_at(10.0, 1.0), far = couple_at(2048.5, 1.0), near = couple_at(2047.5, 1.0);
    const bmr_vec2 d = {1.0, 0.0};
    assert_false(is_none(line_of(&two, d, 8.0)));
    assert_true(is_none(line_of(&two, origin, 8.0)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(0x1p-501, 0.0), 0x1p-498)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(0x1p501, 0.0), 0x1p504)));
    assert_true(is_none(line_of(&two, bmr_vec2_make(1e-320, 1e-320), 8.0)));
    for (size_t i = 0; i < COUNT(bad_numbers); ++i) {
        const double bad = bad_numbers[i];
        assert_true(is_none(line_of(&two, bmr_vec2_make(bad, 0.0), 8.0)));
        assert_true(is_none(line_of(&two, bmr_vec2_make(0.0, bad), 8.0)));
        assert_true(is_none(line_of(&two, d, bad)));
        const couple lost = {two.a, mover_at(10.0, bad, 1.0)}, endless = couple_at(10.0, bad);
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
    couple gone = two;
    const bmr_budget_line line = line_of(&gone, d, 8.0);
    look(&gone.b, 2049.0, 0.0, 0.0);
    assert_true(gap_of(&line, &gone) == 0.0);
    look(&gone.b, NAN, 0.0, 0.0);
    assert_true(gap_of(&line, &gone) == 0.0);
}

TEST(a_line_that_proves_nothing_never_becomes_one_that_does_by_standing_still) {
    // Deep in each other and far from each other along d: sums of two such numbers must not wrap.
    const bmr_vec2 d = {1.0, 0.0};
    for (double way = 100.0; way < 40000.0; way *= 1.25)
        for (double gap = -100.0; gap > -40000.0; gap *= 1.25) {
            couple two = couple_at(way, 1e6);
            const bmr_budget_line line = line_of(&two, d, gap);
            look(&two.b, -way, 0.0, 0.0);
            assert_true(gap_of(&line, &two) <= 0.0);
            two.b.turned += 0x80000000u - BMR_BUDGET_MARK;
            assert_true(gap_of(&line, &two) <= 0.0);
        }
}

TEST(a_line_says_nothing_wrong_until_turning_has_gone_on_by_its_limit) {
    const bmr_vec2 d = {1.0, 0.0};
    const uint32_t limit = 0x80000000u - BMR_BUDGET_MARK;
    for (size_t i = 0; i < COUNT(beginnings); ++i)
        for (int sign = -1; sign <= 1; sign += 2) {
            couple two = couple_at(2047.0 * sign, 4000.0);
            two.a.turned = beginnings[i];
            // The lowest and the highest number that a line holds at its start.
            const bmr_budget_line line = line_of(&two, d, sign > 0 ? 1.0 : -1.0);
            assert_false(is_none(line));
            look(&two.b, 2046.0, 0.0, 0.0);
            const double begin = gap_of(&line, &two);
            two.a.turned += limit;
            assert_true(gap_of(&line, &two) < 0.0);
            assert_true(gap_of(&line, &two) == begin - (double)limit / UNITS);
        }
    // Beyond, it comes round.
    couple two = couple_at(2047.0, 4000.0);
    const bmr_budget_line line = line_of(&two, d, 1.0);
    two.a.turned += 0x80000000u;
    assert_true(gap_of(&line, &two) > 0.0);
}
