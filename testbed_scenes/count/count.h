// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COUNT_H
#define BOOMERANG_TESTBED_COUNT_H

#include <cstdint>

/// @file
/// libboomerang-count.so: preloaded into a worker, it stands in front of Box2D's leaf functions, counts their
/// calls and passes them on. Whoever calls them through the symbol is counted: Box2D itself, the plugin, the
/// scene. Not for worlds that step on several threads at once.

extern "C" {

struct boomerang_counts {
    uint64_t polygon_tests;       ///< b2CollidePolygons
    uint64_t polygon_tests_apart; ///< of those, the ones that found no contact point
    uint64_t toi_calls;           ///< b2TimeOfImpact
    uint64_t distance_calls; ///< b2Distance, of which b2TimeOfImpact and b2TestOverlap make some themselves
};

/// Calls since the process began.
__attribute__((visibility("default"))) void boomerang_count_read(boomerang_counts *counts);
}

#endif
