// SPDX-License-Identifier: MIT
// What takes the place of what it was: fixtures and bodies at addresses of others, other centres, other
// places.
#include <vector>

#include "actor.h"

namespace actor {

namespace {

/// A fixture once it is gone.
struct Kept {
    b2FixtureDef def;
    b2PolygonShape polygon;
    b2CircleShape circle;
    const b2Shape &Shape() const {
        return polygon.m_count > 0 ? static_cast<const b2Shape &>(polygon) : circle;
    }
};

/// False for a shape that nobody copies here: an edge, a chain, a polygon of any size.
bool Keep(b2Fixture &fixture, Kept *kept) {
    kept->def.density = fixture.GetDensity();
    kept->def.friction = fixture.GetFriction();
    kept->def.restitution = fixture.GetRestitution();
    kept->def.isSensor = fixture.IsSensor();
    kept->def.filter = fixture.GetFilterData();
    if (const b2PolygonShape *polygon = PlainPolygon(fixture))
        kept->polygon = *polygon;
    else if (fixture.GetType() == b2Shape::e_circle)
        kept->circle = *static_cast<b2CircleShape *>(fixture.GetShape());
    else
        return false;
    return true;
}

std::vector<Kept> TakeFixtures(b2Body *body) {
    std::vector<Kept> all;
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;) {
        b2Fixture *const next = fixture->GetNext();
        Kept kept;
        if (Keep(*fixture, &kept)) {
            all.push_back(kept);
            body->DestroyFixture(fixture);
        }
        fixture = next;
    }
    return all;
}

} // namespace

/// Both lose their fixtures and get them again, or each other's, in another order: proxies and addresses are
/// others', and pairs change their A and B.
void Actor::ExchangeFixtures() {
    const int how = Byte();
    b2Body *a = SomeBody();
    b2Body *b = SomeBody();
    if (a == nullptr || a == b)
        return;
    const std::vector<Kept> ofA = TakeFixtures(a), ofB = TakeFixtures(b);
    b2Body *firsts = how % 4 == 3 ? a : b, *seconds = how % 4 == 3 ? b : a;
    for (const Kept &kept : ofB)
        m_world->Create(firsts, kept.def, kept.Shape());
    for (size_t i = 0; i < ofA.size(); ++i)
        m_world->Create(seconds, ofA[i].def, ofA[how % 2 == 0 ? i : ofA.size() - 1 - i].Shape());
}

/// By one like it: as large, larger, nearer.
void Actor::ReplaceFixture() {
    const int how = Byte();
    b2Fixture *fixture = SomeFixture();
    const b2Vec2 by = Vector(0.002f);
    Kept kept;
    if (fixture == nullptr || !Keep(*fixture, &kept))
        return;
    b2Body *body = fixture->GetBody();
    body->DestroyFixture(fixture);
    const float scale = how % 4 == 0 ? 2.5f : 1.0f;
    const b2Vec2 shift = how % 2 == 0 ? b2Vec2(0.0f, 0.0f) : by;
    for (int32 i = 0; i < kept.polygon.m_count; ++i)
        kept.polygon.m_vertices[i] = scale * kept.polygon.m_vertices[i] + shift;
    kept.polygon.m_centroid = scale * kept.polygon.m_centroid + shift;
    kept.circle.m_radius *= scale;
    m_world->Create(body, kept.def, kept.Shape());
}

/// The newest one and another: both go, and one like the other comes, twice.
void Actor::ReplaceBody() {
    const int how = Byte();
    b2Body *body = SomeBody();
    const b2Vec2 by = Vector(0.002f);
    if (body == nullptr || body->GetJointList() != nullptr || !World::IsFinite(*body))
        return;
    b2BodyDef def;
    def.type = body->GetType();
    def.position = body->GetPosition() + (how % 2 == 0 ? b2Vec2(0.0f, 0.0f) : by);
    def.angle = body->GetAngle();
    def.bullet = body->IsBullet();
    def.allowSleep = body->IsSleepingAllowed();
    def.linearVelocity = body->GetLinearVelocity();
    const std::vector<Kept> fixtures = TakeFixtures(body);
    b2Body *newest = Box2D().GetBodyList();
    if (how % 4 == 1 && newest != body && newest->GetJointList() == nullptr)
        Box2D().DestroyBody(newest);
    Box2D().DestroyBody(body);
    for (int copies = how % 4 == 1 ? 2 : 1; copies > 0 && MayGrow(); --copies) {
        b2Body *made = m_world->Create(def);
        for (const Kept &kept : fixtures)
            m_world->Create(made, kept.def, kept.Shape());
    }
}

/// Up to 20 m away, or a little; or back to where shapes say.
void Actor::MoveCentre() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const b2Vec2 center = Vector(how % 3 == 0 ? 0.16f : 0.003f);
    if (body == nullptr)
        return;
    if (how / 3 % 4 == 0) {
        body->ResetMassData();
    } else {
        b2MassData mass;
        mass.mass = b2Max(body->GetMass(), 0.01f);
        mass.center = center;
        mass.I = mass.mass * (b2Dot(center, center) + 1.0f);
        body->SetMassData(&mass);
    }
    if (how / 16 % 2 == 0)
        body->SetAngularVelocity(how / 32 % 2 == 0 ? 25.0f : -0.2f);
}

/// Of the first fixture and of the others: the centre of mass moves.
void Actor::SetDensities() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const float spin = Signed(0.2f);
    if (body == nullptr)
        return;
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        f->SetDensity(f == body->GetFixtureList() ? 50.0f : 1.0f);
    body->ResetMassData();
    if (how % 2 == 0) {
        body->SetFixedRotation(true);
        body->SetFixedRotation(false);
    }
    body->SetAngularVelocity(spin);
}

/// By thousands of rounds.
void Actor::TurnOften() {
    static constexpr float kRounds[] = {100.0f, 1e3f, 1e5f, 1e6f, -3e6f, -700.0f};
    b2Body *body = SomeBody();
    const float rounds = kRounds[Below(6)];
    const float part = 0.5f + Unsigned(1.0f / 512.0f);
    if (body != nullptr)
        body->SetTransform(body->GetPosition(), part * rounds);
}

void Actor::Throw() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const b2Vec2 velocity = Vector(0.7f);
    const float spin = Signed(how % 3 == 0 ? 0.5f : 0.025f);
    if (body == nullptr)
        return;
    if (how % 2 == 0)
        body->SetBullet(how % 8 != 6);
    body->SetLinearVelocity(velocity);
    body->SetAngularVelocity(spin);
}

/// A little to the side, where the next one may be, and turned or not.
void Actor::Carry() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const b2Vec2 by = Vector(how % 2 == 0 ? 0.002f : 0.0005f);
    if (body == nullptr)
        return;
    const bool off = how / 2 % 8 == 0;
    if (off)
        body->SetEnabled(false);
    body->SetTransform(body->GetPosition() + by, body->GetAngle() + (how / 16 % 4 == 0 ? 0.785f : 0.0f));
    if (off)
        body->SetEnabled(true);
    body->SetAwake(true);
}

/// Far away, or of another type, and back or nearly so.
void Actor::ThereAndBack() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const float near = Signed(0.0015f);
    if (body == nullptr)
        return;
    const b2Vec2 from = body->GetPosition();
    if (how % 3 == 0) {
        const b2BodyType was = body->GetType();
        body->SetType(was == b2_staticBody ? b2_dynamicBody : b2_staticBody);
        body->SetType(was);
    } else {
        body->SetTransform(from + b2Vec2(0.0f, how % 3 == 1 ? 900.0f : 3.0f), body->GetAngle());
    }
    body->SetTransform(from + b2Vec2(near, 0.0f), body->GetAngle());
}

/// Of a contact, or of all of a body's.
void Actor::DisableContacts() {
    const int how = Byte();
    b2Contact *contact = SomeContact();
    if (contact == nullptr)
        return;
    m_world->Disable(contact);
    if (how % 2 == 0)
        for (b2ContactEdge *edge = contact->GetFixtureA()->GetBody()->GetContactList(); edge != nullptr;
             edge = edge->next)
            m_world->Disable(edge->contact);
}

/// Of all fixtures: nothing collides with them, or all does.
void Actor::MaskBody() {
    b2Body *body = SomeBody();
    const int how = Byte();
    if (body == nullptr)
        return;
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
        b2Filter filter = fixture->GetFilterData();
        filter.maskBits = how % 2 == 0 ? 0 : 0xffff;
        fixture->SetFilterData(filter);
    }
}

/// The two of a contact, so that they no longer collide; or what joins them goes.
void Actor::JoinContact() {
    const int how = Byte();
    b2Contact *contact = SomeContact();
    if (contact == nullptr)
        return;
    b2Body *a = contact->GetFixtureA()->GetBody(), *b = contact->GetFixtureB()->GetBody();
    if (how % 3 == 0) {
        DestroyGears();
        if (a->GetJointList() != nullptr)
            Box2D().DestroyJoint(a->GetJointList()->joint);
        return;
    }
    if (Box2D().GetJointCount() >= m_mostJoints ||
        b2DistanceSquared(a->GetPosition(), b->GetPosition()) < 1e-4f)
        return;
    b2DistanceJointDef def;
    def.Initialize(a, b, a->GetPosition(), b->GetPosition());
    def.collideConnected = how % 3 == 1 && how / 3 % 4 == 0;
    m_world->Create(def);
}

} // namespace actor
