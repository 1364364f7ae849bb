// SPDX-License-Identifier: MIT
#include "random_game.h"

#include "edit.h"
#include "playing.h"
#include "shapes.h"
#include "state/members.h"

using namespace testbed;

namespace box2d_builds {

namespace {

constexpr float kMeter = b2_lengthUnitsPerMeter;

/// Box2D goes on with a contact that is gone: its memory is Box2D's, and is as it was.
#if defined(BOX2D_BUILDS_NO_OWN)
constexpr bool kOwn = false;
#else
constexpr bool kOwn = kReleased;
#endif

/// Is the body neither of the contact's, nor in contact with them, nor touched by anything that moves, and
/// does the contact after this one not ask for it? Then Box2D is in the midst of nothing that its contacts
/// belong to.
bool IsStranger(const b2Body *body, const b2Contact &contact) {
    const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
    const b2Contact *next = contact.GetNext();
    if (body == a || body == b ||
        (next != nullptr &&
         (next->GetFixtureA()->GetBody() == body || next->GetFixtureB()->GetBody() == body)))
        return false;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (edge->other == a || edge->other == b || edge->contact->IsTouching())
            return false;
    return true;
}

/// Has the body this contact alone? Then Box2D, which goes on with a contact that is gone, comes to no other
/// one of its.
bool HasNoOther(const b2Body *body, const b2Contact &contact) {
    const b2ContactEdge *edge = body->GetContactList();
    return edge != nullptr && edge->contact == &contact && edge->next == nullptr;
}

} // namespace

void Deeds::operator+=(const Deeds &more) {
    edits += more.edits;
    filters += more.filters;
    thrown += more.thrown;
    otherSteps += more.otherSteps;
    draws += more.draws;
    disabled += more.disabled;
    ownDisabled += more.ownDisabled;
    enabled += more.enabled;
    refused += more.refused;
    destroyed += more.destroyed;
    made += more.made;
    moved += more.moved;
    solid += more.solid;
    disabledInImpacts += more.disabledInImpacts;
}

void Deeds::Print(FILE *to) const {
    std::fprintf(to,
                 "listeners: edits %lu filters %lu thrown %lu other-steps %lu draws %lu destroyed %lu made "
                 "%lu moved %lu solid %lu",
                 edits, filters, thrown, otherSteps, draws, destroyed, made, moved, solid);
    if (kReleased)
        std::fprintf(to, " disabled %lu disabled-in-impacts %lu own-disabled %lu enabled %lu refused %lu",
                     disabled, disabledInImpacts, ownDisabled, enabled, refused);
    std::fprintf(to, "\n");
}

RandomGame::RandomGame(long seed) : m_seed(seed) {
    m_drawn.SetFlags(b2Draw::e_shapeBit | b2Draw::e_aabbBit | b2Draw::e_pairBit | b2Draw::e_jointBit);
}

void RandomGame::Build(Stage &stage, int size) {
    m_stage = &stage;
    if (m_seed % 3 != 0) // the plugin finds pairs in another way where the filter is the game's
        stage.World().SetContactFilter(this);
    stage.World().SetDebugDraw(&m_drawn);
    m_world.Build(stage, size);
}

void RandomGame::BeforeStep(Stage &stage, int step) {
    m_step = step;
    m_world.BeforeStep(stage, step);
    m_mayThrow = m_seed % 4 == 1 && step % 5 == 3;
    m_mayOwn = kOwn && m_seed % 2 == 0;
    m_watch.StepBegins(stage.World());
}

void RandomGame::LookWhereBodiesAre() {
    m_world.RememberPlaces();
    m_watch.StepBegins(m_stage->World());
}

uint64_t RandomGame::Probes() const {
    return m_world.ProbeHash() * 31 + m_drawn.Hash() * 7 + m_probes.Value();
}

void RandomGame::AfterException() {
    m_mayThrow = m_mayOwn = false;
    m_acting = false;
    m_world.WakeAll();
    LookWhereBodiesAre();
}

uint32_t RandomGame::Mix(const b2Fixture &a, const b2Fixture &b, Occasion occasion) const {
    const uint32_t from = NumberOf(*a.GetBody()) * 8u + NumberOf(a),
                   to = NumberOf(*b.GetBody()) * 8u + NumberOf(b);
    uint32_t mixed = ((from * 37u + to) * 37u + static_cast<uint32_t>(m_step)) * 5u + occasion;
    mixed = (mixed ^ static_cast<uint32_t>(m_seed)) * 2654435761u;
    return (mixed ^ (mixed >> 15)) * 2246822519u >> 8;
}

/// Any body but the first of the list, chosen by a number.
b2Body *RandomGame::Third(uint32_t mixed) const {
    b2World &world = m_stage->World();
    b2Body *body = world.GetBodyList();
    for (uint32_t skip = mixed % static_cast<uint32_t>(world.GetBodyCount()); skip > 0; --skip)
        body = body->GetNext();
    return body;
}

void RandomGame::OnBegin(b2Contact &contact) {
    m_watch.Told(contact);
    m_world.OnBegin(contact);
    Act(contact, kBegin);
}

void RandomGame::OnEnd(b2Contact &contact) {
    m_world.OnEnd(contact);
    Act(contact, kEnd);
}

void RandomGame::OnPreSolve(b2Contact &contact) {
    m_watch.Told(contact);
    m_world.OnPreSolve(contact);
    Act(contact, kPreSolve);
}

void RandomGame::OnPostSolve(b2Contact &contact) {
    Act(contact, kPostSolve);
}

void RandomGame::Act(b2Contact &contact, Occasion occasion) {
    if (m_acting)
        return;
    const uint32_t mixed = Mix(*contact.GetFixtureA(), *contact.GetFixtureB(), occasion);
    m_acting = true;
    if (!m_stage->World().IsLocked())
        ActBetweenSteps(contact, mixed);
    else if (kReleased && mixed % 3 == 0)
        ActReleased(contact, mixed / 3, occasion);
    else
        ActLocked(contact, mixed / 3, occasion);
    m_acting = false;
}

/// What Box2D allows in the midst of a step.
void RandomGame::ActLocked(b2Contact &contact, uint32_t mixed, Occasion occasion) {
    b2Fixture *fixture = mixed % 2 == 0 ? contact.GetFixtureA() : contact.GetFixtureB();
    b2Body *third = Third(mixed / 64);
    switch (mixed / 2 % 32) {
    case 0:
        Edit(fixture->GetBody(), mixed / 64);
        break;
    case 1:
        Edit(third, mixed / 128);
        break;
    case 2:
        ChangeFilter(fixture, mixed / 64);
        break;
    case 3:
        StepOther();
        break;
    case 4:
        m_stage->World().DebugDraw();
        ++m_done.draws;
        break;
    case 5:
        third->SetLinearVelocity(third->GetLinearVelocity() + b2Vec2(1.0f, 2.0f));
        third->SetAwake(true);
        break;
    case 6:
        TurnSolid(third);
        break;
    case 7:
        m_stage->World().SetContinuousPhysics(mixed % 5 != 0);
        break;
    case 8:
        third->SetGravityScale(static_cast<float>(mixed / 64 % 3));
        third->SetLinearDamping(0.1f);
        break;
    case 9:
    case 10:
        Throw(occasion);
        break;
    default:
        break;
    }
}

/// Contacts also end between two steps, where nothing is locked: by what the game does to bodies and
/// fixtures.
void RandomGame::ActBetweenSteps(b2Contact &contact, uint32_t mixed) {
    b2World &world = m_stage->World();
    b2Body *third = Third(mixed / 16);
    if (!IsStranger(third, contact))
        return;
    switch (mixed % 8) {
    case 0:
        if (third->GetType() == b2_dynamicBody && world.GetBodyCount() > 12) {
            m_world.Destroy(world, third);
            ++m_done.destroyed;
        }
        break;
    case 1: {
        const b2Vec2 place = third->GetPosition() + b2Vec2(0.3f, 0.2f);
        m_stage->AddFixture(m_stage->AddBody(b2_staticBody, place, 0.5f),
                            MakeBox(0.2f * kMeter, 0.1f * kMeter), 0.0f);
        ++m_done.made;
        break;
    }
    case 2:
        third->SetTransform(third->GetPosition() + b2Vec2(0.1f, -0.1f), third->GetAngle() + 0.3f);
        ++m_done.moved;
        break;
    default:
        break;
    }
}

/// What Box2D asserts that nobody does in the midst of a step, and what a Box2D without assertions does or
/// refuses.
void RandomGame::ActReleased(b2Contact &contact, uint32_t mixed, Occasion occasion) {
    b2Body *third = Third(mixed / 16);
    switch (mixed % 8) {
    case 0:
    case 1:
    case 2:
        if (third->IsEnabled() && IsStranger(third, contact)) {
            third->SetEnabled(false);
            ++m_done.disabled;
            m_done.disabledInImpacts += m_watch.InImpacts();
        }
        break;
    case 3:
        if (!third->IsEnabled()) {
            third->SetEnabled(true);
            ++m_done.enabled;
        }
        break;
    case 4:
        TryWhatIsRefused(third, mixed / 16);
        break;
    case 5:
    case 6: {
        // The contact itself ends while Box2D is at it, which goes on with what it was.
        b2Body *own = (mixed % 16 < 8 ? contact.GetFixtureA() : contact.GetFixtureB())->GetBody();
        if (m_mayOwn && occasion != kEnd && own->IsEnabled() && HasNoOther(own, contact)) {
            m_mayOwn = false;
            own->SetEnabled(false);
            ++m_done.ownDisabled;
        }
        break;
    }
    default:
        break;
    }
}

/// Vertices that are moved toward the middle of the body or away from it, or another radius.
void RandomGame::Edit(b2Body *body, uint32_t mixed) {
    b2Fixture *fixture = body->GetFixtureList();
    for (uint32_t skip = mixed / 4 % 4; fixture != nullptr && skip > 0 && fixture->GetNext() != nullptr;
         --skip)
        fixture = fixture->GetNext();
    if (fixture == nullptr || fixture->GetType() != b2Shape::e_polygon)
        return;
    b2PolygonShape &polygon = *static_cast<b2PolygonShape *>(fixture->GetShape());
    ++m_done.edits;
    if (mixed % 4 == 0) {
        polygon.m_radius = static_cast<float>(1 + mixed / 16 % 5) * b2_polygonRadius;
        return;
    }
    ScaleInPlace(&polygon, 0.8f * kMeter);
}

void RandomGame::ChangeFilter(b2Fixture *fixture, uint32_t mixed) {
    b2Filter filter = fixture->GetFilterData();
    filter.maskBits = mixed % 3 == 0 ? 0x0001 : 0xffff;
    filter.categoryBits = mixed % 2 == 0 ? 0x0002 : 0x0001;
    fixture->SetFilterData(filter);
    ++m_done.filters;
}

/// A sensor that touches nothing yet; of one that does Box2D would solve contacts that have no manifold.
void RandomGame::TurnSolid(b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (edge->contact->IsTouching())
            return;
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
        if (fixture->IsSensor()) {
            fixture->SetSensor(false);
            ++m_done.solid;
            return;
        }
}

void RandomGame::StepOther() {
    if (m_other == nullptr || m_other->World().IsLocked())
        return;
    auto &other = static_cast<RandomGame &>(m_other->TheGame());
    other.AfterException(); // it is in the midst of nothing, and throws nothing
    m_other->StepAlone();
    ++m_done.otherSteps;
}

/// Not from what the islands of a whole step report: an entry of Box2D's stack of memory would be left
/// behind.
void RandomGame::Throw(Occasion occasion) {
    if (!m_mayThrow || (occasion == kPostSolve && !m_watch.InImpacts()))
        return;
    m_mayThrow = false;
    ++m_done.thrown;
    throw Thrown();
}

void RandomGame::TryWhatIsRefused(b2Body *body, uint32_t mixed) {
    b2World &world = m_stage->World();
    ++m_done.refused;
    switch (mixed % 6) {
    case 0:
        body->SetTransform({1.0f, 2.0f}, 3.0f);
        break;
    case 1:
        body->SetType(b2_staticBody);
        break;
    case 2: {
        b2BodyDef def;
        m_probes.Field("body", uint32_t{world.CreateBody(&def) == nullptr});
        break;
    }
    case 3: {
        b2CircleShape circle;
        m_probes.Field("fixture", uint32_t{body->CreateFixture(&circle, 1.0f) == nullptr});
        break;
    }
    case 4:
        world.DestroyBody(body);
        break;
    default:
        world.ShiftOrigin({100.0f, 100.0f});
    }
}

/// Pairs are filtered when boxes have come to overlap: at the beginning of a step, before the world is
/// locked, or in impacts.
bool RandomGame::ShouldCollide(b2Fixture *a, b2Fixture *b) {
    const bool collide = b2ContactFilter::ShouldCollide(a, b);
    if (m_acting)
        return collide;
    m_acting = true;
    const uint32_t mixed = Mix(*a, *b, kFilter);
    b2Body *third = Third(mixed / 64);
    if (mixed % 11 == 0 && !m_stage->World().IsLocked()) {
        third->SetTransform(third->GetPosition() + b2Vec2(0.2f, 0.1f), third->GetAngle());
        LookWhereBodiesAre();
        ++m_done.moved;
    } else if (mixed % 11 == 1) {
        Edit(third, mixed / 128);
    } else if (mixed % 11 == 2) {
        StepOther();
    } else if (mixed % 11 == 3) {
        Throw(kFilter);
    }
    m_acting = false;
    return collide && mixed % 13 != 0;
}

} // namespace box2d_builds
