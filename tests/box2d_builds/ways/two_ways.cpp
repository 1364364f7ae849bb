// SPDX-License-Identifier: MIT
// The game of tests/plugin that knows nothing of Boomerang; WITH_INTERFACE it calls Install all the same.
#ifdef WITH_INTERFACE
#    include <boomerang/box2d.h>
#endif

int Play(); // the game's main

int main() {
#ifdef WITH_INTERFACE
    bmr::Install();
#endif
    return Play();
}
