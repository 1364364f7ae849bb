// SPDX-License-Identifier: MIT
//
//   threads_forking installing | shapes [ROUNDS]
//
// Forks while another thread is in the middle of what the process has locks for: the child, which has that
// thread no more, steps worlds and makes shapes like any other. `installing`: in the plugin's start at the
// first step, which it is held up in by an environment that is slow to read. `shapes`: somewhere in the
// making and freeing of shapes. Exit status 1: a child stood still or went wrong.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

std::atomic<bool> slow{false}, inside{false};

void Pause(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

} // namespace

/// In front of libc's: the plugin asks for its settings in the middle of Install.
extern "C" __attribute__((visibility("default"))) char *secure_getenv(const char *name) noexcept {
    if (slow && std::strcmp(name, "BOOMERANG_STRUCTURE") == 0) {
        inside = true;
        Pause(50);
    }
    return std::getenv(name);
}

namespace {

constexpr unsigned kPatience = 10; // seconds, for what takes a thousandth of one

/// A heap of boxes and round ones; is it at work, and does it come to rest where it should?
bool PlayWorld() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2PolygonShape box;
    box.SetAsBox(20.0f, 0.5f);
    world.CreateBody(&def)->CreateFixture(&box, 0.0f);
    box.SetAsBox(0.4f, 0.4f);
    bmr::ConvexShape coin;
    if (coin.SetRegular(40, 0.4f) != BMR_OK)
        return false;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 8; ++i) {
        def.position.Set(0.1f * static_cast<float>(i), 1.0f + static_cast<float>(i));
        b2Body *body = world.CreateBody(&def);
        if (i % 2 == 0)
            body->CreateFixture(&box, 1.0f);
        else
            body->CreateFixture(&coin, 1.0f);
    }
    for (int step = 0; step < 30; ++step)
        world.Step(1.0f / 60.0f, 8, 3);
    return bmr::IsInstalled() && world.GetContactCount() > 0 && world.GetBodyList()->GetPosition().y < 9.0f;
}

/// `play` in a forked child; false where it does not come back well.
bool InChild(bool (*play)()) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(kPatience);
        _exit(play() ? 0 : 1);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        return false;
    if (status != 0)
        std::printf("FAILED: a child ended with status %d%s\n", status,
                    WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? ": it stood still" : "");
    return status == 0;
}

/// To be called in a process that has not installed anything yet.
bool ForkWhileInstalling() {
    slow = true;
    bool played = false;
    std::thread first([&played] { played = PlayWorld(); });
    while (!inside)
        std::this_thread::yield();
    const bool child = InChild([] {
        slow = false;
        return PlayWorld();
    });
    first.join();
    return child && played && PlayWorld();
}

bool ForkWhileShapesAreMade(int rounds) {
    std::atomic<bool> done{false};
    std::atomic<unsigned> made{0};
    const auto make = [&done, &made] {
        for (bmr::ConvexShape shape; !done; ++made) {
            if (shape.SetRegular(9, 1.0f) != BMR_OK || shape.SetAsBox(1.0f, 1.0f) != BMR_OK)
                std::abort();
        }
    };
    std::thread makers[] = {std::thread(make), std::thread(make)};
    bool well = true;
    for (int round = 0; round < rounds && well; ++round) {
        const unsigned before = made;
        while (made == before)
            std::this_thread::yield();
        well = InChild(PlayWorld);
    }
    done = true;
    for (std::thread &maker : makers)
        maker.join();
    return well;
}

} // namespace

int main(int argc, char **argv) {
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 1;
    bool well = true;
    if (argc > 1 && std::strcmp(argv[1], "shapes") == 0) {
        well = PlayWorld() && ForkWhileShapesAreMade(rounds);
    } else if (argc > 1 && std::strcmp(argv[1], "installing") == 0) {
        for (int round = 0; round < rounds && well; ++round)
            well = InChild(ForkWhileInstalling); // each installs anew
    } else {
        std::printf("usage: installing | shapes [ROUNDS]\n");
        return 2;
    }
    std::printf(well ? "passed\n" : "FAILED\n");
    return !well;
}
