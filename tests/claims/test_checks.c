// SPDX-License-Identifier: MIT
// Checks of kit/checks.h fail where they must: each one below is wrong, and its test ends there.
#define CHECKS_OWN_MAIN
#include "checks.h"

static int ended_late, right;

#define WRONG(name, check)                                                                                   \
    TEST(wrong_##name) {                                                                                     \
        check;                                                                                               \
        ended_late++;                                                                                        \
    }
WRONG(condition, assert_true(1 > 2))
WRONG(negation, assert_false(2 > 1))
WRONG(equality, assert_int_equal(-1, UINT32_MAX))
WRONG(inequality, assert_int_not_equal(3, 3))
WRONG(text, assert_string_equal("a", "b"))
WRONG(other_text, assert_string_not_equal("a", "a"))
WRONG(bytes, assert_memory_equal("ab", "ac", 2))
WRONG(other_bytes, assert_memory_not_equal("ab", "ac", 1))
WRONG(place, assert_ptr_equal(&right, &ended_late))
WRONG(other_place, assert_ptr_not_equal(&right, &right))
WRONG(nothing, assert_null(&right))
WRONG(something, assert_non_null(NULL))
WRONG(below, assert_float_equal(1.0f, 2.0f, 0.5f))
WRONG(above, assert_float_equal(2.0f, 1.0f, 0.5f))
WRONG(not_a_number, assert_float_equal(0.0f, strtof("nan", NULL), 0.5f))
WRONG(range, assert_in_range(4, 1, 3))
WRONG(end, fail_msg("%d", 1))

TEST(right_after_those_that_failed) {
    right++;
}

int main(void) {
    int failures = 0, tests = 0;
    for (const check_test *test = check_tests; test; test = test->next, tests++)
        failures += check_run(test->name) != EXIT_SUCCESS;
    const bool sound = tests == 18 && failures == 17 && ended_late == 0 && right == 1 &&
                       check_run("") != EXIT_SUCCESS && right == 2 && check_run("none") != EXIT_SUCCESS &&
                       check_run("right") == EXIT_SUCCESS;
    printf("%d of %d failed, %d ended late, %d right\n", failures, tests, ended_late, right);
    return sound ? EXIT_SUCCESS : EXIT_FAILURE;
}
