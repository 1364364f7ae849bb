// SPDX-License-Identifier: MIT
// Over the seams of an outline's pieces things roll and slide as over one line: wheels and boxes on a ground
// that was cut in a hundred places, beside a chain with the same surface and beside triangles.
#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "cases.h"
#include "glue/contacts/convex_contact.h"

#include "plain_pieces.h"

namespace {

constexpr int kSeams = 100;
constexpr float kRadius = 0.5f;

enum class Ground { Chain, Outline, Triangles, Pieces };

/// The height of the ground's surface above x.
using Surface = std::function<float(float)>;

/// A surface from x = -5 to kSeams + 5, with a point at each whole number, and below it a comb: each of its
/// notches takes a cut up to the surface.
struct Terrain {
    std::vector<b2Vec2> surface; ///< from left to right
    std::vector<b2Vec2> outline; ///< counter-clockwise

    explicit Terrain(const Surface &height) {
        for (int i = -5; i <= kSeams + 5; ++i)
            surface.emplace_back(static_cast<float>(i), height(static_cast<float>(i)));
        const size_t last = surface.size() - 1;
        for (size_t i = 0; i < last; ++i) {
            const float depth = i % 2 == 0 ? -3.0f : -2.0f;
            outline.emplace_back(surface[i].x, depth);
        }
        outline.emplace_back(surface[last].x, -3.0f);
        outline.insert(outline.end(), surface.rbegin(), surface.rend());
    }
};

void AddTriangle(b2Body *body, const b2FixtureDef &def, b2Vec2 a, b2Vec2 b, b2Vec2 c) {
    const b2Vec2 corners[] = {a, b, c};
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    b2FixtureDef piece = def;
    piece.shape = &triangle;
    body->CreateFixture(&piece);
}

/// Returns how many seams there are on the surface.
int AddGround(b2World &world, const Terrain &terrain, Ground kind, float friction) {
    const b2BodyDef still;
    b2Body *body = world.CreateBody(&still);
    b2FixtureDef def;
    def.friction = friction;
    const std::vector<b2Vec2> &top = terrain.surface;
    if (kind == Ground::Outline || kind == Ground::Pieces) {
        bmr::OutlineShape outline;
        REQUIRE(outline.Set(terrain.outline.data(), static_cast<int32>(terrain.outline.size())) == BMR_OK);
        if (kind == Ground::Outline)
            REQUIRE(outline.CreateFixtures(body, def) == BMR_OK);
        else
            outlines::AddPlainPieces(body, def, outline);
        return outline.GetPieceCount() - 1;
    }
    if (kind == Ground::Triangles) {
        for (size_t i = 0; i + 1 < top.size(); ++i) {
            const b2Vec2 left(top[i].x, -3.0f), right(top[i + 1].x, -3.0f);
            AddTriangle(body, def, left, right, top[i + 1]);
            AddTriangle(body, def, left, top[i + 1], top[i]);
        }
        return static_cast<int>(top.size()) - 2;
    }
    const std::vector<b2Vec2> line(top.rbegin(), top.rend());
    b2ChainShape chain;
    chain.CreateChain(line.data(), static_cast<int32>(line.size()), line.front() + b2Vec2(1.0f, 0.0f),
                      line.back() - b2Vec2(1.0f, 0.0f));
    def.shape = &chain;
    body->CreateFixture(&def);
    return static_cast<int>(top.size()) - 2;
}

struct Mover {
    std::string name;
    std::unique_ptr<b2Shape> shape;
    float friction; ///< of the ground; the mover's is 1
    float bottom;   ///< its middle is so high above the ground
    bool rolls;
};

std::unique_ptr<b2Shape> Wheel(int vertices) {
    if (vertices == 0) {
        auto circle = std::make_unique<b2CircleShape>();
        circle->m_radius = kRadius;
        return circle;
    }
    auto wheel = std::make_unique<bmr::ConvexShape>();
    REQUIRE(wheel->SetRegular(vertices, kRadius) == BMR_OK);
    return wheel;
}

std::vector<Mover> Movers() {
    std::vector<Mover> movers;
    movers.push_back({"circle", Wheel(0), 1.0f, kRadius + b2_polygonRadius, true});
    movers.push_back({"wheel of 1024", Wheel(1024), 1.0f, kRadius + b2_polygonRadius, true});
    auto box = std::make_unique<b2PolygonShape>();
    box->SetAsBox(0.4f, 0.4f);
    movers.push_back({"box", std::move(box), 0.0f, 0.4f + 2.0f * b2_polygonRadius, false});
    return movers;
}

struct Ride {
    float speed;                          ///< at the end
    float lowest = 1e9f, highest = -1e9f; ///< above the surface
};

Ride RideOver(const Surface &height, Ground kind, const Mover &mover, float speed) {
    b2World world(b2Vec2(0.0f, -10.0f));
    const Terrain terrain(height);
    CHECK(AddGround(world, terrain, kind, mover.friction) >= kSeams / 2);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(0.25f, height(0.25f) + mover.bottom);
    def.linearVelocity.Set(speed, 0.0f);
    def.angularVelocity = mover.rolls ? -speed / (kRadius + b2_polygonRadius) : 0.0f;
    b2Body *body = world.CreateBody(&def);
    b2FixtureDef fixture;
    fixture.shape = mover.shape.get();
    fixture.density = 1.0f;
    fixture.friction = 1.0f;
    body->CreateFixture(&fixture);
    Ride ride;
    int steps = 0;
    for (; body->GetPosition().x < static_cast<float>(kSeams) && steps < 1500; ++steps) {
        world.Step(1.0f / 60.0f, 8, 3);
        if (steps < 20)
            continue;
        const float above = body->GetPosition().y - height(body->GetPosition().x);
        ride.lowest = std::min(ride.lowest, above);
        ride.highest = std::max(ride.highest, above);
    }
    ride.speed = body->GetLinearVelocity().x;
    return ride;
}

/// Of four rides (less at a small scale) at other speeds: what is lost, and how far the height over the
/// surface changes, in the mean.
struct Rides {
    float lost = 0.0f, heights = 0.0f;
};

Rides RideAll(const Surface &height, Ground kind, const Mover &mover) {
    Rides all;
    const size_t rides = std::min(test_scaled(4), size_t{4});
    for (size_t i = 0; i < rides; ++i) {
        const float speed = 7.0f + 1.5f * static_cast<float>(i);
        const Ride ride = RideOver(height, kind, mover, speed);
        all.lost += speed - ride.speed;
        all.heights += (ride.highest - ride.lowest) / static_cast<float>(rides);
    }
    return all;
}

void CheckRides(const Surface &height) {
    float lostOnPieces = 0.0f, lostOnTriangles = 0.0f;
    for (const Mover &mover : Movers()) {
        CAPTURE(mover.name);
        const Rides chain = RideAll(height, Ground::Chain, mover),
                    outline = RideAll(height, Ground::Outline, mover),
                    triangles = RideAll(height, Ground::Triangles, mover),
                    pieces = RideAll(height, Ground::Pieces, mover);
        MESSAGE(mover.name << ": lost, in m/s: chain " << chain.lost << ", outline " << outline.lost
                           << ", triangles " << triangles.lost << ", pieces without seams " << pieces.lost
                           << "; heights, in m: " << chain.heights << ", " << outline.heights << ", "
                           << triangles.heights << ", " << pieces.heights);
        CHECK(outline.lost - chain.lost <= 0.01f * triangles.lost);
        CHECK(outline.heights < chain.heights + 2.0f * b2_linearSlop);
        lostOnPieces += pieces.lost - chain.lost;
        lostOnTriangles += triangles.lost;
    }
    // The control: it is what the pieces know, not that they are few.
    CHECK(lostOnPieces > 0.05f * lostOnTriangles);
}

/// A ring rolls over a box, cut in an outline's pieces or in triangles. Its speed at the end.
float RollRing(Ground kind, float speed) {
    constexpr int points = 512, steps = 400;
    constexpr float inner = 0.6f;
    b2World world(b2Vec2(0.0f, -10.0f));
    const b2BodyDef still;
    b2PolygonShape floor;
    floor.SetAsBox(200.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
    world.CreateBody(&still)->CreateFixture(&floor, 0.0f)->SetFriction(1.0f);
    std::vector<b2Vec2> rim, hole;
    for (int i = 0; i < points; ++i) {
        const float angle = 2.0f * b2_pi * static_cast<float>(i) / points;
        rim.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle));
        if (i % 16 == 0)
            hole.push_back(inner * rim.back());
    }
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(-30.0f, kRadius + b2_polygonRadius);
    def.linearVelocity.Set(speed, 0.0f);
    def.angularVelocity = -speed / (kRadius + b2_polygonRadius);
    b2Body *ring = world.CreateBody(&def);
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    fixture.friction = 1.0f;
    if (kind == Ground::Triangles) {
        for (size_t i = 0; i < rim.size(); ++i) {
            const size_t next = (i + 1) % rim.size();
            AddTriangle(ring, fixture, inner * rim[i], rim[i], rim[next]);
        }
    } else {
        const bmr::OutlineHole holes[] = {{hole.data(), static_cast<int32>(hole.size())}};
        bmr::OutlineShape outline;
        REQUIRE(outline.Set(rim.data(), points, holes, 1) == BMR_OK);
        REQUIRE(outline.GetPieceCount() > 10);
        if (kind == Ground::Outline)
            REQUIRE(outline.CreateFixtures(ring, fixture) == BMR_OK);
        else
            outlines::AddPlainPieces(ring, fixture, outline);
    }
    for (int i = 0; i < steps; ++i)
        world.Step(1.0f / 60.0f, 8, 3);
    return ring->GetLinearVelocity().x;
}

/// How deep a dart of this width gets into a slab with a seam at x = 0; or into one box.
float DeepestDart(bool whole, float half, float x, float speed) {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *const slab = world.CreateBody(&def);
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    if (whole) {
        b2PolygonShape box;
        box.SetAsBox(4.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
        fixture.shape = &box;
        slab->CreateFixture(&fixture);
    } else {
        const b2Vec2 points[] = {{-4, 0}, {-4, -2}, {-2, -2}, {0, -1}, {2, -2}, {4, -2}, {4, 0}, {0, 0}};
        bmr::OutlineShape outline;
        REQUIRE(outline.Set(points, 8) == BMR_OK);
        REQUIRE(outline.GetPieceCount() == 2);
        REQUIRE(outline.CreateFixtures(slab, fixture) == BMR_OK);
    }
    def.position.Set(x, 0.05f);
    def.linearVelocity.Set(0.0f, -speed);
    b2Body *const dart = world.CreateBody(&def);
    const b2Vec2 points[] = {{0.0f, 0.0f}, {half, 0.4f}, {-half, 0.4f}};
    bmr::ConvexShape tip;
    REQUIRE(tip.SetRaw(points, 3) == BMR_OK);
    fixture.shape = &tip;
    fixture.density = 20.0f;
    dart->CreateFixture(&fixture);
    float deepest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        deepest = std::max(deepest, -slab->GetLocalPoint(dart->GetPosition()).y);
    }
    return deepest;
}

} // namespace

TEST_CASE("over a hundred flat seams nothing is lost beyond a chain's loss") {
    CheckRides([](float) { return 0.0f; });
}

TEST_CASE("over a hundred seams of hills nothing is lost beyond a chain's loss") {
    CheckRides([](float x) { return 0.5f * std::sin(0.2f * x); });
}

TEST_CASE("a ring in pieces rolls as the whole it is") {
    for (const float speed : {5.0f, 10.0f}) {
        const float outline = RollRing(Ground::Outline, speed),
                    triangles = RollRing(Ground::Triangles, speed), pieces = RollRing(Ground::Pieces, speed);
        MESSAGE("from " << speed << " m/s: outline " << outline << ", triangles " << triangles
                        << ", pieces without seams " << pieces);
        CHECK(outline > 0.95f * speed);
        CHECK(triangles < 0.8f * speed);
    }
}

TEST_CASE("outlines that fall on a box, an edge or a chain stay on it, and none is thrown") {
    constexpr float thrown = 0.12f;
    const int worlds = static_cast<int>(std::min(test_scaled(8), size_t{40}));
    for (int kind = 0; kind < 3; ++kind) {
        for (int n = 0; n < worlds; ++n) {
            CAPTURE(kind);
            CAPTURE(n);
            b2World world(b2Vec2(0.0f, -10.0f));
            const b2BodyDef still;
            b2PolygonShape box;
            box.SetAsBox(9.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
            b2EdgeShape edge;
            edge.SetTwoSided(b2Vec2(-9.0f, 0.0f), b2Vec2(9.0f, 0.0f));
            const b2Vec2 line[] = {{9.0f, 0.0f}, {3.0f, 0.0f}, {-4.0f, 0.0f}, {-9.0f, 0.0f}};
            b2ChainShape chain;
            chain.CreateChain(line, 4, b2Vec2(10.0f, 0.0f), b2Vec2(-10.0f, 0.0f));
            const b2Shape *const grounds[] = {&box, &edge, &chain};
            world.CreateBody(&still)->CreateFixture(grounds[kind], 0.0f);
            std::vector<b2Body *> bodies;
            for (int i = 0; i < 5; ++i) {
                // Gears, stars and rings.
                const int points = 10 + 2 * ((n + 3 * i) % 6);
                std::vector<b2Vec2> rim, hole;
                for (int p = 0; p < points; ++p) {
                    const float angle = 2.0f * b2_pi * static_cast<float>(p) / static_cast<float>(points);
                    const b2Vec2 out(std::cos(angle), std::sin(angle));
                    rim.push_back((i % 3 == 0 || p % 2 == 0 ? 0.6f : i % 3 == 1 ? 0.42f : 0.25f) * out);
                    hole.push_back(0.3f * out);
                }
                const bmr::OutlineHole holes[] = {{hole.data(), points}};
                bmr::OutlineShape outline;
                REQUIRE(outline.Set(rim.data(), points, holes, i % 3 == 0 ? 1 : 0) == BMR_OK);
                b2BodyDef def;
                def.type = b2_dynamicBody;
                def.position.Set(0.3f * static_cast<float>(i % 2), 1.0f + 1.6f * static_cast<float>(i));
                def.angle = static_cast<float>(n + 5 * i);
                def.angularVelocity = static_cast<float>((n + i) % 9 - 4);
                bodies.push_back(world.CreateBody(&def));
                REQUIRE(outline.CreateFixtures(bodies.back(), 1.0f) == BMR_OK);
            }
            float farthest = 0.0f;
            for (int step = 0; step < 250; ++step) {
                std::vector<b2Vec2> before;
                for (const b2Body *body : bodies)
                    before.push_back(body->GetWorldCenter());
                world.Step(1.0f / 60.0f, 8, 3);
                for (size_t i = 0; i < bodies.size(); ++i)
                    farthest = std::max(farthest, (bodies[i]->GetWorldCenter() - before[i]).Length() -
                                                      bodies[i]->GetLinearVelocity().Length() / 60.0f);
            }
            CHECK(farthest < thrown);
            for (const b2Body *body : bodies)
                CHECK((body->GetPosition().y > 0.0f || std::abs(body->GetPosition().x) > 8.5f));
        }
    }
}

TEST_CASE("a dart that meets a seam goes no deeper than into one box") {
    int darts = 0;
    for (const float half : {0.005f, 0.01f, 0.02f, 0.1f})
        for (float x = -0.01f; x < 0.0101f; x += 0.0025f)
            for (const float speed : {0.5f, 3.0f, 8.0f}) {
                const float into = DeepestDart(false, half, x, speed),
                            box = DeepestDart(true, half, x, speed);
                CAPTURE(half);
                CAPTURE(x);
                CAPTURE(speed);
                CHECK(into <= box + 0.01f);
                darts += box > 0.005f;
            }
    CHECK(darts > 30); // as many did meet it
}

TEST_CASE("an impact with a piece that is not touched gets the points of the one that is") {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    const b2Vec2 points[] = {{-4, 0}, {-4, -2}, {-2, -2}, {0, -1}, {2, -2}, {4, -2}, {4, 0}, {0, 0}};
    bmr::OutlineShape outline;
    REQUIRE(outline.Set(points, 8) == BMR_OK);
    REQUIRE(outline.CreateFixtures(world.CreateBody(&def), 1.0f) == BMR_OK);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    def.position.Set(-0.55f, 0.5f);
    world.CreateBody(&def)->CreateFixture(&box, 1.0f);
    world.Step(0.0f, 1, 1);
    REQUIRE(world.GetContactCount() == 2);
    int far = 0;
    for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
        const bmr::TwoFixtures two = {c->GetFixtureA(), c->GetFixtureB(), c->GetChildIndexA()};
        const b2Transform &xfA = two.a->GetBody()->GetTransform(), &xfB = two.b->GetBody()->GetTransform();
        bmr_convex32_memory memory = {};
        b2Manifold plain = {}, still = {}, impact = {};
        bmr::CollideConvex(two, bmr::Seams::Ignored, &plain, xfA, xfB, &memory);
        if (plain.pointCount > 0)
            continue;
        ++far;
        bmr::AnswerForOthers(*c, two, false, &still, xfA, xfB, memory);
        CHECK(still.pointCount == 0);
        bmr::AnswerForOthers(*c, two, true, &impact, xfA, xfB, memory);
        CHECK(impact.pointCount == 2);
    }
    CHECK(far == 1);
}
