// SPDX-License-Identifier: MIT
// The law of outlines: what one piece leaves to another is answered by that other, at those poses, in that
// call. What is inside of the outline is touched where it is inside, and an impact with it is an impact.
#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "cases.h"

#include "box2d_shapes.h"
#include "plain_pieces.h"

using namespace shapes;

namespace {

constexpr float kSkins = 2.0f * b2_polygonRadius, kRounding = 1e-4f;

/// Where a box of half sizes 0.15 and 0.05 is after one step: how far from the origin, and whether any impact
/// was dropped.
struct Thrown {
    float distance;
    bool dropped;
};

bool AnyIsDropped(const b2World &world) {
    bool dropped = false;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        dropped = dropped || !contact->IsEnabled();
    return dropped;
}

Thrown ThrowAtABentWall(bool seams) {
    std::vector<b2Vec2> points;
    for (const int degrees : {-60, -45, -30, 30, 45, 60}) {
        const double angle = std::abs(degrees) * -3.14159265358979 / 180.0, r = degrees < 0 ? 4.5 : 4.0;
        points.emplace_back(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)));
    }
    bmr::OutlineShape wall;
    REQUIRE(wall.Set(points.data(), 6) == BMR_OK);
    REQUIRE(wall.GetPieceCount() == 2);
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body *const ground = world.CreateBody(&def);
    const b2FixtureDef still;
    if (seams)
        REQUIRE(wall.CreateFixtures(ground, still) == BMR_OK);
    else
        outlines::AddPlainPieces(ground, still, wall);
    def.type = b2_dynamicBody;
    def.position.Set(2.3907f, -2.9298f);
    def.angle = 2.1437f;
    def.linearVelocity.Set(31.44f, 16.02f);
    def.angularVelocity = 94.25f;
    b2Body *const body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(0.15f, 0.05f);
    body->CreateFixture(&box, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    return {body->GetPosition().Length(), AnyIsDropped(world)};
}

/// A dart at a wall 8 km from the origin. Where Box2D says that it hits the one piece it is farther away from
/// that than the skins, and touches the other. Is the impact dropped?
bool IsDartDropped(bool seams) {
    const b2Vec2 points[] = {{0x1.fbad2p+1f, -0x1.09985ep-1f},  {0x1.b731e6p+1f, -0x1.a20e6ep+0f},
                             {0x1.73b0cap+1f, -0x1.601f5p+1f},  {0x1.d0e7b8p+0f, -0x1.ab4274p+1f},
                             {0x1.76ed22p-1f, -0x1.f758e2p+1f}, {0x1.9296ecp+0f, -0x1.0e3e2cp+3f},
                             {0x1.0e3e2cp+3f, 0x1.929702p+0f}};
    bmr::OutlineShape wall;
    REQUIRE(wall.Set(points, 7) == BMR_OK);
    REQUIRE(wall.GetPieceCount() == 2);
    b2World world(b2Vec2_zero);
    b2BodyDef def;
    def.position.Set(-0x1.b9c6ap+12f, -0x1.d45562p+11f);
    def.angle = 0.154974461f;
    b2Body *const ground = world.CreateBody(&def);
    const b2FixtureDef still;
    if (seams)
        REQUIRE(wall.CreateFixtures(ground, still) == BMR_OK);
    else
        outlines::AddPlainPieces(ground, still, wall);
    def.type = b2_dynamicBody;
    def.position.Set(-0x1.b994a2p+12f, -0x1.d49df4p+11f);
    def.angle = -0x1.ac6b48p+0f;
    def.linearVelocity.Set(0x1.192d26p+3f, 0x1.678504p+1f);
    def.angularVelocity = 0x1.01fdp+2f;
    b2PolygonShape dart;
    const b2Vec2 tips[] = {
        {0.0210733656f, 0.0702445507f}, {-0.0210733656f, 0.0702445507f}, {0.0f, -0.0702445507f}};
    dart.Set(tips, 3);
    world.CreateBody(&def)->CreateFixture(&dart, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    return AnyIsDropped(world);
}

bmr::OutlineShape RandomOutline(Engine &engine) {
    const int count = 6 + Below(engine, 14);
    std::vector<b2Vec2> ring, inner;
    for (int i = 0; i < count; ++i) {
        const float angle = 6.2831853f * (static_cast<float>(i) + UniformF(engine, 0.0, 0.7)) /
                            static_cast<float>(count),
                    r = UniformF(engine, 0.5, 1.5);
        ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
        inner.push_back(0.6f * ring.back());
    }
    const bmr::OutlineHole hole = {inner.data(), count};
    bmr::OutlineShape outline;
    REQUIRE(outline.Set(ring.data(), count, &hole, Below(engine, 2)) == BMR_OK);
    return outline;
}

enum class Other { Box, Coin, Circle, Edge, Chain, Outline };

void AddOther(b2Body *body, Other other, Engine &engine, bool seams) {
    const float size = std::pow(10.0f, UniformF(engine, -2.0, -0.1));
    b2FixtureDef def;
    def.density = 1.0f;
    b2PolygonShape box;
    bmr::ConvexShape coin;
    b2CircleShape circle;
    b2EdgeShape edge;
    b2ChainShape chain;
    box.SetAsBox(size, size * UniformF(engine, 0.1, 1.0));
    REQUIRE(coin.SetRegular(9 + Below(engine, 40), size) == BMR_OK);
    circle.m_radius = size;
    edge.SetTwoSided(b2Vec2(-size, 0.0f), b2Vec2(size, 0.0f));
    const b2Vec2 line[] = {{-size, 0.0f}, {0.0f, 0.2f * size}, {size, 0.0f}};
    chain.CreateChain(line, 3, b2Vec2(-2.0f * size, 0.0f), b2Vec2(2.0f * size, 0.0f));
    if (other == Other::Outline) {
        const bmr::OutlineShape outline = RandomOutline(engine);
        if (seams)
            REQUIRE(outline.CreateFixtures(body, def) == BMR_OK);
        else
            outlines::AddPlainPieces(body, def, outline);
        return;
    }
    const b2Shape *const all[] = {&box, &coin, &circle, &edge, &chain};
    def.shape = all[static_cast<int>(other)];
    body->CreateFixture(&def);
}

/// An outline and another body at a random pose, looked at without a step of time. Of the outline's pieces
/// one may be out of the game: `filtered`.
struct Pose {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *whole, *body;

    Pose(Other other, uint64_t seed, bool seams) {
        Engine engine(1000 + seed);
        const bmr::OutlineShape outline = RandomOutline(engine);
        b2BodyDef def;
        whole = world.CreateBody(&def);
        b2FixtureDef fixture;
        if (seams)
            REQUIRE(outline.CreateFixtures(whole, fixture) == BMR_OK);
        else
            outlines::AddPlainPieces(whole, fixture, outline);
        if (Below(engine, 3) == 0) {
            b2Fixture *filtered = whole->GetFixtureList();
            for (int i = Below(engine, outline.GetPieceCount()); i > 0; --i)
                filtered = filtered->GetNext();
            b2Filter none;
            none.maskBits = 0;
            filtered->SetFilterData(none);
        }
        def.type = b2_dynamicBody;
        def.position.Set(UniformF(engine, -1.5, 1.5), UniformF(engine, -1.5, 1.5));
        def.angle = UniformF(engine, -3.2, 3.2);
        body = world.CreateBody(&def);
        AddOther(body, other, engine, seams);
        world.Step(0.0f, 8, 3);
    }

    /// Do the two overlap somewhere, by more than rounding, as contacts with points tell?
    bool Overlaps() const {
        for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            b2WorldManifold manifold;
            c->GetWorldManifold(&manifold);
            for (int32 i = 0; i < c->GetManifold()->pointCount; ++i)
                if (manifold.separations[i] < -kSkins - kRounding)
                    return true;
        }
        return false;
    }

    bool Touches() const {
        for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext())
            if (c->GetManifold()->pointCount > 0)
                return true;
        return false;
    }
};

/// How far is the place, in its body's frame, outside of the polygon?
float Outside(const bmr::ConvexShape &polygon, const b2Vec2 &place) {
    float most = -1e9f;
    for (int32 i = 0; i < polygon.GetVertexCount(); ++i)
        most = std::max(most, b2Dot(polygon.GetNormal(i), place - polygon.GetVertex(i)));
    return most;
}

/// Is each vertex of one body's polygons that is in a polygon of the other's, and takes part, near a polygon
/// there that touches? Counts those that are inside.
bool AreTouchedWhereInside(const Pose &pose, const b2Body &one, const b2Body &other, int *inside) {
    bool all = true;
    for (const b2Fixture *f = one.GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const bmr::ConvexShape *polygon = bmr::ConvexShape::From(f->GetShape());
        for (int32 i = 0; polygon != nullptr && i < polygon->GetVertexCount(); ++i) {
            const b2Vec2 place = other.GetLocalPoint(one.GetWorldPoint(polygon->GetVertex(i)));
            bool in = false, touched = false;
            for (const b2Contact *c = pose.world.GetContactList(); c != nullptr; c = c->GetNext()) {
                const b2Fixture *const at =
                    c->GetFixtureA()->GetBody() == &other ? c->GetFixtureA() : c->GetFixtureB();
                const b2Fixture *const by = at == c->GetFixtureA() ? c->GetFixtureB() : c->GetFixtureA();
                const float outside = Outside(*bmr::ConvexShape::From(at->GetShape()), place);
                in = in || (by == f && outside < -kRounding);
                touched = touched || (c->GetManifold()->pointCount > 0 && outside <= kSkins + kRounding);
            }
            *inside += in;
            all = all && (!in || touched);
        }
    }
    return all;
}

} // namespace

TEST_CASE(
    "a box that one piece is found to be hit by does not go on because that piece leaves it to another") {
    const Thrown outline = ThrowAtABentWall(true), pieces = ThrowAtABentWall(false);
    MESSAGE("the outline stops it at " << outline.distance << ", the pieces at " << pieces.distance);
    CHECK(pieces.distance < 3.85f);
    CHECK(outline.distance < 3.85f);
    CHECK_FALSE(outline.dropped);
}

TEST_CASE("an impact that Box2D finds with a piece beyond the skins is one with the piece that touches") {
    CHECK(IsDartDropped(false));
    CHECK_FALSE(IsDartDropped(true));
}

TEST_CASE("what overlaps an outline touches it, also where a piece is not in the game") {
    const size_t poses = test_scaled(1500);
    for (const Other other :
         {Other::Box, Other::Coin, Other::Circle, Other::Edge, Other::Chain, Other::Outline}) {
        size_t overlapping = 0;
        for (size_t n = 0; n < poses; ++n) {
            const Pose pose(other, n, true), plain(other, n, false);
            if (!plain.Overlaps())
                continue;
            ++overlapping;
            CAPTURE(n);
            CAPTURE(static_cast<int>(other));
            CHECK(pose.Touches());
        }
        CHECK(overlapping > poses / 10);
    }
}

TEST_CASE("what is inside of an outline is touched where it is inside") {
    for (const Other other : {Other::Coin, Other::Outline}) {
        int inside = 0;
        for (size_t n = 0; n < test_scaled(1500); ++n) {
            const Pose pose(other, n, true);
            CAPTURE(n);
            CAPTURE(static_cast<int>(other));
            CHECK(AreTouchedWhereInside(pose, *pose.body, *pose.whole, &inside));
            CHECK(AreTouchedWhereInside(pose, *pose.whole, *pose.body, &inside));
        }
        CHECK(inside > 20);
    }
}
