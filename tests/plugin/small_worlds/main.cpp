// SPDX-License-Identifier: MIT
// Steps small worlds: for their hashes, or for the time that a step takes.
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "small_worlds/worlds.h"

namespace {

constexpr char kUsage[] =
    "usage: small_worlds list\n"
    "       small_worlds hash STEPS       a line for each world\n"
    "       small_worlds time NAME FROM STEPS\n"
    "           microseconds of the first step, and of a step from FROM on, STEPS of them\n";

/// Of this thread: other programs' turns are not counted.
double Microseconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void Play(const SmallWorld &what, b2World &world, int step) {
    if (what.play != nullptr)
        what.play(world, step);
    world.Step(1.0f / 60.0f, 8, 3);
}

void PrintHash(const SmallWorld &what, int steps) {
    b2World world({0.0f, -what.gravity});
    what.build(world);
    Hash hash;
    for (int step = 0; step < steps; ++step) {
        Play(what, world, step);
        hash.Add(world);
    }
    Print(what.name, hash);
}

void PrintTime(const SmallWorld &what, int from, int steps) {
    b2World world({0.0f, -what.gravity});
    what.build(world);
    const double before = Microseconds();
    Play(what, world, 0);
    const double first = Microseconds() - before;
    for (int step = 1; step < from; ++step)
        Play(what, world, step);
    const double begun = Microseconds();
    for (int step = from; step < from + steps; ++step)
        Play(what, world, step);
    std::printf("%s %.2f %.5f\n", what.name, first, (Microseconds() - begun) / steps);
}

template <typename Act> void ForEach(const Act &act) {
    for (const SmallWorld *worlds : {kLooseWorlds, kJointedWorlds})
        for (const SmallWorld *what = worlds; what->name != nullptr; ++what)
            act(*what);
}

} // namespace

int main(int argc, char **argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    bool done = false;
    if (command == "list" && argc == 2)
        ForEach([&done](const SmallWorld &what) { done = std::puts(what.name) >= 0; });
    else if (command == "hash" && argc == 3)
        ForEach([&done, argv](const SmallWorld &what) {
            PrintHash(what, std::atoi(argv[2]));
            done = true;
        });
    else if (command == "time" && argc == 5)
        ForEach([&done, argv](const SmallWorld &what) {
            if (std::string_view(what.name) != argv[2])
                return;
            PrintTime(what, std::atoi(argv[3]), std::atoi(argv[4]));
            done = true;
        });
    if (!done)
        std::fputs(kUsage, stderr);
    return done ? 0 : 2;
}
