// SPDX-License-Identifier: MIT
#include "worker/record_world.h"

#include <box2d/b2_distance.h>

#include "any_size.h"
#include "outlined.h"
#include "stage.h"

namespace testbed {
namespace {

using recording::Vec;

int BodyNumber(const b2Fixture *fixture) {
    return static_cast<int>(NumberOf(*fixture->GetBody()));
}

int FixtureNumber(const b2Fixture *fixture) {
    return static_cast<int>(NumberOf(*fixture));
}

const char *NameOf(b2BodyType type) {
    switch (type) {
    case b2_staticBody:
        return "static";
    case b2_kinematicBody:
        return "kinematic";
    default:
        return "dynamic";
    }
}

const char *NameOf(b2JointType type) {
    switch (type) {
    case e_revoluteJoint:
        return "revolute";
    case e_prismaticJoint:
        return "prismatic";
    case e_distanceJoint:
        return "distance";
    case e_pulleyJoint:
        return "pulley";
    case e_mouseJoint:
        return "mouse";
    case e_gearJoint:
        return "gear";
    case e_wheelJoint:
        return "wheel";
    case e_weldJoint:
        return "weld";
    case e_frictionJoint:
        return "friction";
    case e_motorJoint:
        return "motor";
    default:
        return "rope";
    }
}

std::vector<Vec> ToVecs(const b2Vec2 *points, int32 count) {
    std::vector<Vec> list;
    list.reserve(static_cast<std::size_t>(count));
    for (int32 i = 0; i < count; ++i)
        list.push_back(ToVec(points[i]));
    return list;
}

/// The outline that is to be shown of a polygon: all its vertices, where it has more than Box2D knows.
std::vector<Vec> OutlineOf(const b2PolygonShape &polygon) {
    const Outline outline = VerticesOf(polygon);
    return ToVecs(outline.data(), static_cast<int32>(outline.size()));
}

recording::Fixture RecordFixture(const b2Fixture &fixture) {
    recording::Fixture record;
    record.body = BodyNumber(&fixture);
    record.number = FixtureNumber(&fixture);
    record.radius = fixture.GetShape()->m_radius;
    record.sensor = fixture.IsSensor();
    const b2Shape &shape = *fixture.GetShape();
    switch (shape.GetType()) {
    case b2Shape::e_circle:
        record.shape = "circle";
        record.points = {ToVec(static_cast<const b2CircleShape &>(shape).m_p)};
        break;
    case b2Shape::e_edge: {
        const auto &edge = static_cast<const b2EdgeShape &>(shape);
        record.shape = "edge";
        record.points = {ToVec(edge.m_vertex1), ToVec(edge.m_vertex2)};
        break;
    }
    case b2Shape::e_chain: {
        const auto &chain = static_cast<const b2ChainShape &>(shape);
        record.shape = "chain";
        record.points = ToVecs(chain.m_vertices, chain.m_count);
        break;
    }
    default:
        record.shape = "polygon";
        record.points = OutlineOf(static_cast<const b2PolygonShape &>(shape));
        record.inner = InnerEdgesOf(fixture);
        break;
    }
    return record;
}

template <typename Visit> void VisitFixtures(const b2World &world, Visit visit) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            visit(*f);
    }
}

/// Keeps the lines that Box2D draws.
class LineKeeper final : public b2Draw {
public:
    std::vector<std::array<Vec, 2>> lines;

    void DrawPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawSolidPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawCircle(const b2Vec2 &, float, const b2Color &) override {}
    void DrawSolidCircle(const b2Vec2 &, float, const b2Vec2 &, const b2Color &) override {}
    void DrawSegment(const b2Vec2 &from, const b2Vec2 &to, const b2Color &) override {
        lines.push_back({ToVec(from), ToVec(to)});
    }
    void DrawTransform(const b2Transform &) override {}
    void DrawPoint(const b2Vec2 &, float, const b2Color &) override {}
};

} // namespace

Vec ToVec(const b2Vec2 &v) {
    return {v.x, v.y};
}

std::vector<recording::Body> RecordBodies(const b2World &world) {
    std::vector<recording::Body> bodies;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const b2Transform &xf = body->GetTransform();
        recording::Body record;
        record.number = static_cast<int>(NumberOf(*body));
        record.type = NameOf(body->GetType());
        record.pose = {ToVec(xf.p), xf.q.c, xf.q.s};
        record.asleep = !body->IsAwake();
        record.disabled = !body->IsEnabled();
        record.bullet = body->IsBullet();
        bodies.push_back(record);
    }
    return bodies;
}

std::vector<recording::Fixture> RecordFixtures(const b2World &world) {
    std::vector<recording::Fixture> fixtures;
    VisitFixtures(world, [&](const b2Fixture &fixture) { fixtures.push_back(RecordFixture(fixture)); });
    return fixtures;
}

std::vector<recording::Box> RecordBoxes(const b2World &world) {
    std::vector<recording::Box> boxes;
    VisitFixtures(world, [&](const b2Fixture &fixture) {
        const int32 children = fixture.GetBody()->IsEnabled() ? fixture.GetShape()->GetChildCount() : 0;
        for (int32 child = 0; child < children; ++child) {
            const b2AABB &box = fixture.GetAABB(child);
            boxes.push_back({BodyNumber(&fixture), FixtureNumber(&fixture), child, box.lowerBound.x,
                             box.lowerBound.y, box.upperBound.x, box.upperBound.y});
        }
    });
    return boxes;
}

std::vector<recording::Joint> RecordJoints(const b2World &world) {
    std::vector<recording::Joint> joints;
    for (const b2Joint *constant = world.GetJointList(); constant != nullptr;
         constant = constant->GetNext()) {
        // Its bodies and anchors are not const in Box2D, though asking changes nothing.
        auto *joint = const_cast<b2Joint *>(constant);
        LineKeeper keeper;
        joint->Draw(&keeper);
        recording::Joint record;
        record.number = static_cast<int>(NumberOf(*joint));
        record.type = NameOf(joint->GetType());
        record.bodies = {static_cast<int>(NumberOf(*joint->GetBodyA())),
                         static_cast<int>(NumberOf(*joint->GetBodyB()))};
        record.anchors = {ToVec(joint->GetAnchorA()), ToVec(joint->GetAnchorB())};
        record.segments = std::move(keeper.lines);
        joints.push_back(std::move(record));
    }
    return joints;
}

std::vector<recording::Contact> RecordTouching(const b2World &world) {
    std::vector<recording::Contact> contacts;
    for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
        const b2Fixture *a = c->GetFixtureA(), *b = c->GetFixtureB();
        if (!c->IsTouching() || a->IsSensor() || b->IsSensor())
            continue;
        b2WorldManifold points;
        c->GetWorldManifold(&points);
        recording::Contact record;
        record.bodies = {BodyNumber(a), BodyNumber(b)};
        record.fixtures = {FixtureNumber(a), FixtureNumber(b)};
        record.normal = ToVec(points.normal);
        const b2Manifold &manifold = *c->GetManifold();
        for (int32 i = 0; i < manifold.pointCount; ++i)
            record.points.push_back({ToVec(points.points[i]), manifold.points[i].normalImpulse});
        contacts.push_back(std::move(record));
    }
    return contacts;
}

Closest MeasureClosest(const b2Fixture &fixtureA, const b2Fixture &fixtureB) {
    b2DistanceInput input;
    input.proxyA.Set(fixtureA.GetShape(), 0);
    input.proxyB.Set(fixtureB.GetShape(), 0);
    input.transformA = fixtureA.GetBody()->GetTransform();
    input.transformB = fixtureB.GetBody()->GetTransform();
    input.useRadii = false;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return {output.distance, output.pointA, output.pointB};
}

} // namespace testbed
