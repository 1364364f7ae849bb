// SPDX-License-Identifier: MIT
// Inertia far from a body's origin: what floats hold of it, what is refused, and that Box2D's never comes to
// nothing or less.
#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "cases.h"
#include "small_world.h"

#include "box2d_shapes.h"

using bmr::OutlineShape;
using namespace shapes;
using Ring = std::vector<b2Vec2>;

namespace {

/// Box2D's, about the centre: b2Body shows it about the origin alone, where the rest is lost.
double InertiaOf(b2Body *body) {
    body->SetAngularVelocity(0.0f);
    body->ApplyAngularImpulse(1.0f, true);
    const float speed = body->GetAngularVelocity();
    body->SetAngularVelocity(0.0f);
    return 1.0 / double{speed};
}

struct Exact {
    double mass, inertia; ///< about the centre
    double square;        ///< of the centre's distance from the origin
    double x, y;          ///< the centre
    double Half() const { ///< of the last bit of the floats that Box2D takes from each other
        return std::exp2(std::floor(std::log2(mass * square + inertia)) - 24.0);
    }
};

/// Of a ring, counter-clockwise, in double.
Exact Weigh(const Ring &ring, double density) {
    double area = 0.0, x = 0.0, y = 0.0, inertia = 0.0;
    const double x0 = ring[0].x, y0 = ring[0].y;
    for (size_t i = 1; i + 1 < ring.size(); ++i) {
        const double ax = ring[i].x - x0, ay = ring[i].y - y0, bx = ring[i + 1].x - x0,
                     by = ring[i + 1].y - y0;
        const double cross = ax * by - ay * bx;
        area += cross / 2.0;
        x += cross * (ax + bx) / 6.0;
        y += cross * (ay + by) / 6.0;
        inertia += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
    }
    x /= area;
    y /= area;
    return {density * area, density * (inertia - area * (x * x + y * y)),
            std::pow(x + x0, 2) + std::pow(y + y0, 2), x + x0, y + y0};
}

Ring RandomRing(Engine &engine, b2Vec2 at, float size, int most = 40) {
    const int count = 5 + Below(engine, most);
    Ring ring;
    for (int i = 0; i < count; ++i) {
        const float angle =
            6.2831853f * (static_cast<float>(i) + UniformF(engine, 0.0, 0.7)) / static_cast<float>(count);
        ring.push_back(at + size * UniformF(engine, 0.4, 1.0) * b2Vec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

bool MakeOutline(const Ring &ring, OutlineShape *outline) {
    return outline->Set(ring.data(), static_cast<int32>(ring.size())) == BMR_OK;
}

const Ring kElbow = {{0, 0}, {0.5f, 0}, {0.5f, 0.25f}, {0.25f, 0.25f}, {0.25f, 0.5f}, {0, 0.5f}};

} // namespace

TEST_CASE("an inertia is the nearest that floats hold or one beside it, whatever the density, or an error") {
    Engine engine(3);
    int held = 0, nearest = 0, refused = 0;
    for (size_t n = 0; n < test_scaled(3000); ++n) {
        CAPTURE(n);
        const float size = UniformF(engine, 0.2, 3.0), away = std::pow(10.0f, UniformF(engine, 0.0, 4.0));
        const float angle = UniformF(engine, -3.2, 3.2), density = UniformF(engine, 0.1, 20.0);
        const Ring ring = RandomRing(engine, away * b2Vec2(std::cos(angle), std::sin(angle)), size);
        OutlineShape outline;
        if (!MakeOutline(ring, &outline))
            continue;
        const Exact exact = Weigh(ring, double{density});
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body *const body = AddBody(world);
        const bmr_error error = outline.CreateFixtures(body, density);
        if (error == BMR_OK) {
            ++held;
            const double off = std::abs(InertiaOf(body) - exact.inertia);
            nearest += off <= 1.01 * exact.Half() + 1e-6 * exact.inertia;
            CHECK(off <= 0.126 * exact.inertia);
            body->ResetMassData();
            CHECK(std::abs(InertiaOf(body) - exact.inertia) == doctest::Approx(off));
        } else {
            ++refused;
            CHECK(error == BMR_ERROR_FAR_FROM_ORIGIN);
            CHECK(exact.inertia < 0x1p-18 * exact.mass * exact.square); // of up to 40 pieces
            CHECK(body->GetFixtureList() == nullptr);
        }
    }
    CHECK(held > refused);
    CHECK(refused > 0);
    CHECK(nearest > held * 9 / 10);
}

TEST_CASE("what cannot be held is refused with what to do, and not where nothing turns") {
    const Ring five = {{1125.6969f, -4},
                       {1126.17114f, -4},
                       {1126.39758f, -3.56634521f},
                       {1126.1156f, -3.50019836f},
                       {1125.86841f, -3.48608398f}};
    OutlineShape outline;
    REQUIRE(MakeOutline(five, &outline));
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *const turning = AddBody(world), *const fixed = AddBody(world),
                  *const still = AddBody(world, b2_staticBody);
    fixed->SetFixedRotation(true);
    CHECK(outline.CreateFixtures(turning, 1.0f) == BMR_ERROR_FAR_FROM_ORIGIN);
    CHECK(outline.CreateFixtures(turning, 0.0f) == BMR_OK);
    CHECK(outline.CreateFixtures(fixed, 1.0f) == BMR_OK);
    CHECK(outline.CreateFixtures(still, 1.0f) == BMR_OK);
    // What turns after all has some inertia.
    still->SetType(b2_dynamicBody);
    fixed->SetFixedRotation(false);
    CHECK(InertiaOf(still) > 0.0);
    CHECK(InertiaOf(fixed) > 0.0);
    // One that alone can be held, on a body that has what cannot.
    OutlineShape elbow;
    REQUIRE(MakeOutline(kElbow, &elbow));
    b2Body *const both = AddBody(world);
    CHECK(elbow.CreateFixtures(both, 1.0f) == BMR_OK);
    bmr::ConvexShape coin;
    REQUIRE(coin.SetRegular(16, 0.3f) == BMR_OK);
    CHECK(both->CreateFixture(&coin, 1.0f) != nullptr);
    CHECK(elbow.CreateFixtures(both, 2.0f) == BMR_OK);
}

TEST_CASE("of several outlines on a body, too, an inertia is right to an eighth, or an error") {
    Engine engine(7);
    int refused = 0, several = 0;
    // (Fewer see nothing of an inertia that was taken from the pieces' distances.)
    for (size_t n = 0; n < std::max<size_t>(test_scaled(3000), 1500); ++n) {
        CAPTURE(n);
        const float away = std::pow(10.0f, UniformF(engine, 2.0, 3.5)), angle = UniformF(engine, -3.2, 3.2);
        const b2Vec2 at = away * b2Vec2(std::cos(angle), std::sin(angle));
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body *const body = AddBody(world);
        std::vector<Ring> rings;
        for (int i = 2 + Below(engine, 3); i > 0; --i) {
            // (Large rings take nearly all the time, to be cut.)
            const Ring ring = RandomRing(engine, at, UniformF(engine, 0.3, 2.0), n % 8 == 0 ? 40 : 10);
            OutlineShape outline;
            if (MakeOutline(ring, &outline) && outline.CreateFixtures(body, 1.0f) == BMR_OK)
                rings.push_back(ring);
            else
                ++refused;
        }
        if (rings.size() < 2)
            continue;
        ++several;
        // About `at`, and from there about the centre.
        double mass = 0.0, x = 0.0, y = 0.0, inertia = 0.0;
        for (const Ring &ring : rings) {
            const Exact exact = Weigh(ring, 1.0);
            const double cx = exact.x - at.x, cy = exact.y - at.y;
            mass += exact.mass;
            x += exact.mass * cx;
            y += exact.mass * cy;
            inertia += exact.inertia + exact.mass * (cx * cx + cy * cy);
        }
        const double right = inertia - (x * x + y * y) / mass;
        CHECK(std::abs(InertiaOf(body) - right) <= 0.13 * right);
    }
    CHECK(several > 0);
    CHECK(refused > 0);
}

TEST_CASE("a polygon of more than 8 vertices has the nearest inertia that floats hold, or one above zero") {
    for (const b2Vec2 at : {b2Vec2(0, 0), b2Vec2(80, -29), b2Vec2(200, -74), b2Vec2(280, -90),
                            b2Vec2(800, -296), b2Vec2(8000, -2960)}) {
        CAPTURE(at.x);
        Ring ring;
        for (const b2Vec2 &v : shapes::Circle(16, 0.3, double{at.x}, double{at.y}))
            ring.push_back(v);
        bmr::ConvexShape coin;
        REQUIRE(coin.Set(ring.data(), 16) == BMR_OK);
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body *const body = AddBody(world);
        body->CreateFixture(&coin, 1.0f);
        const Exact exact = Weigh(ring, 1.0);
        const double inertia = InertiaOf(body);
        if (exact.inertia >= 0x1p-21 * exact.mass * exact.square)
            CHECK(std::abs(inertia - exact.inertia) <= 1.01 * exact.Half() + 1e-6 * exact.inertia);
        else
            CHECK(inertia > 0.0);
    }
}

TEST_CASE("whatever is put on a body and taken off it, Box2D's inertia stays above zero") {
    Engine engine(5);
    int bodies = 0, refused = 0;
    for (size_t n = 0; n < test_scaled(600); ++n) {
        CAPTURE(n);
        const float away = std::pow(10.0f, UniformF(engine, 0.0, 4.0)), angle = UniformF(engine, -3.2, 3.2);
        const b2Vec2 at = away * b2Vec2(std::cos(angle), std::sin(angle));
        b2World world(b2Vec2(0.0f, 0.0f));
        // What stands still is weighed when it is set free.
        const bool still = Below(engine, 2) == 0;
        b2Body *const body = AddBody(world, still ? b2_staticBody : b2_dynamicBody);
        for (int i = still ? 1 : 1 + Below(engine, 3); i > 0; --i) {
            OutlineShape outline;
            if (MakeOutline(RandomRing(engine, at, UniformF(engine, 0.1, 2.0)), &outline))
                refused += outline.CreateFixtures(body, UniformF(engine, 0.1, 20.0)) != BMR_OK;
        }
        if (Below(engine, 2) == 0) {
            bmr::ConvexShape coin;
            const Ring ring =
                shapes::Circle(9 + Below(engine, 20), UniformF(engine, 0.5, 2.0), double{at.x}, double{at.y});
            if (coin.Set(ring.data(), static_cast<int32>(ring.size())) == BMR_OK)
                body->CreateFixture(&coin, UniformF(engine, 0.1, 20.0));
        }
        body->SetType(b2_dynamicBody);
        bodies += body->GetFixtureList() != nullptr;
        while (body->GetFixtureList() != nullptr) {
            CHECK(InertiaOf(body) > 0.0);
            b2Fixture *fixture = body->GetFixtureList();
            for (int i = Below(engine, 20); i > 0 && fixture->GetNext() != nullptr; --i)
                fixture = fixture->GetNext();
            if (Below(engine, 4) == 0) {
                fixture->SetDensity(UniformF(engine, 0.1, 20.0));
                body->ResetMassData();
                CHECK(InertiaOf(body) > 0.0);
            }
            body->DestroyFixture(fixture);
        }
    }
    CHECK(bodies > refused);
    CHECK(refused > 0);
}
