// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_SCALE_H
#define BOOMERANG_TEST_SCALE_H

#include <math.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

/// `count` iterations times the environment variable BMR_TEST_SCALE (a positive number; 1 when unset or
/// unreadable), at least 1. The sanitizer builds run with a small scale, a night's run with a large one.
static inline size_t test_scaled(size_t count) {
    const char *text = getenv("BMR_TEST_SCALE");
    char *end = NULL;
    const double scale = text ? strtod(text, &end) : 1.0;
    if (!text || end == text || !(scale > 0.0) || !(scale < 1e6))
        return count;
    const double scaled = floor((double)count * scale);
    return scaled < 1.0 ? 1 : (size_t)scaled;
}

#ifdef __cplusplus
}
#endif
#endif
