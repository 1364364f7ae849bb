// SPDX-License-Identifier: MIT
#include "world.h"

#include <cstring>
#include <typeinfo>

#include <box2d/b2_distance.h>

#include "plugin.h"
#include "state/visit.h"

namespace testbed {

// What the stage of a scene is to the testbed, the world here is to the script.
namespace {
template <typename Object> uint32_t ReadNumber(const Object &object) {
    return static_cast<uint32_t>(const_cast<Object &>(object).GetUserData().pointer);
}
} // namespace

uint32_t NumberOf(const b2Body &body) {
    return ReadNumber(body);
}
uint32_t NumberOf(const b2Fixture &fixture) {
    return ReadNumber(fixture);
}
uint32_t NumberOf(const b2Joint &joint) {
    return ReadNumber(joint);
}

} // namespace testbed

namespace fuzz {

using testbed::ContactMembers;
using testbed::EventObserver;
using testbed::NumberOf;

namespace {

uint32_t Mix(uint32_t from, uint32_t to, uint32_t step, uint32_t occasion) {
    return (((from * 31u + to) * 31u + step) * 5u + occasion) * 2654435761u >> 8;
}

EventObserver &Observer(testbed::EventRecorder &recorder) {
    return recorder;
}

} // namespace

b2PolygonShape *PlainPolygon(b2Fixture &fixture) {
    b2Shape *shape = fixture.GetShape();
    const b2Shape &object = *shape;
    return typeid(object) == typeid(b2PolygonShape) ? static_cast<b2PolygonShape *>(shape) : nullptr;
}

World::World(const b2Vec2 &gravity) : m_world(gravity) {
    m_world.SetContactListener(this);
    m_world.SetDestructionListener(this);
    m_world.SetContactFilter(this);
}

b2Body *World::Create(b2BodyDef def) {
    def.userData.pointer = m_bodiesMade++;
    return m_world.CreateBody(&def);
}

b2Fixture *World::Create(b2Body *body, b2FixtureDef def, const b2Shape &shape) {
    def.shape = &shape;
    def.userData.pointer = NextFixture();
    return body->CreateFixture(&def);
}

b2Joint *World::Create(b2JointDef &def) {
    def.userData.pointer = m_jointsMade++;
    return m_world.CreateJoint(&def);
}

void World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    ++m_steps;
    if (m_handsChanged)
        ChangeHands(0);
    m_handsChanged = false;
    m_world.Step(timeStep, velocityIterations, positionIterations);
}

bool World::IsFinite() const {
    for (const b2Body *body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        if (!body->GetPosition().IsValid() || !body->GetLinearVelocity().IsValid() ||
            !b2IsValid(body->GetAngle()) || !b2IsValid(body->GetAngularVelocity()))
            return false;
    return true;
}

void World::StartRecord(bool inWords) {
    m_recorder.StartStep(inWords);
    m_probes = testbed::HashSink();
}

void World::ChangeHands(uint32_t how) {
    b2ContactListener *const listeners[] = {this, &m_other, nullptr, this};
    b2ContactFilter *const filters[] = {this, &m_other, nullptr, this};
    m_world.SetContactListener(listeners[how % 4]);
    m_world.SetContactFilter(filters[how / 4 % 4]);
}

void World::BeginContact(b2Contact *contact) {
    Observer(m_recorder).OnBegin(*contact);
    React(contact, 0);
}

void World::EndContact(b2Contact *contact) {
    Observer(m_recorder).OnEnd(*contact);
    if (m_world.IsLocked()) // else a body, a fixture or the world is being taken apart
        React(contact, 1);
}

void World::PreSolve(b2Contact *contact, const b2Manifold *old) {
    Observer(m_recorder).OnPreSolve(*contact, *old);
    React(contact, 2);
}

void World::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    Observer(m_recorder).OnPostSolve(*contact, *impulse);
    React(contact, 3);
}

void World::SayGoodbye(b2Joint *joint) {
    Observer(m_recorder).OnGoodbye(*joint);
}

void World::SayGoodbye(b2Fixture *fixture) {
    Observer(m_recorder).OnGoodbye(*fixture);
}

bool World::ShouldCollide(b2Fixture *a, b2Fixture *b) {
    // The same for a pair whichever of the two comes first.
    if (filterReacts)
        ReactAsFilter(a, b);
    const uint32_t pair = (NumberOf(*a) + 1) * (NumberOf(*b) + 1);
    return (refused >> (pair % 8) & 1) == 0 && b2ContactFilter::ShouldCollide(a, b);
}

void World::React(b2Contact *contact, uint32_t occasion) {
    const b2Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
    const uint32_t mixed = Mix(NumberOf(a), NumberOf(b), m_steps, occasion);
    const uint32_t reaction = reactions[mixed % kReactions];
    if (reaction != 0)
        ActOn(contact, reaction, mixed / kReactions);
}

/// What can be done without a contact.
void World::ReactAsFilter(b2Fixture *a, b2Fixture *b) {
    const uint32_t mixed = Mix(NumberOf(*a), NumberOf(*b), m_steps, 4);
    b2Body *third = SomeBody(mixed / 8);
    switch (mixed % 32) {
    case 0:
        m_handsChanged = true;
        ChangeHands(mixed / 32);
        break;
    case 1:
        a->GetBody()->SetBullet(!a->GetBody()->IsBullet());
        break;
    case 2:
        third->SetAwake(!third->IsAwake());
        break;
    case 3:
        b->GetBody()->SetAwake(false);
        break;
    case 4:
        third->SetLinearVelocity({0.25f * static_cast<float>(mixed / 64 % 64) - 8.0f, 1.0f});
        break;
    case 5:
        b->GetShape()->m_radius = static_cast<float>(mixed / 64 % 8) * b2_polygonRadius;
        break;
    case 6:
        if (!m_world.IsLocked())
            third->SetTransform(third->GetPosition() + b2Vec2(0.0f, 0.125f), third->GetAngle());
        break;
    default:
        break;
    }
}

b2Body *World::SomeBody(uint32_t mixed) {
    b2Body *body = m_world.GetBodyList();
    for (uint32_t skip = mixed % static_cast<uint32_t>(m_world.GetBodyCount()); skip > 0; --skip)
        body = body->GetNext();
    return body;
}

void World::ActOn(b2Contact *contact, uint32_t reaction, uint32_t mixed) {
    b2Fixture *fixture = mixed % 2 == 0 ? contact->GetFixtureA() : contact->GetFixtureB();
    b2Body *body = fixture->GetBody(), *third = SomeBody(mixed / 2);
    const float amount = 0.05f * static_cast<float>(mixed / 2 % 20);
    switch (reaction % 24) {
    case 1:
    case 2:
        contact->SetEnabled(false);
        break;
    case 3:
        contact->SetFriction(amount);
        break;
    case 4:
        contact->SetRestitution(amount);
        contact->SetRestitutionThreshold(amount);
        break;
    case 5:
        contact->SetTangentSpeed(10.0f * amount - 5.0f);
        break;
    case 6:
        body->SetBullet(!body->IsBullet());
        break;
    case 7:
        third->SetBullet(!third->IsBullet());
        break;
    case 8:
        body->SetAwake(false);
        break;
    case 9:
        third->SetAwake(mixed / 64 % 2 == 0);
        break;
    case 10:
        fixture->SetSensor(true);
        break;
    case 11:
        fixture->SetSensor(false);
        break;
    case 12:
        fixture->Refilter();
        break;
    case 13:
        body->SetLinearVelocity(-amount * body->GetLinearVelocity());
        break;
    case 14:
        third->ApplyLinearImpulseToCenter({amount, 1.0f - amount}, true);
        third->ApplyAngularImpulse(amount, false);
        break;
    case 15: // Evaluate of anybody, in the middle of a step
        ProbeContact(contact);
        break;
    case 16:
        ProbePair(m_probes, *contact->GetFixtureA(), contact->GetChildIndexA(), *contact->GetFixtureB(),
                  contact->GetChildIndexB());
        break;
    case 17: // in place, and nobody is told
        if (b2PolygonShape *polygon = PlainPolygon(*fixture))
            polygon->SetAsBox(0.2f + amount, 0.3f);
        break;
    case 18:
        third->SetGravityScale(amount - 0.5f);
        third->SetSleepingAllowed(mixed / 64 % 2 == 0);
        break;
    case 19: // the list is whole for whoever looks
        for (const b2Contact *c = m_world.GetContactList(); c != nullptr; c = c->GetNext()) {
            m_probes.Field("a", NumberOf(*c->GetFixtureA()));
            m_probes.Field("b", NumberOf(*c->GetFixtureB()));
            m_probes.Field("flags", ContactMembers::FlagsThatLast(*c));
        }
        break;
    case 20: // a listener steps another world
        if (other != nullptr && !other->m_world.IsLocked())
            other->Step(1.0f / 60.0f, 4, 2);
        break;
    case 21:
        fixture->GetShape()->m_radius = amount * 4.0f * b2_polygonRadius;
        break;
    case 22:
        fixture->SetFriction(amount);
        contact->ResetFriction();
        contact->ResetRestitution();
        break;
    case 23: // another listener, filter or none, in the midst of a step
        m_handsChanged = true;
        ChangeHands(mixed / 64);
        break;
    default:
        break;
    }
}

void World::ProbeContact(b2Contact *contact) {
    b2Manifold manifold;
    std::memset(static_cast<void *>(&manifold), 0x7f, sizeof manifold);
    contact->Evaluate(&manifold, contact->GetFixtureA()->GetBody()->GetTransform(),
                      contact->GetFixtureB()->GetBody()->GetTransform());
    testbed::VisitManifold(m_probes, manifold, false);
}

void ProbePair(testbed::HashSink &sink, const b2Fixture &a, int32 childA, const b2Fixture &b, int32 childB) {
    const b2Transform &xfA = a.GetBody()->GetTransform(), &xfB = b.GetBody()->GetTransform();
    b2DistanceInput input;
    input.proxyA.Set(a.GetShape(), childA);
    input.proxyB.Set(b.GetShape(), childB);
    input.transformA = xfA;
    input.transformB = xfB;
    input.useRadii = true;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput distance;
    b2Distance(&distance, &cache, &input);
    sink.Field("distance", distance.distance);
    testbed::VisitVector(sink, "a.x", "a.y", distance.pointA);
    sink.Field("overlap",
               uint32_t{b2TestOverlap(a.GetShape(), childA, b.GetShape(), childB, xfA, xfB) ? 1u : 0u});
    b2ShapeCastInput cast;
    cast.proxyA = input.proxyA;
    cast.proxyB = input.proxyB;
    cast.transformA = xfA;
    cast.transformB = xfB;
    cast.translationB = {1.0f, -2.0f};
    b2ShapeCastOutput hit = {};
    if (b2ShapeCast(&hit, &cast))
        sink.Field("lambda", hit.lambda);
}

} // namespace fuzz
