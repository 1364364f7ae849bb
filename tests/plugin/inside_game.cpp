// SPDX-License-Identifier: MIT
// A program that calls a Box2D of its own inside, as far as one can tell from its own b2CollidePolygons,
// while the system's is loaded besides. Boomerang must not take the one for the other.
#include <cstdio>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>

void b2CollidePolygons(b2Manifold *manifold, const b2PolygonShape *, const b2Transform &,
                       const b2PolygonShape *, const b2Transform &) {
    manifold->pointCount = 0;
}

int main() {
    const bool installed = bmr::Install();
    bmr::ConvexShape coin;
    const bmr_error error = coin.SetRegular(64, 1.0f);
    std::printf("installed %d, %s\n", installed, bmr_error_describe(error));
    return !installed && !bmr::IsInstalled() && error == BMR_ERROR_UNSUPPORTED ? 0 : 1;
}
