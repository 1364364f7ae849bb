// SPDX-License-Identifier: MIT
// bmr::ContactRecorder, on Box2D alone: it holds what a listener hears, and the hooks know it.
#include <array>
#include <iterator>

#include "boomerang/contact_recorder.h"
#include "cases.h"
#include "glue/contacts/game_calls.h"
#include "small_world.h"

namespace {

uintptr_t NumberOf(const b2Fixture *fixture) {
    return const_cast<b2Fixture *>(fixture)->GetUserData().pointer;
}

/// One event in numbers: user data of fixtures, children, whether it was heard in a step, and of a hit where.
using Line = std::array<float, 10>;
using Lines = std::vector<Line>;
constexpr float kHit = 0.5f;

Line Of(uintptr_t a, int32 childA, uintptr_t b, int32 childB, bool outside = false) {
    return {static_cast<float>(a), static_cast<float>(childA), static_cast<float>(b),
            static_cast<float>(childB), outside ? 1.0f : 0.0f};
}
Line Of(b2Contact *c, bool swapped, bool outside = false) {
    const Line line = Of(NumberOf(c->GetFixtureA()), c->GetChildIndexA(), NumberOf(c->GetFixtureB()),
                         c->GetChildIndexB(), outside);
    return swapped ? Line{line[2], line[3], line[0], line[1], line[4]} : line;
}
void Locate(Line *line, b2Vec2 point, b2Vec2 normal, float impulse) {
    const float values[] = {point.x, point.y, normal.x, normal.y, impulse};
    std::copy(std::begin(values), std::end(values), line->begin() + 5);
}

/// The five lists, by hand.
struct ByHand final : b2ContactListener {
    Lines begins, ends, sensorBegins, sensorEnds, hits;

    static bool IsOfSensor(b2Contact *c) {
        return c->GetFixtureA()->IsSensor() || c->GetFixtureB()->IsSensor();
    }
    void BeginContact(b2Contact *c) override {
        (IsOfSensor(c) ? sensorBegins : begins)
            .push_back(Of(c, IsOfSensor(c) && !c->GetFixtureA()->IsSensor()));
    }
    void EndContact(b2Contact *c) override {
        const bool outside = !c->GetFixtureA()->GetBody()->GetWorld()->IsLocked();
        (IsOfSensor(c) ? sensorEnds : ends)
            .push_back(Of(c, IsOfSensor(c) && !c->GetFixtureA()->IsSensor(), outside));
    }
    void PostSolve(b2Contact *c, const b2ContactImpulse *impulse) override {
        const float *normal = impulse->normalImpulses;
        const bool two = impulse->count == 2;
        const float sum = two ? normal[0] + normal[1] : normal[0];
        if (sum < kHit)
            return;
        b2WorldManifold where;
        c->GetWorldManifold(&where);
        hits.push_back(Of(c, false));
        Locate(&hits.back(), where.points[two && normal[1] > normal[0] ? 1 : 0], where.normal, sum);
    }
};

Line Of(const bmr::ContactSide &a, const bmr::ContactSide &b, bool outside) {
    return Of(a.userData.pointer, a.child, b.userData.pointer, b.child, outside);
}

/// The same, taken from a recorder.
void Take(bmr::ContactRecorder *recorder, ByHand *taken) {
    const bmr::ContactEvents events = recorder->Take();
    CHECK(events.lost == 0);
    for (const auto &e : events.begins)
        taken->begins.push_back(Of(e.a, e.b, e.mayBeGone));
    for (const auto &e : events.ends)
        taken->ends.push_back(Of(e.a, e.b, e.mayBeGone));
    for (const auto &e : events.sensorBegins)
        taken->sensorBegins.push_back(Of(e.sensor, e.visitor, e.mayBeGone));
    for (const auto &e : events.sensorEnds)
        taken->sensorEnds.push_back(Of(e.sensor, e.visitor, e.mayBeGone));
    for (const auto &e : events.hits) {
        taken->hits.push_back(Of(e.a, e.b, false));
        Locate(&taken->hits.back(), e.point, e.normal, e.impulse);
    }
}

/// Boxes and a disk that fall on planks and a chain past a sensor; some are destroyed as they lie.
template <typename AfterStep> void Play(b2World &world, const AfterStep &afterStep) {
    FillWithBoxes(world);
    AddBox(world, b2_staticBody, {0.0f, 2.0f}, {12.0f, 0.3f}, 0.0f,
           true); // what is older comes first in contacts
    const b2Vec2 links[] = {{-30.0f, -8.0f}, {-5.0f, -9.0f}, {5.0f, -9.0f}, {30.0f, -8.0f}};
    b2ChainShape chain;
    chain.CreateChain(links, 4, {-40.0f, -8.0f}, {40.0f, -8.0f});
    b2BodyDef def;
    world.CreateBody(&def)->CreateFixture(&chain, 0.0f);
    uintptr_t number = 0;
    for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        body->GetUserData().pointer = ++number;
        body->GetFixtureList()->GetUserData().pointer = 1000 + number;
    }
    for (int step = 0; step < 240; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        if (step > 100 && step % 10 == 0)
            world.DestroyBody(world.GetBodyList()->GetNext());
        afterStep(step);
    }
}

// docs/contact-recorder.md shows this.

struct Coin {
    int value;
    bool isTaken;
};

/// A coin's body has the address of its Coin for user data. Two players may touch it in one step.
int TakePickups(const bmr::ContactEvents &events, b2World &world) {
    int score = 0;
    for (const bmr::SensorTouchEvent &event : events.sensorBegins) {
        Coin *coin = reinterpret_cast<Coin *>(event.sensor.bodyUserData.pointer);
        if (coin == nullptr || coin->isTaken)
            continue;
        coin->isTaken = true;
        score += coin->value;
        world.DestroyBody(event.sensor.body);
    }
    return score;
}

} // namespace

TEST_CASE("a recorder holds what a listener hears, in its order") {
    ByHand heard, taken;
    bmr::ContactRecorder recorder;
    recorder.SetHitThreshold(kHit);
    b2World listened({0.0f, -10.0f}), recorded({0.0f, -10.0f});
    listened.SetContactListener(&heard);
    recorded.SetContactListener(&recorder);
    Play(listened, [](int) {});
    Play(recorded, [&](int step) { // taken at each step at first, then less often
        if (step < 60 || step % 7 == 0)
            Take(&recorder, &taken);
    });
    Take(&recorder, &taken);
    CHECK(heard.begins.size() > 100);
    CHECK(heard.sensorEnds.size() > 20);
    CHECK(heard.hits.size() > 50);
    CHECK(std::any_of(heard.ends.begin(), heard.ends.end(), [](const Line &line) { return line[4] != 0; }));
    CHECK(taken.begins == heard.begins);
    CHECK(taken.ends == heard.ends);
    CHECK(taken.sensorBegins == heard.sensorBegins);
    CHECK(taken.sensorEnds == heard.sensorEnds);
    CHECK(taken.hits == heard.hits);
}

TEST_CASE("nothing hits until a threshold is set, and lists stay until the next ones are taken") {
    bmr::ContactRecorder recorder;
    b2World world({0.0f, -10.0f});
    world.SetContactListener(&recorder);
    b2Body *floor = AddBox(world, b2_staticBody, {0.0f, 0.0f}, {5.0f, 0.5f}, 0.0f);
    b2Body *box = AddBox(world, b2_dynamicBody, {0.0f, 1.0f}, {0.5f, 0.5f}, 0.0f);
    box->GetUserData().pointer = 7;
    world.Step(1.0f / 60.0f, 8, 3);
    const bmr::ContactEvents first = recorder.Take();
    REQUIRE(first.begins.size() == 1);
    const bool boxIsA = first.begins[0].a.body == box;
    const bmr::ContactSide &side = boxIsA ? first.begins[0].a : first.begins[0].b;
    CHECK(side.fixture == box->GetFixtureList());
    CHECK(side.bodyUserData.pointer == 7);
    CHECK(first.hits.count == 0);
    world.DestroyBody(box);
    CHECK(first.begins.count == 1);
    CHECK(side.bodyUserData.pointer == 7);
    const bmr::ContactEvents second = recorder.Take();
    CHECK(second.begins.count == 0);
    REQUIRE(second.ends.count == 1);
    CHECK(second.ends[0].mayBeGone);
    CHECK((boxIsA ? second.ends[0].b : second.ends[0].a).body == floor);
    CHECK(recorder.Take().ends.count == 0);
}

TEST_CASE("each coin is taken once, by two players at a time") {
    bmr::ContactRecorder recorder;
    b2World world({0.0f, -10.0f});
    world.SetContactListener(&recorder);
    for (const float x : {-1.0f, 1.0f})
        AddBox(world, b2_dynamicBody, {x, 3.0f}, {0.5f, 0.5f}, 0.0f)->GetUserData().pointer = 0;
    Coin coins[] = {{10, false}, {20, false}};
    for (int i = 0; i < 2; ++i)
        AddBox(world, b2_staticBody, {0.0f, -2.0f * static_cast<float>(i)}, {4.0f, 0.2f}, 0.0f, true)
            ->GetUserData()
            .pointer = reinterpret_cast<uintptr_t>(&coins[i]);
    int score = 0;
    std::size_t most = 0;
    for (int frame = 0; frame < 120; ++frame) {
        world.Step(1.0f / 60.0f, 8, 3);
        const bmr::ContactEvents events = recorder.Take();
        most = std::max(most, static_cast<std::size_t>(events.sensorBegins.size()));
        score += TakePickups(events, world);
    }
    CHECK(most == 2);
    CHECK(score == 30);
    CHECK(world.GetBodyCount() == 2);
}

#if defined(__x86_64__) && defined(__linux__)
TEST_CASE("what a listener inherits is known by its first instruction, in whatever copy") {
    REQUIRE(bmr::WhyBox2DIsUnknown() == nullptr);
    // A return, behind the mark of a branch's target, too; and what is neither.
    const unsigned char codes[][5] = {
        {0xc3}, {0xf3, 0x0f, 0x1e, 0xfa, 0xc3}, {0x90, 0xc3}, {0xf3, 0x0f, 0x1e, 0xfb, 0xc3}};
    for (int i = 0; i < 4; ++i)
        for (int slot = 4; slot < 6; ++slot) {
            const void *table[6];
            for (int k = 0; k < 6; ++k)
                table[k] = codes[k == slot ? i : 2 - 2 * (i / 2)];
            const void *const listener = static_cast<const void *>(table);
            const auto &as = *reinterpret_cast<const b2ContactListener *>(&listener);
            CHECK(bmr::HasOwnPreSolve(as) == (slot == 4 ? i >= 2 : i < 2));
            CHECK(bmr::HasOwnPostSolve(as) == (slot == 5 ? i >= 2 : i < 2));
        }
}
#endif
