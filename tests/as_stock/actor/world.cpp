// SPDX-License-Identifier: MIT
#include "world.h"

#include <cfenv>
#include <cstring>
#include <initializer_list>
#include <typeinfo>

#include <box2d/b2_distance.h>

#include "state/visit.h"

namespace actor {

using testbed::NumberOf;

namespace {

/// Hashes what b2World::DebugDraw draws, in order.
class Drawn final : public b2Draw {
public:
    explicit Drawn(testbed::HashSink *hash) : m_hash(hash) {
        SetFlags(e_shapeBit | e_aabbBit | e_pairBit | e_jointBit);
    }
    void DrawPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        for (int32 i = 0; i < count; ++i)
            Add({vertices[i].x, vertices[i].y, color.r, color.g, color.b, color.a});
    }
    void DrawSolidPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        DrawPolygon(vertices, count, color);
    }
    void DrawCircle(const b2Vec2 &p, float radius, const b2Color &color) override {
        Add({p.x, p.y, radius, color.r});
    }
    void DrawSolidCircle(const b2Vec2 &p, float radius, const b2Vec2 &axis, const b2Color &color) override {
        Add({p.x, p.y, radius, axis.x, axis.y, color.r});
    }
    void DrawSegment(const b2Vec2 &p, const b2Vec2 &q, const b2Color &color) override {
        Add({p.x, p.y, q.x, q.y, color.r});
    }
    void DrawTransform(const b2Transform &xf) override { Add({xf.p.x, xf.p.y, xf.q.s, xf.q.c}); }
    void DrawPoint(const b2Vec2 &p, float size, const b2Color &color) override {
        Add({p.x, p.y, size, color.r});
    }

private:
    void Add(std::initializer_list<float> numbers) {
        for (const float number : numbers)
            m_hash->Field("drawn", number);
    }
    testbed::HashSink *m_hash;
};

uint32_t Mix(uint32_t from, uint32_t to, uint32_t step, uint32_t occasion) {
    return (((from * 31u + to) * 31u + step) * 5u + occasion) * 2654435761u >> 8;
}

/// The mode in which a step rounds; the one before comes back, whatever ends the step.
class Rounding {
public:
    explicit Rounding(int mode) : m_before(std::fegetround()) {
        static constexpr int kRoundings[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
        std::fesetround(kRoundings[mode]);
    }
    ~Rounding() { std::fesetround(m_before); }

private:
    int m_before;
};

} // namespace

b2PolygonShape *PlainPolygon(b2Fixture &fixture) {
    b2Shape *shape = fixture.GetShape();
#ifdef __cpp_rtti
    const b2Shape &object = *shape;
    const bool isPlain = typeid(object) == typeid(b2PolygonShape);
#else // and no shape is derived from a polygon
    const bool isPlain = shape->GetType() == b2Shape::e_polygon;
#endif
    return isPlain ? static_cast<b2PolygonShape *>(shape) : nullptr;
}

World::World(const b2Vec2 &gravity) : m_world(gravity) {
    m_world.SetContactListener(this);
    m_world.SetDestructionListener(this);
    m_world.SetContactFilter(this);
}

b2Body *World::Create(b2BodyDef def) {
    def.userData.pointer = m_bodiesMade++;
    return m_world.CreateBody(&def);
}

b2Fixture *World::Create(b2Body *body, b2FixtureDef def, const b2Shape &shape) {
    def.shape = &shape;
    def.userData.pointer = NextFixture();
    return body->CreateFixture(&def);
}

b2Joint *World::Create(b2JointDef &def) {
    def.userData.pointer = m_jointsMade++;
    return m_world.CreateJoint(&def);
}

static bool IsAwake(const b2Fixture &fixture) {
    return fixture.GetBody()->IsAwake() && fixture.GetBody()->GetType() != b2_staticBody;
}

void World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    if (m_stepping) // by the other one
        return;
    m_stepping = true;
    ++m_steps;
    m_read = 0;
    if (m_handsChanged)
        ChangeHands(0);
    m_handsChanged = false;
    if (m_disabled && !m_heard) {
        // A known difference: if nobody listens, Boomerang may leave a contact disabled that the game
        // disabled while it had no points.
        for (b2Contact *contact = m_world.GetContactList(); contact != nullptr; contact = contact->GetNext())
            if (!contact->IsTouching() || contact->GetFixtureA()->IsSensor() ||
                contact->GetFixtureB()->IsSensor())
                contact->SetEnabled(true);
        m_disabled = false;
    }
    if (ticks != 0)
        Tick();
    if (rescueBeyond > 0.0f)
        Rescue();
    const Rounding rounded(rounding);
    m_called = false;
    for (bool again = true; again;) {
        RememberPlaces();
        try {
            m_world.Step(timeStep, velocityIterations, positionIterations);
            NoteStepped(timeStep);
            again = false;
        } catch (const Thrown &) {
            hasThrown = true;
            m_reacting = m_inItself = false;
        }
    }
    m_stepping = false;
    if (m_disabled && !m_called) {
        // The same of a step that calls nobody: until it ends.
        for (b2Contact *contact = m_world.GetContactList(); contact != nullptr; contact = contact->GetNext())
            contact->SetEnabled(contact->IsEnabled() || IsAwake(*contact->GetFixtureA()) ||
                                IsAwake(*contact->GetFixtureB()));
        m_disabled = false;
    }
}

void World::NoteStepped(float timeStep) {
    if (timeStep > 0.0f && m_world.GetContinuousPhysics())
        m_mayGoOn = m_world.GetSubStepping();
}

/// Ahead of a step: some bodies are filtered anew, so that their contacts' ends and beginnings call
/// listeners; one goes to and fro, and has new contacts each time.
void World::Tick() {
    for (b2Body *body = m_world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const uint32_t number = NumberOf(*body);
        if (number % 8 == ticks % 8u)
            for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
                f->Refilter();
        if (number == ticks / 8u)
            body->SetTransform(body->GetPosition() + b2Vec2(m_steps % 2 == 0 ? 2.0f : -2.0f, 0.0f),
                               body->GetAngle());
    }
}

/// What has been squeezed out of its arena comes back in.
void World::Rescue() {
    for (b2Body *body = m_world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const b2Vec2 away = body->GetPosition() - home;
        if (body->GetType() == b2_staticBody || b2Max(b2Abs(away.x), b2Abs(away.y)) < rescueBeyond)
            continue;
        const uint32_t mixed = actor::Mix(NumberOf(*body), 0, m_steps, 0);
        const b2Vec2 at(static_cast<float>(mixed % 64) - 31.5f, static_cast<float>(mixed / 64 % 64) - 31.5f);
        body->SetTransform(home + rescueBeyond / 64.0f * at, 0.0f);
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAngularVelocity(0.0f);
    }
}

void World::RememberPlaces() {
    m_inImpacts = false;
    m_places.resize(m_bodiesMade);
    for (const b2Body *body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        m_places[NumberOf(*body)] = {body->GetWorldCenter(), body->GetAngle()};
}

/// Box2D reports begins twice in a step at most: where contacts are brought up to date, before any body has
/// moved, and in impacts, after all have.
void World::Watch(const b2Contact &contact) {
    for (const b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()}) {
        const b2Body *body = fixture->GetBody();
        const uint32_t number = NumberOf(*body);
        m_inImpacts =
            m_inImpacts || (number < m_places.size() && (m_places[number].center != body->GetWorldCenter() ||
                                                         m_places[number].angle != body->GetAngle()));
    }
}

bool World::IsFinite(const b2Body &body) {
    return body.GetPosition().IsValid() && body.GetLinearVelocity().IsValid() && b2IsValid(body.GetAngle()) &&
           b2IsValid(body.GetAngularVelocity());
}

bool World::IsFinite() const {
    for (const b2Body *body = m_world.GetBodyList(); body != nullptr && !mayBeNowhere; body = body->GetNext())
        if (!IsFinite(*body))
            return false;
    return true;
}

void World::StartRecord(bool inWords) {
    m_recorder.StartStep(inWords);
    m_probes = testbed::HashSink();
}

void World::ChangeHands(uint32_t how) {
    b2ContactListener *const listeners[] = {this, &m_other, nullptr, this};
    b2ContactFilter *const filters[] = {this, &m_other, nullptr, this};
    m_heard = listeners[how % 4] != nullptr || filters[how / 4 % 4] != nullptr;
    m_world.SetContactListener(listeners[how % 4]);
    m_world.SetContactFilter(filters[how / 4 % 4]);
}

void World::ChangeHandsForNow(uint32_t how) {
    m_handsChanged = true;
    ChangeHands(how);
}

void World::Draw() {
    Drawn drawn(&m_probes);
    m_world.SetDebugDraw(&drawn);
    m_world.DebugDraw();
    m_world.SetDebugDraw(nullptr);
}

void World::BeginContact(b2Contact *contact) {
    m_recorder.OnBegin(*contact);
    Watch(*contact);
    React(contact, kBegin);
}

void World::EndContact(b2Contact *contact) {
    m_recorder.OnEnd(*contact);
    React(contact, kEnd);
}

void World::PreSolve(b2Contact *contact, const b2Manifold *old) {
    m_recorder.OnPreSolve(*contact, *old);
    Watch(*contact);
    React(contact, kPreSolve);
}

void World::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    m_recorder.OnPostSolve(*contact, *impulse);
    React(contact, kPostSolve);
}

void World::SayGoodbye(b2Joint *joint) {
    m_recorder.OnGoodbye(*joint);
}

void World::SayGoodbye(b2Fixture *fixture) {
    m_recorder.OnGoodbye(*fixture);
}

bool World::ShouldCollide(b2Fixture *a, b2Fixture *b) {
    m_called = true;
    // The same for a pair whichever of the two comes first.
    if ((filterReacts & 1) != 0)
        ReactAsFilter(a, b);
    if ((filterReacts & 2) != 0 && !ReactAsWildFilter(a, b))
        return false;
    const uint32_t pair = (NumberOf(*a) + 1) * (NumberOf(*b) + 1);
    return (refused >> (pair % 8) & 1) == 0 && b2ContactFilter::ShouldCollide(a, b);
}

uint32_t World::Mix(const b2Fixture &a, const b2Fixture &b, Occasion occasion) const {
    return actor::Mix(NumberOf(a), NumberOf(b), m_steps, occasion);
}

void World::React(b2Contact *contact, Occasion occasion) {
    m_called = true;
    if (m_reacting)
        return;
    const b2Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
    const uint32_t mixed = Mix(a, b, occasion);
    const uint32_t held = reactions[mixed % kReactionsHeld], number = held < kReactionCount ? held : 0;
    const Reaction &reaction = kReactions[number];
    // Not locked: a body, a fixture or the world is being taken apart.
    if (!m_world.IsLocked() && reaction.manners != kUnlocked)
        return;
    m_reacting = true;
    if (m_world.IsLocked())
        MayThrow(occasion);
    const uint32_t rest = mixed / kReactionsHeld;
    b2Fixture *fixture = rest % 2 == 0 ? contact->GetFixtureA() : contact->GetFixtureB();
    Moment moment = {*this,
                     contact,
                     fixture,
                     fixture->GetBody(),
                     SomeBody(rest / 2),
                     rest,
                     0.05f * static_cast<float>(rest / 2 % 20),
                     occasion};
    reactionsDone[number].fetch_add(1, std::memory_order_relaxed);
    reaction.act(moment);
    m_reacting = false;
}

/// Not from what the islands of a whole step report: an entry of Box2D's stack of memory would be left
/// behind. Nor while a step goes on that stopped at an impact (SetSubStepping): Box2D's next impact would
/// leave out bodies that the last one has marked, and read places that it has not written for them.
void World::MayThrow(Occasion occasion) {
    if (throwing == 0 || throwing % 5 != static_cast<int>(occasion) || m_mayGoOn ||
        (occasion == kPostSolve && !m_inImpacts))
        return;
    throwing = static_cast<uint8_t>(throwing < 10 ? 0 : throwing - 5);
    if (throwing == 0)
        throw Thrown();
}

b2Body *World::SomeBody(uint32_t mixed) {
    b2Body *body = m_world.GetBodyList();
    for (uint32_t skip = mixed % static_cast<uint32_t>(m_world.GetBodyCount()); skip > 0; --skip)
        body = body->GetNext();
    return body;
}

void ProbePair(testbed::HashSink &sink, const b2Fixture &a, int32 childA, const b2Fixture &b, int32 childB) {
    const b2Transform &xfA = a.GetBody()->GetTransform(), &xfB = b.GetBody()->GetTransform();
    b2DistanceInput input;
    input.proxyA.Set(a.GetShape(), childA);
    input.proxyB.Set(b.GetShape(), childB);
    input.transformA = xfA;
    input.transformB = xfB;
    input.useRadii = true;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput distance;
    b2Distance(&distance, &cache, &input);
    sink.Field("distance", distance.distance);
    testbed::VisitVector(sink, "a.x", "a.y", distance.pointA);
    sink.Field("overlap",
               uint32_t{b2TestOverlap(a.GetShape(), childA, b.GetShape(), childB, xfA, xfB) ? 1u : 0u});
    b2ShapeCastInput cast;
    cast.proxyA = input.proxyA;
    cast.proxyB = input.proxyB;
    cast.transformA = xfA;
    cast.transformB = xfB;
    cast.translationB = {1.0f, -2.0f};
    b2ShapeCastOutput hit = {};
    if (b2ShapeCast(&hit, &cast))
        sink.Field("lambda", hit.lambda);
}

void ProbeContact(testbed::HashSink &sink, b2Contact &contact, b2Vec2 away) {
    b2Transform xfA = contact.GetFixtureA()->GetBody()->GetTransform();
    xfA.p += away;
    b2Manifold manifold;
    std::memset(static_cast<void *>(&manifold), 0x7f, sizeof manifold);
    contact.Evaluate(&manifold, xfA, contact.GetFixtureB()->GetBody()->GetTransform());
    testbed::VisitManifold(sink, manifold);
}

void ScaleInPlace(b2PolygonShape *polygon, float reach) {
    float farthest = 0.0f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        farthest = b2Max(farthest, polygon->m_vertices[i].Length());
    const float factor = farthest > reach ? 0.75f : 1.25f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        polygon->m_vertices[i] *= factor;
    polygon->m_centroid *= factor;
}

} // namespace actor
