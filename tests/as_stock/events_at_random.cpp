// SPDX-License-Identifier: MIT
// Crowds of bodies that meet at random: whatever happens, each life is one that the header allows, and nobody
// plays otherwise for being listened to.
#include "box2d_shapes.h"
#include "events.h"

using namespace as_stock;

namespace {

constexpr float kArena = 7.0f;
constexpr uint16_t kWall = 1, kPiece = 2, kOfMany = 4, kSensor = 8;

/// Sensors meet bodies of one fixture alone: of more, nobody could say whose event it is.
void Sort(b2Fixture *fixture, uint16_t category, uint16_t mask) {
    b2Filter filter;
    filter.categoryBits = category;
    filter.maskBits = mask;
    fixture->SetFilterData(filter);
}

void AddWalls(Game &game) {
    for (int side = 0; side < 4; ++side) {
        const b2Rot turn(0.5f * b2_pi * Real(side));
        b2Body *wall =
            game.Body(b2_staticBody, b2Mul(turn, b2Vec2(0.0f, -kArena - 0.5f)), 0.5f * b2_pi * Real(side));
        Sort(game.Box(wall, kArena + 1.0f, 0.5f), kWall, kWall | kPiece | kOfMany);
    }
}

/// A box, a triangle, a coin, a plank of ten boxes, or a sensor.
void AddBody(Game &game, shapes::Engine &random, bool big) {
    b2Body *body =
        game.Body(b2_dynamicBody, {shapes::UniformF(random, -6.0, 6.0), shapes::UniformF(random, -6.0, 6.0)},
                  shapes::UniformF(random, 0.0, 6.0));
    body->SetLinearVelocity({shapes::UniformF(random, -4.0, 4.0), shapes::UniformF(random, -4.0, 4.0)});
    body->SetAngularVelocity(shapes::UniformF(random, -3.0, 3.0));
    const int kind = shapes::Below(random, 12);
    if (kind == 0) {
        game.Plank(body);
        for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            Sort(f, kOfMany, kWall | kPiece | kOfMany);
        return;
    }
    bmr::ConvexShape coin;
    b2PolygonShape small;
    const float half = shapes::UniformF(random, 0.15, 0.7);
    const b2Vec2 triangle[3] = {{-half, -half}, {half, -half}, {0.0f, half}};
    if (kind < 8)
        small.SetAsBox(half, shapes::UniformF(random, 0.1, 0.6));
    else
        small.Set(triangle, 3);
    const bool isCoin =
        big && kind > 4 && coin.SetEllipse(9 + shapes::Below(random, 60), half, 0.4f * half) == BMR_OK;
    const b2Shape &shape = isCoin ? static_cast<const b2Shape &>(coin) : small;
    const bool sensor = kind == 1;
    b2Fixture *fixture = game.Fixture(body, shape, sensor);
    fixture->SetRestitution(0.9f);
    if (sensor)
        Sort(fixture, kSensor, kPiece);
    else
        Sort(fixture, kPiece, kWall | kPiece | kOfMany | kSensor);
}

uint32_t seed = 1;

/// `witness` may be nullptr.
void PlayCrowd(Run &run, Witness *witness, bool big) {
    shapes::Engine random(seed);
    Heard game(run, {0.0f, seed % 2 == 0 ? 0.0f : -10.0f});
    if (witness != nullptr)
        witness->Watch(&game.world);
    AddWalls(game);
    for (int i = 0; i < 45; ++i)
        AddBody(game, random, big);
    for (int i = 0; i < 150; ++i) {
        game.Step();
        if (witness != nullptr)
            witness->CheckContacts(game.world);
    }
}

void CheckThatItLived(Run &run, const Witness &witness) {
    for (const bmr_event_kind kind : {BMR_EVENT_START, BMR_EVENT_PUSH, BMR_EVENT_CONTACT, BMR_EVENT_LEAVE})
        run.Expect(witness.Count(kind) > 0, "there are events of every common kind");
    run.Expect(witness.Count(BMR_EVENT_CONTACT) >= witness.Count(BMR_EVENT_LEAVE),
               "who leaves was in contact");
}

void PlaySmall(Run &run, Witness &witness) {
    PlayCrowd(run, &witness, false);
    CheckThatItLived(run, witness);
}

void PlayBig(Run &run, Witness &witness) {
    PlayCrowd(run, &witness, true);
    CheckThatItLived(run, witness);
    run.Expect(witness.Count(BMR_EVENT_STAB) > 0 && witness.Count(BMR_EVENT_COARSEN) > 0,
               "disks come and go");
}

void PlaySmallUnheard(Run &run) {
    PlayCrowd(run, nullptr, false);
}
void PlayBigUnheard(Run &run) {
    PlayCrowd(run, nullptr, true);
}

/// With each structure, and with and without remembered edges.
template <typename Check> void ForSettings(Check check) {
    const uint32_t seeds = std::max(3u, static_cast<uint32_t>(test_scaled(6)));
    for (seed = 1; seed <= seeds; ++seed) {
        bmr::Options options;
        const PairsBy by(seed % 3 != 0 ? nullptr : seed % 2 == 1 ? "lazy-compass" : "free-direction");
        CAPTURE(seed);
        check(options);
    }
}

} // namespace

TEST_CASE("contacts of small polygons live as the header allows, and as if nobody listened") {
    ForSettings([](const bmr::Options &options) {
        const std::string stock = InChild(PlaySmallUnheard);
        CHECK(Difference(stock, Told(PlaySmall, options)) == "");
        CHECK(Difference(stock, InChild(PlaySmallUnheard, &options)) == "");
    });
}

TEST_CASE("contacts of big polygons live as the header allows, and as if nobody listened") {
    ForSettings([](const bmr::Options &options) {
        const std::string quiet = InChild(PlayBigUnheard, &options);
        CHECK(Difference(quiet, Told(PlayBig, options)) == "");
    });
}
