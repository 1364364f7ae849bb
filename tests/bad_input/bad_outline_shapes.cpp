// SPDX-License-Identifier: MIT
// What bmr::OutlineShape says to outlines that are none, and to bad bodies and definitions.
#include <cstring>

#include <box2d/box2d.h>

#include "arguments.h"
#include "boomerang/outline_shape.h"

using namespace bad_input;

namespace {

const b2Vec2 kElbow[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {2.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 2.0f}, {0.0f, 2.0f}};
const float kNone32 = std::nanf(""), kInfinite32 = INFINITY;

using Ring = std::vector<b2Vec2>;

bmr::OutlineShape Elbow() {
    bmr::OutlineShape outline;
    outline.Set(kElbow, 6);
    return outline;
}

bmr::OutlineShape FarElbow() {
    b2Vec2 points[6];
    for (int i = 0; i < 6; ++i)
        points[i] = 0.5f * kElbow[i] + b2Vec2(3000.0f, 0.0f);
    bmr::OutlineShape outline;
    outline.Set(points, 6);
    return outline;
}

/// What Set says to an outline that has points, and whether an error left them as they were.
std::string SetTo(const b2Vec2 *points, int32 count, const bmr::OutlineHole *holes = nullptr,
                  int32 holeCount = 0, float tolerance = 0.0f) {
    bmr::OutlineShape outline = Elbow();
    const bmr::OutlineShape before = outline;
    bmr::OutlineFault fault = {{-2, -2}, {-2, -2}, {0.0f, 0.0f}};
    const bmr_error error = outline.Set(points, count, holes, holeCount, tolerance, &fault);
    if (error == BMR_OK)
        return std::to_string(outline.GetPieceCount()) + " pieces";
    if (outline != before)
        return Said(error) + ", and the outline has changed";
    const auto name = [](int32 edge) { return edge < 0 ? "none" : std::to_string(edge); };
    return fault.edge[0] == -2
               ? Said(error)
               : Said(error) + ", edges " + name(fault.edge[0]) + " and " + name(fault.edge[1]);
}

std::string SetTo(const Ring &ring, const Ring &hole = {}) {
    const bmr::OutlineHole inside = {hole.data(), static_cast<int32>(hole.size())};
    return SetTo(ring.data(), static_cast<int32>(ring.size()), &inside, hole.empty() ? 0 : 1);
}

/// What `call` says to a body with one fixture, and whether an error left that as it was.
std::string OfBody(const std::function<bmr_error(b2Body *)> &call) {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *const body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    const b2Fixture *const fixture = body->CreateFixture(&box, 1.0f);
    const float mass = body->GetMass(), inertia = body->GetInertia();
    const bmr_error error = call(body);
    const bool same = body->GetFixtureList() == fixture && fixture->GetNext() == nullptr &&
                      body->GetMass() == mass && body->GetInertia() == inertia;
    return Said(error) + (same ? "" : ", and the body has changed");
}

std::string Defined(const std::function<void(b2FixtureDef &)> &change) {
    return OfBody([&](b2Body *body) {
        b2FixtureDef def;
        def.density = 1.0f;
        change(def);
        return Elbow().CreateFixtures(body, def);
    });
}

/// In the midst of a step: what `call` says there.
std::string Locked(const std::function<bmr_error(b2Body *)> &call) {
    struct Listener : b2ContactListener {
        const std::function<bmr_error(b2Body *)> *call = nullptr;
        std::string said = "never asked";
        void BeginContact(b2Contact *contact) override {
            said = Said((*call)(contact->GetFixtureA()->GetBody()));
        }
    } listener;
    listener.call = &call;
    b2World world(b2Vec2(0.0f, 0.0f));
    world.SetContactListener(&listener);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 2; ++i)
        Elbow().CreateFixtures(world.CreateBody(&def), 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    return listener.said;
}

std::vector<Argument> Shapes() {
    static const Ring elbow(kElbow, kElbow + 6);
    static const bmr::OutlineHole no_points = {nullptr, 3}, below = {kElbow, -1};
    return {
        {"`Set`: `NULL`", [] { return SetTo(nullptr, 3); }},
        {"`Set`: 0 points", [] { return SetTo(kElbow, 0); }},
        {"`Set`: 2 points", [] { return SetTo(kElbow, 2); }},
        {"`Set`: -6 points", [] { return SetTo(kElbow, -6); }},
        {"`Set`: 65,536 points", [] { return SetTo(Ring(65536, b2Vec2(1.0f, 1.0f))); }},
        {"`Set`: a coordinate of NaN",
         [] {
             return SetTo(Ring{{0, 0}, {kNone32, 0}, {0, 1}});
         }},
        {"`Set`: a coordinate of infinity",
         [] {
             return SetTo(Ring{{0, 0}, {kInfinite32, 0}, {0, 1}});
         }},
        {"`Set`: a coordinate of 2e9",
         [] {
             return SetTo(Ring{{0, 0}, {2e9f, 0}, {0, 1}});
         }},
        {"`Set`: a triangle of sides 1e-30",
         [] {
             return SetTo(Ring{{0, 0}, {1e-30f, 0}, {0, 1e-30f}});
         }},
        {"`Set`: like an 8",
         [] {
             return SetTo(Ring{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
         }},
        {"`Set`: with a spike",
         [] {
             return SetTo(Ring{{0, 0}, {4, 0}, {2, 0}, {2, 2}});
         }},
        {"`Set`: a point twice",
         [] {
             return SetTo(Ring{{0, 0}, {2, 0}, {2, 0}, {0, 2}});
         }},
        {"`Set`: a hole beside it",
         [] {
             return SetTo(elbow, Ring{{9, 9}, {10, 9}, {9, 10}});
         }},
        {"`Set`: a hole, and no holes", [] { return SetTo(kElbow, 6, nullptr, 1); }},
        {"`Set`: a hole of `NULL`", [] { return SetTo(kElbow, 6, &no_points, 1); }},
        {"`Set`: a hole of -1 points", [] { return SetTo(kElbow, 6, &below, 1); }},
        {"`Set`: -1 holes", [] { return SetTo(kElbow, 6, &below, -1); }},
        {"`Set`: a tolerance of NaN", [] { return SetTo(kElbow, 6, nullptr, 0, kNone32); }},
        {"`Set`: a tolerance below 0", [] { return SetTo(kElbow, 6, nullptr, 0, -1.0f); }},
        {"`CreateFixtures`: no body", [] { return Said(Elbow().CreateFixtures(nullptr, 1.0f)); }},
        {"`CreateFixtures`: of no outline",
         [] { return OfBody([](b2Body *body) { return bmr::OutlineShape().CreateFixtures(body, 1.0f); }); }},
        {"`CreateFixtures`: a density of NaN",
         [] { return Defined([](b2FixtureDef &def) { def.density = kNone32; }); }},
        {"`CreateFixtures`: a density below 0",
         [] { return Defined([](b2FixtureDef &def) { def.density = -1.0f; }); }},
        {"`CreateFixtures`: a density of 3e38",
         [] { return Defined([](b2FixtureDef &def) { def.density = 3e38f; }); }},
        {"`CreateFixtures`: a friction below 0",
         [] { return Defined([](b2FixtureDef &def) { def.friction = -1.0f; }); }},
        {"`CreateFixtures`: an infinite restitution",
         [] { return Defined([](b2FixtureDef &def) { def.restitution = kInfinite32; }); }},
        {"`CreateFixtures`: 1 m large, 3 km from the origin of the body",
         [] {
             b2World world(b2Vec2(0.0f, 0.0f));
             b2BodyDef def;
             def.type = b2_dynamicBody;
             b2Body *const body = world.CreateBody(&def);
             const bmr_error error = FarElbow().CreateFixtures(body, 1.0f);
             return Said(error) + (body->GetFixtureList() == nullptr ? "" : ", and the body has changed");
         }},
        {"`CreateFixtures`: in a step",
         [] { return Locked([](b2Body *body) { return Elbow().CreateFixtures(body, 1.0f); }); }},
        {"`DestroyFixtures`: no body", [] { return Said(Elbow().DestroyFixtures(nullptr)); }},
        {"`DestroyFixtures`: a body without this outline",
         [] { return OfBody([](b2Body *body) { return Elbow().DestroyFixtures(body); }); }},
        {"`DestroyFixtures`: in a step",
         [] { return Locked([](b2Body *body) { return Elbow().DestroyFixtures(body); }); }},
        {"`From`: `NULL`",
         [] { return std::to_string(bmr::OutlineShape::From(nullptr).GetPieceCount()) + " pieces"; }},
        {"`GetPiece`: one that there is not",
         [] {
             int32 vertices = Elbow().GetPiece(99).GetVertexCount() + Elbow().GetPiece(-1).GetVertexCount();
             vertices += bmr::OutlineShape().GetPiece(0).GetVertexCount();
             return std::to_string(vertices) + " vertices";
         }},
        {"`IsInnerEdge`: an edge that there is not",
         [] {
             const bmr::OutlineShape outline = Elbow();
             return Said(outline.IsInnerEdge(0, 99) || outline.IsInnerEdge(0, -1) ||
                         outline.IsInnerEdge(9, 0) || bmr::OutlineShape().IsInnerEdge(0, 0));
         }},
    };
}

} // namespace

int main(int argc, char **argv) {
    return Main(argc, argv, {ArgumentTable("outline shapes", Shapes())});
}
