// SPDX-License-Identifier: MIT
//
//   bullet_game thrown|recentred
//
// `thrown`: a listener throws as the first of many impacts of a step is told. What Box2D had found out of the
// others is to be forgotten, also where their bodies are no bullets any more and nobody listens.
//
// `recentred`: a listener gives bodies other centres of mass, and throws them, when they have been looked at.
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

#include <box2d/box2d.h>

#include "small_world.h"

namespace {

struct Told {};

class Throwing final : public b2ContactListener {
public:
    bool armed = false;
    void BeginContact(b2Contact *) override {
        if (armed)
            throw Told();
    }
};

/// `rounded`: the step that is thrown out of is rounded upward, and so was one before; between them an impact
/// is had.
void PlayThrown(bool rounded) {
    constexpr int kResting = 700, kShots = 40; // more at rest than a short list has room for
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBox(world, b2_staticBody, {0.0f, -0.5f}, {400.0f, 0.5f}, 0.0f);
    for (int i = 0; i < kResting; ++i)
        AddBox(world, b2_dynamicBody, {-350.0f + static_cast<float>(i), 0.25f}, {0.25f, 0.25f}, 0.0f)
            ->SetSleepingAllowed(false);
    std::vector<b2Body *> bullets;
    for (int i = 0; i < kShots; ++i) {
        const float x = 6.0f * static_cast<float>(i - kShots / 2);
        AddBox(world, b2_dynamicBody, {x, 20.0f}, {0.01f, 0.5f}, 0.0f)->SetGravityScale(0.0f);
        bullets.push_back(AddBox(world, b2_dynamicBody, {x - 0.2f, 20.0f}, {0.03f, 0.03f}, 0.0f));
        bullets.back()->SetGravityScale(0.0f);
    }
    Hash hash;
    Step(world, 60, &hash);
    if (rounded) {
        std::fesetround(FE_UPWARD);
        Step(world, 1, &hash);
        std::fesetround(FE_TONEAREST);
        bullets.back()->SetBullet(true);
        bullets.back()->SetLinearVelocity({30.0f, 0.0f});
        bullets.pop_back();
        for (b2Body *bullet : bullets) // so that they are looked at
            bullet->SetAwake(true);
        Step(world, 1, &hash);
        std::fesetround(FE_UPWARD);
    }
    Throwing listener;
    listener.armed = true;
    world.SetContactListener(&listener);
    for (b2Body *bullet : bullets) {
        bullet->SetBullet(true);
        bullet->SetLinearVelocity({30.0f, 0.0f});
    }
    try {
        world.Step(1.0f / 60.0f, 8, 3);
        Print("nothing was thrown", hash);
    } catch (const Told &) {
        Print("thrown", hash);
    }
    std::fesetround(FE_TONEAREST);
    world.SetContactListener(nullptr);
    for (b2Body *bullet : bullets) {
        bullet->SetBullet(false);
        bullet->SetLinearVelocity({0.0f, 0.0f});
    }
    Step(world, 3, &hash);
    Print("three steps on", hash);
}

/// Does once, in a PreSolve, what is to be done.
class Once final : public b2ContactListener {
public:
    std::function<void()> what;
    void PreSolve(b2Contact *, const b2Manifold *) override {
        if (what)
            std::exchange(what, nullptr)();
    }
};

/// Bars in front of plates that stand aslant. Each bar's centre of mass is near the plate, and then in
/// its middle: it has moved towards the plate by less than the bar does.
void PlayRecentred() {
    constexpr int kPairs = 40;
    const b2Rot aslant(0.25f * b2_pi);
    b2World world(b2Vec2(0.0f, 0.0f));
    Once listener;
    Hash hash;
    std::vector<b2Body *> bars;
    for (int i = 0; i < kPairs; ++i) {
        const b2Vec2 at(6.0f * static_cast<float>(i), 0.0f);
        AddBox(world, b2_staticBody, at, {0.02f, 3.0f}, aslant.GetAngle());
        bars.push_back(
            AddBox(world, b2_dynamicBody, at + 0.79f * aslant.GetXAxis(), {0.4f, 0.1f}, aslant.GetAngle()));
        bars.back()->SetSleepingAllowed(false);
        b2MassData mass;
        bars.back()->GetMassData(&mass);
        mass.center.Set(-0.29f, 0.0f);
        mass.I = 2.0f * mass.mass;
        bars.back()->SetMassData(&mass);
    }
    for (const float x : {0.0f, 0.995f}) // who touch
        AddBox(world, b2_dynamicBody, {x, 90.0f}, {0.5f, 0.5f}, 0.0f)->SetSleepingAllowed(false);
    world.SetContactListener(&listener);
    Step(world, 4, &hash);
    Print("recentred", hash);
    listener.what = [&] {
        float speed = 20.0f;
        for (b2Body *bar : bars) {
            bar->ResetMassData();
            bar->SetLinearVelocity(-speed * aslant.GetXAxis());
            speed += 0.5f;
        }
    };
    for (int i = 0; i < 3; ++i) {
        Step(world, 1, &hash);
        Print("recentred", hash);
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "thrown") == 0) {
        PlayThrown(false);
        PlayThrown(true);
        return 0;
    }
    if (argc == 2 && std::strcmp(argv[1], "recentred") == 0) {
        PlayRecentred();
        return 0;
    }
    std::fputs("usage: bullet_game thrown|recentred\n", stderr);
    return 2;
}
