// SPDX-License-Identifier: MIT
//
//   clock_game
//
// Is b2Profile filled? Any program of Box2D's; run with the plugin in front of it. Exit status 0: it is; else
// what is wrong is said.
#include <chrono>
#include <cstdio>

#include <box2d/box2d.h>

namespace {

float b2Profile::*const kTimes[] = {
    &b2Profile::step,          &b2Profile::collide,       &b2Profile::solve,      &b2Profile::solveInit,
    &b2Profile::solveVelocity, &b2Profile::solvePosition, &b2Profile::broadphase, &b2Profile::solveTOI};
int failures = 0;

void Expect(bool holds, const char *claim) {
    if (!holds)
        std::printf("FAILED: %s\n", claim);
    failures += !holds;
}

/// Up to a hundredth, and the microseconds that Box2D's own clock counts in.
bool IsInside(double inner, double outer) {
    return inner <= 1.01 * outer + 0.005;
}

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (int tower = 0; tower < 50; ++tower) {
        for (int storey = 0; storey < 8; ++storey) { // the lowest rests
            def.type = storey == 0 ? b2_staticBody : b2_dynamicBody;
            def.position.Set(2.0f * static_cast<float>(tower), static_cast<float>(storey));
            world.CreateBody(&def)->CreateFixture(&box, 1.0f);
        }
    }
    for (int i = 0; i < 20; ++i)
        world.Step(1.0f / 60.0f, 8, 3);
    b2Profile most = {};
    for (int i = 0; i < 20; ++i) {
        const auto start = std::chrono::steady_clock::now();
        world.Step(1.0f / 60.0f, 8, 3);
        const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - start;
        const b2Profile &p = world.GetProfile();
        Expect(IsInside(p.step, whole.count()), "the profile's step is inside the step");
        Expect(IsInside(p.collide + p.solve + p.solveTOI, p.step), "its passes are inside that");
        Expect(IsInside(p.solveInit + p.solveVelocity + p.solvePosition + p.broadphase, p.solve),
               "and what the solver does inside its pass");
        for (float b2Profile::*time : kTimes)
            most.*time = b2Max(most.*time, p.*time);
    }
    for (float b2Profile::*time : kTimes)
        Expect(most.*time > 0.0f, "each of its times is there");
    if (failures == 0)
        std::printf("passed\n");
    return failures != 0;
}
