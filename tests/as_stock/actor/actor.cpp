// SPDX-License-Identifier: MIT
#include "actor.h"

#include <cfloat>
#include <cmath>

namespace actor {

#define ROW(name, bytes) {#name, bytes, &Actor::name},
const Actor::Row Actor::kActions[] = {ACTOR_ACTIONS(ROW, ROW)};
#undef ROW
const int Actor::kActionCount = sizeof kActions / sizeof *kActions;

Actor::Actor(const uint8_t *data, size_t size)
    : m_data(data), m_size(size), m_anySize(AsksForAnySize(data, size)) {
    // Near the origin, about where certificates are no longer trusted, and beyond.
    static constexpr float kFar[] = {0.0f, 0.0f, 0.0f, 60.0f, 505.0f, 1000.0f, 10000.0f, 100000.0f};
    static constexpr float kSpreads[] = {0.015625f, 0.0625f, 0.25f, 1.0f};
    const uint8_t flags = Byte();
    const uint8_t where = Byte();
    m_origin = {kFar[where % 8], (where & 8) != 0 ? kFar[where % 8] : 0.0f};
    m_spread = kSpreads[where / 64];
    for (std::optional<World> &world : m_worlds)
        world.emplace((flags & 2) != 0 ? b2Vec2(0.0f, 0.0f) : b2Vec2(0.0f, -10.0f));
    for (int i = 0; i < 2; ++i)
        m_worlds[i]->other = &*m_worlds[1 - i];
    m_world = &*m_worlds[0];
    Box2D().SetSubStepping((flags & 4) != 0);
    if ((flags & 64) != 0) {
        m_largest = 2.0f; // what all others touch takes seconds
        m_mostBodies = 320;
        m_mostFixtures = 200;
        m_mostJoints = 40;
        m_mostActions = 2000;
        m_mostRecords = 160;
    }
    if ((flags & 8) != 0)
        BuildBin();
}

/// Where what is created stays together.
void Actor::BuildBin() {
    constexpr float kHalfWidth = 2.5f, kHalfHeight = 2.5f, kWall = 0.3f;
    b2BodyDef def;
    def.position = m_origin;
    b2Body *bin = m_world->Create(def);
    b2PolygonShape wall;
    wall.SetAsBox(kHalfWidth, kWall, {0.0f, -kHalfHeight}, 0.0f);
    m_world->Create(bin, b2FixtureDef(), wall);
    for (const float side : {-1.0f, 1.0f}) {
        wall.SetAsBox(kWall, kHalfHeight, {side * kHalfWidth, 0.0f}, side * 0.1f);
        m_world->Create(bin, b2FixtureDef(), wall);
    }
}

b2Vec2 Actor::Vector(float scale) {
    const float x = Signed(scale);
    const float y = Signed(scale);
    return {x, y};
}

b2Vec2 Actor::Place() {
    return m_origin + Vector(m_spread);
}

float Actor::Angle() {
    static constexpr float kAngles[] = {0.0f,     0.0f,   0.5f * b2_pi, 0.25f * b2_pi, b2_pi,   1e-4f,
                                        1e-7f,    -1e-3f, 700.0f,       -1e4f,         1e6f,    -0.5f * b2_pi,
                                        3.14159f, 1e-20f, 0.1f,         -3.0f * b2_pi, 499.99f, 500.01f};
    constexpr int kCount = sizeof kAngles / sizeof *kAngles;
    const int byte = Byte();
    return byte < 4 * kCount ? kAngles[byte % kCount] : static_cast<float>(byte - 160) * (b2_pi / 96.0f);
}

float Actor::Size() {
    static constexpr float kSizes[] = {0.5f, 1.0f,  0.25f, 0.1f, 2.0f, 0.05f,  0.3f,  0.7f,
                                       1.5f, 0.02f, 4.0f,  0.4f, 0.2f, 100.0f, 0.01f, 1000.0f};
    const int byte = Byte();
    const float size = kSizes[byte % 16] * (1.0f + static_cast<float>(byte / 16) / 16.0f);
    return b2Min(size, m_largest);
}

b2Vec2 Actor::Velocity() {
    static constexpr float kScales[] = {0.02f, 0.1f, 0.5f, 2.0f};
    const float scale = kScales[Below(4)];
    return Vector(scale);
}

b2Body *Actor::SomeBody() {
    const int byte = Byte();
    if (Box2D().GetBodyCount() == 0)
        return nullptr;
    b2Body *body = Box2D().GetBodyList();
    for (int skip = byte % Box2D().GetBodyCount(); skip > 0; --skip)
        body = body->GetNext();
    return body;
}

b2Fixture *Actor::SomeFixtureOf(b2Body *body) {
    int count = 0;
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
        ++count;
    if (count == 0)
        return nullptr;
    b2Fixture *fixture = body->GetFixtureList();
    for (int skip = count == 1 ? 0 : Below(count); skip > 0; --skip)
        fixture = fixture->GetNext();
    return fixture;
}

b2Fixture *Actor::SomeFixture() {
    b2Body *body = SomeBody();
    return body != nullptr ? SomeFixtureOf(body) : nullptr;
}

b2Joint *Actor::SomeJoint() {
    const int byte = Byte();
    if (Box2D().GetJointCount() == 0)
        return nullptr;
    b2Joint *joint = Box2D().GetJointList();
    for (int skip = byte % Box2D().GetJointCount(); skip > 0; --skip)
        joint = joint->GetNext();
    return joint;
}

b2Contact *Actor::SomeContact() {
    const int byte = Byte();
    if (Box2D().GetContactCount() == 0)
        return nullptr;
    b2Contact *contact = Box2D().GetContactList();
    for (int skip = byte % Box2D().GetContactCount(); skip > 0; --skip)
        contact = contact->GetNext();
    return contact;
}

bool Actor::PlayOn(Record *record) {
    if (m_hasEnded)
        return false;
    while (m_stepsLeft == 0) {
        if (m_at >= m_size || m_actions >= m_mostActions || m_records >= m_mostRecords)
            return End(record);
        m_code = Byte();
        if (m_code >= kFirstStep) {
            m_stepsLeft = m_code % 4 + 1;
        } else if (m_code < kActionCount) {
            ++m_actions;
            (this->*kActions[m_code].act)();
        }
    }
    if (m_records >= m_mostRecords)
        return End(record);
    --m_stepsLeft;
    if (m_records == perturbAt)
        Perturb();
    m_world->Step(m_timeStep, m_velocityIterations, m_positionIterations);
    if ((m_code & 4) != 0)
        m_world->other->Step(m_timeStep, m_velocityIterations, m_positionIterations);
    m_isFinite = m_worlds[0]->IsFinite() && m_worlds[1]->IsFinite();
    m_hasEnded = !m_isFinite || m_worlds[0]->hasThrown || m_worlds[1]->hasThrown;
    if (!m_hasEnded)
        Tell(record);
    return !m_hasEnded;
}

/// One record after all.
bool Actor::End(Record *record) {
    if (m_hasEnded)
        return false;
    m_hasEnded = true;
    Tell(record);
    return true;
}

void Actor::Tell(Record *record) {
    *record = {};
    for (std::optional<World> &world : m_worlds) {
        const testbed::StateHashes hashes = world->Hashes();
        record->bodies = 3 * record->bodies + hashes.bodies;
        record->contacts = 3 * record->contacts + hashes.contacts;
        record->events = 3 * record->events + hashes.events;
        record->probes = 3 * record->probes + world->Probes().Value();
        if (m_records == dumpAt)
            dump += "world\n" + world->Describe();
        world->StartRecord(m_records + 1 == dumpAt);
    }
    ++m_records;
}

/// The control: so little must be seen.
void Actor::Perturb() {
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody && body->IsAwake() && body->IsEnabled()) {
            const b2Vec2 v = body->GetLinearVelocity();
            body->SetLinearVelocity({std::nextafter(v.x, FLT_MAX), v.y});
            return;
        }
}

} // namespace actor
