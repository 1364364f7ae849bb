// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_AS_STOCK_H
#define BOOMERANG_TEST_AS_STOCK_H

#include <cfenv>

#include <sys/resource.h>

#include "forked_world.h"
#include "small_world.h"

/// @file
/// Games that must have stock Box2D's bits. A game is a test case: it builds worlds, plays them, and hands
/// what happens to a listener or a filter as lambdas. `AsStock` plays it in child processes: once on stock
/// Box2D, and once for each form of the library. What is written down of each step, and of each call of a
/// listener or filter, must be the same.

namespace as_stock {

using forked::Run;

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
    int told = 0;

    void BeginContact(b2Contact *contact) override { Tell(1, contact, begin); }
    void EndContact(b2Contact *contact) override { Tell(2, contact, end); }
    void PreSolve(b2Contact *contact, const b2Manifold *old) override {
        m_hash->Add(static_cast<uint32_t>(old->pointCount));
        Tell(3, contact, preSolve);
    }
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override {
        m_hash->Add(static_cast<uint32_t>(impulse->count));
        Tell(4, contact, postSolve);
    }

private:
    void Tell(uint32_t what, b2Contact *contact, Callback<b2Contact *> &callback) {
        ++told;
        m_hash->Add(what);
        for (const b2Fixture *fixture : {contact->GetFixtureA(), contact->GetFixtureB()})
            m_hash->Add(static_cast<uint32_t>(const_cast<b2Fixture *>(fixture)->GetUserData().pointer));
        uint32_t count = 0;
        for (const b2Contact *c = m_world.GetContactList(); c != nullptr; c = c->GetNext())
            ++count;
        m_hash->Add(count);
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
        ++count;
        m_hash->Add(static_cast<uint32_t>(a->GetUserData().pointer));
        m_hash->Add(static_cast<uint32_t>(b->GetUserData().pointer));
        asked(a, b);
        return !refuses && b2ContactFilter::ShouldCollide(a, b);
    }

private:
    Hash *m_hash;
};

/// A world whose every step is written down. Nobody listens or filters unless the game says so.
class Game {
public:
    explicit Game(Run &run, b2Vec2 gravity = b2Vec2(0.0f, 0.0f))
        : listener(world, &hash), filter(&hash), world(gravity), m_run(run) {}

    void Listen() { world.SetContactListener(&listener); }
    void Ask() { world.SetContactFilter(&filter); }

    b2Body *Box(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        return Numbered(AddBox(world, b2_dynamicBody, at, half, angle));
    }
    /// One that never sleeps.
    b2Body *Awake(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        b2Body *body = Box(at, half, angle);
        body->SetSleepingAllowed(false);
        return body;
    }
    b2Body *Wall(b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
        return Numbered(AddBox(world, b2_staticBody, at, half, angle));
    }
    b2Body *Wheel(b2Vec2 at, int count, float radius) { return Numbered(AddWheel(world, at, count, radius)); }
    b2Body *Disk(b2Vec2 at, float radius) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = at;
        b2Body *body = world.CreateBody(&def);
        b2CircleShape circle;
        circle.m_radius = radius;
        body->CreateFixture(&circle, 1.0f);
        return Numbered(body);
    }
    void AddBoxTo(b2Body *body, b2Vec2 half, b2Vec2 center, float angle = 0.0f) {
        b2PolygonShape box;
        box.SetAsBox(half.x, half.y, center, angle);
        body->CreateFixture(&box, 1.0f)->GetUserData().pointer = ++m_made;
    }
    /// Two boxes that never sleep, beside each other but for `gap`. Returns the right one.
    b2Body *Near(b2Vec2 at, float gap = 0.1f) {
        Awake(at, {0.4f, 0.4f});
        return Awake({at.x + 0.8f + gap, at.y}, {0.4f, 0.4f});
    }
    /// Two boxes that touch and rest: their contact has a PreSolve in every step.
    void Touching(b2Vec2 at) {
        Awake(at);
        Awake({at.x + 0.995f, at.y});
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
    void StepWithin(float seconds = 0.0f, int iterations = 1) { world.Step(seconds, iterations, iterations); }
    void WriteDown() {
        hash.Add(world);
        m_run.Print("%d contacts, %d told, %d asked, %016" PRIx64, static_cast<int>(world.GetContactCount()),
                    listener.told, filter.count, hash.Value());
    }

    Hash hash;
    Listener listener;
    Filter filter;
    b2World world;

private:
    b2Body *Numbered(b2Body *body) {
        for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            f->GetUserData().pointer = ++m_made;
        return body;
    }
    Run &m_run;
    uintptr_t m_made = 0;
};

inline b2PolygonShape *PolygonOf(b2Body *body, int index = 0) {
    b2Fixture *fixture = body->GetFixtureList();
    for (; index > 0; --index)
        fixture = fixture->GetNext();
    return static_cast<b2PolygonShape *>(fixture->GetShape());
}

/// How the library is installed.
struct Form {
    const char *name;
    bool everywhere, counts;
    bmr::Mode mode;
    bool ifNamed = false; ///< it is played where BMR_AS_STOCK names it
};
constexpr Form kStock = {"stock", false, false, bmr::Mode::Off};
constexpr Form kForms[] = {{"on", false, false, bmr::Mode::On},
                           {"everywhere", true, false, bmr::Mode::On},
                           {"counting", true, true, bmr::Mode::On, true},
                           {"verifying", true, true, bmr::Mode::Verify}};

using Play = std::function<void(Run &)>;

inline std::string Played(const Play &play, const Form &form, bool mustAnswer, bool modest = false) {
    return forked::InChild(
        [&play, &form, mustAnswer, modest](Run &run) {
            // A game takes a second or two of the processor. What goes round for ever ends here.
            const rlimit most = {20, 20};
            setrlimit(RLIMIT_CPU, &most);
            bmr::Options options;
            setenv("BOOMERANG_EVERYWHERE", form.everywhere ? "on" : "off", 1);
            options.statistics = form.counts;
            options.mode = form.mode;
            options.modestListeners = modest;
            if (form.mode != bmr::Mode::Off && !bmr::Install(options))
                run.Print("!not installed");
            const bmr::Counted before = bmr::internal::ReadCounts();
            play(run);
            const bmr::Counted statistics = bmr::internal::ReadCounts();
            if (form.counts && mustAnswer && statistics.evaluations == before.evaluations)
                run.Print("!nothing was answered");
            if (statistics.differences != 0)
                run.Print("!answers differ from Box2D's");
        },
        nullptr, forked::When::kByScenario);
}

/// The claim of every game. The library has something to answer in it, unless `mustAnswer` is false. With
/// BMR_AS_STOCK in the environment in the form of this name alone. `modest`: Options::modestListeners.
inline void AsStock(const Play &play, bool mustAnswer = true, bool modest = false) {
    const std::string stock = Played(play, kStock, false);
    REQUIRE(stock != "");
    REQUIRE(forked::Difference(stock, stock) == "");
    const std::string only = std::getenv("BMR_AS_STOCK") != nullptr ? std::getenv("BMR_AS_STOCK") : "";
    for (const Form &form : kForms) {
        if (only != "" ? form.name != only : form.ifNamed)
            continue;
        const std::string name = form.name;
        CAPTURE(name);
        REQUIRE(forked::Difference(stock, Played(play, form, mustAnswer, modest)) == "");
    }
}

} // namespace as_stock

/// A test case that is one game: AS_STOCK("name") { Game game(run); ... }
#define AS_STOCK_OF(play, name)                                                                              \
    static void play(forked::Run &run);                                                                      \
    TEST_CASE(name) {                                                                                        \
        as_stock::AsStock(play);                                                                             \
    }                                                                                                        \
    static void play(forked::Run &run)
#define AS_STOCK(name) AS_STOCK_OF(DOCTEST_ANONYMOUS(game_), name)

#endif
