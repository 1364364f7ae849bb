// SPDX-License-Identifier: MIT
// Mode::Verify tells two answers apart by each of their fields, counts all differences and describes the
// first.
#include "as_stock.h"
#include "base/private_members.h"
#include "debug/verify.h"

using namespace as_stock;

namespace {

b2Manifold TwoPoints() {
    b2Manifold m = {};
    m.type = b2Manifold::e_faceA;
    m.localNormal.Set(1.0f, 0.0f);
    m.localPoint.Set(0.5f, -0.5f);
    m.pointCount = 2;
    for (int i = 0; i < 2; ++i) {
        m.points[i].localPoint.Set(static_cast<float>(i), 2.0f);
        m.points[i].id.key = static_cast<uint32>(i);
    }
    return m;
}

/// What comparisons add to the counts of a process that compares for the first time, and what it says of
/// them.
struct Verdict {
    unsigned verified = 0, differences = 0;
    std::string line;
};
template <typename Verify> Verdict By(Verify verify) {
    static const Verify *chosen;
    chosen = &verify;
    const std::string text = InChild([](Run &run) {
        const std::string line = StderrOf(*chosen);
        const bmr::Counted s = bmr::internal::ReadCounts();
        run.Print("%u %u", static_cast<unsigned>(s.verified), static_cast<unsigned>(s.differences));
        run.Print("%s", line.c_str());
    });
    Verdict verdict;
    REQUIRE(std::sscanf(text.c_str(), "%u %u", &verdict.verified, &verdict.differences) == 2);
    verdict.line = text.substr(text.find('\n') + 1);
    return verdict;
}

/// One comparison, of which there is a line if it finds a difference.
bool OneDiffers(const Verdict &verdict) {
    CHECK(verdict.verified == 1);
    CHECK((verdict.line != "\n") == (verdict.differences == 1));
    return verdict.differences == 1;
}

bool Differ(const b2Manifold &ours, const b2Manifold &box2d) {
    return OneDiffers(By([&] { bmr::VerifyManifold(nullptr, nullptr, ours, box2d); }));
}

bool Differ(bool ours, bool box2d) {
    return OneDiffers(By([&] { bmr::VerifyAnswer("a sensor's overlap", nullptr, nullptr, ours, box2d); }));
}

bool Holds(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("manifolds differ by each field that has a meaning") {
    const b2Manifold stock = TwoPoints();
    CHECK(!Differ(stock, stock));
    b2Manifold ours[8];
    for (b2Manifold &m : ours)
        m = stock;
    ours[0].pointCount = 1;
    ours[1].type = b2Manifold::e_faceB;
    ours[2].localNormal.y = 1e-40f;
    ours[3].localPoint.x = std::nextafterf(0.5f, 1.0f);
    ours[4].points[1].localPoint.y = std::nextafterf(2.0f, 3.0f);
    ours[5].points[1].id.key = 7;
    for (int i = 0; i < 6; ++i) {
        CAPTURE(i);
        CHECK(Differ(ours[i], stock));
    }
    ours[6].localNormal.y = -0.0f; // a zero is a zero
    ours[7].points[0].normalImpulse = 3.0f;
    CHECK(!Differ(ours[6], stock));
    CHECK(!Differ(ours[7], stock));
}

TEST_CASE("without points, or where both are no numbers, there is nothing to differ") {
    b2Manifold ours = TwoPoints(), box2d = {};
    ours.pointCount = 0;
    CHECK(!Differ(ours, box2d));
    ours = box2d = TwoPoints();
    ours.localPoint.x = box2d.localPoint.x = NAN;
    CHECK(!Differ(ours, box2d));
    box2d.localPoint.x = 0.0f;
    CHECK(Differ(ours, box2d));
}

TEST_CASE("overlaps differ by their answer") {
    for (const bool ours : {false, true})
        for (const bool box2d : {false, true})
            CHECK(Differ(ours, box2d) == (ours != box2d));
}

TEST_CASE("a contact is held against Box2D's own answer where its bodies are") {
    b2World world({0.0f, 0.0f});
    b2PolygonShape box, wide;
    box.SetAsBox(1.0f, 1.0f);
    wide.SetAsBox(20.0f, 1.0f);
    b2EdgeShape edge;
    edge.SetTwoSided({-1.0f, 0.95f}, {1.0f, 0.95f});
    b2ChainShape chain;
    const b2Vec2 links[] = {{1.0f, 0.95f}, {0.0f, 0.95f}, {-1.0f, 0.95f}};
    chain.CreateChain(links, 3, {2.0f, 0.95f}, {-2.0f, 0.95f});
    b2BodyDef def;
    const b2Shape *const shapes[] = {&box, &edge, &chain, &box};
    for (int i = 0; i < 4; ++i) {
        def.position.Set(5.0f * Real(i), 0.0f);
        b2FixtureDef fixture;
        fixture.shape = shapes[i];
        fixture.isSensor = i == 3;
        world.CreateBody(&def)->CreateFixture(&fixture);
    }
    def.type = b2_dynamicBody;
    def.position.Set(7.5f, 1.9f);
    world.CreateBody(&def)->CreateFixture(&wide, 1.0f);
    world.Step(0.0f, 1, 1);
    int contacts = 0;
    for (b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const auto differs = [contact] { return OneDiffers(By([&] { bmr::VerifyContact(*contact); })); };
        const bool isSensor = contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
        ++contacts;
        CHECK(!differs());
        if (isSensor)
            bmr::ContactAccess::Flags(contact) ^= bmr::ContactAccess::kTouching;
        else
            contact->GetManifold()->pointCount = 0;
        CHECK(differs());
    }
    CHECK(contacts >= 4);
}

TEST_CASE("the first difference is described with its step, its question and its fixtures") {
    b2World world({0.0f, 0.0f});
    b2BodyDef def;
    def.position.Set(3.0f, -4.0f);
    def.angle = 0.5f;
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    const b2Fixture *fixture = world.CreateBody(&def)->CreateFixture(&box, 1.0f);

    const b2Manifold none = {};
    const std::string manifold = By([&] { bmr::VerifyManifold(fixture, nullptr, none, TwoPoints()); }).line;
    CHECK(Holds(manifold, "boomerang: first difference from Box2D, step 0: a manifold; fixture 0x"));
    CHECK(Holds(manifold, " (at 3, -4, angle 0.5)\n"));
    CHECK(Holds(By([&] { bmr::VerifyAnswer("a sensor's overlap", fixture, fixture, true, false); }).line,
                "a sensor's overlap; fixture 0x"));
}

TEST_CASE("of many differences the first alone is described") {
    const Verdict verdict = By([] {
        for (int i = 0; i < 3; ++i)
            bmr::VerifyAnswer("a sensor's overlap", nullptr, nullptr, true, false);
    });
    CHECK(verdict.differences == 3);
    CHECK(Holds(verdict.line, "first difference"));
    CHECK(verdict.line.find("first difference") == verdict.line.rfind("first difference"));
}
