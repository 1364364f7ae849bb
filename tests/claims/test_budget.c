// SPDX-License-Identifier: MIT
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
    const bool due = bmr_budget_is_due(deadline, a + by / 3u, b + (by - by / 3u));
    const uint32_t left = bmr_budget_left(deadline, a + by / 3u, b + (by - by / 3u));
    assert_int_equal(due, left == 0);
    assert_true(due || left <= BMR_BUDGET_MOST || by > 0x80000000u);
    return due;
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

TEST(no_slack_is_due_at_once_and_no_slack_counts_for_more_than_the_most) {
    const double none[] = {0.0, -0.0, -1.0, -1e300, -INFINITY, NAN, 0.999 / UNITS, DBL_MIN, DBL_TRUE_MIN};
    for (size_t i = 0; i < COUNT(none); ++i)
        assert_true(due_after(none[i], 7u, 8u, 0u));
    const double much[] = {(double)BMR_BUDGET_MARK / UNITS, 1e10, 1e300, DBL_MAX, INFINITY};
    for (size_t i = 0; i < COUNT(much); ++i) {
        assert_int_equal(bmr_budget_deadline(much[i], 0u, 0u, UNITS), BMR_BUDGET_MOST);
        assert_true(due_after(much[i], 1u, 2u, BMR_BUDGET_MARK));
    }
    assert_int_equal(bmr_budget_deadline(1.0 / UNITS / (1.0 - BMR_BUDGET_ROUNDING), 0u, 0u, UNITS), 1u);
}

TEST(a_mark_makes_every_pair_of_the_body_due) {
    for (size_t i = 0; i < COUNT(beginnings); ++i) {
        bmr_mover a = mover_at(0.0, 0.0, 1.0);
        const uint32_t other = beginnings[COUNT(beginnings) - 1 - i];
        a.moved = beginnings[i];
        const uint32_t deadline = bmr_budget_deadline(INFINITY, a.moved, other, UNITS);
        assert_false(bmr_budget_is_due(deadline, a.moved, other));
        for (int marks = 1; marks <= 15; ++marks) {
            bmr_mover_mark(&a);
            assert_true(bmr_budget_is_due(deadline, a.moved, other));
        }
        bmr_mover_mark(&a); // the 16th is beyond 2^31 less the budget; after the 17th it has come round
        bmr_mover_mark(&a);
        assert_false(bmr_budget_is_due(deadline, a.moved, other));
    }
}

TEST(a_motion_counts_for_more_than_it_is) {
    assert_int_equal(bmr_budget_motion(0.0, UNITS), 1);
    assert_int_equal(bmr_budget_motion(DBL_TRUE_MIN, UNITS), 1);
    assert_int_equal(bmr_budget_motion(0.5, 1.0), 1);
    assert_int_equal(bmr_budget_motion(1.0, 1.0), 2);
    assert_int_equal(bmr_budget_motion(nextafter(1.0, 0.0), 1.0), 2); // one that rounding may have made less
    assert_int_equal(bmr_budget_motion(2.5, 2.0), 6);
    assert_int_equal(bmr_budget_motion((double)BMR_BUDGET_MARK - 1.5, 1.0), BMR_BUDGET_MARK - 1u);
    assert_int_equal(bmr_budget_motion((double)BMR_BUDGET_MARK - 1.0, 1.0), BMR_BUDGET_MARK);
    assert_int_equal(bmr_budget_motion((double)BMR_BUDGET_MARK, 1.0), BMR_BUDGET_MARK);
    for (size_t i = 0; i < COUNT(bad_numbers); ++i)
        assert_int_equal(bmr_budget_motion(bad_numbers[i], UNITS), BMR_BUDGET_MARK);
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

/// What a look adds where one number of the body or its pose is not a number that can be: the k-th of 7.
static uint32_t look_with(size_t k, double bad, bmr_mover *mover) {
    bmr_pose pose = pose_at(1.0, 1.0, 0.5);
    double *numbers[] = {&pose.position.x, &pose.position.y, &pose.c,      &pose.s,
                         &mover->pivot.x,  &mover->pivot.y,  &mover->reach};
    *numbers[k] = bad;
    return bmr_mover_look(mover, &pose, UNITS);
}

TEST(numbers_that_cannot_be_are_motions_that_no_budget_outlasts) {
    for (size_t k = 0; k < 7; ++k)
        for (size_t i = 0; i < COUNT(bad_numbers); ++i) {
            bmr_mover mover = mover_at(1.0, 1.0, 1.0), other = mover_at(9.0, 9.0, 1.0);
            const uint32_t deadline = bmr_budget_deadline(INFINITY, mover.moved, other.moved, UNITS);
            assert_int_equal(look_with(k, bad_numbers[i], &mover), BMR_BUDGET_MARK);
            assert_true(bmr_budget_is_due(deadline, mover.moved, other.moved));
            // And so is the way back.
            const uint32_t again = bmr_budget_deadline(INFINITY, mover.moved, other.moved, UNITS);
            assert_int_equal(look(&mover, 1.0, 1.0, 0.0), BMR_BUDGET_MARK);
            assert_true(bmr_budget_is_due(again, mover.moved, other.moved));
        }
    bmr_mover negative = mover_at(1.0, 1.0, -1.0);
    assert_int_equal(look(&negative, 3.0, 1.0, 0.1), BMR_BUDGET_MARK);
    // So far away that nobody knows by how much it moved.
    bmr_mover far = mover_at(0x1p31, 0.0, 1.0);
    assert_int_equal(look(&far, 0x1p31, 0.0, 0.0), BMR_BUDGET_MARK);
}

TEST(units_may_be_as_small_as_numbers_go) {
    // A way of 1000 units, whose square is no number above 0 before it is in units.
    const double units = 1e200, way = 1e-197;
    const bmr_pose from = {{0.0, 0.0}, 1.0, 0.0}, to = {{way, 0.0}, 1.0, 0.0};
    bmr_mover mover;
    bmr_mover_start(&mover, &from, origin, 0.0, units);
    assert_true(bmr_mover_sweep(&mover, to.position, to.position, 0.0, units) > 999);
    assert_in_range(bmr_mover_look(&mover, &to, units), 1000, 1001);
}

TEST(reaches_grow_and_never_shrink) {
    bmr_mover mover = mover_at(0.0, 0.0, 1.0);
    bmr_mover_extend(&mover, 0.5);
    assert_true(mover.reach == 1.0);
    bmr_mover_extend(&mover, 2.0);
    assert_true(mover.reach == 2.0);
    assert_int_equal(mover.moved, 0);
    bmr_mover_extend(&mover, NAN);
    bmr_mover_extend(&mover, 3.0);
    assert_true(mover.reach != mover.reach);
    assert_int_equal(look(&mover, 0.0, 0.0, 0.1), BMR_BUDGET_MARK);
}

TEST(a_sweep_is_the_farther_end_and_the_arc) {
    const bmr_mover mover = mover_at(1.0, 1.0, 2.0);
    const bmr_vec2 near = {1.0, 2.0}, far = {4.0, 5.0};
    assert_int_equal(bmr_mover_sweep(&mover, mover.center, mover.center, 0.0, UNITS), 1);
    assert_int_equal(bmr_mover_sweep(&mover, near, far, 0.0, UNITS), 5 * 65536 + 1);
    assert_int_equal(bmr_mover_sweep(&mover, far, near, 0.0, UNITS), 5 * 65536 + 1);
    assert_int_equal(bmr_mover_sweep(&mover, near, far, -0.5, UNITS), 6 * 65536 + 1);
    // However often it turns: no point comes farther than to the other side.
    assert_int_equal(bmr_mover_sweep(&mover, near, far, 100.0, UNITS), 9 * 65536 + 1);
    for (size_t i = 0; i < COUNT(bad_numbers); ++i) {
        const double bad = bad_numbers[i];
        assert_int_equal(bmr_mover_sweep(&mover, bmr_vec2_make(bad, 1.0), far, 0.0, UNITS), BMR_BUDGET_MARK);
        assert_int_equal(bmr_mover_sweep(&mover, bmr_vec2_make(1.0, bad), far, 0.0, UNITS), BMR_BUDGET_MARK);
        assert_int_equal(bmr_mover_sweep(&mover, far, bmr_vec2_make(bad, 1.0), 0.0, UNITS), BMR_BUDGET_MARK);
        assert_int_equal(bmr_mover_sweep(&mover, far, bmr_vec2_make(1.0, bad), 0.0, UNITS), BMR_BUDGET_MARK);
    }
    assert_int_equal(bmr_mover_sweep(&mover, near, far, NAN, UNITS), BMR_BUDGET_MARK);
    const bmr_mover lost = mover_at(NAN, 1.0, 2.0);
    assert_int_equal(bmr_mover_sweep(&lost, near, far, 0.0, UNITS), BMR_BUDGET_MARK);
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

TEST(a_line_is_used_up_by_turning_and_by_coming_nearer_and_by_nothing_else) {
    couple two = couple_at(10.0, 1.0);
    two.a.turned = UINT32_MAX - 3u;
    two.b.turned = 0x7fffffffu;
    const bmr_vec2 d = {1.0, 0.0};
    const bmr_budget_line line = line_of(&two, d, 8.0);
    const double unit = 1.0 / UNITS;
    assert_true(gap_of(&line, &two) <= 8.0 && gap_of(&line, &two) > 8.0 - 4.0 * unit);
    for (int step = 1; step <= 10000; ++step) // side by side for ever
        look(&two.b, 10.0, 0.1 * step, 0.0);
    assert_true(gap_of(&line, &two) > 8.0 - 4.0 * unit);
    bmr_mover_mark(&two.a);
    assert_true(gap_of(&line, &two) > 8.0 - 4.0 * unit);
    look(&two.b, 30.0, 1000.0, 0.0);
    assert_true(gap_of(&line, &two) > 28.0 - 6.0 * unit && gap_of(&line, &two) <= 28.0);
    look(&two.a, 5.0, 0.0, 0.0);
    assert_true(gap_of(&line, &two) > 23.0 - 6.0 * unit && gap_of(&line, &two) <= 23.0);
    look(&two.a, 5.0, 0.0, 1.0);
    look(&two.b, 30.0, 1000.0, -1.0);
    const double turning = 4.0 * sin(0.5);
    assert_true(gap_of(&line, &two) <= 23.0 - turning && gap_of(&line, &two) > 23.0 - turning - 9.0 * unit);
    look(&two.b, 5.0, 0.0, -1.0);
    assert_true(gap_of(&line, &two) <= -2.0 - turning);
}

TEST(the_length_of_a_lines_direction_does_not_matter) {
    const double lengths[] = {0x1p-499, 1e-100, 1e-7, 0.5, 1.0, 2.0, 3e5, 1e100, 0x1p499};
    const couple two = couple_at(1000.0, 300.0);
    for (size_t i = 0; i < COUNT(lengths); ++i) {
        const bmr_vec2 d = {0.6 * lengths[i], 0.8 * lengths[i]};
        const bmr_budget_line line = line_of(&two, d, -10.0 * lengths[i]);
        const double nx = (double)line.normal[0], ny = (double)line.normal[1];
        assert_true(nx * nx + ny * ny <= 1.0 && nx * nx + ny * ny > 1.0 - 1e-6);
        assert_true(gap_of(&line, &two) <= -10.0 * hypot(nx, ny) && gap_of(&line, &two) > -10.001);
    }
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

TEST(no_turn_is_too_large_for_a_line_to_notice) {
    // A needle of 10,000 lengths: turned by half it is 20,000 lengths elsewhere, more than any count holds.
    const bmr_vec2 d = {1.0, 0.0};
    for (int both = 0; both <= 1; ++both) {
        couple two = couple_at(-1000.0, 1e4);
        const bmr_budget_line line = line_of(&two, d, 1.0); // by what lies far in front of their pivots
        look(&two.b, 3000.0, 0.0, 0.0);                     // parted by as much as can be
        look(&two.a, 953.0, 0.0, 0.0);
        assert_true(gap_of(&line, &two) > 3047.0);
        const bmr_pose half_a = {{953.0, 0.0}, -1.0, 0.0}, half_b = {{3000.0, 0.0}, -1.0, 0.0};
        bmr_mover_look(&two.b, &half_b, UNITS);
        if (both)
            bmr_mover_look(&two.a, &half_a, UNITS);
        assert_true(gap_of(&line, &two) <= 0.0);
    }
    // The same where the turn is no number.
    couple two = couple_at(2047.0, 1.0);
    const bmr_budget_line line = line_of(&two, d, 2045.0);
    look(&two.b, 2047.0, 0.0, NAN);
    look(&two.b, 2047.0, 0.0, 0.0);
    assert_true(gap_of(&line, &two) <= 0.0);
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
