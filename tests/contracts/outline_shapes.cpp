// SPDX-License-Identifier: MIT
// bmr::OutlineShape: what refuses leaves the outline, or the body, as it was.
#include <climits>
#include <cmath>

#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "contracts.h"

using namespace contracts;

namespace {

using Ring = std::vector<b2Vec2>;
const Ring kElbow = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

bmr::OutlineShape Elbow() {
    bmr::OutlineShape outline;
    outline.Set(kElbow.data(), 6);
    return outline;
}

/// What Set says to an outline that has points; where edges are named, they are the fault's.
std::string SetTo(const b2Vec2 *points, int32 count, const bmr::OutlineHole *holes, int32 holeCount,
                  float tolerance) {
    bmr::OutlineShape outline = Elbow();
    const bmr::OutlineShape before = outline;
    bmr::OutlineFault fault = {{-2, -2}, {-2, -2}, {0.0f, 0.0f}};
    const bmr_error error = outline.Set(points, count, holes, holeCount, tolerance, &fault);
    if (error == BMR_OK)
        return std::to_string(outline.GetPieceCount()) + " pieces";
    const auto name = [](int32 edge) { return edge < 0 ? "none" : std::to_string(edge); };
    const std::string said = Said(error, outline != before);
    return fault.edge[0] == -2 ? said
                               : said + ", edges " + name(fault.edge[0]) + " and " + name(fault.edge[1]);
}

struct BadRing {
    const char *name;
    Ring points;
    Ring hole = {};
};
const BadRing kBadRings[] = {
    {"65,536 points", Ring(65536, b2Vec2(1.0f, 1.0f))},
    {"a coordinate of NaN", {{0, 0}, {NAN, 0}, {0, 1}}},
    {"a coordinate of infinity", {{0, 0}, {INFINITY, 0}, {0, 1}}},
    {"a coordinate of 2e9", {{0, 0}, {2e9f, 0}, {0, 1}}},
    {"a triangle of sides 1e-30", {{0, 0}, {1e-30f, 0}, {0, 1e-30f}}},
    {"like an 8", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
    {"a spike", {{0, 0}, {4, 0}, {2, 0}, {2, 2}}},
    {"a point twice", {{0, 0}, {2, 0}, {2, 0}, {0, 2}}},
    {"a hole beside it", kElbow, {{9, 9}, {10, 9}, {9, 10}}},
};

const Table kRings("bad rings of shapes", [] {
    Matrix matrix;
    matrix.columns = {"`OutlineShape::Set`"};
    for (const BadRing &ring : kBadRings)
        matrix.rows.emplace_back(ring.name);
    matrix.answer = [](size_t row, size_t) {
        const BadRing &ring = kBadRings[row];
        const bmr::OutlineHole hole = {ring.hole.data(), static_cast<int32>(ring.hole.size())};
        return SetTo(ring.points.data(), static_cast<int32>(ring.points.size()), &hole,
                     ring.hole.empty() ? 0 : 1, 0.0f);
    };
    return matrix;
});

/// What `call` says to a body of so many fixtures, and whether an error left that as it was.
std::string OfBody(const std::function<bmr_error(b2Body *)> &call, int fixtures = 1) {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *const body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    const b2Fixture *const fixture = fixtures > 0 ? body->CreateFixture(&box, 1.0f) : nullptr;
    const float mass = body->GetMass(), inertia = body->GetInertia();
    const bmr_error error = call(body);
    return Said(error, body->GetFixtureList() != fixture || (fixture && fixture->GetNext()) ||
                           body->GetMass() != mass || body->GetInertia() != inertia);
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

/// The outline of value 2 has no points; that of 3 is far from the origin.
bmr::OutlineShape OutlineOf(double value) {
    bmr::OutlineShape outline = value == 2.0 ? bmr::OutlineShape() : Elbow();
    Ring points = kElbow;
    for (b2Vec2 &p : points)
        p = 0.5f * p + b2Vec2(3000.0f, 0.0f);
    if (value == 3.0)
        outline.Set(points.data(), 6);
    return outline;
}

const Table kOutlines("boomerang/outline_shape.h", [] {
    const Rules unsuited = Says("NOT_FINITE", {kNaN, kInfinity}) + kNotNegative;
    Answers("OutlineShape::Set", "2 pieces",
            {{"points", kNotNull},
             {"count", 6,
              Says("NEGATIVE", {-6, INT_MIN}) + Says("TOO_FEW_POINTS, edges none and none", {0}) +
                  Says("TOO_FEW_POINTS, edges 0 and 0", {2})},
             {"holes", 0, Says("NULL_ARGUMENT", {{"`NULL`, a count of 1", 1}})},
             {"count of holes", 0, Says("NEGATIVE", {-1})},
             {"points of a hole", 0, Says("NULL_ARGUMENT", {{"`NULL`", 1}})},
             {"count of a hole", 0, Says("NEGATIVE", {-1})},
             {"tolerance", 0, unsuited}},
            [](const Given &g) {
                const bool hole = g[4] != 0.0 || g[5] != 0.0;
                const bmr::OutlineHole inside = {g[4] != 0.0 ? nullptr : kElbow.data(),
                                                 g[5] != 0.0 ? static_cast<int32>(g[5]) : 3};
                return SetTo(g.Or(0, kElbow.data()), static_cast<int32>(g[1]),
                             g[2] != 0.0 ? nullptr : &inside,
                             hole || g[2] != 0.0 ? 1 : static_cast<int32>(g[3]), g.Float(6));
            });
    const Rules whenLocked = Says("WORLD_LOCKED", {{"in a step", 0}});
    Refuses("CreateFixtures",
            {{"outline", Says("NO_POINTS", {{"of no points", 2}}) +
                             Says("FAR_FROM_ORIGIN", {{"of 1 m, 3 km from the body's origin", 3}})},
             {"body", kNotNull},
             {"density", unsuited + Says("OUT_OF_RANGE", {3e38})},
             {"friction", unsuited},
             {"restitution", Says("NOT_FINITE", {kNaN, kInfinity}) + Says("OK", {-1})},
             {"call", whenLocked}},
            [](const Given &g) {
                b2FixtureDef def;
                def.density = g.Float(2);
                def.friction = g.Float(3);
                def.restitution = g.Float(4);
                const auto create = [&](b2Body *body) {
                    return OutlineOf(g[0]).CreateFixtures(g.Or(1, body), def);
                };
                return g[5] == 0.0
                           ? Locked(create)
                           : OfBody(create, g[0] == 3.0 ? 0 : 1); // (a box here would move the centre)
            });
    Refuses("DestroyFixtures",
            {{"body", kNotNull + Says("OK", {{"without this outline", 2}})}, {"call", whenLocked}},
            [](const Given &g) {
                const bmr::OutlineShape outline = Elbow();
                const auto destroy = [&](b2Body *body) {
                    if (g[0] == 1.0 && g[1] == 1.0)
                        outline.CreateFixtures(body, 1.0f);
                    return outline.DestroyFixtures(g.Or(0, body));
                };
                return g[1] == 0.0 ? Locked(destroy) : OfBody(destroy);
            });
    Answers("From", "2 pieces", {{"fixture", Says("0 pieces", {kNull})}}, [](const Given &g) {
        std::string answer;
        OfBody([&](b2Body *body) {
            Elbow().CreateFixtures(body, 1.0f);
            const b2Fixture *fixture = body->GetFixtureList();
            answer = std::to_string(bmr::OutlineShape::From(g.Or(0, fixture)).GetPieceCount()) + " pieces";
            return BMR_OK;
        });
        return answer;
    });
    Answers(
        "GetPiece", "4 vertices",
        {{"outline", Says("0 vertices", {{"of no points", 2}})}, {"piece", 0, Says("0 vertices", {99, -1})}},
        [](const Given &g) {
            const bmr::ConvexShape piece = OutlineOf(g[0]).GetPiece(static_cast<int32>(g[1]));
            return std::to_string(piece.GetVertexCount()) + " vertices";
        });
    Answers("IsInnerEdge", "one is",
            {{"outline", Says("none is", {{"of no points", 2}})},
             {"piece", 0, Says("none is", {9})},
             {"edge", 0, Says("none is", {99, -1})}},
            [](const Given &g) {
                const bmr::OutlineShape outline = OutlineOf(g[0]);
                bool inner = false;
                for (int32 edge = 0; edge < 4; ++edge) // all four of a piece, where the edge is there
                    inner |= outline.IsInnerEdge(static_cast<int32>(g[1]),
                                                 static_cast<int32>(g[2] == 0.0 ? edge : g[2]));
                return inner ? "one is" : "none is";
            });
});

} // namespace
