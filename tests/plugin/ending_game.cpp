// SPDX-License-Identifier: MIT
// A game that steps worlds while its threads and itself come to their end: from destructors of thread_locals
// that were made before anybody's who is met in a step, of a thread's key, of static objects, and from an
// exit handler.
#include <cstdlib>
#include <memory>
#include <thread>

#include <pthread.h>

#include "../kit/small_world.h"

namespace {

constexpr int kSteps = 40;

/// Steps on where it dies.
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
        FillWithBoxes(*world);
        // Enough fixtures on each of two bodies for the table of their contacts.
        AddWheel(*world, {0.0f, 20.0f}, 24, 1.5f);
        AddWheel(*world, {0.5f, 22.0f}, 24, 1.5f);
        Step(*world, kSteps, &hash);
    }
    void StepOn() {
        // What others have freed by now is somebody's by then.
        for (const size_t size :
             {size_t{64}, size_t{8192}, sizeof(b2World), size_t{150000}, size_t{200000}}) {
            void *taken = std::malloc(size);
            std::memset(taken, 0x5a, size);
            std::free(taken);
        }
        Step(*world, kSteps, &hash);
        Print(name, hash);
    }

    const char *name;
    Hash hash;
    std::unique_ptr<b2World> world;
};

Dying inStatic("in a static object's destructor");
Dying atExit("in an exit handler");

void RunThread() {
    static thread_local Dying inThreadLocal("in a thread_local's destructor");
    // Its destructor comes last: it is there before the first step.
    inThreadLocal.Begin();
}

void RunThreadWithKey() {
    pthread_key_t key;
    pthread_key_create(&key, [](void *dying) { delete static_cast<Dying *>(dying); });
    auto *dying = new Dying("in the destructor of a thread's key");
    pthread_setspecific(key, dying);
    dying->Begin();
}

} // namespace

int main() {
    std::atexit([] {
        atExit.StepOn();
        atExit.world = nullptr;
    });
    std::thread(RunThread).join();
    std::thread(RunThreadWithKey).join();
    inStatic.Begin();
    atExit.Begin();
    return 0;
}
