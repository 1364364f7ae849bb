// SPDX-License-Identifier: MIT
//
// doctest's own part and the main of all tests in C++, compiled once: it takes three times as long as a test.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
