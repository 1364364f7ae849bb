// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_ARM64_CMOCKA_H
#define BMR_TEST_ARM64_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// @file
/// What the tests that run here use of cmocka, of which there is no build for another processor on most
/// machines. A test that fails ends the program.

struct CMUnitTest {
    const char *name;
    void (*run)(void **state);
};
#define cmocka_unit_test(function)                                                                           \
    { #function, function }
#define cmocka_run_group_tests(tests, setup, teardown) run_group_(tests, sizeof(tests) / sizeof *(tests))

static inline int run_group_(const struct CMUnitTest *tests, size_t count) {
    void *state = NULL;
    for (size_t i = 0; i < count; ++i) {
        tests[i].run(&state);
        printf("ok %s\n", tests[i].name);
    }
    return count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#define print_message(...) fprintf(stderr, __VA_ARGS__)
#define fail_msg(...)                                                                                        \
    (fprintf(stderr, __VA_ARGS__), fprintf(stderr, "\n%s:%d: failed\n", __FILE__, __LINE__), exit(1))
#define assert_true(condition) ((condition) ? (void)0 : fail_msg("not so: %s", #condition))
#define assert_false(condition) assert_true(!(condition))
#define assert_int_equal(a, b) assert_true((long long)(a) == (long long)(b))
#define assert_int_not_equal(a, b) assert_true((long long)(a) != (long long)(b))
#define assert_string_equal(a, b) assert_true(strcmp(a, b) == 0)
#define assert_memory_equal(a, b, size) assert_true(memcmp(a, b, size) == 0)
#define assert_non_null(pointer) assert_true((pointer) != NULL)
#define assert_null(pointer) assert_true((pointer) == NULL)

#endif
