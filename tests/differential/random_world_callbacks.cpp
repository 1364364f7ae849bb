// SPDX-License-Identifier: MIT
// What the listeners of a random world do in the middle of its steps.
#include <algorithm>

#include "random_world.h"
#include "state/members.h"

using namespace testbed;

namespace differential {

namespace {

/// Does a contact of this fixture, other than this one, wait for its time of impact? Box2D would solve it
/// though it is a sensor by then, and assert.
bool Awaited(const b2Fixture *fixture, const b2Contact &but) {
    for (const b2ContactEdge *edge = fixture->GetBody()->GetContactList(); edge != nullptr;
         edge = edge->next) {
        const b2Contact *contact = edge->contact;
        if (contact != &but && (contact->GetFixtureA() == fixture || contact->GetFixtureB() == fixture) &&
            ContactMembers::HasToi(*contact) && ContactMembers::Toi(*contact) < 1.0f)
            return true;
    }
    return false;
}

} // namespace

/// What a listener does hangs on numbers and the step alone: a draw more or less would change all that
/// follows, and hide where two runs began to differ.
uint32_t RandomWorld::Mix(b2Contact &contact) const {
    const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
    const uint32_t from = NumberOf(*a.GetBody()) * 8u + NumberOf(a),
                   to = NumberOf(*b.GetBody()) * 8u + NumberOf(b);
    return ((from * 31u + to) * 31u + static_cast<uint32_t>(m_step)) * 2654435761u >> 8;
}

void RandomWorld::OnBegin(b2Contact &contact) {
    const uint32_t mixed = Mix(contact);
    if (mixed % 7 == 0)
        contact.GetFixtureB()->GetBody()->SetBullet(mixed % 2 == 0);
    Meddle(contact, mixed >> 3);
}

void RandomWorld::OnPreSolve(b2Contact &contact) {
    const uint32_t mixed = Mix(contact);
    if (mixed % 13 == 0)
        contact.SetEnabled(false);
    if (mixed % 17 == 0)
        contact.SetFriction(0.05f * static_cast<float>(mixed % 20));
    if (mixed % 19 == 0)
        contact.SetRestitution(0.02f * static_cast<float>(mixed % 20));
    if (mixed % 31 == 0)
        contact.SetTangentSpeed(static_cast<float>(mixed % 5) - 2.0f);
    if (mixed % 41 == 0) // contacts that follow are filtered in this step, those before in the next
        contact.GetFixtureA()->Refilter();
    Meddle(contact, mixed >> 5);
}

/// Between the solving of velocities, after which bodies have moved, and the end of the step nobody is told
/// of contacts but by b2World::SolveTOI.
bool RandomWorld::ImpactsAreSolved() const {
    for (std::size_t i = 0; i < m_places.size(); ++i)
        if (m_bodies[i]->GetPosition() != m_places[i].position ||
            m_bodies[i]->GetAngle() != m_places[i].angle)
            return true;
    return false;
}

void RandomWorld::RememberPlaces() {
    m_places.clear();
    for (const b2Body *body : m_bodies)
        m_places.push_back({body->GetPosition(), body->GetAngle()});
}

void RandomWorld::WakeAll() {
    for (b2Body *body : m_bodies)
        body->SetAwake(true);
    m_turnedInImpacts = false;
}

/// The list of contacts is whole and in its order for whoever looks.
void RandomWorld::LookAtContacts(const b2Contact &contact) {
    const b2World *world = contact.GetFixtureA()->GetBody()->GetWorld();
    const b2Contact *previous = nullptr;
    for (const b2Contact *c = world->GetContactList(); c != nullptr; previous = c, c = c->GetNext()) {
        m_probes.Field("a", NumberOf(*c->GetFixtureA()->GetBody()) * 8u + NumberOf(*c->GetFixtureA()));
        m_probes.Field("b", NumberOf(*c->GetFixtureB()->GetBody()) * 8u + NumberOf(*c->GetFixtureB()));
        m_probes.Field("backwards", uint32_t{ContactMembers::Previous(*c) == previous});
    }
}

void RandomWorld::Meddle(b2Contact &contact, uint32_t mixed) {
    if (mixed % 5 == 0)
        LookAtContacts(contact);
    const bool inImpacts = ImpactsAreSolved();
    // More than Box2D allows a contact in a step: it is left alone then.
    m_inImpacts.spent += inImpacts && ContactMembers::ToiCount(contact) == b2_maxSubSteps;
    b2Fixture *fixture = mixed % 2 == 0 ? contact.GetFixtureA() : contact.GetFixtureB();
    b2Body *body = fixture->GetBody(), *third = m_bodies[mixed % m_bodies.size()];
    switch (mixed / 2 % 16) {
    case 0:
        body->SetBullet(!body->IsBullet());
        m_inImpacts.bullets += inImpacts;
        break;
    case 1: // one that need not have to do with the two
        third->SetBullet(!third->IsBullet());
        m_inImpacts.bullets += inImpacts;
        break;
    case 2:
        contact.SetEnabled(false);
        m_inImpacts.disabled += inImpacts;
        break;
    case 3:
    case 4:
        if (StepIsSleepy()) {
            (mixed % 3 == 0 ? third : body)->SetAwake(false);
            m_inImpacts.asleep += inImpacts;
        }
        break;
    case 5:
        third->SetAwake(true);
        break;
    case 6:
    case 7:
    case 8:
        if (m_step % 3 == 0 && m_sensorsMayTurn && m_timeStep > 0.0f)
            MeddleWithSensor(contact, fixture, inImpacts);
        break;
    default:
        break;
    }
}

void RandomWorld::MeddleWithSensor(const b2Contact &contact, b2Fixture *fixture, bool inImpacts) {
    if (!fixture->IsSensor()) {
        if (inImpacts && Awaited(fixture, contact))
            return;
        fixture->SetSensor(true);
        m_inImpacts.sensors += inImpacts;
    } else if (inImpacts) { // earlier, contacts that have been brought up to date would be solved
        fixture->SetSensor(false);
        m_turnedInImpacts = true;
        ++m_inImpacts.solids;
    }
}

} // namespace differential
