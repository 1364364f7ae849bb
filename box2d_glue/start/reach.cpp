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

constexpr const char *kHooks[] = {"b2World::Step",
                                  "b2ContactManager::Collide",
                                  "b2ContactManager::FindNewContacts",
                                  "b2ContactManager::Destroy",
                                  "b2World::Solve",
                                  "b2World::SolveTOI",
                                  "b2Fixture::Synchronize",
                                  "b2DynamicTree::MoveProxy"};
static_assert(sizeof kHooks / sizeof *kHooks == static_cast<size_t>(HookOf::Count), "each has a name");

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
    const uint32_t missing =
        ~noted.load(std::memory_order_relaxed) & ((1u << static_cast<uint32_t>(HookOf::Count)) - 1);
    if (missing == 0)
        return nullptr;
    std::snprintf(sentence, sizeof sentence,
                  "Box2D does not call Boomerang's %s. Link boomerang::box2d ahead of it, or use "
                  "boomerang_accelerate()",
                  kHooks[LowestBit(missing)]);
    return sentence;
}

} // namespace bmr
