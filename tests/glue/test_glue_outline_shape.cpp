// SPDX-License-Identifier: MIT
// bmr::OutlineShape: what a body of an outline weighs, who owns what, what is refused, and who finds it
// again.
#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "shapes/outline_record.h"
#include "small_world.h"

#include "failing_allocator.h"

using bmr::OutlineHole;
using bmr::OutlineShape;
using Ring = std::vector<b2Vec2>;

namespace {

/// An L of three unit squares, clockwise: both directions are allowed.
const Ring kElbow = {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}};
const Ring kFrame = {{-3, -1}, {3, -1}, {3, 1}, {-3, 1}};
const Ring kWindow = {{0, -0.5f}, {2, -0.5f}, {2, 0.5f}, {0, 0.5f}};

int32 Count(const Ring &ring) {
    return static_cast<int32>(ring.size());
}

OutlineShape Elbow() {
    OutlineShape outline;
    REQUIRE(outline.Set(kElbow.data(), Count(kElbow)) == BMR_OK);
    return outline;
}

/// A rectangle of 6 x 2 with a hole of 2 x 1 to the right of its middle.
OutlineShape Frame() {
    const OutlineHole hole = {kWindow.data(), Count(kWindow)};
    OutlineShape outline;
    REQUIRE(outline.Set(kFrame.data(), Count(kFrame), &hole, 1) == BMR_OK);
    return outline;
}

/// Scanned: 200 points around a lobed thing.
Ring Scan() {
    Ring ring;
    for (int i = 0; i < 200; ++i) {
        const float angle = 2.0f * b2_pi * static_cast<float>(i) / 200.0f;
        const float radius = 1.0f + 0.3f * std::cos(3.0f * angle) + 0.004f * static_cast<float>(i % 3);
        ring.emplace_back(3.0f + radius * std::cos(angle), radius * std::sin(angle));
    }
    return ring;
}

int CountFixtures(const b2Body &body) {
    int count = 0;
    for (const b2Fixture *f = body.GetFixtureList(); f != nullptr; f = f->GetNext())
        ++count;
    return count;
}

void CheckMass(const b2Body &body, float mass, b2Vec2 centre, float inertia) {
    CHECK(body.GetMass() == doctest::Approx(mass).epsilon(1e-5));
    CHECK(body.GetLocalCenter().x == doctest::Approx(centre.x).epsilon(1e-5));
    CHECK(body.GetLocalCenter().y == doctest::Approx(centre.y).epsilon(1e-5));
    CHECK(body.GetInertia() == doctest::Approx(inertia).epsilon(1e-5));
}

} // namespace

TEST_CASE("a body of an outline weighs what the outline does") {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *elbow = AddBody(world), *frame = AddBody(world);
    REQUIRE(Elbow().CreateFixtures(elbow, 2.0f) == BMR_OK);
    CHECK(CountFixtures(*elbow) == 2);
    // Three squares of mass 2 around (0.5, 0.5), (1.5, 0.5), (0.5, 1.5); inertia about the body's origin.
    CheckMass(*elbow, 6.0f, {5.0f / 6.0f, 5.0f / 6.0f}, 2.0f * (3.0f / 6.0f + 0.5f + 2.5f + 2.5f));
    REQUIRE(Frame().CreateFixtures(frame, 1.0f) == BMR_OK);
    const float whole = 12.0f * (36.0f + 4.0f) / 12.0f, hole = 2.0f * ((4.0f + 1.0f) / 12.0f + 1.0f);
    CheckMass(*frame, 10.0f, {-0.2f, 0.0f}, whole - hole);
    // Of bodies that have other fixtures, too, and after whatever a game does to them.
    b2MassData other = {};
    other.mass = 1.0f;
    frame->SetMassData(&other);
    frame->ResetMassData();
    CheckMass(*frame, 10.0f, {-0.2f, 0.0f}, whole - hole);
    b2MassData mass;
    Frame().ComputeMass(&mass, 1.0f);
    CHECK(mass.mass == doctest::Approx(10.0f));
    CHECK(mass.I == doctest::Approx(whole - hole));
}

TEST_CASE("with a tolerance the masses are still the outline's, not those of the pieces") {
    b2World world(b2Vec2(0.0f, 0.0f));
    const Ring ring = Scan();
    OutlineShape exact, rough;
    REQUIRE(exact.Set(ring.data(), Count(ring)) == BMR_OK);
    REQUIRE(rough.Set(ring.data(), Count(ring), nullptr, 0, 0.1f) == BMR_OK);
    CHECK(rough.GetPieceCount() < exact.GetPieceCount() / 4);
    b2MassData mass;
    exact.ComputeMass(&mass, 3.0f);
    float ofPieces = 0.0f;
    for (int32 i = 0; i < rough.GetPieceCount(); ++i) {
        bmr::ConvexShape plain;
        const bmr::ConvexShape piece = rough.GetPiece(i);
        REQUIRE(plain.SetRaw(piece.GetVertices(), piece.GetVertexCount()) == BMR_OK);
        b2MassData own;
        plain.ComputeMass(&own, 3.0f);
        ofPieces += own.mass;
    }
    CHECK(std::abs(ofPieces - mass.mass) > 1e-3f * mass.mass); // the control
    for (const OutlineShape &outline : {exact, rough}) {
        b2Body *body = AddBody(world);
        REQUIRE(outline.CreateFixtures(body, 3.0f) == BMR_OK);
        CheckMass(*body, mass.mass, mass.center, mass.I);
        // Each share is a mass of its own: what is left of a body when fixtures go has one, too.
        while (body->GetFixtureList()->GetNext() != nullptr)
            body->DestroyFixture(body->GetFixtureList());
        CHECK(body->GetMass() > 0.0f);
        CHECK(body->GetInertia() > body->GetMass() * b2Dot(body->GetLocalCenter(), body->GetLocalCenter()));
    }
}

TEST_CASE("what a definition says holds for all pieces, and they are found and changed as one") {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *body = AddBody(world);
    const OutlineShape outline = Elbow(), other = Frame();
    b2PolygonShape box;
    box.SetAsBox(0.1f, 0.1f);
    const b2Fixture *plain = body->CreateFixture(&box, 1.0f);
    b2FixtureDef def;
    def.friction = 0.7f;
    def.restitution = 0.4f;
    def.restitutionThreshold = 2.0f;
    def.isSensor = true;
    def.filter.categoryBits = 4;
    def.userData.pointer = 77;
    def.density = 1.5f;
    REQUIRE(outline.CreateFixtures(body, def) == BMR_OK);
    REQUIRE(other.CreateFixtures(body, 1.0f) == BMR_OK);
    int found = 0;
    outline.ForEachFixture(body, [&](b2Fixture &piece) {
        ++found;
        CHECK(piece.GetFriction() == 0.7f);
        CHECK(piece.GetRestitution() == 0.4f);
        CHECK(piece.GetRestitutionThreshold() == 2.0f);
        CHECK(piece.IsSensor());
        CHECK(piece.GetFilterData().categoryBits == 4);
        CHECK(piece.GetUserData().pointer == 77);
        CHECK(piece.GetDensity() == 1.5f);
        CHECK(OutlineShape::From(&piece) == outline);
        CHECK(OutlineShape::From(&piece) != other);
        piece.SetSensor(false);
    });
    CHECK(found == outline.GetPieceCount());
    CHECK(OutlineShape::From(plain) == OutlineShape());
    CHECK(OutlineShape::From(nullptr) == OutlineShape());
    CHECK_FALSE(OutlineShape().Has(*plain));
    const int before = CountFixtures(*body);
    REQUIRE(outline.DestroyFixtures(body) == BMR_OK);
    CHECK(CountFixtures(*body) == before - found);
    outline.ForEachFixture(body, [](b2Fixture &) { FAIL("one is left"); });
    CHECK(OutlineShape::From(body->GetFixtureList()) == other);
}

TEST_CASE("the last of the copies and fixtures frees an outline, in any order") {
    REQUIRE(bmr::registry::Count() == 0);
    {
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body *first = AddBody(world), *second = AddBody(world);
        OutlineShape outline = Elbow(), copy = outline;
        outline = *&outline;
        REQUIRE(outline.CreateFixtures(first, 1.0f) == BMR_OK);
        REQUIRE(outline.CreateFixtures(second, 1.0f) == BMR_OK);
        CHECK(bmr::registry::Count() == 2);
        outline = copy = OutlineShape();
        CHECK(bmr::registry::Count() == 2);
        // Singly: the last fixture still knows the whole outline.
        world.DestroyBody(first);
        second->DestroyFixture(second->GetFixtureList());
        const OutlineShape found = OutlineShape::From(second->GetFixtureList());
        CHECK(found.GetPieceCount() == 2);
        bmr::ConvexShape piece = found.GetPiece(0);
        world.DestroyBody(second);
        CHECK(bmr::registry::Count() == 2);
        piece = bmr::ConvexShape();
        CHECK(bmr::registry::Count() == 2);
    }
    CHECK(bmr::registry::Count() == 0);
    {
        b2World world(b2Vec2(0.0f, 0.0f));
        REQUIRE(Frame().CreateFixtures(AddBody(world), 1.0f) == BMR_OK);
        CHECK(bmr::registry::Count() > 0);
    }
    CHECK(bmr::registry::Count() == 0);
}

// Other errors: tests/contracts/test_glue_contracts.cpp.
TEST_CASE("rings in doubles that floats cannot hold are refused, and hold where an origin is subtracted") {
    const bmr_vec2 origin = {141.1081, -23.8278}; // degrees on a map
    bmr_vec2 corners[3] = {{origin.x, origin.y}, {origin.x + 1e-4, origin.y}, {origin.x, origin.y + 1e-4}};
    const uint32_t count = 3;
    const bmr_rings rings = {corners, &count, 1};
    OutlineShape outline = Elbow();
    const int32 before = outline.GetPieceCount();
    CHECK(outline.Set(rings) == BMR_ERROR_FAR_FROM_ORIGIN);
    CHECK(outline.GetPieceCount() == before);
    for (bmr_vec2 &corner : corners)
        corner = {corner.x - origin.x, corner.y - origin.y};
    REQUIRE(outline.Set(rings) == BMR_OK);
    b2MassData mass;
    outline.ComputeMass(&mass, 1.0f);
    CHECK(static_cast<double>(mass.mass) == doctest::Approx(0.5e-8).epsilon(1e-5));
    // What floats hold exactly may be as far as it likes.
    const bmr_vec2 exact[3] = {{1e6, 1e6}, {1e6 + 0.125, 1e6}, {1e6, 1e6 + 0.125}};
    CHECK(outline.Set(bmr_rings{exact, &count, 1}) == BMR_OK);
}

TEST_CASE("a coordinate that is no number is named by its point") {
    bmr_vec2 points[] = {{-3, -1}, {3, -1}, {3, 1}, {-3, 1}, {0, -0.5}, {2, -0.5}, {2, 0.5}, {0, 0.5}};
    const uint32_t counts[] = {4, 4};
    const bmr_rings rings = {points, counts, 2};
    OutlineShape outline;
    bmr_outline_fault fault = {};
    for (const double wrong : {static_cast<double>(NAN), 2e9}) {
        points[6].x = wrong;
        CHECK(outline.Set(rings, 0.0f, &fault) ==
              (wrong == 2e9 ? BMR_ERROR_OUT_OF_RANGE : BMR_ERROR_NOT_FINITE));
        CHECK(fault.edge[0] == 6);
        CHECK(fault.edge[1] == BMR_OUTLINE_NONE);
        CHECK(fault.ring[0] == 1);
        CHECK(fault.where.y == 0.5);
    }
    points[6].x = 2;
    CHECK(outline.Set(rings, 0.0f, &fault) == BMR_OK);
}

TEST_CASE("without memory an outline stays as it was and nothing leaks") {
    REQUIRE(bmr::registry::Count() == 0);
    const Ring ring = Scan();
    const OutlineHole hole = {kWindow.data(), Count(kWindow)};
    size_t failures = 0;
    for (size_t failAt = 0; failAt < 400; failAt += failAt < 60 ? 1 : 17) {
        test_heap heap;
        test_heap_init(&heap, failAt);
        bmr::registry::SetAllocator(&heap.allocator);
        {
            OutlineShape outline;
            const bmr_error first = outline.Set(kFrame.data(), Count(kFrame), &hole, 1);
            const OutlineShape before = outline;
            const bmr_error second = outline.Set(ring.data(), Count(ring), nullptr, 0, 0.05f);
            for (const bmr_error error : {first, second}) {
                CHECK((error == BMR_OK || error == BMR_ERROR_NO_MEMORY));
                failures += error != BMR_OK;
            }
            if (first != BMR_OK)
                CHECK(before.GetPieceCount() == 0);
            if (second != BMR_OK)
                CHECK(outline == before);
        }
        bmr::registry::SetAllocator(nullptr);
        CHECK(bmr::registry::Count() == 0);
        CHECK(heap.blocks <= 1); // the chunk of handles stays, once
        CHECK(heap.wrong_sizes == 0);
        if (heap.asked <= failAt)
            break;
    }
    CHECK(failures > 20);
}

TEST_CASE("slivers that floats cannot tell from a line are left out, and their neighbours stand for them") {
    // A bump, on a side in the diagonal, that is lower than a normal's rounding can tell: one cut takes it
    // off.
    const Ring ring = {{2, 2}, {1, 1}, {-1e-9f, 1e-9f}, {-1, -1}, {-2, -2}, {2, -2}};
    OutlineShape outline;
    REQUIRE(outline.Set(ring.data(), Count(ring)) == BMR_OK);
    CHECK(outline.GetPieceCount() == 1);
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *body = AddBody(world);
    REQUIRE(outline.CreateFixtures(body, 1.0f) == BMR_OK);
    CHECK(body->GetMass() == doctest::Approx(8.0f).epsilon(1e-6));
    // What comes to that side comes to a face.
    const b2Transform here = body->GetTransform();
    for (const float x : {-1.5f, -0.5f, 0.5f, 1.5f}) {
        const b2RayCastInput down = {b2Vec2(x - 1.0f, x + 1.0f), b2Vec2(x + 1.0f, x - 1.0f), 1.0f};
        b2RayCastOutput out = {};
        CHECK(body->GetFixtureList()->GetShape()->RayCast(&out, down, here, 0));
        CHECK(out.fraction == doctest::Approx(0.5f));
        CHECK(out.normal.x < -0.7f);
    }
}

TEST_CASE("a sliver's faces become its neighbour's") {
    // Pieces as nobody has to cut them: a sliver on the diagonal side of a triangle.
    const bmr_vec2 points[] = {{1, 1}, {-1e-9, 1e-9}, {-1, -1}, {1, -1}};
    const uint32_t first[] = {0, 3, 6}, none = BMR_OUTLINE_NONE;
    const bmr_outline_edge edges[] = {{0, 0, none, 0}, {1, 1, none, 0}, {2, none, 5, 0},
                                      {2, 2, none, 1}, {3, 3, none, 1}, {0, none, 2, 1}};
    const bmr_outline_pieces pieces = {points, 4, 2, first, edges, 6};
    REQUIRE(bmr_outline_pieces_audit(&pieces) == BMR_OK);
    const bmr_mass mass = {2.0, {1.0 / 3.0, -1.0 / 3.0}, 4.0 / 9.0};
    bmr::OutlineRecord *record = nullptr;
    REQUIRE(bmr::MakeOutlineRecord(pieces, mass, &record) == BMR_OK);
    CHECK(record->pieceCount == 1);
    CHECK(bmr::registry::Find(record->pieces[0]).block.load()->polygon.seams == nullptr);
    bmr::registry::ReleaseGroup(record);
    // Nothing but slivers.
    const bmr_outline_edge alone[] = {{0, 0, none, 0}, {1, 1, none, 0}, {2, 2, none, 0}};
    const bmr_outline_pieces thin = {points, 4, 1, first, alone, 3};
    bmr::OutlineRecord *const before = record;
    CHECK(bmr::MakeOutlineRecord(thin, mass, &record) == BMR_ERROR_TOO_FEW_POINTS);
    CHECK(record == before);
}

TEST_CASE("the outline turns at a piece's corner as it does, whichever of its edges are the piece's") {
    // A square, cut from corner to corner.
    const bmr_vec2 points[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const bmr_vec32 normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    const uint32_t first[] = {0, 3, 6}, none = BMR_OUTLINE_NONE;
    const bmr_outline_edge edges[] = {{0, 0, none, 0}, {1, 1, none, 0}, {2, none, 5, 0},
                                      {2, 2, none, 1}, {3, 3, none, 1}, {0, none, 2, 1}};
    bmr::OutlineRecord *record = nullptr;
    REQUIRE(bmr::MakeOutlineRecord({points, 4, 2, first, edges, 6}, {1.0, {0.5, 0.5}, 1.0 / 6.0}, &record) ==
            BMR_OK);
    for (uint32_t piece = 0; piece < 2; ++piece) {
        const bmr_convex32 &polygon = bmr::registry::Find(record->pieces[piece]).block.load()->polygon;
        REQUIRE(polygon.seams != nullptr);
        for (uint32_t i = 0; i < polygon.count; ++i) {
            const bmr_vec32 v = polygon.vertices[i];
            const int corner = v.y > 0.5f ? (v.x > 0.5f ? 2 : 3) : (v.x > 0.5f ? 1 : 0);
            const bmr_vec32 low = polygon.seams->low[i], high = polygon.seams->high[i],
                            before = normals[(corner + 3) % 4];
            CHECK(before.x * low.x + before.y * low.y == doctest::Approx(1.0f));
            CHECK(normals[corner].x * high.x + normals[corner].y * high.y == doctest::Approx(1.0f));
        }
    }
    bmr::registry::ReleaseGroup(record);
}

TEST_CASE("of all the contacts of two outlines one begins and one ends") {
    struct Listener final : b2ContactListener {
        void BeginContact(b2Contact *contact) override {
            ++begins;
            alone += bmr::TouchesAlone(*contact);
            if (locked != nullptr)
                CHECK(Elbow().CreateFixtures(locked, 1.0f) == BMR_ERROR_WORLD_LOCKED);
            if (locked != nullptr)
                CHECK(Elbow().DestroyFixtures(locked) == BMR_ERROR_WORLD_LOCKED);
        }
        void EndContact(b2Contact *contact) override {
            ++ends;
            aloneAtEnd += bmr::TouchesAlone(*contact);
        }
        b2Body *locked = nullptr;
        int begins = 0, alone = 0, ends = 0, aloneAtEnd = 0;
    } listener;
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetContactListener(&listener);
    b2Body *ground = AddBody(world, b2_staticBody);
    const Ring comb = {{-5, -2}, {-2, -1}, {0, -2}, {2, -1}, {5, -2},
                       {5, 0},   {2, 0},   {0, 0},  {-2, 0}, {-5, 0}};
    OutlineShape floor;
    REQUIRE(floor.Set(comb.data(), Count(comb)) == BMR_OK);
    REQUIRE(floor.GetPieceCount() > 1);
    REQUIRE(floor.CreateFixtures(ground, 0.0f) == BMR_OK);
    b2Body *body = AddBody(world, b2_dynamicBody, {-0.3f, 0.5f});
    listener.locked = body;
    REQUIRE(Frame().CreateFixtures(body, 1.0f) == BMR_OK);
    body->SetTransform({-0.3f, 1.5f}, 0.0f);
    for (int i = 0; i < 120; ++i)
        world.Step(1.0f / 60.0f, 8, 3);
    CHECK(listener.begins > listener.ends + 1); // several pairs touch: the control
    CHECK(listener.alone == listener.aloneAtEnd + 1);
    // It is destroyed as a whole: the contacts end one after the other, the last one alone.
    listener.locked = nullptr;
    world.DestroyBody(body);
    CHECK(listener.begins == listener.ends);
    CHECK(listener.alone == listener.aloneAtEnd);
    CHECK(listener.alone >= 1);
}

TEST_CASE("each piece has a mass that there can be, whatever the tolerance fills") {
    // A heavy disc, and far from it two combs, which the tolerance fills: the pieces there weigh too much.
    Ring ring;
    for (const float side : {1.0f, -1.0f}) {
        Ring half = {{0.0f, -1.0f}, {0.7f, -0.7f}, {0.95f, -0.1f}};
        for (int i = 0; i < 16; ++i) {
            const float below = i < 8 ? -1.0f : 1.0f;
            const float x = 9.0f + 0.15f * static_cast<float>(i < 8 ? i : 15 - i);
            const float first = i < 8 ? x : x + 0.05f, second = i < 8 ? x + 0.05f : x;
            for (const b2Vec2 point : {b2Vec2(first, 0.1f * below), b2Vec2(first, 1.2f * below),
                                       b2Vec2(second, 1.2f * below), b2Vec2(second, 0.1f * below)})
                half.push_back(point);
        }
        half.emplace_back(0.95f, 0.1f);
        half.emplace_back(0.7f, 0.7f);
        for (const b2Vec2 point : half)
            ring.push_back(side * point);
    }
    for (const float tolerance : {0.0f, 0.06f, 0.1f}) {
        CAPTURE(tolerance);
        OutlineShape outline;
        REQUIRE(outline.Set(ring.data(), Count(ring), nullptr, 0, tolerance) == BMR_OK);
        b2MassData whole;
        outline.ComputeMass(&whole, 1.0f);
        for (int32 i = 0; i < outline.GetPieceCount(); ++i) {
            b2MassData piece;
            outline.GetPiece(i).ComputeMass(&piece, 1.0f);
            CHECK(piece.mass > 0.0f);
            CHECK(piece.I - piece.mass * piece.center.LengthSquared() > 0.0f);
        }
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body *body = AddBody(world);
        REQUIRE(outline.CreateFixtures(body, 1.0f) == BMR_OK);
        CheckMass(*body, whole.mass, whole.center, whole.I);
        // One by one, as a game may, and all at once.
        for (int32 left = outline.GetPieceCount(); left > 3; --left) {
            body->DestroyFixture(body->GetFixtureList());
            CHECK(body->GetInertia() > 0.0f);
        }
        REQUIRE(outline.DestroyFixtures(body) == BMR_OK);
        CHECK(body->GetFixtureList() == nullptr);
    }
}
