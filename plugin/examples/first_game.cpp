// SPDX-License-Identifier: MIT
// The first game of docs/first-steps.md: a coin of 64 vertices rolls into a valley, which is one outline.
#include <cstdio>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>

int main() {
    bmr::Install(); // once, before the first step

    b2World world(b2Vec2(0.0f, -10.0f));

    const b2Vec2 points[] = {{-10, 0}, {10, 0}, {10, 5}, {5, 1}, {-5, 1}, {-10, 5}};
    bmr::OutlineShape valley;
    if (const bmr_error error = valley.Set(points, 6)) {
        std::puts(bmr_error_describe(error));
        return 1;
    }
    b2BodyDef def; // a static body at the origin
    valley.CreateFixtures(world.CreateBody(&def), 0.0f);

    bmr::ConvexShape coin;
    if (const bmr_error error = coin.SetRegular(64, 0.5f)) {
        std::puts(bmr_error_describe(error));
        return 1;
    }
    def.type = b2_dynamicBody;
    def.position.Set(-7.0f, 5.0f);
    b2Body *const body = world.CreateBody(&def);
    body->CreateFixture(&coin, 1.0f);

    for (int frame = 1; frame <= 240; ++frame) {
        world.Step(1.0f / 60.0f, 8, 3);
        if (frame % 40 == 0)
            std::printf("frame %3d: coin at (%.1f, %.1f)\n", frame, body->GetPosition().x,
                        body->GetPosition().y);
        // Draw here.
    }
    std::printf("Boomerang is %s\n", bmr::IsInstalled() ? "at work" : "off");
}
