// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_CHECKS_H
#define BMR_TEST_CHECKS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boomerang/error.h"
#include "random.h"
#include "test_scale.h"

/// @file
/// Tests in C: a program is one source that includes this header, `main` is here. TEST(name) { ... } is a
/// test, and needs no list. A check that fails ends its test, which says how to run it again; the program
/// goes on with the next, and fails in the end. `PROGRAM PART` runs the tests whose names have this part. No
/// test at all is a failure.

typedef struct check_test {
    const char *name;
    void (*run)(void);
    int line;
    struct check_test *next;
} check_test;

static check_test *check_tests;
static jmp_buf check_leave;
/// The same numbers for each test, whichever tests ran before it.
static test_random check_random;
/// Of the kinetic structure that the test made last, for many tests go through all: a failure says it.
static const char *check_structure;

/// By line, because compilers differ in the order of constructors.
static inline void check_register(check_test *test) {
    check_test **place = &check_tests;
    while (*place && (*place)->line < test->line)
        place = &(*place)->next;
    test->next = *place;
    *place = test;
}

#define TEST(name)                                                                                           \
    static void name(void);                                                                                  \
    __attribute__((constructor)) static void register_##name(void) {                                         \
        static check_test test = {#name, name, __LINE__, NULL};                                              \
        check_register(&test);                                                                               \
    }                                                                                                        \
    static void name(void)

__attribute__((noreturn, format(printf, 3, 4))) static inline void check_failed(const char *file, int line,
                                                                                const char *format, ...) {
    va_list values;
    va_start(values, format);
    fflush(stdout); // what the test has printed stands above its failure
    fprintf(stderr, "%s:%d: ", file, line);
    vfprintf(stderr, format, values);
    fprintf(stderr, check_structure ? " (the structure made last: %s)\n" : "\n", check_structure);
    va_end(values);
    longjmp(check_leave, 1);
}

static inline void check_integers(long long a, long long b, bool equal, const char *text, const char *file,
                                  int line) {
    if ((a == b) == equal)
        return;
    const bool is_error = strstr(text, "BMR_OK") || strstr(text, "BMR_ERROR_");
    check_failed(file, line, "%s: %lld and %lld%s%s", text, a, b, is_error ? ": " : "",
                 is_error ? bmr_error_describe((bmr_error)a) : "");
}

static inline void check_strings(const char *a, const char *b, const char *text, const char *file, int line) {
    if (strcmp(a, b) != 0)
        check_failed(file, line, "%s: \"%s\" and \"%s\"", text, a, b);
}

static inline void check_memory(const void *a, const void *b, size_t size, const char *text, const char *file,
                                int line) {
    const unsigned char *const x = (const unsigned char *)a, *const y = (const unsigned char *)b;
    for (size_t i = 0; i < size; i++)
        if (x[i] != y[i])
            check_failed(file, line, "%s: byte %zu of %zu is %02x and %02x", text, i, size, x[i], y[i]);
}

static inline void check_range(double a, double least, double most, const char *text, const char *file,
                               int line) {
    if (!(a >= least && a <= most))
        check_failed(file, line, "%s: %.17g is not in [%.17g, %.17g]", text, a, least, most);
}

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
#define fail_msg(...) check_failed(__FILE__, __LINE__, __VA_ARGS__)
#define assert_true(condition) ((condition) ? (void)0 : fail_msg("not so: %s", #condition))
#define assert_false(condition) ((condition) ? fail_msg("so: %s", #condition) : (void)0)
#define assert_int_equal(a, b)                                                                               \
    check_integers((long long)(a), (long long)(b), true, #a " == " #b, __FILE__, __LINE__)
#define assert_int_not_equal(a, b)                                                                           \
    check_integers((long long)(a), (long long)(b), false, #a " != " #b, __FILE__, __LINE__)
#define assert_string_equal(a, b) check_strings(a, b, #a " == " #b, __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) check_memory(a, b, size, #a " == " #b, __FILE__, __LINE__)
#define assert_ptr_equal(a, b) assert_true((const void *)(a) == (const void *)(b))
#define assert_in_range(a, least, most)                                                                      \
    check_range((double)(a), (double)(least), (double)(most), #a, __FILE__, __LINE__)
#define assert_null(pointer) assert_true((pointer) == NULL)
#define assert_non_null(pointer) assert_true((pointer) != NULL)

#include "owned.h" // it makes things, and checks that they are

/// Runs the tests whose names have `part`. 0 if there are any and none failed.
static inline int check_run(const char *program, const char *part) {
    static int ran, failed; // static: longjmp must not lose them
    ran = failed = 0;
    for (check_test *volatile test = check_tests; test; test = test->next) {
        if (!strstr(test->name, part))
            continue;
        ran++;
        check_random = test_random_from(1);
        check_structure = NULL;
        if (setjmp(check_leave) == 0) {
            test->run();
            printf("passed: %s\n", test->name);
            continue;
        }
        failed++;
        printf("FAILED: %s. Again: %s %s", test->name, program, test->name);
        if (test_random_last.drawn > 0)
            printf(". After %llu random numbers of the seed %llu", (unsigned long long)test_random_last.drawn,
                   (unsigned long long)test_random_last.seed);
        putchar('\n');
    }
    return ran > 0 && failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv) {
    return check_run(argv[0], argc > 1 ? argv[1] : "");
}

#endif
