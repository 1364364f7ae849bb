// SPDX-License-Identifier: MIT
#include "script.h"

#include <cfloat>
#include <cmath>
#include <cstdio>

namespace fuzz {

const Script::Action Script::kActions[] = {
    &Script::CreateBody,         &Script::CreateBody,
    &Script::CreateBody,         &Script::CreateBeside,
    &Script::CreateBeside,       &Script::AddFixtureToSome,
    &Script::DestroyFixture,     &Script::DestroyBody,
    &Script::Teleport,           &Script::NudgePose,
    &Script::SwapPoses,          &Script::CopyPose,
    &Script::PutBeside,          &Script::SetType,
    &Script::SetEnabled,         &Script::SetAwake,
    &Script::SetBullet,          &Script::SetVelocity,
    &Script::SetExtremeVelocity, &Script::Push,
    &Script::SetFreedoms,        &Script::SetMass,
    &Script::SetFilter,          &Script::SetMaterial,
    &Script::SetSensor,          &Script::ResizeInPlace,
    &Script::NudgeShapeInPlace,  &Script::ChangeRadiusInPlace,
    &Script::ChangeRoundInPlace, &Script::CreateJoint,
    &Script::DestroyJoint,       &Script::ChangeJoint,
    &Script::ShiftOrigin,        &Script::SetGravity,
    &Script::SetTimeStep,        &Script::SetIterations,
    &Script::SetSolver,          &Script::SetReactions,
    &Script::SetRefusals,        &Script::AskWorld,
    &Script::ProbeContact,       &Script::ProbeFixtures,
    &Script::SwitchWorld,        &Script::RecreateWorld,
    &Script::MoveElsewhere,      &Script::WakeAll,
    &Script::LookAround,
};
const int Script::kActionCount = sizeof kActions / sizeof *kActions;
const Script::Action Script::kLaterActions[] = {&Script::EmptyWorld, &Script::Crowd, &Script::ChangeHands};
const int Script::kLaterActionCount = sizeof kLaterActions / sizeof *kLaterActions;

Script::Script(const RunRequest &request)
    : m_bytes(fuzz_bytes_make(request.data, request.size)), m_request(request) {
    // Near the origin, about where certificates are no longer trusted, and beyond.
    static constexpr float kFar[] = {0.0f, 0.0f, 0.0f, 60.0f, 505.0f, 1000.0f, 10000.0f, 100000.0f};
    static constexpr float kSpreads[] = {0.015625f, 0.0625f, 0.25f, 1.0f};
    const uint8_t flags = Byte();
    m_anySize = AsksForAnySize(request.data, request.size);
    const uint8_t where = Byte();
    m_origin = {kFar[where % 8], (where & 8) != 0 ? kFar[where % 8] : 0.0f};
    m_spread = kSpreads[where / 64];
    for (std::optional<World> &world : m_worlds)
        world.emplace((flags & 2) != 0 ? b2Vec2(0.0f, 0.0f) : b2Vec2(0.0f, -10.0f));
    for (int i = 0; i < 2; ++i)
        m_worlds[i]->other = &*m_worlds[1 - i];
    m_world = &*m_worlds[0];
    Box2D().SetSubStepping((flags & 4) != 0);
    if ((flags & 8) != 0)
        BuildBin();
}

/// Where what is created stays together.
void Script::BuildBin() {
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

b2Vec2 Script::Vector(float scale) {
    const float x = Signed(scale);
    const float y = Signed(scale);
    return {x, y};
}

b2Vec2 Script::Place() {
    return m_origin + Vector(m_spread);
}

float Script::Angle() {
    static constexpr float kAngles[] = {0.0f,     0.0f,   0.5f * b2_pi, 0.25f * b2_pi, b2_pi,   1e-4f,
                                        1e-7f,    -1e-3f, 700.0f,       -1e4f,         1e6f,    -0.5f * b2_pi,
                                        3.14159f, 1e-20f, 0.1f,         -3.0f * b2_pi, 499.99f, 500.01f};
    constexpr int kCount = sizeof kAngles / sizeof *kAngles;
    const int byte = Byte();
    return byte < 4 * kCount ? kAngles[byte % kCount] : static_cast<float>(byte - 160) * (b2_pi / 96.0f);
}

float Script::Size() {
    static constexpr float kSizes[] = {0.5f, 1.0f,  0.25f, 0.1f, 2.0f, 0.05f,  0.3f,  0.7f,
                                       1.5f, 0.02f, 4.0f,  0.4f, 0.2f, 100.0f, 0.01f, 1000.0f};
    const int byte = Byte();
    return kSizes[byte % 16] * (1.0f + static_cast<float>(byte / 16) / 16.0f);
}

b2Vec2 Script::Velocity() {
    static constexpr float kScales[] = {0.02f, 0.1f, 0.5f, 2.0f};
    const float scale = kScales[Below(4)];
    return Vector(scale);
}

b2Body *Script::SomeBody() {
    const int byte = Byte();
    if (Box2D().GetBodyCount() == 0)
        return nullptr;
    b2Body *body = Box2D().GetBodyList();
    for (int skip = byte % Box2D().GetBodyCount(); skip > 0; --skip)
        body = body->GetNext();
    return body;
}

b2Fixture *Script::SomeFixtureOf(b2Body *body) {
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

b2Fixture *Script::SomeFixture() {
    b2Body *body = SomeBody();
    return body != nullptr ? SomeFixtureOf(body) : nullptr;
}

b2Joint *Script::SomeJoint() {
    const int byte = Byte();
    if (Box2D().GetJointCount() == 0)
        return nullptr;
    b2Joint *joint = Box2D().GetJointList();
    for (int skip = byte % Box2D().GetJointCount(); skip > 0; --skip)
        joint = joint->GetNext();
    return joint;
}

b2Contact *Script::SomeContact() {
    const int byte = Byte();
    if (Box2D().GetContactCount() == 0)
        return nullptr;
    b2Contact *contact = Box2D().GetContactList();
    for (int skip = byte % Box2D().GetContactCount(); skip > 0; --skip)
        contact = contact->GetNext();
    return contact;
}

Script::Action Script::ActionOf(uint8_t code) const {
    const int later = code - (kFirstStep - kLaterActionCount);
    return later >= 0 ? kLaterActions[later] : kActions[code % kActionCount];
}

RunResult Script::Run() {
    int actions = 0;
    while (!fuzz_done(&m_bytes) && actions < kMostActions && m_result.records < kMostRecords - 1) {
        // Not one action more: it may be what Box2D does not allow.
        if (m_result.records == m_request.mostRecords) {
            m_result.ending = Ending::Enough;
            return m_result;
        }
        const uint8_t code = Byte();
        if (code >= kFirstStep) {
            if (!Step(code))
                return m_result;
        } else {
            ++actions;
            (this->*ActionOf(code))();
        }
    }
    m_result.ending = Ending::Done;
    Record();
    return m_result;
}

bool Script::Step(uint8_t code) {
    for (int steps = code % 4; steps >= 0 && m_result.records < kMostRecords - 1; --steps) {
        if (m_result.records == m_request.mostRecords) {
            m_result.ending = Ending::Enough;
            return false;
        }
        if (m_result.records == m_request.perturbAt)
            Perturb();
        m_world->Step(m_timeStep, m_velocityIterations, m_positionIterations);
        if ((code & 4) != 0)
            m_world->other->Step(m_timeStep, m_velocityIterations, m_positionIterations);
        if (!m_worlds[0]->IsFinite() || !m_worlds[1]->IsFinite()) {
            m_result.ending = Ending::NotFinite;
            return false;
        }
        if (!Record())
            return false;
    }
    return true;
}

bool Script::Record() {
    if (m_result.records == m_request.mostRecords) {
        m_result.ending = Ending::Enough;
        return false;
    }
    fuzz::Record record = {};
    const bool dump = m_result.records == m_request.dumpAt;
    for (std::optional<World> &world : m_worlds) {
        const testbed::StateHashes hashes = world->Hashes();
        record.bodies = 3 * record.bodies + hashes.bodies;
        record.contacts = 3 * record.contacts + hashes.contacts;
        record.events = 3 * record.events + hashes.events;
        record.probes = 3 * record.probes + world->Probes().Value();
        if (dump)
            std::fprintf(stderr, "world\n%s", world->Describe().c_str());
        world->StartRecord(m_result.records + 1 == m_request.dumpAt);
    }
    m_request.records[m_result.records++] = record;
    return true;
}

/// The control: so little must be seen.
void Script::Perturb() {
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody && body->IsAwake() && body->IsEnabled()) {
            const b2Vec2 v = body->GetLinearVelocity();
            body->SetLinearVelocity({std::nextafter(v.x, FLT_MAX), v.y});
            return;
        }
}

} // namespace fuzz
