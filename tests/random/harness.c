// SPDX-License-Identifier: MIT
#include "harness.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *fuzz_input_name = "";
static const char *control;
static bool control_known;
static void (*on_found)(void);

void fuzz_fail(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("found: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    if (on_found)
        on_found();
    abort();
}

bool fuzz_control(const char *name) {
    if (!control_known) {
        control = getenv("BMR_FUZZ_CONTROL");
        control_known = true;
    }
    return control && strcmp(control, name) == 0;
}

void fuzz_set_control(const char *name, void (*found)(void)) {
    control = name;
    control_known = true;
    on_found = found;
}
