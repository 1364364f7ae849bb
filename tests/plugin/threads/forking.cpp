// SPDX-License-Identifier: MIT
//
//   threads_forking installing | shapes [ROUNDS]
//
// Forks while another thread is in the middle of what the process has locks for: the child, which has that
// thread no more, steps worlds and makes shapes like any other. `installing`: in the plugin's start at the
// first step, which is held up in an environment that is read no sooner than the fork is under way.
// `shapes`: somewhere in the making and freeing of shapes, as often as ROUNDS says: where exactly is luck, so
// a lock that is forgotten shows in one of many. Exit status 1: a child stood still or went wrong.
//
// No clock decides. A thread that waits for a lock is asleep, says the kernel, however busy the machine is.
#include <atomic>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

std::atomic<bool> slow{false}, inside{false}, forking{false}, forked{false};

/// Is the thread of the process asleep? (The state stands behind the last parenthesis.)
bool Sleeps(pid_t process, pid_t thread) {
    char path[64], text[512];
    std::snprintf(path, sizeof path, "/proc/%d/task/%d/stat", process, thread);
    const int file = open(path, O_RDONLY);
    if (file < 0)
        return false;
    const ssize_t length = read(file, text, sizeof text - 1);
    close(file);
    text[length > 0 ? length : 0] = '\0';
    const char *name = std::strrchr(text, ')');
    return name != nullptr && name[1] == ' ' && name[2] == 'S';
}

/// Whenever it was looked at, many times one after another: not for a moment, but until somebody wakes it.
bool StandsStill(pid_t process, pid_t thread) {
    constexpr int kLooks = 100;
    for (int i = 0; i < kLooks; ++i) {
        if (!Sleeps(process, thread))
            return false;
        usleep(100);
    }
    return true;
}

} // namespace

/// In front of libc's: the plugin asks for its settings in the middle of Install. There it stays until the
/// first thread is in fork() and waits for it, or has forked without waiting.
extern "C" __attribute__((visibility("default"))) char *secure_getenv(const char *name) noexcept {
    if (slow && std::strcmp(name, "BOOMERANG_PAIRS_BY") == 0) {
        inside = true;
        while (!forked && !(forking && StandsStill(getpid(), getpid())))
            std::this_thread::yield();
    }
    return std::getenv(name);
}

namespace {

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

/// The status with which a child ends that has one thread and waits for nothing: where it stands still, it
/// does so for ever, and is ended with SIGALRM.
int EndOf(pid_t child) {
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child)
            return status;
        if (ended < 0)
            return -1;
        if (StandsStill(child, child))
            kill(child, SIGALRM);
        usleep(100);
    }
}

bool EndedWell(int status) {
    if (status != 0)
        std::printf("FAILED: a child ended with status %d%s\n", status,
                    WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? ": it stood still" : "");
    return status == 0;
}

/// `play` in a forked child; false where it does not come back well.
bool InChild(bool (*play)()) {
    forking = true;
    const pid_t child = fork();
    if (child == 0)
        _exit(play() ? 0 : 1);
    forked = true;
    return child > 0 && EndedWell(EndOf(child));
}

/// The same with a child that has children and threads itself, and waits for them.
bool InChildThatWaits(bool (*play)()) {
    const pid_t child = fork();
    if (child == 0)
        _exit(play() ? 0 : 1);
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && EndedWell(status);
}

/// To be called in a process that has not installed anything yet.
bool ForkWhileInstalling() {
    slow = true;
    bool played = false;
    std::atomic<pid_t> number{0};
    std::thread first([&played, &number] {
        number = gettid();
        // The start, and no allocation between it and the fork: the thread sanitizer's allocator does not
        // survive a fork in its midst. (Rounded so, the step is Box2D's.)
        b2World empty(b2Vec2(0.0f, 0.0f));
        std::fesetround(FE_UPWARD);
        empty.Step(1.0f / 60.0f, 8, 3);
        std::fesetround(FE_TONEAREST);
        while (!forked)
            std::this_thread::yield();
        played = PlayWorld();
    });
    while (!inside) {
        if (number != 0 && !inside && StandsStill(getpid(), number) && !inside) {
            std::printf("FAILED: the first step stands still\n");
            std::fflush(stdout);
            _exit(1);
        }
        std::this_thread::yield();
    }
    const bool child = InChild([] {
        slow = false;
        return PlayWorld();
    });
    first.join();
    return child && played && PlayWorld();
}

/// Takes the lock of the register of polygons, more than once.
bool MakeShape() {
    bmr::ConvexShape shape;
    return shape.SetRegular(9, 1.0f) == BMR_OK && shape.GetVertexCount() == 9;
}

bool ForkWhileShapesAreMade(int rounds) {
    std::atomic<bool> done{false};
    std::atomic<unsigned> made{0};
    // Most of the calls fail at the first vertex, after the lock was taken and before the work is done: in
    // about every eighth round somebody has the lock.
    b2Vec2 nowhere[9];
    nowhere[0].Set(NAN, 0.0f);
    const auto make = [&done, &made, &nowhere] {
        for (bmr::ConvexShape shape; !done; ++made) {
            for (int i = 0; i < 100; ++i)
                if (shape.SetRaw(nowhere, 9) == BMR_OK)
                    std::abort();
            if (!MakeShape())
                std::abort();
        }
    };
    std::thread makers[] = {std::thread(make), std::thread(make)};
    bool well = true;
    for (int round = 0; round < rounds && well; ++round) {
        const unsigned before = made;
        while (made == before)
            std::this_thread::yield();
        well = InChild(round % 16 == 0 ? PlayWorld : MakeShape);
        if (!well)
            std::printf("in round %d\n", round);
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
            well = InChildThatWaits(ForkWhileInstalling); // each installs anew
    } else {
        std::printf("usage: installing | shapes [ROUNDS]\n");
        return 2;
    }
    std::printf(well ? "passed\n" : "FAILED\n");
    return !well;
}
