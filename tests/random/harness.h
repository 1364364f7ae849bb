// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_HARNESS_H
#define BMR_FUZZ_HARNESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// What every fuzzer is made of: one function that takes bytes, and checks that end the process where an
/// answer is not the oracle's. Linked with libFuzzer, or with replay.c, which runs files.

/// libFuzzer's. Returns 0; aborts where anything is wrong.
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/// Prints what is wrong and aborts. (replay --control: leaves with 0, it was to be found.)
#if defined(__GNUC__)
__attribute__((noreturn, format(printf, 1, 2)))
#endif
void fuzz_fail(const char *format, ...);

#define FUZZ_CHECK(condition, ...)                                                                           \
    do {                                                                                                     \
        if (!(condition))                                                                                    \
            fuzz_fail(__VA_ARGS__);                                                                          \
    } while (0)

/// Is this control asked for, by replay --control NAME or by BMR_FUZZ_CONTROL=NAME? Then the fuzzer falsifies
/// the answer of that name before it checks it, and the check must find it.
bool fuzz_control(const char *name);

/// For replay.c alone: the control asked for, and what is called when something was found.
void fuzz_set_control(const char *name, void (*found)(void));

/// The name of the corpus' input that replay.c plays. A mutated or made input has none: it is empty then, and
/// always with libFuzzer.
extern const char *fuzz_input_name;

#ifdef __cplusplus
}
#endif
#endif
