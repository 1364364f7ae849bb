// SPDX-License-Identifier: MIT
// What filters do, and what a listener does that steps its own world.
#include "world.h"

namespace actor {

b2Body *CreateBox(World &world, b2Vec2 at, float angle, b2BodyType type) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.angle = angle;
    b2Body *body = world.Create(def);
    b2PolygonShape box;
    box.SetAsBox(0.2f, 0.1f);
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    world.Create(body, fixture, box);
    return body;
}

void Edit(b2Fixture *fixture, uint32_t mixed) {
    b2PolygonShape *polygon = PlainPolygon(*fixture);
    if (polygon == nullptr)
        return;
    if (mixed % 4 == 0)
        polygon->m_radius = static_cast<float>(1 + mixed / 4 % 5) * b2_polygonRadius;
    else if (mixed % 4 == 1)
        for (int32 i = 0; i < polygon->m_count; ++i) // beyond, there is what the memory held before
            polygon->m_vertices[i] *= 0.9375f;
    else
        ScaleInPlace(polygon, 0.8f);
}

void SetFilterData(b2Fixture *fixture, uint32_t mixed) {
    b2Filter filter = fixture->GetFilterData();
    filter.maskBits = mixed % 3 == 0 ? 0x0001 : 0xffff;
    filter.categoryBits = mixed % 2 == 0 ? 0x0002 : 0x0001;
    filter.groupIndex = static_cast<int16>(mixed % 7 / 3) - 1;
    fixture->SetFilterData(filter);
}

void ThrowBody(b2Body *body, uint32_t mixed) {
    body->SetLinearVelocity(
        {static_cast<float>(mixed % 181) - 90.0f, static_cast<float>(mixed / 181 % 121) - 60.0f});
    body->SetAngularVelocity(0.25f * (static_cast<float>(mixed % 73) - 36.0f));
}

/// What a filter can do without a contact.
void World::ReactAsFilter(b2Fixture *a, b2Fixture *b) {
    const uint32_t mixed = Mix(*a, *b, kFilter);
    b2Body *third = SomeBody(mixed / 8);
    switch (mixed % 32) {
    case 0:
        ChangeHandsForNow(mixed / 32);
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

/// The rest; false: the pair is refused, this time.
bool World::ReactAsWildFilter(b2Fixture *a, b2Fixture *b) {
    if (m_reacting)
        return true;
    m_reacting = true;
    const uint32_t mixed = Mix(*a, *b, kFilter) / 7;
    b2Body *third = SomeBody(mixed / 64);
    MayThrow(kFilter);
    switch (mixed % 24) {
    case 0:
        if (other != nullptr && !other->m_world.IsLocked())
            other->Step(1.0f / 60.0f, 4, 2);
        break;
    case 1:
        if (third->GetFixtureList() != nullptr)
            Edit(third->GetFixtureList(), mixed / 64);
        break;
    case 2:
        SetFilterData(b, mixed / 64);
        break;
    case 3:
        third->SetBullet(true);
        ThrowBody(third, mixed / 64);
        break;
    case 4:
        third->SetAwake(mixed / 64 % 2 == 0);
        break;
    case 5:
        if (!m_world.IsLocked() && third != a->GetBody() && third != b->GetBody())
            third->SetTransform(third->GetPosition() + b2Vec2(0.2f, 0.1f), third->GetAngle());
        break;
    case 6:
        m_world.SetContinuousPhysics(mixed / 64 % 4 != 0);
        break;
    case 7:
        third->SetGravityScale(static_cast<float>(mixed / 64 % 3));
        break;
    case 8:
        if (third->GetFixtureList() != nullptr)
            third->GetFixtureList()->Refilter();
        break;
    default:
        break;
    }
    m_reacting = false;
    return mixed / 32 % 9 != 0;
}

void World::StepInItself(const Moment &moment) {
    if (m_inItself || m_inImpacts || (moment.occasion != kPreSolve && moment.occasion != kBegin))
        return;
    m_inItself = true;
    const float timeStep = moment.mixed / 64 % 3 == 0 ? 1.0f / 240.0f : 0.0f;
    m_world.Step(timeStep, 1, 1);
    NoteStepped(timeStep);
    uint32_t mixed = moment.mixed;
    for (uint32_t changes = mixed / 256 % 6; changes > 0 && !m_world.IsLocked(); --changes) {
        mixed = mixed * 2654435761u + 1u;
        ChangeUnlocked(moment, mixed >> 8);
    }
    m_inItself = false;
    RememberPlaces();
}

/// Of bodies that are not those of the contact that Box2D is at.
void World::ChangeUnlocked(const Moment &moment, uint32_t mixed) {
    b2Body *body = SomeBody(mixed / 8);
    if (body == moment.contact->GetFixtureA()->GetBody() ||
        body == moment.contact->GetFixtureB()->GetBody() || body->GetJointList() != nullptr)
        return;
    const float part = static_cast<float>(mixed / 64 % 17) / 8.0f - 1.0f;
    switch (mixed % 8) {
    case 0:
    case 1:
        body->SetTransform(body->GetPosition() + b2Vec2(0.4f * part, 0.4f - 0.4f * part * part),
                           body->GetAngle() + (mixed / 64 % 2 == 0 ? b2_pi : part));
        break;
    case 2:
        body->SetTransform(body->GetPosition(), body->GetAngle() + b2_pi);
        ThrowBody(body, mixed / 64);
        break;
    case 3:
        m_world.DestroyBody(body);
        break;
    case 4:
        body->SetType(body->GetType() == b2_dynamicBody ? b2_staticBody : b2_dynamicBody);
        break;
    case 5:
        m_world.ShiftOrigin({0.5f * part, 0.0f});
        break;
    case 6:
        body->SetEnabled(!body->IsEnabled());
        break;
    default:
        if (m_world.GetBodyCount() < 300)
            CreateBox(*this, body->GetPosition() + b2Vec2(part, 0.3f), part, b2_dynamicBody)->SetBullet(true);
    }
}

} // namespace actor
