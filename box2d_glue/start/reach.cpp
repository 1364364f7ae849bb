// SPDX-License-Identifier: MIT
#include "start/reach.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

std::atomic<uint32_t> noted{kNoHooks};
thread_local bool finding = false;
std::atomic<const char *> way{"contacts alone of Box2D"}, whyNotAll{nullptr};
std::atomic<uint32_t> hooksOfWay{kAllHooks};

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

} // namespace

void internal::NoteReached(Hook hook) {
    // These two hooks answer only inside steps that were announced.
    const bool inStepsAlone = hook == Hook::TimeOfImpact || hook == Hook::TestOverlap;
    if (finding && (!inStepsAlone || CurrentStep() != 0))
        noted.fetch_or(Bit(hook), std::memory_order_relaxed);
}

void SetWayOfHooks(const char *words, uint32_t hooks, const char *why) {
    way.store(words, std::memory_order_relaxed);
    hooksOfWay.store(hooks, std::memory_order_relaxed);
    whyNotAll.store(why, std::memory_order_relaxed);
}

const char *WayOfHooks() {
    return way.load(std::memory_order_relaxed);
}

uint32_t HooksOfWay() {
    return hooksOfWay.load(std::memory_order_relaxed);
}

const char *WhyNotAllHooks() {
    return whyNotAll.load(std::memory_order_relaxed);
}

bool IsFindingReachedHooks() {
    return finding;
}

uint32_t FindReachedHooks() {
    void *room = std::malloc(sizeof(b2World)); // too large for some stacks
    if (room == nullptr)
        return kNoHooks;
    auto *world = new (room) b2World(b2Vec2(0.0f, -10.0f));
    Fill(world);
    finding = true;
    internal::activeHooks = internal::kWatching;
    world->Step(1.0f / 60.0f, 1, 1);
    world->DestroyBody(world->GetBodyList()); // which ends contacts
    internal::activeHooks = kNoHooks;
    finding = false;
    world->~b2World();
    std::free(room);
    return (noted & HooksOfWay()) | Bit(Hook::TouchingManifold);
}

} // namespace bmr
