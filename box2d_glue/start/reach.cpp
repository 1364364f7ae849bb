// SPDX-License-Identifier: MIT
#include "start/reach.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "base/compiler.h"
#include "start/settings.h"

namespace bmr {

namespace {

struct HookInTrial {
    const char *name;
    bool isHeard; ///< in the trial step; Box2D has to call these
};
constexpr bool kHeard = true, kAny = false;
constexpr HookInTrial kHooks[] = {
#define BMR_NAME_HOOK(name, function, symbol, heard, result, parameters, renamed) {#function, heard},
    BMR_HOOKS(BMR_NAME_HOOK)};

thread_local bool finding = false;
std::atomic<uint32_t> noted{0};
std::atomic<const char *> theWay{"not ahead of Box2D"}, theReason{nullptr};
char sentence[120];

/// A box that falls on another one, and overlaps a sensor.
void Fill(b2World *world) {
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f;
    b2BodyDef body;
    world->CreateBody(&body)->CreateFixture(&fixture);
    fixture.isSensor = true;
    world->CreateBody(&body)->CreateFixture(&fixture);
    fixture.isSensor = false;
    body.type = b2_dynamicBody;
    body.position.Set(0.0f, 1.5f);
    world->CreateBody(&body)->CreateFixture(&fixture);
}

bool StepSmallWorld() {
    void *room = std::malloc(sizeof(b2World)); // too large for some stacks
    if (room == nullptr)
        return false;
    auto *world = new (room) b2World(b2Vec2(0.0f, -10.0f));
    Fill(world);
    finding = true;
    internal::state = internal::State::Watching;
    world->Step(1.0f / 60.0f, 1, 1);
    world->DestroyBody(world->GetBodyList()); // which ends contacts
    internal::state = internal::State::Nothing;
    finding = false;
    world->~b2World();
    std::free(room);
    return true;
}

} // namespace

void internal::NoteReached(HookOf hook) {
    if (finding)
        noted.fetch_or(1u << static_cast<uint32_t>(hook), std::memory_order_relaxed);
}

void SetWay(const char *words, const char *why) {
    theWay.store(words, std::memory_order_relaxed);
    theReason.store(why, std::memory_order_relaxed);
}

const char *TheWay() {
    return theWay.load(std::memory_order_relaxed);
}

bool IsFindingReach() {
    return finding;
}

const char *WhyNotAhead() {
    return theReason.load(std::memory_order_relaxed);
}

const char *WhichHookIsNotCalled() {
    if (!StepSmallWorld())
        return "there is no memory";
    uint32_t hook = 0;
    for (const HookInTrial &listed : kHooks) {
        if (listed.isHeard && (noted.load(std::memory_order_relaxed) >> hook & 1) == 0) {
            std::snprintf(sentence, sizeof sentence,
                          "Box2D does not call Boomerang's %s. Link boomerang::box2d ahead of it, or use "
                          "boomerang_accelerate()",
                          listed.name);
            return sentence;
        }
        ++hook;
    }
    return nullptr;
}

} // namespace bmr
