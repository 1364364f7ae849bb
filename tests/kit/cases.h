// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CASES_H
#define BOOMERANG_TEST_CASES_H

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include <doctest/doctest.h>

#include "test_scale.h"

/// @file
/// doctest, and what its tests need of the standard library. kit/doctest_main.cpp has their main.

/// What `speak()` writes to stderr, which stays silent.
template <typename Speak> std::string StderrOf(Speak speak) {
    std::fflush(stderr);
    std::FILE *const heard = std::tmpfile();
    const int kept = dup(STDERR_FILENO);
    if (heard == nullptr || kept < 0 || dup2(fileno(heard), STDERR_FILENO) < 0)
        return "stderr cannot be taken";
    speak();
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    std::string text;
    std::rewind(heard);
    for (int c; (c = std::fgetc(heard)) != EOF;)
        text += static_cast<char>(c);
    std::fclose(heard);
    return text;
}

#endif
