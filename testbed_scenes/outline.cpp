// SPDX-License-Identifier: MIT
#include "outline.h"

#include <cfloat>
#include <map>
#include <utility>

#include <box2d/b2_distance.h>
#include <box2d/box2d.h>

#include "stage.h"

namespace testbed {
namespace {

const char *StateOf(const b2Body &body, const b2Fixture &fixture) {
    if (!body.IsEnabled())
        return "disabled";
    if (fixture.IsSensor())
        return "sensor";
    if (body.GetType() == b2_staticBody)
        return "static";
    if (body.GetType() == b2_kinematicBody)
        return "kinematic";
    return body.IsAwake() ? "dynamic" : "sleeping";
}

// Nine digits bring every float back exactly.
void WritePoint(std::FILE *out, const b2Vec2 &point) {
    std::fprintf(out, " %.9g %.9g", static_cast<double>(point.x), static_cast<double>(point.y));
}

void WriteHead(std::FILE *out, const char *kind, uint32_t body, const char *state) {
    std::fprintf(out, "outline %s %u %s", kind, body, state);
}

void WriteFixture(std::FILE *out, const b2Body &body, const b2Fixture &fixture) {
    const b2Transform &xf = body.GetTransform();
    const char *state = StateOf(body, fixture);
    const uint32_t number = NumberOf(body);
    switch (fixture.GetType()) {
    case b2Shape::e_polygon: {
        const auto &polygon = static_cast<const b2PolygonShape &>(*fixture.GetShape());
        WriteHead(out, "polygon", number, state);
        for (int32 i = 0; i < polygon.m_count; ++i)
            WritePoint(out, b2Mul(xf, polygon.m_vertices[i]));
        break;
    }
    case b2Shape::e_circle: {
        const auto &circle = static_cast<const b2CircleShape &>(*fixture.GetShape());
        WriteHead(out, "circle", number, state);
        WritePoint(out, b2Mul(xf, circle.m_p));
        std::fprintf(out, " %.9g %.9g", static_cast<double>(circle.m_radius),
                     static_cast<double>(xf.q.GetAngle()));
        break;
    }
    case b2Shape::e_edge: {
        const auto &edge = static_cast<const b2EdgeShape &>(*fixture.GetShape());
        WriteHead(out, "chain", number, state);
        WritePoint(out, b2Mul(xf, edge.m_vertex1));
        WritePoint(out, b2Mul(xf, edge.m_vertex2));
        break;
    }
    case b2Shape::e_chain: {
        const auto &chain = static_cast<const b2ChainShape &>(*fixture.GetShape());
        WriteHead(out, "chain", number, state);
        for (int32 i = 0; i < chain.m_count; ++i)
            WritePoint(out, b2Mul(xf, chain.m_vertices[i]));
        break;
    }
    default:
        return;
    }
    std::fputc('\n', out);
}

struct Gap {
    float distance = FLT_MAX;
    b2Vec2 onA, onB;
};

Gap MeasureGap(const b2Fixture &fixtureA, const b2Fixture &fixtureB) {
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

void WriteContacts(std::FILE *out, const b2World &world, SlackFunction slack) {
    // Keyed by numbers, not addresses: the order of the lines must not depend on the allocator.
    std::map<std::pair<uint32_t, uint32_t>, std::pair<Gap, std::pair<const b2Body *, const b2Body *>>> pairs;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        const b2Fixture *fixtureA = contact->GetFixtureA();
        const b2Fixture *fixtureB = contact->GetFixtureB();
        if (fixtureA->IsSensor() || fixtureB->IsSensor())
            continue;
        if (contact->IsTouching()) {
            b2WorldManifold manifold;
            contact->GetWorldManifold(&manifold);
            for (int32 i = 0; i < contact->GetManifold()->pointCount; ++i) {
                std::fputs("outline point", out);
                WritePoint(out, manifold.points[i]);
                std::fputc('\n', out);
            }
        }
        if (fixtureA->GetType() != b2Shape::e_polygon || fixtureB->GetType() != b2Shape::e_polygon)
            continue;
        uint32_t numberA = NumberOf(*fixtureA->GetBody());
        uint32_t numberB = NumberOf(*fixtureB->GetBody());
        if (numberA > numberB) {
            std::swap(numberA, numberB);
            std::swap(fixtureA, fixtureB);
        }
        const Gap gap = MeasureGap(*fixtureA, *fixtureB);
        auto &least = pairs[{numberA, numberB}];
        if (gap.distance < least.first.distance)
            least = {gap, {fixtureA->GetBody(), fixtureB->GetBody()}};
    }
    for (const auto &[key, value] : pairs) {
        const auto &[gap, bodies] = value;
        std::fprintf(out, "outline pair %u %u", key.first, key.second);
        WritePoint(out, gap.onA);
        WritePoint(out, gap.onB);
        const double certified =
            slack != nullptr ? static_cast<double>(slack(bodies.first, bodies.second)) : -1.0;
        std::fprintf(out, " %.9g\n", certified);
    }
}

} // namespace

void WriteOutline(std::FILE *out, const b2World &world, SlackFunction slack) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        for (const b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
            WriteFixture(out, *body, *fixture);
    }
    for (const b2Joint *joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        // The anchors are not const in Box2D, though they change nothing.
        auto *readable = const_cast<b2Joint *>(joint);
        std::fputs("outline joint", out);
        WritePoint(out, readable->GetAnchorA());
        WritePoint(out, readable->GetAnchorB());
        std::fputc('\n', out);
    }
    WriteContacts(out, world, slack);
}

} // namespace testbed
