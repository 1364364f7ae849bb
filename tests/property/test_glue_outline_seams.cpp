// SPDX-License-Identifier: MIT
// Over the seams of an outline's pieces things roll and slide as over one line: wheels and boxes on a ground
// that was cut in a hundred places, beside a chain with the same surface and beside triangles.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"

namespace {

constexpr int kSeams = 100;
constexpr float kRadius = 0.5f;

enum class Ground { Chain, Outline, Triangles };

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
    if (kind == Ground::Outline) {
        bmr::OutlineShape outline;
        REQUIRE(outline.Set(terrain.outline.data(), static_cast<int32>(terrain.outline.size())) == BMR_OK);
        REQUIRE(outline.CreateFixtures(body, def) == BMR_OK);
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
    movers.push_back({"wheel of 64", Wheel(64), 1.0f, kRadius + b2_polygonRadius, true});
    auto box = std::make_unique<b2PolygonShape>();
    box->SetAsBox(0.4f, 0.4f);
    movers.push_back({"box", std::move(box), 0.0f, 0.4f + 2.0f * b2_polygonRadius, false});
    return movers;
}

struct Ride {
    float speed;                           ///< at the end
    float rough = 0.0f;                    ///< how far it got from its height over the surface
    float lowest = 1e9f, highest = -1e9f; ///< above the surface
    float upwards = 0.0f;                  ///< the fastest
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
        if (std::getenv("TR") && kind == Ground::Outline && body->GetPosition().y - height(body->GetPosition().x) > 0.516f) {
            printf("%s step %d x %.4f y %.4f vy %.4f\n", mover.name.c_str(), steps, body->GetPosition().x, body->GetPosition().y, body->GetLinearVelocity().y);
            for (b2ContactEdge *e = body->GetContactList(); e; e = e->next) {
                const b2Manifold &m = *e->contact->GetManifold();
                b2WorldManifold w; e->contact->GetWorldManifold(&w);
                if (m.pointCount) printf("   type %d n %.4f %.4f count %d at %.4f %.4f sep %.4f\n", m.type, w.normal.x, w.normal.y, m.pointCount, w.points[0].x, w.points[0].y, w.separations[0]);
                if (m.pointCount && m.type == 2) { const bmr::ConvexShape &p = *bmr::ConvexShape::From(e->contact->GetFixtureA()->GetShape()); bmr::OutlineShape o = bmr::OutlineShape::From(e->contact->GetFixtureA()); int idx=-1; for (int q=0;q<o.GetPieceCount();++q) if (o.GetPiece(q).GetVertices()==p.GetVertices()) idx=q;
                  for (int v=0; v<p.GetVertexCount(); ++v) printf("      %.3f %.3f inner %d\n", p.GetVertex(v).x, p.GetVertex(v).y, o.IsInnerEdge(idx, v)); }
            }
        }
        if (steps < 20)
            continue;
        const float above = body->GetPosition().y - height(body->GetPosition().x);
        ride.lowest = std::min(ride.lowest, above);
        ride.highest = std::max(ride.highest, above);
        ride.upwards = std::max(ride.upwards, body->GetLinearVelocity().y);
    }
    ride.speed = body->GetLinearVelocity().x;
    return ride;
}

} // namespace

TEST_CASE("scratch") {
    const Surface flat = [](float) { return 0.0f; };
    const Surface hills = [](float x) { return 0.5f * std::sin(0.2f * x); };
    for (const auto &[name, surface] : {std::pair{"flat", flat}, std::pair{"hills", hills}})
        for (const Mover &mover : Movers())
            for (const Ground kind : {Ground::Chain, Ground::Outline, Ground::Triangles}) {
                const Ride ride = RideOver(surface, kind, mover, 10.0f);
                MESSAGE(name << " " << mover.name << " on " << static_cast<int>(kind) << ": speed " << ride.speed
                             << " height " << ride.lowest << " .. " << ride.highest << " up " << ride.upwards);
            }
}
