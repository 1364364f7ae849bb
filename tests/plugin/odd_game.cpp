// SPDX-License-Identifier: MIT
// Games that live oddly:
//
//   odd_game endless                             steps until it is ended from outside; says when it has begun
//   odd_game ending                              steps worlds while its threads and itself come to their end
//   odd_game forking EARLIER LATER [abruptly]    forks after EARLIER steps; both go on for LATER steps
//   odd_game opening [LIBRARY]                   opens a library when it has a world with contacts, and
//   closes it
#include <cstdlib>
#include <cstring>
#include <memory>
#include <thread>

#include <dlfcn.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../kit/small_world.h"

namespace {

/// Two wheels, with enough fixtures for a table of their contacts.
void Fill(b2World &world, int fixtures) {
    FillWithBoxes(world);
    AddWheel(world, {0.0f, 16.0f}, fixtures, 1.0f);
    AddWheel(world, {0.4f, 18.5f}, fixtures, 1.0f);
}

int PlayEndless() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    Hash hash;
    for (uint64_t round = 0;; ++round) {
        Step(world, 1, &hash);
        if (round == 9)
            Print("played", hash);
        usleep(2000); // as a game waits for its screen
    }
}

/// Steps on where it dies: in the destructor of a thread_local that is older than any which a step makes, of
/// a thread's key, of a static object, and in an exit handler.
struct Dying {
    explicit Dying(const char *said) : name(said) {}
    ~Dying() {
        if (world != nullptr)
            StepOn();
    }
    Dying(const Dying &) = delete;
    Dying &operator=(const Dying &) = delete;

    void Begin() {
        world = std::make_unique<b2World>(b2Vec2(0.0f, -10.0f));
        Fill(*world, 24);
        Step(*world, kSteps, &hash);
    }
    void StepOn() {
        // Memory that was freed by now is overwritten.
        for (const size_t size :
             {size_t{64}, size_t{8192}, sizeof(b2World), size_t{150000}, size_t{200000}}) {
            void *taken = std::malloc(size);
            std::memset(taken, 0x5a, size);
            std::free(taken);
        }
        Step(*world, kSteps, &hash);
        Print(name, hash);
    }

    static constexpr int kSteps = 40;
    const char *name;
    Hash hash;
    std::unique_ptr<b2World> world;
};

Dying inStatic("in a static object's destructor");
Dying atExit("in an exit handler");

int PlayEnding() {
    std::atexit([] {
        atExit.StepOn();
        atExit.world = nullptr;
    });
    std::thread([] {
        static thread_local Dying inThreadLocal("in a thread_local's destructor");
        inThreadLocal.Begin();
    }).join();
    std::thread([] {
        pthread_key_t key;
        pthread_key_create(&key, [](void *dying) { delete static_cast<Dying *>(dying); });
        auto *dying = new Dying("in the destructor of a thread's key");
        pthread_setspecific(key, dying);
        dying->Begin();
    }).join();
    inStatic.Begin();
    atExit.Begin();
    return 0;
}

/// Each prints what happened; the child first, which takes one step more than its parent.
int PlayForking(int earlier, int later, bool abruptly) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Fill(world, 16);
    Hash hash;
    Step(world, earlier, &hash);
    const pid_t child = fork();
    if (child < 0)
        return 3;
    if (child == 0) {
        Step(world, 1 + later, &hash);
        Print("child", hash);
        std::exit(0);
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child || status != 0)
        return 4;
    Step(world, later, &hash);
    Print("parent", hash);
    if (abruptly)
        _exit(0);
    return 0;
}

/// The library's own environment says on, but Box2D is ahead of it.
bool Open(const char *library) {
    void *opened = dlopen(library, RTLD_NOW);
    if (opened == nullptr) {
        std::printf("%s\n", dlerror());
        return false;
    }
    const auto isInstalled = reinterpret_cast<bool (*)()>(dlsym(opened, "_ZN3bmr11IsInstalledEv"));
    const bool installed = isInstalled != nullptr && isInstalled();
    return dlclose(opened) == 0 && !installed;
}

int PlayOpening(const char *library) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Fill(world, 16);
    Hash hash;
    Step(world, 100, &hash);
    if (library != nullptr && !Open(library))
        return 1;
    Fill(world, 16);
    Step(world, 100, &hash);
    b2World another(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(another);
    Step(another, 100, &hash);
    Print("opened", hash);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    const auto is = [&](const char *how) { return argc > 1 && std::strcmp(argv[1], how) == 0; };
    if (is("endless"))
        return PlayEndless();
    if (is("ending"))
        return PlayEnding();
    if (is("forking") && argc > 3)
        return PlayForking(std::atoi(argv[2]), std::atoi(argv[3]), argc > 4);
    return is("opening") ? PlayOpening(argc > 2 ? argv[2] : nullptr) : 2;
}
