// SPDX-License-Identifier: MIT
// What listeners do: a table, and what needs more than a line.
#include "state/visit.h"
#include "world.h"

namespace actor {

using testbed::ContactMembers;
using testbed::NumberOf;

namespace {

/// Does a contact of this fixture, other than this one, wait for its time of impact? Box2D would solve it
/// though it is a sensor by then, and assert.
bool IsAwaited(const b2Fixture *fixture, const b2Contact &but) {
    for (const b2ContactEdge *edge = fixture->GetBody()->GetContactList(); edge != nullptr;
         edge = edge->next) {
        const b2Contact *contact = edge->contact;
        if (contact != &but && (contact->GetFixtureA() == fixture || contact->GetFixtureB() == fixture))
            return true;
    }
    return false;
}

/// A touching sensor has no manifold: Box2D asserts where one turns solid after its update.
void TurnSensorWithCare(Moment &m) {
    bool touches = false;
    for (const b2ContactEdge *edge = m.body->GetContactList(); edge != nullptr; edge = edge->next)
        touches = touches || edge->contact->IsTouching();
    if (!m.fixture->IsSensor() && !(m.world.IsInImpacts() && IsAwaited(m.fixture, *m.contact)))
        m.fixture->SetSensor(true);
    else if (m.fixture->IsSensor() && !touches)
        m.fixture->SetSensor(false);
}

/// Is Box2D in the midst of nothing that the body's contacts belong to? Then the game may end it, or put it
/// out of the world, while a contact of others ends or is reported.
bool IsStranger(const b2Body *body, const b2Contact &contact) {
    const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
    const b2Contact *next = contact.GetNext();
    if (body == a || body == b || body->GetJointList() != nullptr ||
        (next != nullptr &&
         (next->GetFixtureA()->GetBody() == body || next->GetFixtureB()->GetBody() == body)))
        return false;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (edge->other == a || edge->other == b || edge->contact->IsTouching())
            return false;
    return true;
}

void ActBetweenSteps(Moment &m) {
    b2World &world = m.world.Box2D();
    if (world.IsLocked() || !IsStranger(m.third, *m.contact))
        return;
    if (m.mixed / 64 % 4 == 0 && m.third->GetType() == b2_dynamicBody && world.GetBodyCount() > 12)
        world.DestroyBody(m.third);
    else if (m.mixed / 64 % 4 == 1)
        CreateBox(m.world, m.third->GetPosition() + b2Vec2(0.3f, 0.2f), 0.5f, b2_staticBody);
    else
        m.third->SetTransform(m.third->GetPosition() + b2Vec2(0.1f, -0.1f), m.third->GetAngle() + 0.3f);
}

/// What Box2D asserts that games do not do in the midst of a step, and what a Box2D without assertions does.
void DisableInStep(Moment &m) {
#if defined(AS_STOCK_BUILDS) && defined(NDEBUG)
    const bool own = m.mixed / 64 % 4 == 0 && m.occasion != kEnd;
    b2Body *body = own ? m.body : m.third;
    const b2ContactEdge *edge = body->GetContactList();
    // Box2D goes on with a contact that is gone; where it is the body's only one it comes to no other.
    const bool alone = edge != nullptr && edge->contact == m.contact && edge->next == nullptr;
    if (!body->IsEnabled())
        body->SetEnabled(true);
    else if (own && alone)
        body->SetEnabled(false);
    else if (!own && IsStranger(body, *m.contact))
        body->SetEnabled(false);
#else
    (void)m;
#endif
}

/// What a Box2D without assertions refuses.
void TryWhatIsRefused(Moment &m) {
#if defined(AS_STOCK_BUILDS) && defined(NDEBUG)
    b2World &world = m.world.Box2D();
    b2CircleShape circle;
    b2BodyDef def;
    switch (m.mixed / 64 % 6) {
    case 0:
        m.third->SetTransform({1.0f, 2.0f}, 3.0f);
        break;
    case 1:
        m.third->SetType(b2_staticBody);
        break;
    case 2:
        m.world.Probes().Field("body", uint32_t{world.CreateBody(&def) == nullptr});
        break;
    case 3:
        m.world.Probes().Field("fixture", uint32_t{m.third->CreateFixture(&circle, 1.0f) == nullptr});
        break;
    case 4:
        world.DestroyBody(m.third);
        break;
    default:
        world.ShiftOrigin({100.0f, 100.0f});
    }
#else
    (void)m;
#endif
}

/// The lists are whole and in their order for whoever reads them.
void ReadContacts(Moment &m) {
    testbed::HashSink &probes = m.world.Probes();
    if (!m.world.MayRead())
        return;
    for (const b2Contact *c = m.world.Box2D().GetContactList(); c != nullptr; c = c->GetNext()) {
        probes.Field("a", NumberOf(*c->GetFixtureA()));
        probes.Field("b", NumberOf(*c->GetFixtureB()));
        probes.Field("flags", ContactMembers::FlagsThatLast(*c));
    }
}

void ReadEdges(Moment &m) {
    testbed::HashSink &probes = m.world.Probes();
    if (!m.world.MayRead())
        return;
    const b2Contact *previous = nullptr;
    for (const b2Contact *c = m.world.Box2D().GetContactList(); c != nullptr; previous = c, c = c->GetNext())
        probes.Field("backwards", uint32_t{ContactMembers::Previous(*c) == previous});
    for (const b2Body *body = m.world.Box2D().GetBodyList(); body != nullptr; body = body->GetNext()) {
        probes.Field("awake", uint32_t{body->IsAwake()});
        probes.Field("contacts", testbed::HashContactOrder(*body));
    }
}

void SetWorld(Moment &m) {
    b2World &world = m.world.Box2D();
    switch (m.mixed / 64 % 8) {
    case 0:
        world.SetContinuousPhysics(!world.GetContinuousPhysics());
        break;
    case 1:
        world.SetSubStepping(!world.GetSubStepping());
        break;
    case 2:
        world.SetWarmStarting(!world.GetWarmStarting());
        break;
    case 3:
        world.SetAllowSleeping(!world.GetAllowSleeping());
        break;
    case 4:
        world.SetGravity({10.0f * m.amount - 5.0f, -5.0f});
        break;
    default:
        world.SetContinuousPhysics(true);
        world.SetSubStepping(false);
    }
}

/// Another centre of mass, and often fast.
void SetDensity(Moment &m) {
    if (m.mixed / 64 % 4 == 0)
        m.body->SetFixedRotation(!m.body->IsFixedRotation());
    m.fixture->SetDensity(0.5f + 60.0f * m.amount);
    m.body->ResetMassData();
    if (m.mixed / 64 % 2 == 0)
        ThrowBody(m.body, m.mixed / 8);
}

void DisableOther(Moment &m) {
    uint32_t which = m.mixed / 8 % 60;
    for (b2Contact *c = m.world.Box2D().GetContactList(); c != nullptr; c = c->GetNext())
        if (which-- == 0)
            m.world.Disable(c);
}

void MaskAll(Moment &m) {
    for (b2Fixture *f = m.third->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        b2Filter filter = f->GetFilterData();
        filter.maskBits = m.mixed / 64 % 2 == 0 ? 0 : 0xffff;
        if (m.mixed / 128 % 3 == 0)
            f->Refilter();
        else
            f->SetFilterData(filter);
    }
}

} // namespace

const Reaction kReactions[] = {
    {"nothing", kLocked, [](Moment &) {}},
    {"disables", kLocked, [](Moment &m) { m.contact->SetEnabled(false); }},
    {"disables", kLocked, [](Moment &m) { m.contact->SetEnabled(false); }},
    {"sets friction", kLocked, [](Moment &m) { m.contact->SetFriction(m.amount); }},
    {"sets restitution", kLocked,
     [](Moment &m) {
         m.contact->SetRestitution(m.amount);
         m.contact->SetRestitutionThreshold(m.amount);
     }},
    {"sets tangent speed", kLocked, [](Moment &m) { m.contact->SetTangentSpeed(10.0f * m.amount - 5.0f); }},
    {"switches bullet", kLocked, [](Moment &m) { m.body->SetBullet(!m.body->IsBullet()); }},
    {"switches another bullet", kLocked, [](Moment &m) { m.third->SetBullet(!m.third->IsBullet()); }},
    {"puts to sleep", kLocked, [](Moment &m) { m.body->SetAwake(false); }},
    {"wakes another or not", kLocked, [](Moment &m) { m.third->SetAwake(m.mixed / 64 % 2 == 0); }},
    {"makes a sensor", kLocked, [](Moment &m) { m.fixture->SetSensor(true); }},
    {"makes solid", kLocked, [](Moment &m) { m.fixture->SetSensor(false); }},
    {"refilters", kLocked, [](Moment &m) { m.fixture->Refilter(); }},
    {"turns back", kLocked,
     [](Moment &m) { m.body->SetLinearVelocity(-m.amount * m.body->GetLinearVelocity()); }},
    {"pushes another", kLocked,
     [](Moment &m) {
         m.third->ApplyLinearImpulseToCenter({m.amount, 1.0f - m.amount}, true);
         m.third->ApplyAngularImpulse(m.amount, false);
     }},
    {"evaluates", kLocked,
     [](Moment &m) {
         ProbeContact(m.world.Probes(), *m.contact, {0.0f, 0.0f});
     }},
    {"asks for distances", kLocked,
     [](Moment &m) {
         ProbePair(m.world.Probes(), *m.contact->GetFixtureA(), m.contact->GetChildIndexA(),
                   *m.contact->GetFixtureB(), m.contact->GetChildIndexB());
     }},
    {"makes a box of it", kLocked,
     [](Moment &m) {
         if (b2PolygonShape *polygon = PlainPolygon(*m.fixture))
             polygon->SetAsBox(0.2f + m.amount, 0.3f);
     }},
    {"sets another's freedoms", kLocked,
     [](Moment &m) {
         m.third->SetGravityScale(m.amount - 0.5f);
         m.third->SetSleepingAllowed(m.mixed / 64 % 2 == 0);
     }},
    {"reads contacts", kLocked, ReadContacts},
    {"steps the other world", kLocked,
     [](Moment &m) {
         if (m.world.other != nullptr && !m.world.other->Box2D().IsLocked())
             m.world.other->Step(1.0f / 60.0f, 4, 2);
     }},
    {"sets radius", kLocked,
     [](Moment &m) { m.fixture->GetShape()->m_radius = m.amount * 4.0f * b2_polygonRadius; }},
    {"resets friction", kLocked,
     [](Moment &m) {
         m.fixture->SetFriction(m.amount);
         m.contact->ResetFriction();
         m.contact->ResetRestitution();
     }},
    {"exchanges itself", kLocked, [](Moment &m) { m.world.ChangeHandsForNow(m.mixed / 64); }},
    {"steps its own world", kLocked, [](Moment &m) { m.world.StepInItself(m); }},
    {"makes a sensor or solid, with care", kLocked, TurnSensorWithCare},
    {"shoots another", kLocked,
     [](Moment &m) {
         m.third->SetBullet(true);
         ThrowBody(m.third, m.mixed / 8);
     }},
    {"edits a shape", kLocked, [](Moment &m) { Edit(m.fixture, m.mixed / 64); }},
    {"sets filter data", kLocked, [](Moment &m) { SetFilterData(m.fixture, m.mixed / 64); }},
    {"draws", kLocked,
     [](Moment &m) {
         if (m.world.MayRead())
             m.world.Draw();
     }},
    {"sets the world's solver", kLocked, SetWorld},
    {"moves the centre of mass", kLocked, SetDensity},
    {"disables another contact", kLocked, DisableOther},
    {"disables all of another", kLocked,
     [](Moment &m) {
         for (b2ContactEdge *edge = m.third->GetContactList(); edge != nullptr; edge = edge->next)
             m.world.Disable(edge->contact);
     }},
    {"reads edges", kLocked, ReadEdges},
    {"throws it", kLocked, [](Moment &m) { ThrowBody(m.body, m.mixed / 8); }},
    {"ends, makes, moves between steps", kUnlocked, ActBetweenSteps},
    {"puts bodies out of the world", kLocked, DisableInStep},
    {"tries what is refused", kLocked, TryWhatIsRefused},
    {"masks all of another", kLocked, MaskAll},
    {"edits another shape", kLocked,
     [](Moment &m) {
         if (b2Fixture *fixture = m.third->GetFixtureList())
             Edit(fixture, m.mixed / 64);
     }},
    {"shifts another's shapes", kLocked,
     [](Moment &m) {
         EditAll(m.third, 1.0f, {m.mixed / 64 % 2 == 0 ? 0.15f : -0.15f, 0.0f});
     }},
    {"shifts its shapes", kLocked,
     [](Moment &m) {
         EditAll(m.body, 1.0f, {m.mixed / 64 % 2 == 0 ? 0.15f : -0.15f, 0.0f});
     }},
};
const uint32_t kReactionCount = sizeof kReactions / sizeof *kReactions;
std::atomic<uint64_t> reactionsDone[sizeof kReactions / sizeof *kReactions];

} // namespace actor
