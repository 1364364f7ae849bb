// SPDX-License-Identifier: MIT
#include "passes/stoppers.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "start/current_step.h"

namespace bmr {

bool Stops(const b2Body *body) {
    return body->IsBullet() || body->GetType() != b2_dynamicBody;
}

/// (New contacts come at the head of the list.)
bool Stoppers::AreKnown() const {
    return m_known && m_world->GetContactManager().m_contactList == m_newest;
}

void Stoppers::Begin() {
    const b2ContactManager &manager = m_world->GetContactManager();
    m_known = true;
    m_room->Reserve(static_cast<uint32_t>(manager.m_contactCount));
    m_hasDigest = false;
    m_count = 0;
    m_contactCount = manager.m_contactCount;
    m_newest = manager.m_contactList;
    m_step = LatestStep();
}

void Stoppers::BeforeGame() {
    if (m_known && !m_hasDigest)
        m_digest = Digest();
    m_hasDigest = true;
}

void Stoppers::AfterGame() {
    const b2ContactManager &manager = m_world->GetContactManager();
    m_known = m_known && m_world->IsLocked() && LatestStep() == m_step &&
              manager.m_contactCount == m_contactCount && Digest() == m_digest;
}

/// Who is a bullet, and which fixtures are sensors. Two different answers have the same digest with a
/// probability of 2^-64.
uint64_t Stoppers::Digest() const {
    uint64_t digest = 1;
    const auto add = [&digest](bool is) {
        digest = (digest ^ (is ? 1 : 2)) * 0x9e3779b97f4a7c15u;
        digest ^= digest >> 32;
    };
    for (const b2Body *body = m_world->GetBodyList(); body != nullptr; body = body->GetNext()) {
        add(body->IsBullet());
        for (const b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
            add(fixture->IsSensor());
    }
    return digest;
}

} // namespace bmr
