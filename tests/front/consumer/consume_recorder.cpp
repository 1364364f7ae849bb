// SPDX-License-Identifier: MIT
#if defined(WITH_PLUGIN)
#    include <boomerang/box2d.h>
#endif
#include <boomerang/contact_recorder.h>
#include <box2d/box2d.h>

int main() {
#if defined(WITH_PLUGIN)
    bmr::Install();
#endif
    bmr::ContactRecorder recorder;
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetContactListener(&recorder);
    b2BodyDef def;
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    world.CreateBody(&def)->CreateFixture(&box, 0.0f);
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 1.9f);
    world.CreateBody(&def)->CreateFixture(&box, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    if (recorder.Take().begins.size() != 1)
        return 1;
#if defined(WITH_PLUGIN)
    return bmr::IsInstalled() ? 0 : 1;
#else
    return 0;
#endif
}
