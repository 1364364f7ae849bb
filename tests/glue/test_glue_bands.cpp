// SPDX-License-Identifier: MIT
// How far out a fixture's row is (glue/pairs/fixture_motion.h): its pairs' margins grow with it, a row that
// comes into another band has its pairs looked at, and one that trembles about a border does not.
#include <box2d/box2d.h>

#include "cases.h"
#include "glue/pairs/fixture_motion.h"

namespace {

constexpr float kBorder = bmr::kBandReach;

/// One box whose row has a proof, so that looks read it.
struct Yard {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *body;
    b2Fixture *fixture;
    bmr::FixtureMotions motions;
    uint32_t row;
    uint64_t look = 0;

    explicit Yard(float half = 0.5f) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        body = world.CreateBody(&def);
        b2PolygonShape box;
        box.SetAsBox(half, half);
        fixture = body->CreateFixture(&box, 1.0f);
        row = motions.Acquire(fixture, BroadPhase(), ++look);
        motions.AddProof(row, BroadPhase(), look);
    }
    const b2BroadPhase &BroadPhase() const { return world.GetContactManager().m_broadPhase; }

    /// The row's bits after a look with the body there.
    uint8_t At(float x, float y = 0.0f) {
        body->SetTransform({x, y}, 0.3f);
        motions.SetBits(row, motions.Bits(row) & static_cast<uint8_t>(~(bmr::kChanged | bmr::kChangedLate)));
        motions.Update(row, BroadPhase(), ++look, false);
        return motions.Bits(row);
    }
    int Band() const { return motions.Band(row, row); }
};

} // namespace

TEST_CASE("a row is in the band that its body is in") {
    Yard yard;
    CHECK(yard.Band() == 0);
    CHECK(yard.motions.RoundingMargin(yard.row, yard.row) == bmr::kRoundingMargin);
    for (int band = 1; band < bmr::kBands; ++band) {
        const float from = std::ldexp(kBorder, band - 1), to = std::ldexp(kBorder, band) - 5.0f;
        for (const b2Vec2 place : {b2Vec2(from + 1.0f, 0.0f), b2Vec2(0.0f, -from - 1.0f), b2Vec2(to, -to)}) {
            CAPTURE(place.x);
            CAPTURE(place.y);
            yard.At(0.0f);
            const uint8_t bits = yard.At(place.x, place.y);
            CHECK((bits & bmr::kPlain) == 0);
            CHECK((bits & bmr::kChanged) != 0); // its pairs' lines left less
            CHECK(yard.Band() == band);
            CHECK(yard.motions.RoundingMargin(yard.row, yard.row) == bmr::BandMargin(band));
        }
    }
}

TEST_CASE("margins grow at least as the bands do") {
    for (int band = 1; band < bmr::kBands; ++band)
        CHECK(bmr::BandMargin(band) >= 2.0 * bmr::BandMargin(band - 1));
}

TEST_CASE("the extent counts as much as the analysis says") {
    constexpr float half = 50.0f, far = half * 1.41422f * bmr::kBandReachOfExtent;
    Yard yard(half);
    yard.At(kBorder - far - 1.0f);
    CHECK(yard.Band() == 0);
    yard.At(kBorder - far + 1.0f);
    CHECK(yard.Band() == 1);
    // Larger than band 0 has room for: nowhere.
    Yard large(kBorder);
    for (const float x : {0.0f, 2.0f * kBorder})
        CHECK((large.At(x) & bmr::kPlain) != 0);
}

TEST_CASE("who trembles about a border is in the farther band, and nothing is said of it") {
    Yard yard;
    CHECK((yard.At(kBorder + 1.0f) & bmr::kChanged) != 0);
    for (int i = 0; i < 10; ++i) {
        CHECK((yard.At(kBorder - 5.0f) & bmr::kChanged) == 0);
        CHECK((yard.At(kBorder + 5.0f) & bmr::kChanged) == 0);
        CHECK(yard.Band() == 1);
    }
    // What was proved of impacts went by the larger margin.
    CHECK((yard.At(0.5f * kBorder) & bmr::kChanged) != 0);
    CHECK(yard.Band() == 0);
    yard.At(7.0f * kBorder);
    CHECK(yard.Band() == 3);
    yard.At(0.9f * kBorder); // past the borders between
    CHECK(yard.Band() == 1);
}

TEST_CASE("beyond the last band, and nowhere, there is no budget") {
    const float last = std::ldexp(kBorder, bmr::kBands - 1);
    Yard yard;
    CHECK((yard.At(last - 5.0f) & bmr::kPlain) == 0);
    const uint8_t gone = yard.At(last + 5.0f);
    CHECK((gone & bmr::kPlain) != 0);
    CHECK((gone & bmr::kChanged) != 0);
    CHECK((yard.At(0.0f) & bmr::kPlain) == 0);
    CHECK((yard.At(1e30f) & bmr::kPlain) != 0);
}
