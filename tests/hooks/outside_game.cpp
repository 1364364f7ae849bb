// SPDX-License-Identifier: MIT
//
// A program that asks b2TimeOfImpact and b2TestOverlap itself, beside the steps of its worlds and in them: it
// gets Box2D's own answers, and Box2D's counters go on; but that in a step an overlap is answered by the
// plugin, with the same word. And what a step asks itself. Linked to the plugin. Exit status 0: so it is;
// else what is wrong is said.
#include <cstdint>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <thread>

#include <boomerang/box2d.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>

#include "tell/event.h"

extern B2_API int32 b2_toiCalls;
extern B2_API int32 b2_gjkCalls;

namespace {

int failures = 0;

void Expect(bool holds, const char *claim) {
    if (!holds)
        std::printf("FAILED: %s\n", claim);
    failures += !holds;
}

/// What the plugin counts while `something` is done: questions that it was asked in a step.
uint64_t Asked(const std::function<void()> &something) {
    const auto sum = [] {
        const bmr::Counted s = bmr::internal::ReadCounts();
        return s.toiQueries + s.overlapsAnswered;
    };
    const uint64_t before = sum();
    something();
    return sum() - before;
}

/// Whether Box2D has answered.
struct Answered {
    bool impact, overlap;
};

/// One question of each kind, about two boxes far apart, which the plugin would answer itself.
Answered AskBoth() {
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2TOIInput in;
    in.proxyA.Set(&box, 0);
    in.proxyB.Set(&box, 0);
    in.sweepA.localCenter.SetZero();
    in.sweepA.c0.SetZero();
    in.sweepA.c.SetZero();
    in.sweepA.a0 = in.sweepA.a = in.sweepA.alpha0 = 0.0f;
    in.sweepB = in.sweepA;
    in.sweepB.c0.Set(5.0f, 0.0f);
    in.sweepB.c.Set(5.0f, 0.0f);
    in.tMax = 1.0f;
    b2TOIOutput out;
    const int32 toiBefore = b2_toiCalls;
    b2TimeOfImpact(&out, &in);
    const bool toi = b2_toiCalls == toiBefore + 1 && out.state == b2TOIOutput::e_separated && out.t == 1.0f;
    b2Transform here, there;
    here.SetIdentity();
    there.Set({5.0f, 0.0f}, 0.0f);
    const int32 gjkBefore = b2_gjkCalls;
    const bool overlap = b2TestOverlap(&box, 0, &box, 0, here, there);
    return {toi, !overlap && b2_gjkCalls == gjkBefore + 1};
}

/// Does something at the first contact that begins, in the middle of a step.
class AtBegin : public b2ContactListener {
public:
    explicit AtBegin(std::function<void()> something) : m_something(std::move(something)) {}
    void BeginContact(b2Contact *) override {
        if (!m_done) {
            m_done = true;
            m_something();
        }
    }
    bool Done() const { return m_done; }

private:
    std::function<void()> m_something;
    bool m_done = false;
};

b2Fixture *AddBox(b2World *world, b2BodyType type, b2Vec2 at) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    return world->CreateBody(&def)->CreateFixture(&box, 1.0f);
}

/// Times of impact that steps ask for with one box beside another, near enough for a contact.
uint64_t ImpactsAskedFor(bool sensor) {
    b2World world({0.0f, 0.0f});
    AddBox(&world, b2_staticBody, {0.0f, 0.0f});
    AddBox(&world, b2_dynamicBody, {0.0f, 1.05f})->SetSensor(sensor);
    const uint64_t before = bmr::internal::ReadCounts().toiQueries;
    for (int step = 0; step < 3; ++step)
        world.Step(1.0f / 60.0f, 8, 3);
    return bmr::internal::ReadCounts().toiQueries - before;
}

/// A box that falls on another, until they touch; `something` is done then. True if it was.
bool AtFirstTouch(std::function<void()> something) {
    b2World world({0.0f, -10.0f});
    AddBox(&world, b2_staticBody, {0.0f, 0.0f});
    AddBox(&world, b2_dynamicBody, {0.0f, 1.1f});
    AtBegin listener(std::move(something));
    world.SetContactListener(&listener);
    for (int step = 0; step < 60 && !listener.Done(); ++step)
        world.Step(1.0f / 60.0f, 8, 3);
    return listener.Done();
}

void CheckBetweenSteps() {
    Answered box2d = {false, false};
    Expect(Asked([&] { box2d = AskBoth(); }) == 0, "outside of steps nothing is taken for a step's");
    Expect(box2d.impact && box2d.overlap, "outside of steps Box2D answers");
}

/// A body that a bullet hits asks in the middle of the search for impacts.
void CheckInSearch() {
    b2World world({0.0f, 0.0f});
    AddBox(&world, b2_staticBody, {0.0f, 0.0f});
    b2Body *const bullet = AddBox(&world, b2_dynamicBody, {0.0f, 3.0f})->GetBody();
    bullet->SetBullet(true);
    bullet->SetLinearVelocity({0.0f, -300.0f});
    Answered box2d = {false, false};
    uint64_t asked = 0;
    const uint64_t before = bmr::internal::ReadCounts().toiQueries;
    uint64_t searched = 0;
    AtBegin listener([&] {
        searched = bmr::internal::ReadCounts().toiQueries - before;
        asked = Asked([&] { box2d = AskBoth(); });
    });
    world.SetContactListener(&listener);
    world.Step(1.0f / 60.0f, 8, 3);
    Expect(listener.Done() && searched > 0, "a bullet hits, in the search for impacts");
    Expect(asked == 1 && box2d.impact, "a listener's question in the search for impacts is Box2D's");
}

} // namespace

int main() {
    bmr::Options options;
    options.statistics = true;
    Expect(bmr::Install(options), "the plugin is at work");
    CheckBetweenSteps();

    Answered box2d = {false, true};
    uint64_t asked = 0;
    Expect(AtFirstTouch([&] { asked = Asked([&] { box2d = AskBoth(); }); }), "two boxes touch");
    Expect(asked == 1 && !box2d.overlap, "control: in a step, on its thread, the plugin answers overlaps");
    Expect(box2d.impact, "a listener's question for a time of impact is Box2D's");
    CheckInSearch();
    CheckBetweenSteps();

    box2d = {false, false};
    Expect(AtFirstTouch([&] { asked = Asked([&] { std::thread([&] { box2d = AskBoth(); }).join(); }); }),
           "two boxes touch again");
    Expect(asked == 0 && box2d.impact && box2d.overlap,
           "another thread gets Box2D's answers while this one steps");

    // A world of its own, stepped by a listener in the middle of the first one's step.
    Expect(AtFirstTouch([&] {
               Expect(AtFirstTouch([] {}), "a step within a step");
               asked = Asked([&] { box2d = AskBoth(); });
           }),
           "two boxes touch once more");
    Expect(asked == 0 && box2d.overlap, "when the inner step has ended, Box2D answers in the outer one");
    CheckBetweenSteps();

    bool thrown = false;
    try {
        AtFirstTouch([] { throw std::runtime_error("a listener's"); });
    } catch (const std::runtime_error &) {
        thrown = true;
    }
    Expect(thrown, "a listener's exception comes through");
    CheckBetweenSteps();
    Expect(ImpactsAskedFor(true) == 0, "a sensor has no time of impact");
    Expect(ImpactsAskedFor(false) == 3, "control: what is solid has one in each step");
    if (failures == 0)
        std::printf("passed\n");
    return failures != 0;
}
