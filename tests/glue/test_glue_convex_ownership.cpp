// SPDX-License-Identifier: MIT
// Who owns the real polygon of bmr::ConvexShapes: copies, clones, fixtures and threads share it, and the last
// frees it.
#include <atomic>

#include <box2d/box2d.h>

#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "shapes/big_polygons.h"

using bmr::ConvexShape;
using namespace shapes;

TEST_CASE("copies, clones and fixtures share one polygon, and the last frees it") {
    REQUIRE(bmr::registry::Count() == 0);
    const ConvexShape *kept = nullptr;
    {
        ConvexShape shape;
        REQUIRE(shape.SetRegular(64, 0.5f) == BMR_OK);
        shape.m_radius = 0.02f;
        const b2Vec2 *const vertices = shape.GetVertices();
        ConvexShape copy(shape), assigned;
        assigned = copy;
        assigned = *&assigned;
        CHECK(copy.GetVertices() == vertices);
        CHECK(assigned.GetVertices() == vertices);
        CHECK(assigned.m_radius == 0.02f);
        CHECK(bmr::registry::Count() == 1);
        REQUIRE(shape.SetRegular(32, 0.5f) == BMR_OK); // a new one: the others keep theirs
        CHECK(copy.GetVertexCount() == 64);
        CHECK(copy.GetVertices() == vertices);
        CHECK(bmr::registry::Count() == 2);
        shape = copy;
        CHECK(bmr::registry::Count() == 1);
        {
            b2World world(b2Vec2(0.0f, -10.0f));
            b2BodyDef def;
            def.type = b2_dynamicBody;
            b2Body *bodies[10];
            for (int i = 0; i < 10; ++i) {
                def.position.Set(5.0f * static_cast<float>(i), 0.0f);
                bodies[i] = world.CreateBody(&def);
                b2Fixture *fixture = bodies[i]->CreateFixture(&shape, 1.0f);
                kept = ConvexShape::From(fixture->GetShape());
                REQUIRE(kept != nullptr);
                CHECK(kept != &shape);
                CHECK(kept->GetVertices() == vertices);
                CHECK(kept->m_radius == 0.02f);
            }
            CHECK(bodies[0]->GetMass() == doctest::Approx(3.14159 * 0.25).epsilon(0.01));
            bodies[0]->DestroyFixture(bodies[0]->GetFixtureList());
            world.DestroyBody(bodies[1]);
            CHECK(bmr::registry::Count() == 1);
            b2PolygonShape *const plain = &copy;
            CHECK(plain->GetType() == b2Shape::e_polygon);
        }
        shape.SetRegular(4, 1.0f);
        copy = shape;
        CHECK(bmr::registry::Count() == 1);
        assigned = shape;
        CHECK(bmr::registry::Count() == 0);
        CHECK(assigned.GetVertexCount() == 4);
    }
    CHECK(bmr::registry::Count() == 0);
}

TEST_CASE("shapes are known for what they are, and polygons by a number that never comes again") {
    ConvexShape none, small, big;
    REQUIRE(small.SetRegular(8, 1.0f) == BMR_OK);
    REQUIRE(big.SetRegular(9, 1.0f) == BMR_OK);
    const b2PolygonShape plain;
    const b2CircleShape circle;
    CHECK(ConvexShape::From(nullptr) == nullptr);
    CHECK(ConvexShape::From(&plain) == nullptr);
    CHECK(ConvexShape::From(&circle) == nullptr);
    for (const ConvexShape *shape : {&none, &small, &big})
        CHECK(ConvexShape::From(shape) == shape);
    CHECK(bmr::AnyBigPolygon());
    CHECK(bmr::NumberOfBigPolygon(small) == 0);
    CHECK(bmr::NumberOfBigPolygon(plain) == 0);
    CHECK(bmr::BigPolygonOf(circle) == nullptr);
    std::vector<uint64_t> numbers;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(big.SetRegular(9 + i % 3, 1.0f) == BMR_OK);
        numbers.push_back(bmr::NumberOfBigPolygon(big));
        REQUIRE(numbers.back() != 0);
        CHECK(bmr::BigPolygonOfNumber(numbers.back()) == bmr::BigPolygonOf(big));
        if (i > 0)
            CHECK(bmr::BigPolygonOfNumber(numbers[numbers.size() - 2]) == nullptr);
    }
    std::sort(numbers.begin(), numbers.end());
    CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
    Engine engine(3);
    for (int i = 0; i < 10000; ++i) { // whatever stands in memory
        const uint64_t number = test_random_next(&engine.random);
        CHECK(bmr::BigPolygonOfNumber(i % 2 ? number : number & 0xff) == nullptr);
    }
}
