// SPDX-License-Identifier: MIT
// The game of tests/plugin that knows nothing of Boomerang, and what else a program may have: the plugin's
// interface (WITH_INTERFACE), core (WITH_CORE). Prints what the game prints, and whether these work.
#include <cstdio>

#ifdef WITH_INTERFACE
#    include <boomerang/box2d.h>
#endif
#ifdef WITH_CORE
#    include <boomerang/boomerang.h>
#endif

int Play(); // the game's main

extern "C" int PlayAll() {
#ifdef WITH_INTERFACE
    bmr::Install();
    bmr::ConvexShape coin;
    std::printf("64-gon: %s; %s\n", bmr_error_describe(coin.SetRegular(64, 0.5f)), bmr::GetPresence().way);
#endif
#ifdef WITH_CORE
    const bmr_vec2 points[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    bmr_polygon *square = nullptr;
    const bmr_error error = bmr_polygon_create(points, 4, nullptr, &square);
    std::printf("core: %s\n", bmr_error_describe(error));
    bmr_polygon_destroy(square, nullptr);
#endif
    return Play();
}

int main() {
    return PlayAll();
}
