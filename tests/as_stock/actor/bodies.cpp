// SPDX-License-Identifier: MIT
// Bodies: born, moved, changed, dead.
#include <cfloat>
#include <cmath>

#include "actor.h"

namespace actor {

namespace {

/// `steps` units in the last place away.
float Neighbour(float value, int steps) {
    for (; steps != 0; steps += steps < 0 ? 1 : -1)
        value = std::nextafter(value, steps < 0 ? -FLT_MAX : FLT_MAX);
    return value;
}

/// The box around a body's fixtures (their first children) at this pose, and the radius of the first.
b2AABB BoxOf(const b2Body &body, const b2Transform &pose, float *radius) {
    b2AABB box = {pose.p, pose.p};
    *radius = 0.0f;
    bool first = true;
    for (const b2Fixture *fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
        b2AABB one;
        fixture->GetShape()->ComputeAABB(&one, pose, 0);
        if (first) {
            box = one;
            *radius = fixture->GetShape()->m_radius;
        } else {
            box.Combine(one);
        }
        first = false;
    }
    return box;
}

} // namespace

void Actor::CreateBody() {
    static constexpr b2BodyType kTypes[] = {b2_dynamicBody, b2_dynamicBody, b2_dynamicBody, b2_dynamicBody,
                                            b2_dynamicBody, b2_dynamicBody, b2_staticBody,  b2_kinematicBody};
    const int how = Byte();
    b2BodyDef def;
    def.type = kTypes[how % 8];
    def.bullet = (how & 8) != 0;
    def.fixedRotation = how / 16 == 7;
    def.allowSleep = how / 16 != 6;
    def.position = Place();
    def.angle = Angle();
    if ((how & 16) != 0)
        def.linearVelocity = Velocity();
    if ((how & 32) != 0)
        def.angularVelocity = Signed(0.1f);
    if (!MayGrow())
        return;
    b2Body *body = m_world->Create(def);
    for (int parts = how / 64 == 3 ? 2 + Below(6) : 1; parts > 0; --parts)
        AddFixture(body);
}

void Actor::CreateBeside() {
    b2Body *fixed = SomeBody();
    if (fixed == nullptr || !MayGrow())
        return;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = fixed->GetPosition();
    b2Body *body = m_world->Create(def);
    AddFixture(body);
    PlaceBeside(fixed, body);
}

void Actor::PutBeside() {
    b2Body *fixed = SomeBody();
    b2Body *moved = SomeBody();
    if (fixed != nullptr && moved != fixed)
        PlaceBeside(fixed, moved);
}

/// So that the two are as far apart as something hangs on, give or take some units in the last place.
b2Body *Actor::PlaceBeside(b2Body *fixed, b2Body *moved) {
    static constexpr float kGaps[] = {0.0f,
                                      b2_linearSlop,
                                      2.0f * b2_polygonRadius,
                                      2.8284271f * b2_polygonRadius,
                                      1.25f * b2_linearSlop,
                                      0.75f * b2_linearSlop,
                                      2.0f * b2_polygonRadius - b2_linearSlop,
                                      2.0f * b2_polygonRadius - 3.0f * b2_linearSlop,
                                      2.0f * b2_aabbExtension,
                                      -b2_linearSlop,
                                      -0.1f,
                                      0.03f,
                                      1.0f,
                                      b2_polygonRadius,
                                      0.021f,
                                      0.2f};
    const int how = Byte();
    const float gap = kGaps[how % 16];
    const int ulps = static_cast<int8_t>(Byte());
    const float sideways = Signed(0.01f);
    const float turn = Angle();
    const float tilt = how / 32 == 0 ? 0.0f : Signed(1e-4f);
    b2Transform upright;
    upright.Set(fixed->GetPosition(), 0.0f);
    float radiusA = 0.0f, radiusB = 0.0f;
    const b2AABB boxA = BoxOf(*fixed, upright, &radiusA), boxB = BoxOf(*moved, upright, &radiusB);
    const bool above = (how & 16) != 0;
    b2Vec2 offset = above ? b2Vec2(sideways, boxA.upperBound.y - boxB.lowerBound.y + gap - radiusA - radiusB)
                          : b2Vec2(boxA.upperBound.x - boxB.lowerBound.x + gap - radiusA - radiusB, sideways);
    // Both are turned as one, often not at all.
    const float angle = fixed->GetType() == b2_dynamicBody ? turn : 0.0f;
    offset = b2Mul(b2Rot(angle), offset);
    b2Vec2 place = fixed->GetPosition() + offset;
    place = {Neighbour(place.x, ulps), Neighbour(place.y, ulps)};
    fixed->SetTransform(fixed->GetPosition(), angle);
    moved->SetTransform(place, angle + tilt);
    return moved;
}

void Actor::AddFixtureToSome() {
    if (b2Body *body = SomeBody())
        AddFixture(body);
}

void Actor::DestroyFixture() {
    if (b2Fixture *fixture = SomeFixture())
        fixture->GetBody()->DestroyFixture(fixture);
}

void Actor::DestroyBody() {
    b2Body *body = SomeBody();
    if (body == nullptr)
        return;
    if (body->GetJointList() != nullptr)
        DestroyGears();
    Box2D().DestroyBody(body);
}

void Actor::Teleport() {
    b2Body *body = SomeBody();
    const b2Vec2 place = Place();
    const float angle = Angle();
    if (body != nullptr)
        body->SetTransform(place, angle);
}

void Actor::NudgePose() {
    b2Body *body = SomeBody();
    const int x = static_cast<int8_t>(Byte()) / 8;
    const int y = static_cast<int8_t>(Byte()) / 8;
    const int turn = static_cast<int8_t>(Byte()) / 8;
    if (body != nullptr)
        body->SetTransform({Neighbour(body->GetPosition().x, x), Neighbour(body->GetPosition().y, y)},
                           Neighbour(body->GetAngle(), turn));
}

void Actor::SwapPoses() {
    b2Body *a = SomeBody();
    b2Body *b = SomeBody();
    if (a == nullptr)
        return;
    const b2Vec2 place = a->GetPosition();
    const float angle = a->GetAngle();
    a->SetTransform(b->GetPosition(), b->GetAngle());
    b->SetTransform(place, angle);
}

/// One upon the other.
void Actor::CopyPose() {
    b2Body *a = SomeBody();
    b2Body *b = SomeBody();
    const b2Vec2 beside = Vector(0.001f);
    if (a != nullptr)
        a->SetTransform(b->GetPosition() + beside, b->GetAngle());
}

void Actor::SetType() {
    b2Body *body = SomeBody();
    const int type = Below(4);
    if (body != nullptr)
        body->SetType(static_cast<b2BodyType>(type == 3 ? b2_dynamicBody : type));
}

void Actor::SetEnabled() {
    if (b2Body *body = SomeBody())
        body->SetEnabled(!body->IsEnabled());
}

void Actor::SetAwake() {
    if (b2Body *body = SomeBody())
        body->SetAwake(!body->IsAwake());
}

void Actor::SetBullet() {
    if (b2Body *body = SomeBody())
        body->SetBullet(!body->IsBullet());
}

void Actor::SetVelocity() {
    b2Body *body = SomeBody();
    const b2Vec2 velocity = Velocity();
    const float spin = Signed(0.2f);
    if (body == nullptr)
        return;
    body->SetLinearVelocity(velocity);
    body->SetAngularVelocity(spin);
}

void Actor::SetExtremeVelocity() {
    static constexpr float kScales[] = {1.0f, 10.0f, 100.0f, 1e4f, 1e8f, 1e15f, 1e-20f, 1e-38f};
    b2Body *body = SomeBody();
    const int how = Byte();
    const b2Vec2 velocity = Vector(kScales[how % 8]);
    if (body == nullptr)
        return;
    body->SetLinearVelocity(velocity);
    if (how / 8 % 2 != 0)
        body->SetAngularVelocity(kScales[how / 16 % 8]);
}

/// Where numbers are none, or in no time. Box2D's search for impacts asserts there: it is off until PutBack.
void Actor::SendNowhere() {
    b2Body *body = SomeBody();
    const int how = Byte();
    if (body == nullptr)
        return;
    static constexpr float kNone[] = {NAN, INFINITY, -INFINITY, FLT_MAX};
    const float none = kNone[how / 8 % 4];
    const b2Vec2 at = body->GetPosition();
    Box2D().SetContinuousPhysics(false);
    m_world->mayBeNowhere = true;
    switch (how % 8) {
    case 0:
    case 1:
        body->SetTransform({none, at.y}, body->GetAngle());
        break;
    case 2:
        body->SetTransform({at.x, none}, 0.5f);
        break;
    case 3:
        body->SetTransform({none, none}, 0.0f);
        break;
    case 4:
        body->SetTransform(at, none);
        break;
    case 5:
        body->SetLinearVelocity({0.0f, none});
        break;
    case 6:
        body->SetAngularVelocity(none);
        break;
    default:
        body->ApplyForceToCenter({none, 0.0f}, true);
    }
}

void Actor::PutBack() {
    const int how = Byte();
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (World::IsFinite(*body))
            continue;
        const auto number = static_cast<float>(testbed::NumberOf(*body) % 16);
        body->SetTransform(m_origin + 0.25f * b2Vec2(number - 8.0f, number), number);
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAngularVelocity(0.0f);
    }
    if (how % 2 == 0)
        Box2D().SetContinuousPhysics(true);
}

void Actor::Push() {
    b2Body *body = SomeBody();
    const int how = Byte();
    const b2Vec2 impulse = Vector(how / 4 % 4 == 0 ? 10.0f : 0.05f);
    const b2Vec2 arm = Vector(0.01f);
    if (body == nullptr)
        return;
    if (how % 4 == 0)
        body->ApplyForce(60.0f * impulse, body->GetPosition() + arm, how / 16 % 2 == 0);
    else if (how % 4 == 1)
        body->ApplyTorque(impulse.x, how / 16 % 2 == 0);
    else
        body->ApplyLinearImpulse(impulse, body->GetPosition() + arm, how / 16 % 2 == 0);
}

void Actor::SetFreedoms() {
    b2Body *body = SomeBody();
    const int how = Byte();
    if (body == nullptr)
        return;
    switch (how % 5) {
    case 0:
        body->SetFixedRotation(!body->IsFixedRotation());
        break;
    case 1:
        body->SetSleepingAllowed(!body->IsSleepingAllowed());
        break;
    case 2:
        body->SetGravityScale(static_cast<float>(how / 5 % 8) - 2.0f);
        break;
    case 3:
        body->SetLinearDamping(static_cast<float>(how / 5 % 8));
        break;
    default:
        body->SetAngularDamping(static_cast<float>(how / 5 % 8));
    }
}

void Actor::SetMass() {
    b2Body *body = SomeBody();
    const int how = Byte();
    if (body == nullptr)
        return;
    if (how % 2 == 0) {
        body->ResetMassData();
        return;
    }
    b2MassData mass;
    mass.mass = 0.1f + static_cast<float>(how / 2);
    mass.center = Vector(0.005f);
    mass.I = mass.mass * (b2Dot(mass.center, mass.center) + Size());
    body->SetMassData(&mass);
}

void Actor::SetFilter() {
    b2Fixture *fixture = SomeFixture();
    const int how = Byte();
    b2Filter filter;
    filter.maskBits = (how & 1) != 0 ? 0xffff : 0x0001;
    filter.categoryBits = (how & 6) != 0 ? 0x0001 : 0x0002;
    filter.groupIndex = static_cast<int16>(how / 8 % 7 - 3);
    if (fixture != nullptr && how / 64 == 0)
        fixture->Refilter();
    else if (fixture != nullptr)
        fixture->SetFilterData(filter);
}

void Actor::SetMaterial() {
    b2Fixture *fixture = SomeFixture();
    const int how = Byte();
    if (fixture == nullptr)
        return;
    const float amount = static_cast<float>(how / 4) / 32.0f;
    if (how % 4 == 0) {
        fixture->SetFriction(amount);
    } else if (how % 4 == 1) {
        fixture->SetRestitution(amount);
        fixture->SetRestitutionThreshold(2.0f * amount);
    } else {
        fixture->SetDensity(10.0f * amount);
        if (how % 4 == 2)
            fixture->GetBody()->ResetMassData();
    }
}

/// What touches a sensor that turns solid must be looked at before it is solved, or Box2D asserts.
void Actor::SetSensor() {
    b2Fixture *fixture = SomeFixture();
    const int how = Byte();
    if (fixture == nullptr)
        return;
    fixture->SetSensor(!fixture->IsSensor());
    if (how % 8 == 7)
        return;
    b2Body *body = fixture->GetBody();
    for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        edge->other->SetAwake(true);
    body->SetAwake(true);
}

} // namespace actor
