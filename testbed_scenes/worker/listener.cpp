// SPDX-License-Identifier: MIT
#include "worker/listener.h"

namespace testbed {
namespace {

/// A number for a contact and a step that hangs on no address: what the listener does, hangs on it.
uint32_t Mix(b2Contact &contact, int step) {
    uint32_t mixed = static_cast<uint32_t>(step);
    for (const b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()})
        mixed = (mixed * 31u + NumberOf(*fixture->GetBody())) * 31u + NumberOf(*fixture);
    // The multiplier of Knuth's multiplicative hashing; the low bits are the poorest, so they go.
    return mixed * 2654435761u >> 8;
}

double SumOf(const b2Vec2 &v) {
    return static_cast<double>(v.x) + static_cast<double>(v.y);
}

double SumOf(const b2Manifold &manifold) {
    if (manifold.pointCount == 0)
        return 0.0; // the rest was perhaps never written
    double sum =
        static_cast<double>(manifold.type) + SumOf(manifold.localNormal) + SumOf(manifold.localPoint);
    for (int i = 0; i < manifold.pointCount; ++i)
        sum += SumOf(manifold.points[i].localPoint) + static_cast<double>(manifold.points[i].normalImpulse) +
               static_cast<double>(manifold.points[i].tangentImpulse) + manifold.points[i].id.key;
    return sum;
}

void Push(b2Body *body) {
    if (body->GetType() == b2_dynamicBody)
        body->ApplyLinearImpulse({0.0f, 0.2f * body->GetMass()}, body->GetPosition(), true);
}

} // namespace

nlohmann::json ListenedScene::ToJson() const {
    return {{"begins", m_begins},
            {"ends", m_ends},
            {"pre_solves", m_preSolves},
            {"post_solves", m_postSolves},
            {"read", m_read}};
}

void ListenedScene::BeforeStep(Stage &stage, int step) {
    m_step = step;
    m_scene.BeforeStep(stage, step);
}

void ListenedScene::Read(b2Contact &contact) {
    m_read += SumOf(*contact.GetManifold()) + static_cast<double>(contact.GetFriction()) +
              (contact.IsTouching() ? 1.0 : 0.0) + (contact.IsEnabled() ? 1.0 : 0.0);
    for (b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()}) {
        const b2Body &body = *fixture->GetBody();
        m_read += SumOf(body.GetPosition()) + static_cast<double>(body.GetAngle()) +
                  SumOf(body.GetLinearVelocity()) + static_cast<double>(body.GetAngularVelocity());
    }
}

void ListenedScene::OnBegin(b2Contact &contact) {
    ++m_begins;
    if (Reads())
        Read(contact);
    if (Acts() && Mix(contact, m_step) % 4 == 0)
        Push(contact.GetFixtureB()->GetBody());
    m_scene.OnBegin(contact);
}

void ListenedScene::OnEnd(b2Contact &contact) {
    ++m_ends;
    if (Reads())
        Read(contact);
    m_scene.OnEnd(contact);
}

void ListenedScene::OnPreSolve(b2Contact &contact, const b2Manifold &old) {
    ++m_preSolves;
    if (Reads()) {
        Read(contact);
        m_read += SumOf(old);
    }
    if (Acts()) {
        const uint32_t mixed = Mix(contact, m_step);
        if (mixed % 16 == 0)
            contact.SetEnabled(false);
        else if (mixed % 16 == 1)
            contact.SetFriction(0.1f * static_cast<float>(mixed % 7));
    }
    m_scene.OnPreSolve(contact, old);
}

void ListenedScene::OnPostSolve(b2Contact &contact, const b2ContactImpulse &impulse) {
    ++m_postSolves;
    if (Reads()) {
        Read(contact);
        for (int i = 0; i < impulse.count; ++i)
            m_read += static_cast<double>(impulse.normalImpulses[i]) +
                      static_cast<double>(impulse.tangentImpulses[i]);
    }
    if (Acts() && Mix(contact, m_step) % 64 == 0)
        Push(contact.GetFixtureA()->GetBody());
    m_scene.OnPostSolve(contact, impulse);
}

} // namespace testbed
