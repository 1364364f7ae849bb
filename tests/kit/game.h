// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_GAME_H
#define BOOMERANG_TEST_GAME_H

#include <cfenv>

#include "in_child.h"
#include "small_world.h"

/// @file
/// A world whose every step is written down, and each call of its listener and filter.

namespace as_stock {

constexpr float Real(int i) {
    return static_cast<float>(i);
}

/// What is done in a callback; nothing within itself.
template <typename... Arguments> class Callback {
public:
    template <typename What> Callback &operator=(What what) {
        m_once = false;
        Set(std::move(what));
        return *this;
    }
    /// Is done in the next call alone, which may name what the one after it does.
    template <typename What> void Once(What what) {
        m_once = true;
        Set(std::move(what));
    }
    Callback &operator=(std::nullptr_t) {
        m_what = nullptr;
        m_set = true;
        return *this;
    }
    void operator()(Arguments... arguments) {
        if (!m_what)
            return;
        Function now;
        now.swap(m_what);
        const bool once = m_once;
        m_set = false;
        now(arguments...);
        if (!once && !m_set)
            m_what.swap(now);
    }

private:
    using Function = std::function<void(Arguments...)>;
    template <typename What> void Set(What what) {
        m_set = true;
        if constexpr (std::is_invocable_v<What &, Arguments...>)
            m_what = std::move(what);
        else
            m_what = [what](Arguments...) mutable { what(); };
    }
    Function m_what;
    bool m_once = false, m_set = false;
};

/// Writes down each call, and the length of the world's list of contacts by then.
class Listener final : public b2ContactListener {
public:
    Listener(const b2World &world, Hash *hash) : m_world(world), m_hash(hash) {}
    Callback<b2Contact *> begin, end, preSolve, postSolve;
    int calls = 0;

    void BeginContact(b2Contact *contact) override { Tell(1, contact, begin); }
    void EndContact(b2Contact *contact) override { Tell(2, contact, end); }
    void PreSolve(b2Contact *contact, const b2Manifold *old) override {
        m_hash->Begin("call", static_cast<uint64_t>(calls));
        testbed::VisitManifold(*m_hash, *old);
        Tell(3, contact, preSolve);
    }
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override {
        m_hash->Begin("call", static_cast<uint64_t>(calls));
        m_hash->Field("impulses", impulse->count);
        Tell(4, contact, postSolve);
    }

private:
    void Tell(uint32_t what, b2Contact *contact, Callback<b2Contact *> &callback) {
        uint32_t count = 0;
        for (const b2Contact *c = m_world.GetContactList(); c != nullptr; c = c->GetNext())
            ++count;
        m_hash->Begin("call", static_cast<uint64_t>(calls++));
        testbed::NameContact(*m_hash, *contact);
        static constexpr const char *kCalls[] = {"", "BeginContact", "EndContact", "PreSolve", "PostSolve"};
        m_hash->Field(kCalls[what], what);
        m_hash->Field("contacts", count);
        callback(contact);
    }
    const b2World &m_world;
    Hash *m_hash;
};

/// Answers as Box2D's own, unless it refuses, once `asked` is done.
class Filter final : public b2ContactFilter {
public:
    explicit Filter(Hash *hash) : m_hash(hash) {}
    Callback<b2Fixture *, b2Fixture *> asked;
    bool refuses = false;
    int count = 0;

    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        m_hash->Begin("filter's call", static_cast<uint64_t>(count++));
        m_hash->Field("a", testbed::NumberOf(*a));
        m_hash->Field("b", testbed::NumberOf(*b));
        asked(a, b);
        return !refuses && b2ContactFilter::ShouldCollide(a, b);
    }

private:
    Hash *m_hash;
};

/// A world whose every step is written down. Nobody listens or filters unless the game says so. Fixtures are
/// numbered as they are made.
class Game {
public:
    explicit Game(Run &run, b2Vec2 gravity = b2Vec2(0.0f, 0.0f))
        : listener(world, &hash), filter(&hash), world(gravity), m_run(run) {
        run.BeginsWorld();
        if (!Run::InWords().empty())
            hash.words = &m_words;
    }

    void Listen() { world.SetContactListener(&listener); }
    void Ask() { world.SetContactFilter(&filter); }

    b2Body *Body(b2BodyType type, b2Vec2 at, float angle = 0.0f) {
        b2BodyDef def;
        def.type = type;
        def.position = at;
        def.angle = angle;
        def.userData.pointer = ++m_bodiesMade;
        return world.CreateBody(&def);
    }
    b2Fixture *Fixture(b2Body *body, const b2Shape &shape, bool sensor = false) {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = 1.0f;
        def.isSensor = sensor;
        def.userData.pointer = ++m_made;
        return body->CreateFixture(&def);
    }
    b2Fixture *Box(b2Body *body, float halfWidth, float halfHeight, b2Vec2 center = {0.0f, 0.0f},
                   float angle = 0.0f) {
        b2PolygonShape box;
        box.SetAsBox(halfWidth, halfHeight, center, angle);
        return Fixture(body, box);
    }
    b2Body *Box(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        b2Body *body = Body(b2_dynamicBody, at, angle);
        Box(body, half.x, half.y);
        return body;
    }
    /// One that never sleeps.
    b2Body *Awake(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        b2Body *body = Box(at, half, angle);
        body->SetSleepingAllowed(false);
        return body;
    }
    b2Body *Wall(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        b2Body *body = Body(b2_staticBody, at, angle);
        Box(body, half.x, half.y);
        return body;
    }
    b2Body *Wheel(b2Vec2 at, int count, float radius) {
        b2Body *body = AddWheel(world, at, count, radius);
        for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            f->GetUserData().pointer = ++m_made;
        return body;
    }
    b2Body *Disk(b2Vec2 at, float radius) {
        b2Body *body = Body(b2_dynamicBody, at);
        b2CircleShape circle;
        circle.m_radius = radius;
        Fixture(body, circle);
        return body;
    }
    /// A plank of many boxes, four long and 0.2 thick, around `center` of its body: many, so that two planks
    /// have as many contacts as the glue may ask for before it gives them a structure. Only its pieces in
    /// [from, to) are made.
    void Plank(b2Body *body, b2Vec2 center = {0.0f, 0.0f}, int from = 0, int to = kPlankPieces) {
        constexpr float kHalf = 2.0f / Real(kPlankPieces);
        for (int i = from; i < to; ++i)
            Box(body, kHalf, 0.1f, center + b2Vec2((2.0f * Real(i) + 1.0f) * kHalf - 2.0f, 0.0f));
    }
    static constexpr int kPlankPieces = 10;
    /// Two boxes that never sleep, beside each other but for `gap`. Returns the right one.
    b2Body *Near(b2Vec2 at, float gap = 0.1f) {
        Awake(at, {0.4f, 0.4f});
        return Awake({at.x + 0.8f + gap, at.y}, {0.4f, 0.4f});
    }
    /// Two boxes that touch and rest: their contact has a PreSolve in every step.
    void Leaning(b2Vec2 at) {
        Awake(at);
        Awake({at.x + 0.995f, at.y});
    }
    b2RevoluteJoint *Hinge(b2Body *a, b2Body *b, b2Vec2 at) {
        b2RevoluteJointDef joint;
        joint.Initialize(a, b, at);
        return static_cast<b2RevoluteJoint *>(world.CreateJoint(&joint));
    }
    void Tie(b2Body *a, b2Body *b) {
        b2DistanceJointDef joint;
        joint.Initialize(a, b, a->GetPosition(), b->GetPosition());
        world.CreateJoint(&joint);
    }

    void Step(int count = 1, float seconds = 1.0f / 60.0f) {
        for (int i = 0; i < count; ++i) {
            world.Step(seconds, 8, 3);
            WriteDown();
        }
    }
    /// A step in the midst of another: what it did is written down with that one.
    void StepWithin(float seconds = 0.0f, int iterations = 1) {
        m_run.BreaksRules();
        world.Step(seconds, iterations, iterations);
    }
    void WriteDown() {
        hash.Add(world);
        char line[120];
        std::snprintf(line, sizeof line, "%d contacts, %d calls, %d asked, %016" PRIx64,
                      static_cast<int>(world.GetContactCount()), listener.calls, filter.count, hash.Value());
        if (line == Run::InWords())
            m_run.Write("in words\n" + m_words.Text());
        m_words.Clear();
        hash.Begin("the game's", 0);
        m_run.Print("%s", line);
    }

    /// How many contacts touch between solid fixtures: games check that what they stage takes place.
    int Touching() const {
        int count = 0;
        for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext())
            count += c->IsTouching() && !c->GetFixtureA()->IsSensor() && !c->GetFixtureB()->IsSensor();
        return count;
    }
    /// How many of the bodies are on the left of x: what came from there was stopped.
    static int LeftOf(float x, const std::vector<b2Body *> &bodies) {
        int count = 0;
        for (const b2Body *body : bodies)
            count += body->GetPosition().x < x;
        return count;
    }
    void Stage(bool holds, const char *what) { m_run.Stage(holds, what); }
    /// How often that happened which the game is about: it has to.
    void TookPlace(int count, const char *what) { m_run.Stage(count > 0, what); }
    /// Games about structures of bodies are void without one, where structures were asked for.
    void StagePairs() {
        const bmr::Counted counted = bmr::internal::ReadCounts();
        m_run.ExpectCounted(m_run.RemembersEdges() || (counted.structures > 0 && counted.hullChecks > 0),
                            "a structure watches the bodies");
    }

    Hash hash;
    Listener listener;
    Filter filter;
    b2World world;

private:
    Run &m_run;
    testbed::TextSink m_words; ///< of what was written down since the last line, if a run asks for it
    uintptr_t m_made = 0, m_bodiesMade = 0;
};

/// One whose listener is there from the beginning.
struct Heard : Game {
    explicit Heard(Run &run, b2Vec2 gravity = b2Vec2(0.0f, 0.0f)) : Game(run, gravity) { Listen(); }
};

inline b2PolygonShape *PolygonOf(b2Body *body, int index = 0) {
    b2Fixture *fixture = body->GetFixtureList();
    for (; index > 0; --index)
        fixture = fixture->GetNext();
    return static_cast<b2PolygonShape *>(fixture->GetShape());
}

// --- Slanted planks side by side, whose boxes overlap long before they do.

constexpr float kSlant = 0.785398185f; // 45 degrees: boxes of planks overlap long before the planks do

/// `along` and `across` a slanted plank, in the world.
inline b2Vec2 Slanted(float along, float across) {
    return b2Mul(b2Rot(kSlant), b2Vec2(along, across));
}

inline b2Body *Slanting(Game &game, float across, b2BodyType type = b2_dynamicBody) {
    b2Body *body = game.Body(type, Slanted(0.0f, across), kSlant);
    body->SetSleepingAllowed(false);
    return body;
}

/// Two planks, side by side, which know of each other.
struct TwoPlanks {
    TwoPlanks(Game &game, float across) : a(Slanting(game, 0.0f)), b(Slanting(game, across)) {
        game.Plank(a);
        game.Plank(b);
        game.Step(5);
        game.Stage(game.world.GetContactCount() >= 2 && game.Touching() == 0, "contacts, apart");
        game.StagePairs();
    }
    b2Body *a, *b;
};

inline void Place(b2Body *body, b2Vec2 position) {
    body->SetTransform(position, body->GetAngle());
}

inline b2PolygonShape *PolygonOf(b2Fixture *fixture) {
    return fixture->GetType() == b2Shape::e_polygon ? static_cast<b2PolygonShape *>(fixture->GetShape())
                                                    : nullptr;
}

} // namespace as_stock

#endif
