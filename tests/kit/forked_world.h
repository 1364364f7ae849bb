// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_FORKED_WORLD_H
#define BOOMERANG_TEST_FORKED_WORLD_H

#include <cstdarg>

#include <box2d/box2d.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include "boomerang/box2d_glue.h"
#include "cases.h"
#include "leave.h"
#include "tell/event.h"
#include "test_scale.h"

#if defined(__has_feature)
#    if __has_feature(address_sanitizer)
#        define FORKED_WORLD_ASAN
#    endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#    define FORKED_WORLD_ASAN
#endif
#if defined(FORKED_WORLD_ASAN)
// Of the sanitizer's own headers, which not every compiler brings.
extern "C" size_t __sanitizer_get_current_allocated_bytes(void);
extern "C" int __lsan_do_recoverable_leak_check(void);
#endif

/// @file
/// One scenario, run in a child process on stock Box2D, and again in other children with the plugin installed
/// in each of its forms. What the scenario prints must be the same, to the bit, in all of them. (The contact
/// register is process-wide: a process with the plugin in it is no reference.)

namespace forked {

/// Is the library ahead of Box2D in this program? Then it sees the changes itself. Otherwise the program
/// links the glue alone, and tells it. (Each form of a program defines it: as_stock/CMakeLists.txt.)
extern const bool kAhead;

inline uint32_t Bits(float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// As long as one lives, what is installed holds every pair by this structure (nullptr: as games have it).
class PairsBy {
public:
    explicit PairsBy(const char *structure) {
        if (structure != nullptr)
            setenv("BOOMERANG_PAIRS_BY", structure, 1);
    }
    explicit PairsBy(bmr_structure structure) : PairsBy(bmr_structure_name(structure)) {}
    ~PairsBy() { unsetenv("BOOMERANG_PAIRS_BY"); }
    PairsBy(const PairsBy &) = delete;
    PairsBy &operator=(const PairsBy &) = delete;
};

/// What a scenario sees of the run that it is in.
class Run {
public:
    Run(int pipe, const bmr::Options *options) : m_pipe(pipe), m_options(options) {
        m_text.reserve(kBuffer + 1024); // so that printing allocates nothing later
    }
    ~Run() { Flush(); }

    bool HasPlugin() const { return m_options != nullptr; }
    /// Does it count? Then claims about counts may be made.
    bool Counts() const { return HasPlugin() && m_options->statistics; }
    /// Do contacts remember edges?
    bool RemembersEdges() const { return HasPlugin() && std::getenv("BOOMERANG_PAIRS_BY") == nullptr; }
    /// Does nothing in a stock run.
    void Install() {
        if (HasPlugin())
            Expect(bmr::Install(*m_options), "the first Install succeeds");
    }

    /// A line that must be the same in all runs.
    void Print(const char *format, ...) __attribute__((format(printf, 2, 3))) {
        char line[512];
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(line, sizeof line, format, arguments);
        va_end(arguments);
        m_text += line;
        m_text += '\n';
        if (m_text.size() > kBuffer)
            Flush();
    }
    /// What another run (of a thread, without a pipe) printed.
    void Take(Run *other) {
        Flush();
        m_text.swap(other->m_text);
        Flush();
    }
    /// A claim about the plugin's own doing: a failure of this run if it is false. Stock has none.
    void Expect(bool holds, const char *claim) {
        if (HasPlugin() && !holds)
            Print("!claim broken: %s", claim);
    }

private:
    static constexpr size_t kBuffer = 60000;

    void Flush() {
        for (size_t done = 0; done < m_text.size() && m_pipe >= 0;) {
            const ssize_t written = write(m_pipe, m_text.data() + done, m_text.size() - done);
            if (written <= 0)
                _exit(3);
            done += static_cast<size_t>(written);
        }
        if (m_pipe >= 0)
            m_text.clear();
    }

    int m_pipe;
    const bmr::Options *m_options;
    std::string m_text;
};

/// A world whose every step is printed. Bodies and fixtures are numbered as they are made.
class Game : private b2ContactListener {
public:
    explicit Game(Run &run, b2Vec2 gravity = {0.0f, 0.0f}) : world(gravity), m_run(run) {
        world.SetContactListener(this);
    }

    b2Body *Body(b2BodyType type, b2Vec2 position, float angle = 0.0f) {
        b2BodyDef def;
        def.type = type;
        def.position = position;
        def.angle = angle;
        def.linearDamping = 0.0f;
        def.userData.pointer = m_made++;
        return world.CreateBody(&def);
    }
    b2Fixture *Fixture(b2Body *body, const b2Shape &shape, bool sensor = false) {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = 1.0f;
        def.isSensor = sensor;
        def.userData.pointer = m_made++;
        return body->CreateFixture(&def);
    }
    b2Fixture *Box(b2Body *body, float halfWidth, float halfHeight, b2Vec2 center = {0.0f, 0.0f},
                   float angle = 0.0f) {
        b2PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight, center, angle);
        return Fixture(body, shape);
    }
    /// A plank of many boxes, four long and 0.2 thick, around `center` of its body: many, so that two planks
    /// have as many contacts as the glue may ask for before it gives them a structure. Only its pieces in
    /// [from, to) are made.
    void Plank(b2Body *body, b2Vec2 center = {0.0f, 0.0f}, int from = 0, int to = kPlankPieces) {
        constexpr float kHalf = 2.0f / static_cast<float>(kPlankPieces);
        for (int i = from; i < to; ++i)
            Box(body, kHalf, 0.1f,
                center + b2Vec2((2.0f * static_cast<float>(i) + 1.0f) * kHalf - 2.0f, 0.0f));
    }
    static constexpr int kPlankPieces = 10;

    void Step(int count = 1, float seconds = 1.0f / 60.0f) {
        for (int i = 0; i < count; ++i) {
            world.Step(seconds, 8, 3);
            Print();
        }
    }
    void Print() {
        for (const b2Body *b = world.GetBodyList(); b != nullptr; b = b->GetNext()) {
            const b2Transform &xf = b->GetTransform();
            const b2Vec2 c = b->GetWorldCenter(), v = b->GetLinearVelocity();
            m_run.Print("body %u: %08x %08x %08x %08x %08x %08x %08x %08x %08x %08x %d", Number(b),
                        Bits(xf.p.x), Bits(xf.p.y), Bits(xf.q.s), Bits(xf.q.c), Bits(c.x), Bits(c.y),
                        Bits(b->GetAngle()), Bits(v.x), Bits(v.y), Bits(b->GetAngularVelocity()),
                        b->IsAwake());
        }
        for (b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            m_run.Print("contact %u %u: touching %d", Number(c->GetFixtureA()), Number(c->GetFixtureB()),
                        c->IsTouching());
            Print(*c->GetManifold());
        }
    }
    void Print(const b2Manifold &m) {
        if (m.pointCount == 0)
            return;
        m_run.Print("  type %d %08x %08x %08x %08x", m.type, Bits(m.localNormal.x), Bits(m.localNormal.y),
                    Bits(m.localPoint.x), Bits(m.localPoint.y));
        for (int32 i = 0; i < m.pointCount; ++i) {
            const b2ManifoldPoint &p = m.points[i];
            m_run.Print("  point %08x %08x %08x %08x %08x", Bits(p.localPoint.x), Bits(p.localPoint.y),
                        Bits(p.normalImpulse), Bits(p.tangentImpulse), p.id.key);
        }
    }

    /// Scenarios about structures of bodies are void without one.
    void StagePairs() {
        if (m_run.Counts())
            m_run.Expect(bmr::internal::ReadCounts().structures > 0 &&
                             bmr::internal::ReadCounts().hullChecks > 0,
                         "a structure watches the bodies");
    }
    /// How many contacts touch between solid fixtures: scenarios check that what they stage takes place.
    int Touching() {
        int count = 0;
        for (b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext())
            count += c->IsTouching() && !c->GetFixtureA()->IsSensor() && !c->GetFixtureB()->IsSensor();
        return count;
    }
    /// Takes place in stock too: a staging mistake, not a difference.
    void Stage(bool holds, const char *what) {
        if (!holds)
            m_run.Print("!not staged: %s", what);
    }

    b2World world;

private:
    template <typename Object> static unsigned Number(const Object *object) {
        return static_cast<unsigned>(const_cast<Object *>(object)->GetUserData().pointer);
    }
    void Event(const char *name, b2Contact *c) {
        m_run.Print("%s %u %u", name, Number(c->GetFixtureA()), Number(c->GetFixtureB()));
    }
    void BeginContact(b2Contact *c) override { Event("begin", c); }
    void EndContact(b2Contact *c) override { Event("end", c); }
    void PreSolve(b2Contact *c, const b2Manifold *old) override {
        Event("presolve", c);
        Print(*old);
    }

    Run &m_run;
    unsigned m_made = 1;
};

/// Bytes that malloc has given out.
inline size_t BytesInUse() {
#if defined(FORKED_WORLD_ASAN)
    return __sanitizer_get_current_allocated_bytes();
#else
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

using Scenario = std::function<void(Run &)>;
enum class When { kBefore, kByScenario };

/// What a child printed, and how it ended appended where that was badly.
inline std::string InChild(const Scenario &scenario, const bmr::Options *options, When when) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    std::fflush(nullptr);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        close(ends[0]);
        mallopt(M_PERTURB, 0x5a); // memory that nobody initialised is no zeros
        {
            Run run(ends[1], options);
            if (when == When::kBefore)
                run.Install();
            scenario(run);
        }
#if defined(FORKED_WORLD_ASAN)
        if (__lsan_do_recoverable_leak_check() != 0)
            test_leave(4);
#endif
        test_leave(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[65536];
    for (ssize_t got; (got = read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<size_t>(got));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0)
        text += "!child ended with status " + std::to_string(status) + "\n";
    return text;
}

/// "" if the texts are the same, else the first difference and what was broken.
inline std::string Difference(const std::string &stock, const std::string &plugin) {
    std::string report;
    for (const std::string *text : {&stock, &plugin}) {
        for (size_t at = text->find('!'); at != std::string::npos; at = text->find('!', at + 1))
            report += text->substr(at, text->find('\n', at) - at) + "\n";
    }
    size_t from = stock == plugin ? std::string::npos : 0;
    for (int line = 1; from != std::string::npos; ++line) {
        const size_t a = stock.find('\n', from), b = plugin.find('\n', from);
        if (stock.compare(from, a - from, plugin, from, b - from) != 0 || a != b) {
            report += "line " + std::to_string(line) + "\nstock:  " + stock.substr(from, a - from) +
                      "\nplugin: " + plugin.substr(from, b - from) + "\n";
            break;
        }
        from = a == std::string::npos ? a : a + 1;
    }
    return report;
}

/// The claim of nearly every test here.
inline void CheckSameAsStock(const Scenario &scenario, When when = When::kBefore) {
    const std::string stock = InChild(scenario, nullptr, when);
    CHECK(stock.size() > 0);
    REQUIRE(Difference(stock, stock) == "");
    // A brief run takes half of the settings.
    const char *const kStructures[] = {nullptr, "lazy-compass", "lazy-dudley", "free-direction"};
    const bool all = test_scaled(8) >= 4;
    for (int i = 0; i < 8; ++i) {
        const bool statistics = i / 4 != 0;
        const char *const structure = kStructures[i % 4];
        if (!all && (i % 4 + statistics) % 2 == 0)
            continue;
        const PairsBy by(structure);
        bmr::Options options;
        options.statistics = statistics;
        const std::string plugin = InChild(scenario, &options, when);
        const std::string name = structure != nullptr ? structure : "";
        CAPTURE(name);
        CAPTURE(statistics);
        CHECK(Difference(stock, plugin) == "");
    }
}

} // namespace forked

/// A test case that is one scenario: SAME_AS_STOCK("name") { Game game(run); ... }
#define SAME_AS_STOCK_OF(scenario, name)                                                                     \
    static void scenario(forked::Run &run);                                                                  \
    TEST_CASE(name) {                                                                                        \
        forked::CheckSameAsStock(scenario);                                                                  \
    }                                                                                                        \
    static void scenario(forked::Run &run)
#define SAME_AS_STOCK(name) SAME_AS_STOCK_OF(DOCTEST_ANONYMOUS(scenario_), name)

#endif
