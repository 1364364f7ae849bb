// SPDX-License-Identifier: MIT
//
//   threads_stock  WAY THREADS STEPS
//   threads_plugin WAY THREADS STEPS
//
// Steps many worlds in one of several ways and prints a line of hashes for every step of each, world by
// world: what is printed depends neither on the way nor on the number of threads. The ways:
//
//   one-by-one    the main thread, a world after the other
//   at-once       each thread takes a world, makes it, steps it to its end, destroys it, and takes the next
//   handed-over   from thread to thread after each step
//   short-lived   a thread for a few steps, which then ends; the world lives on
//   counted       handed over, while another thread reads the statistics
//   installing    as at-once; every thread installs the plugin first, all at one moment
//   beside        as at-once; every other thread moves bodies of a world that is not stepped at first, while
//                 the others begin
//
// On stderr: how many calls installed the plugin. Exit status 1: a claim does not hold, which is said.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "worlds.h"
#if defined(WITH_PLUGIN)
#    include <boomerang/box2d.h>

#    include "debug/statistics.h"
#endif

namespace {

using threads::World;

#if defined(WITH_PLUGIN)

/// Did this call put the plugin to work?
bool Install(bool counting) {
    bmr::Options options;
    options.statistics = counting;
    return bmr::Install(options);
}
bool IsInstalled() {
    return bmr::IsInstalled();
}

/// Reads the statistics, which never go back. False where one did, or where they do not belong together.
struct StatisticsReader {
    bool Read() {
        const bmr::Counted s = bmr::internal::ReadCounts();
        const bool forward = s.steps >= steps && s.evaluations >= evaluations && s.differences == 0;
        steps = s.steps;
        evaluations = s.evaluations;
        return forward;
    }
    unsigned long long steps = 0, evaluations = 0; ///< as they were read last
};

#else // stock has nothing to install

bool Install(bool) {
    return false;
}
bool IsInstalled() {
    return true;
}
struct StatisticsReader {
    static bool Read() { return true; }
};

#endif

using Worlds = std::deque<World>;

std::atomic<int> failures{0};
std::atomic<int> installed{0};
std::atomic<bool> stepped{false}; // relaxed: it must not order what the plugin has to order

void Expect(bool holds, const char *claim) {
    if (!holds && ++failures < 10)
        std::fprintf(stderr, "FAILED: %s\n", claim);
}

/// All arrive, then all go on, as near to one moment as can be.
class Start {
public:
    explicit Start(int count) : m_missing(count) {}
    void Wait() {
        --m_missing;
        while (m_missing > 0)
            std::this_thread::yield();
    }

private:
    std::atomic<int> m_missing;
};

/// `work(number)` on so many threads.
void InParallel(int count, const std::function<void(int)> &work) {
    std::vector<std::thread> crew;
    for (int i = 0; i < count; ++i)
        crew.emplace_back(work, i);
    for (std::thread &member : crew)
        member.join();
}

void StepAll(World *world, int steps) {
    for (int i = 0; i < steps; ++i)
        world->Step();
}

void LiveWhole(World *world, int steps) {
    world->Build();
    world->Step();
    stepped.store(true, std::memory_order_relaxed);
    StepAll(world, steps - 1);
    world->Destroy();
}

/// Each thread takes the next world that no thread has had.
void ForEach(Worlds *worlds, std::atomic<size_t> *next, const std::function<void(World *)> &work) {
    for (size_t i; (i = next->fetch_add(1)) < worlds->size();)
        work(&(*worlds)[i]);
}

void AtOnce(Worlds *worlds, int count, int steps, const std::function<void(int)> &before) {
    Start start(count);
    std::atomic<size_t> next{0};
    InParallel(count, [&](int member) {
        start.Wait();
        before(member);
        ForEach(worlds, &next, [steps](World *world) { LiveWhole(world, steps); });
    });
}

/// What is to be done next, and whose turn it is to be taken.
class Line {
public:
    void Put(World *world, int left) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_waiting.push_back({world, left});
    }
    bool Take(World **world, int *left) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (m_waiting.empty())
            return false;
        *world = m_waiting.front().world;
        *left = m_waiting.front().left;
        m_waiting.pop_front();
        return true;
    }

private:
    struct Turn {
        World *world;
        int left;
    };
    std::mutex m_mutex;
    std::deque<Turn> m_waiting;
};

/// The first turn makes the world, the last destroys it, the others step it. (A thread that finds nobody
/// waiting is not needed any more: who holds a world goes on with it.)
void HandedOver(Worlds *worlds, int count, int steps) {
    Line line;
    for (World &world : *worlds)
        line.Put(&world, steps);
    InParallel(count, [&line, steps](int) {
        World *world;
        for (int left; line.Take(&world, &left);) {
            if (left == steps)
                world->Build();
            else
                world->Step();
            if (left > 0)
                line.Put(world, left - 1);
            else
                world->Destroy();
        }
    });
}

void ShortLived(Worlds *worlds, int count, int steps) {
    constexpr int kSteps = 7;
    for (World &world : *worlds)
        world.Build();
    for (int done = 0; done < steps; done += kSteps) {
        for (size_t first = 0; first < worlds->size(); first += static_cast<size_t>(count)) {
            const int batch = std::min(count, static_cast<int>(worlds->size() - first));
            InParallel(batch, [&](int member) {
                StepAll(&(*worlds)[first + static_cast<size_t>(member)], std::min(kSteps, steps - done));
            });
        }
    }
    for (World &world : *worlds)
        world.Destroy();
}

void Counted(Worlds *worlds, int count, int steps) {
    installed += Install(true);
    std::atomic<bool> done{false};
    std::thread reader([&done] {
        StatisticsReader statistics;
        do // once at least, however late this thread begins
            Expect(statistics.Read(), "statistics go forward and tell of no difference");
        while (!done);
    });
    HandedOver(worlds, count, steps);
    done = true;
    reader.join();
}

void InstallHere() {
    installed += Install(false);
    Expect(IsInstalled(), "when Install is back the plugin is installed, whoever did it");
}

/// Box2D is called, but nothing is stepped: before others begin to step, while they do, and after.
void MoveBodies() {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *body = world.CreateBody(&def);
    body->CreateFixture(&box, 1.0f);
    const auto move = [body](int count) {
        for (int i = 0; i < count; ++i)
            body->SetTransform({0.01f * static_cast<float>(i), 0.0f}, 0.1f * static_cast<float>(i));
    };
    while (!stepped.load(std::memory_order_relaxed))
        move(100);
    move(5001);
    Expect(body->GetFixtureList()->GetAABB(0).upperBound.x > 50.0f,
           "a body that is moved takes its box along");
}

bool Run(const char *way, Worlds *worlds, int count, int steps) {
    const auto is = [way](const char *name) { return std::strcmp(way, name) == 0; };
    if (is("one-by-one"))
        for (World &world : *worlds)
            LiveWhole(&world, steps);
    else if (is("at-once"))
        AtOnce(worlds, count, steps, [](int) {});
    else if (is("handed-over"))
        HandedOver(worlds, count, steps);
    else if (is("short-lived"))
        ShortLived(worlds, count, steps);
    else if (is("counted"))
        Counted(worlds, count, steps);
    else if (is("installing"))
        AtOnce(worlds, count, steps, [](int) { InstallHere(); });
    else if (is("beside"))
        AtOnce(worlds, count, steps, [](int member) {
            if (member % 2 == 1)
                MoveBodies();
        });
    else
        return false;
    return true;
}

} // namespace

int main(int argc, char **argv) {
    Worlds worlds;
    for (int i = 0; i < World::Count(); ++i)
        worlds.emplace_back(i);
    if (argc != 4 || !Run(argv[1], &worlds, std::atoi(argv[2]), std::atoi(argv[3]))) {
        std::fprintf(stderr, "usage: WAY THREADS STEPS\n");
        return 2;
    }
    for (const World &world : worlds)
        for (const std::string &line : world.Lines())
            std::printf("%s\n", line.c_str());
    std::fprintf(stderr, "installed %d\n", installed.load());
    return failures != 0;
}
