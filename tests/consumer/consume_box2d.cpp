// SPDX-License-Identifier: MIT
#include <boomerang/box2d.h>
#include <box2d/box2d.h>

int main() {
    bmr::Options options;
    options.statistics = true;
    options.hooks = bmr::kAllHooks & ~bmr::Bit(bmr::Hook::ProfileClock);
    bmr::Install(options);
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    world.CreateBody(&body)->CreateFixture(&box, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    // Installed, and ahead of Box2D: the step came by.
    return bmr::IsInstalled() && bmr::GetStatistics().steps == 1 ? 0 : 1;
}
