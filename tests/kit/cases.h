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
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

/// @file
/// doctest, and what its tests need of the standard library. kit/doctest_main.cpp has their main.

#endif
