// SPDX-License-Identifier: MIT
#include <cstring>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>

int main() {
    bmr::Install();
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    world.CreateBody(&body)->CreateFixture(&box, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    // What is wrong with a polygon can be told.
    bmr::ConvexShape line;
    const b2Vec2 ends[] = {{0.0f, 0.0f}, {1.0f, 0.0f}};
    const bmr_error error = line.Set(ends, 2);
    if (error != BMR_ERROR_TOO_FEW_POINTS ||
        std::strcmp(bmr_error_describe(error), bmr_error_describe(BMR_OK)) == 0)
        return 1;
    // An outline, which core cuts.
    const b2Vec2 elbow[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {2.0f, 1.0f},
                            {1.0f, 1.0f}, {1.0f, 2.0f}, {0.0f, 2.0f}};
    bmr::OutlineShape outline;
    if (outline.Set(elbow, 6) != BMR_OK || outline.CreateFixtures(world.CreateBody(&body), 1.0f) != BMR_OK ||
        !outline.Has(*world.GetBodyList()->GetFixtureList()))
        return 1;
    // Installed, and ahead of Box2D: a step was heard.
    return bmr::IsInstalled() ? 0 : 1;
}
