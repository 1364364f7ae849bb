// SPDX-License-Identifier: MIT
// The table of pairs (glue/pairs). How far out a fixture's row is: its pairs' margins grow with it, a row
// that comes into another band has its pairs looked at, and one that trembles about a border does not. How
// far a row can come in the sweep of its body: what the budget of a pair is held against, ahead of Box2D's
// search for impacts. Code of the game may have run since the row was looked at: the body need not turn about
// what it turned about, nor be of the same shape. And when a pass over the table pays.
#include <box2d/box2d.h>

#include "base/private_members.h"
#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "glue/pairs/fixture_motion.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/table_cost.h"
#include "random.h"
#include "shapes/small_polygon.h"

namespace {

/// One fixture whose row has a proof, so that looks read it.
struct Row {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *body;
    b2PolygonShape *shape;
    bmr::FixtureMotions motions;
    uint32_t row;
    uint64_t stamp = 0;

    explicit Row(const b2PolygonShape &polygon) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        body = world.CreateBody(&def);
        b2Fixture *const fixture = body->CreateFixture(&polygon, 1.0f);
        shape = static_cast<b2PolygonShape *>(fixture->GetShape());
        row = motions.Acquire(fixture, BroadPhase(), ++stamp);
        motions.AddProof(row, BroadPhase(), stamp);
    }
    const b2BroadPhase &BroadPhase() const { return world.GetContactManager().m_broadPhase; }
    void Update() { motions.Update(row, BroadPhase(), ++stamp, false); }
};

constexpr float kBorder = bmr::kBandReach;

b2PolygonShape Square(float half) {
    b2PolygonShape box;
    box.SetAsBox(half, half);
    return box;
}

struct Yard : Row {
    explicit Yard(float half = 0.5f) : Row(Square(half)) {}

    /// The row's bits after an update with the body there.
    uint8_t At(float x, float y = 0.0f) {
        body->SetTransform({x, y}, 0.3f);
        motions.SetBits(row, motions.Bits(row) & static_cast<uint8_t>(~(bmr::kChanged | bmr::kChangedLate)));
        Update();
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
            CHECK((bits & bmr::kNoBudget) == 0);
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
        CHECK((large.At(x) & bmr::kNoBudget) != 0);
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
    CHECK((yard.At(last - 5.0f) & bmr::kNoBudget) == 0);
    const uint8_t gone = yard.At(last + 5.0f);
    CHECK((gone & bmr::kNoBudget) != 0);
    CHECK((gone & bmr::kChanged) != 0);
    CHECK((yard.At(0.0f) & bmr::kNoBudget) == 0);
    CHECK((yard.At(1e30f) & bmr::kNoBudget) != 0);
}

namespace {

b2PolygonShape Triangle() {
    const b2Vec2 corners[3] = {{-0.3f, -0.2f}, {0.9f, -0.1f}, {-0.2f, 0.8f}};
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    return triangle;
}

struct Swept : Row {
    Swept() : Row(Triangle()) {}
    b2Sweep &Sweep() { return body->*Named(bmr::SweepMember()); }

    /// In units, from the last update on.
    uint32_t End(bool careful = true) {
        motions.UpdateEnd(row, careful, ++stamp);
        return motions.End(row) - motions.Moved(row);
    }
    /// As Box2D's solver leaves it: from the body's place on.
    void Move(b2Vec2 by, float turn) {
        b2Sweep &sweep = Sweep();
        sweep.c0 = sweep.c;
        sweep.a0 = sweep.a;
        sweep.c += by;
        sweep.a += turn;
        const_cast<b2Transform &>(body->GetTransform()).q.Set(sweep.a);
        const_cast<b2Transform &>(body->GetTransform()).p =
            sweep.c - b2Mul(body->GetTransform().q, sweep.localCenter);
    }
    void MoveCentre(b2Vec2 to) {
        b2MassData mass;
        body->GetMassData(&mass);
        mass.center = to;
        mass.I = mass.mass * (b2Dot(to, to) + 1.0f);
        body->SetMassData(&mass);
    }
};

bool IsNothingClaimed(uint32_t end) {
    return end >= BMR_BUDGET_MARK;
}

} // namespace

TEST_CASE("no point goes farther in a sweep than the row says") {
    int claimed = 0;
    for (int round = 0; round < 3000; ++round) {
        test_random random = {static_cast<uint64_t>(round)}; // each round can be played alone
        const auto between = [&random](double low, double high) {
            return static_cast<float>(test_random_uniform(&random, low, high));
        };
        Swept one;
        one.body->SetTransform({between(-9.0f, 9.0f), between(-9.0f, 9.0f)}, between(-7.0f, 7.0f));
        if (round % 2 == 0)
            one.MoveCentre({between(-0.5f, 0.5f), between(-0.5f, 0.5f)});
        const auto move = [&] {
            one.Move({between(-0.4f, 0.4f), between(-0.4f, 0.4f)},
                     round % 4 == 0 ? 0.0f : between(-0.5f, 0.5f));
        };
        const bool sleeps = round % 3 == 0; // its sweep is that of an earlier step
        if (sleeps)
            move();
        one.Update();
        const b2Transform before = one.body->GetTransform();
        // What a game may do that is told of contacts.
        if (round % 5 == 0)
            one.MoveCentre({between(-0.5f, 0.5f), between(-0.5f, 0.5f)});
        if (round % 7 == 0)
            for (b2Vec2 &v : one.shape->m_vertices)
                v *= 1.5f;
        if (!sleeps)
            move();
        const uint32_t end = one.End();
        if (IsNothingClaimed(end))
            continue;
        ++claimed;
        double farthest = 0.0;
        for (int step = 0; step <= 16; ++step) {
            b2Transform xf;
            one.Sweep().GetTransform(&xf, static_cast<float>(step) / 16.0f);
            for (int32 i = 0; i < one.shape->m_count; ++i) {
                const b2Vec2 way =
                    b2Mul(xf, one.shape->m_vertices[i]) - b2Mul(before, one.shape->m_vertices[i]);
                farthest = std::fmax(farthest, double{way.Length()});
            }
        }
        CAPTURE(round);
        CAPTURE(one.motions[one.row].mover.reach);
        REQUIRE(farthest * bmr::kUnits <= static_cast<double>(end) + 1.0);
    }
    CHECK(claimed > 1500);
}

TEST_CASE("nothing is claimed of what turns about another point, or is another shape") {
    for (const bool careful : {false, true}) {
        Swept one;
        one.Update();
        one.Move({0.1f, 0.0f}, 0.1f);
        CHECK(!IsNothingClaimed(one.End(careful)));
        one.shape->m_radius *= 2.0f;
        CHECK(IsNothingClaimed(one.End(careful)) == careful); // without a game nobody can have done that
        const b2Vec2 centre = one.body->GetLocalCenter();
        for (const b2Vec2 by : {b2Vec2(0.001f, 0.0f), b2Vec2(0.0f, 0.001f)}) {
            one.MoveCentre(centre);
            one.Update();
            one.Move({0.1f, 0.0f}, 0.1f);
            CHECK(!IsNothingClaimed(one.End(careful)));
            one.MoveCentre(centre + by);
            CHECK(IsNothingClaimed(one.End(careful)));
        }
    }
}

TEST_CASE("nothing is claimed beyond the reach and the angle that the margins of impacts are for") {
    const auto endAt = [](float x, float angle, b2Vec2 by, float turn) {
        Swept one;
        one.body->SetTransform({x, 0.0f}, angle);
        one.Update();
        one.Move(by, turn);
        return one.End();
    };
    const b2Vec2 little(0.01f, 0.0f), farther(4.0f, 0.0f);
    for (const float side : {-1.0f, 1.0f}) {
        const float near = side * (bmr::kImpactReach - 3.0f);
        CHECK(!IsNothingClaimed(endAt(near, 0.0f, side * little, 0.0f)));
        CHECK(IsNothingClaimed(endAt(near, 0.0f, side * farther, 0.0f)));                // in the end
        CHECK(IsNothingClaimed(endAt(near + 4.0f * side, 0.0f, -side * farther, 0.0f))); // in the beginning
        const float turned = side * (bmr::kImpactAngle - 0.5f);
        CHECK(!IsNothingClaimed(endAt(0.0f, turned, little, 0.1f * side)));
        CHECK(IsNothingClaimed(endAt(0.0f, turned, little, side)));
        CHECK(IsNothingClaimed(endAt(0.0f, turned + side, little, -side)));
    }
    // In the next band twice as far.
    CHECK(!IsNothingClaimed(endAt(2.0f * bmr::kImpactReach - 3.0f, 0.0f, little, 0.0f)));
    CHECK(IsNothingClaimed(endAt(2.0f * bmr::kImpactReach - 3.0f, 0.0f, farther, 0.0f)));
}

TEST_CASE("each vertex, normal, skin and count of a polygon that is edited in place makes another digest") {
    for (int32 count = 3; count <= b2_maxPolygonVertices; ++count) {
        b2PolygonShape shape;
        shape.Set(shapes::Circle(count, 0.3).data(), count);
        const uint64_t digest = bmr::DigestOf(shape);
        const auto differs = [&shape, digest](float *number) {
            const float before = *number;
            *number = std::nextafter(before, 9.0f);
            const bool is = bmr::DigestOf(shape) != digest;
            *number = before;
            return is;
        };
        CHECK(differs(&shape.m_radius));
        for (int32 i = 0; i < count; ++i)
            for (b2Vec2 *const v : {&shape.m_vertices[i], &shape.m_normals[i]})
                CHECK((differs(&v->x) && differs(&v->y)));
        if (count < b2_maxPolygonVertices) // the control: what is past the count does not belong to it
            CHECK_FALSE(differs(&shape.m_vertices[count].x));
        CHECK(bmr::DigestOf(shape) == digest);
        --shape.m_count;
        CHECK(bmr::DigestOf(shape) != digest);
    }
}

TEST_CASE("a row has the length of its shortest side, which may be the last; of a big polygon it has none") {
    const b2Vec2 corners[3] = {{1.0f, 0.2f}, {0.0f, 1.0f}, {0.9f, 0.0f}};
    b2PolygonShape shape;
    shape.Set(corners, 3);
    const Row last(shape), middle(Triangle());
    CHECK(last.motions[last.row].shortest == (shape.m_vertices[2] - shape.m_vertices[0]).Length());
    CHECK(middle.motions[middle.row].shortest ==
          (middle.shape->m_vertices[2] - middle.shape->m_vertices[1]).Length());
    bmr::ConvexShape disc;
    REQUIRE(disc.SetRegular(32, 0.5f) == BMR_OK);
    const Row big(disc);
    CHECK(big.motions[big.row].shortest == 0.0f);
}

TEST_CASE("who was not looked at in the sweeps may stop others") {
    Swept one;
    CHECK((one.motions.SweepBits(one.row) & bmr::kBulletOrStatic) != 0);
}

TEST_CASE("a budget outlasts sweeps if it was proved for impacts, too") {
    b2World world(b2Vec2(0.0f, 0.0f));
    for (const float x : {0.0f, 1.05f}) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position.Set(x, 0.0f);
        b2PolygonShape box;
        box.SetAsBox(0.5f, 0.5f);
        world.CreateBody(&def)->CreateFixture(&box, 1.0f);
    }
    world.Step(1.0f / 60.0f, 1, 1);
    REQUIRE(world.GetContactCount() == 1);
    bmr::PairTable table(const_cast<b2ContactManager *>(&world.GetContactManager()));
    REQUIRE(table.Follow());
    table.UpdateMotions();
    const auto outlasts = [&table] {
        table.BeginSearch();
        return table.OutlastsSweeps(0);
    };
    const bmr_vec2 across = {1.0, 0.0};
    CHECK(!outlasts()); // without a proof
    for (const bool forImpactsToo : {true, false, true}) {
        REQUIRE(table.BeginProof(0));
        table.Prove(0, across, 0.05, 0.01, forImpactsToo);
        CHECK(outlasts() == forImpactsToo);
    }
    REQUIRE(table.BeginProof(0));
    table.Prove(0, {0.0, 0.0}, 0.05, 0.01, false); // as a sensor's overlap is
    CHECK(!outlasts());
}

namespace {

constexpr uint32_t kPairs = 200;

/// How many of 2,000 steps go by the list in a world of which each step is so.
int StepsByList(uint32_t updates, uint32_t fixtures, uint32_t awake, int searches, uint32_t pairs = kPairs) {
    bmr::TableCost cost;
    int byList = 0;
    for (int step = 0; step < 2000; ++step) {
        if (!cost.CountStep()) {
            ++byList;
            cost.NoteList(pairs, awake);
            continue;
        }
        for (int i = 0; i < searches; ++i)
            cost.NoteSearch();
        cost.NotePass(step == 0 ? pairs : updates, fixtures, pairs, awake);
    }
    return byList;
}

} // namespace

TEST_CASE("a table rests where most pairs are updated, and works where few are") {
    CHECK(StepsByList(5, 60, kPairs, 0) == 0);
    // Nine passes of 265 steps are tries.
    CHECK(StepsByList(kPairs, 60, kPairs, 0) > 1900);
    CHECK(StepsByList(kPairs, 60, kPairs, 0) < 2000);
}

TEST_CASE("searches for impacts, and walks over many contacts, are a reason to work") {
    CHECK(StepsByList(kPairs, 60, kPairs, 100) == 0);
    CHECK(StepsByList(3000, 3000, 4096, 0, 4096) > 1900);
    CHECK(StepsByList(3000, 3000, 4097, 0, 4097) == 0);
}

TEST_CASE("a world of fewer pairs than a pass costs is stepped by its list; sleepers end a rest") {
    CHECK(StepsByList(2, 20, 30, 0, 30) > 1900);
    bmr::TableCost cost;
    for (int pass = 0; pass < 9; ++pass)
        cost.NotePass(kPairs, kPairs, kPairs, kPairs);
    REQUIRE_FALSE(cost.CountStep());
    cost.NoteList(kPairs, kPairs);
    REQUIRE_FALSE(cost.CountStep());
    cost.NoteList(kPairs, 3);
    CHECK(cost.CountStep());
}
