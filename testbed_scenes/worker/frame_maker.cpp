// SPDX-License-Identifier: MIT
#include "worker/frame_maker.h"

#include <algorithm>
#include <tuple>

#include <box2d/b2_distance.h>

#include "shapes.h"
#include "stage.h"

namespace testbed {
namespace {

using shown::Vec;

int Number(const b2Body &body) {
    return static_cast<int>(NumberOf(body));
}

std::pair<int, int> Sorted(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::pair<int, int> BodiesOf(const b2Contact &contact) {
    return Sorted(Number(*contact.GetFixtureA()->GetBody()), Number(*contact.GetFixtureB()->GetBody()));
}

bool IsSolid(const b2Contact &contact) {
    return !contact.GetFixtureA()->IsSensor() && !contact.GetFixtureB()->IsSensor();
}

bool IsOfPolygons(const b2Contact &contact) {
    return contact.GetFixtureA()->GetType() == b2Shape::e_polygon &&
           contact.GetFixtureB()->GetType() == b2Shape::e_polygon;
}

/// Whether the plugin is there, and at work.
bool ShowsProofs() {
    static const bool shows = PluginName() == std::string("plugin");
    return shows;
}

std::vector<Vec> ToVecs(const b2Vec2 *points, int32 count) {
    std::vector<Vec> list;
    list.reserve(static_cast<std::size_t>(count));
    for (int32 i = 0; i < count; ++i)
        list.push_back(ToVec(points[i]));
    return list;
}

const char *NameOf(b2BodyType type) {
    return type == b2_staticBody ? "static" : type == b2_kinematicBody ? "kinematic" : "dynamic";
}

shown::Fixture ShowFixture(const b2Fixture &fixture) {
    shown::Fixture record;
    record.body = Number(*fixture.GetBody());
    record.number = static_cast<int>(NumberOf(fixture));
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
    default: {
        // All its vertices, where it has more than Box2D knows.
        const Vertices vertices = VerticesOf(static_cast<const b2PolygonShape &>(shape));
        record.shape = "polygon";
        record.points = ToVecs(vertices.data(), static_cast<int32>(vertices.size()));
        record.inner = InnerEdgesOf(fixture);
        break;
    }
    }
    return record;
}

/// Bodies, fixtures and the boxes of the broad phase.
void AddBodies(const b2World &world, shown::Frame *frame) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const b2Transform &xf = body->GetTransform();
        shown::Body record;
        record.number = Number(*body);
        record.type = NameOf(body->GetType());
        record.pose = {ToVec(xf.p), xf.q.c, xf.q.s};
        record.asleep = !body->IsAwake();
        record.disabled = !body->IsEnabled();
        frame->bodies.push_back(record);
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            frame->fixtures.push_back(ShowFixture(*f));
            const int32 children = body->IsEnabled() ? f->GetShape()->GetChildCount() : 0;
            for (int32 child = 0; child < children; ++child) {
                const b2AABB &box = f->GetAABB(child);
                frame->boxes.push_back(
                    {box.lowerBound.x, box.lowerBound.y, box.upperBound.x, box.upperBound.y});
            }
        }
    }
}

/// From body to body over both anchors.
void AddJoints(const b2World &world, shown::Frame *frame) {
    for (const b2Joint *constant = world.GetJointList(); constant != nullptr;
         constant = constant->GetNext()) {
        // Its anchors are not const in Box2D, though asking changes nothing.
        auto *joint = const_cast<b2Joint *>(constant);
        frame->joints.push_back({{ToVec(joint->GetBodyA()->GetPosition()), ToVec(joint->GetAnchorA()),
                                  ToVec(joint->GetAnchorB()), ToVec(joint->GetBodyB()->GetPosition())}});
    }
}

/// Touching contacts of solid fixtures.
void AddTouching(const b2World &world, shown::Frame *frame) {
    for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
        if (!c->IsTouching() || !IsSolid(*c))
            continue;
        b2WorldManifold points;
        c->GetWorldManifold(&points);
        shown::Contact record;
        record.bodies = {Number(*c->GetFixtureA()->GetBody()), Number(*c->GetFixtureB()->GetBody())};
        record.normal = ToVec(points.normal);
        const b2Manifold &manifold = *c->GetManifold();
        for (int32 i = 0; i < manifold.pointCount; ++i)
            record.points.push_back({ToVec(points.points[i]), manifold.points[i].normalImpulse});
        frame->touching.push_back(std::move(record));
    }
}

/// Closest points of two fixtures, one child each, without their radii.
b2DistanceOutput MeasureClosest(const b2Fixture &fixtureA, const b2Fixture &fixtureB) {
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
    return output;
}

/// A proof between the same two bodies, called the other way round.
void Swap(shown::Proof *proof) {
    proof->owner = proof->kind == "disks" ? proof->owner : 1 - proof->owner;
    std::swap(proof->supports[0], proof->supports[1]);
    std::swap(proof->centres[0], proof->centres[1]);
    std::swap(proof->radii[0], proof->radii[1]);
}

} // namespace

void FrameMaker::BeginStep(int step) {
    m_step = step;
    m_events.clear();
    m_handedOver.clear();
}

void FrameMaker::OnKineticEvent(const b2Body &bodyA, const b2Body &bodyB, const char *kind) {
    const auto [a, b] = Sorted(Number(bodyA), Number(bodyB));
    m_events.push_back({kind, a, b});
}

void FrameMaker::OnAnswer(const b2Contact &contact, bool handedOver) {
    if (handedOver)
        ++m_handedOver[BodiesOf(contact)];
}

shown::Frame FrameMaker::Take(const b2World &world) {
    shown::Frame frame;
    frame.scene = m_scene;
    frame.program = PluginName();
    frame.step = m_step;
    AddBodies(world, &frame);
    AddJoints(world, &frame);
    AddTouching(world, &frame);
    AddPairs(world, &frame);
    frame.events = std::move(m_events);
    return frame;
}

void FrameMaker::AddPairs(const b2World &world, shown::Frame *frame) {
    std::map<Bodies, Draft> drafts;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        if (IsSolid(*contact))
            AddContact(*contact, &drafts[BodiesOf(*contact)]);
    for (auto &[bodies, draft] : drafts) {
        std::tie(draft.pair.a, draft.pair.b) = bodies;
        const auto handedOver = m_handedOver.find(bodies);
        draft.pair.handed_over = handedOver != m_handedOver.end() ? handedOver->second : 0;
        frame->pairs.push_back(std::move(draft.pair));
    }
}

void FrameMaker::AddContact(const b2Contact &contact, Draft *draft) {
    shown::Pair &pair = draft->pair;
    ++pair.contacts;
    pair.touching += contact.IsTouching() ? 1 : 0;
    if (!IsOfPolygons(contact))
        return;
    const b2Fixture *a = contact.GetFixtureA(), *b = contact.GetFixtureB();
    const bool swapped = Number(*a->GetBody()) > Number(*b->GetBody());
    if (swapped)
        std::swap(a, b);
    const bool isFirst = pair.polygon_contacts++ == 0;
    const b2DistanceOutput closest = MeasureClosest(*a, *b);
    if (isFirst || closest.distance < pair.distance) {
        pair.distance = closest.distance;
        pair.closest = {ToVec(closest.pointA), ToVec(closest.pointB)};
    }
    if (ShowsProofs())
        AddProof(contact, swapped, draft);
}

void FrameMaker::AddProof(const b2Contact &contact, bool swapped, Draft *draft) {
    shown::Pair &pair = draft->pair;
    ShownProof shown = ShowProof(contact);
    shown::Proof &proof = shown.proof;
    // All that is unproved goes together, and so does what one structure proves.
    const bool alone = shown.structure == nullptr && proof.kind != "none";
    if (!alone) {
        for (const auto &[structure, place] : draft->shared) {
            if (structure == shown.structure) {
                ++pair.proofs[place].contacts;
                return;
            }
        }
        draft->shared.emplace_back(shown.structure, pair.proofs.size());
    }
    if (swapped)
        Swap(&proof);
    pair.proofs.push_back(std::move(proof));
}

} // namespace testbed
