// SPDX-License-Identifier: MIT
#include "worker/summary.h"

#include <algorithm>

#include "stage.h"

namespace testbed {
namespace {

double EnergyOf(const b2Body &body, const b2Vec2 &gravity) {
    const double mass = static_cast<double>(body.GetMass());
    // Of a body inertia is given about its origin.
    const b2Vec2 centre = body.GetLocalCenter();
    const double inertia =
        static_cast<double>(body.GetInertia()) - mass * static_cast<double>(b2Dot(centre, centre));
    const double speed2 = static_cast<double>(body.GetLinearVelocity().LengthSquared());
    const double spin = static_cast<double>(body.GetAngularVelocity());
    return 0.5 * (mass * speed2 + inertia * spin * spin) -
           mass * static_cast<double>(b2Dot(gravity, body.GetWorldCenter()));
}

float DeepestOverlap(const b2World &world) {
    float deepest = 0.0f;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        if (!contact->IsTouching() || contact->GetFixtureA()->IsSensor() ||
            contact->GetFixtureB()->IsSensor())
            continue;
        b2WorldManifold points;
        contact->GetWorldManifold(&points);
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            deepest = std::max(deepest, -points.separations[i]);
    }
    return deepest;
}

} // namespace

void Behaviour::AddStep(const b2World &world) {
    if (m_steps == 0)
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            if (body->GetType() == b2_dynamicBody)
                m_places.emplace(NumberOf(*body), body->GetPosition());
    m_awake = 0;
    m_energy = 0.0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() != b2_dynamicBody)
            continue;
        m_awake += body->IsAwake() ? 1 : 0;
        m_energy += EnergyOf(*body, world.GetGravity());
    }
    if (m_steps == 0)
        m_energyStart = m_energy;
    m_energyGain = std::max(m_energyGain, m_energy - m_energyStart);
    if (m_awake > 0)
        m_asleepFrom = -1;
    else if (m_asleepFrom < 0)
        m_asleepFrom = m_steps;
    m_overlap = DeepestOverlap(world);
    m_deepest = std::max(m_deepest, m_overlap);
    ++m_steps;
    AddMoved(world);
}

/// A body that was made since has no place to be compared with.
void Behaviour::AddMoved(const b2World &world) {
    double sum = 0.0, most = 0.0;
    std::size_t count = 0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const auto place = m_places.find(NumberOf(*body));
        if (place == m_places.end())
            continue;
        const auto moved = static_cast<double>(b2Distance(body->GetPosition(), place->second));
        sum += moved;
        most = std::max(most, moved);
        ++count;
    }
    m_moved = count > 0 ? sum / static_cast<double>(count) : 0.0;
    m_movedMost = most;
}

nlohmann::json Behaviour::ToJson() const {
    return {{"awake", m_awake},
            {"asleep_from", m_asleepFrom < 0 ? nlohmann::json() : nlohmann::json(m_asleepFrom)},
            {"overlap", m_overlap},
            {"overlap_deepest", m_deepest},
            {"energy", m_energy},
            {"energy_start", m_energyStart},
            {"energy_gain", m_energyGain},
            {"moved", m_moved},
            {"moved_most", m_movedMost}};
}

} // namespace testbed
