// SPDX-License-Identifier: MIT
//
//   games list                                          the named games, one a line
//   games NAME [dump STEP]
//   games random FIRST COUNT STEPS [dump SEED STEP]
//
// Plays and prints a line for each step: the game or the seed, the step, and for each world the hashes of its
// bodies, contacts, events and of what the game saw beside. `dump` prints the whole state after one step
// instead. On stderr, at the end: what random games did. An ending of its own: 0, or 2 where it was asked for
// something that there is not.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "install.h"
#include "playing.h"
#include "random_game.h"

using namespace box2d_builds;

namespace {

void Print(Playing &playing) {
    const testbed::StateHashes h = playing.Hashes();
    std::printf(" %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64, h.bodies, h.contacts, h.events,
                playing.TheGame().Probes());
}

/// One or two worlds at once, step by step. `dumpStep` < 0: hashes.
void Play(const char *name, std::unique_ptr<Playing> (&all)[2], int steps, int dumpStep) {
    for (int step = 0; step < steps; ++step) {
        for (std::unique_ptr<Playing> &playing : all)
            if (playing != nullptr)
                playing->Step(step, step == dumpStep);
        if (dumpStep < 0)
            std::printf("%s %d", name, step);
        for (std::unique_ptr<Playing> &playing : all) {
            if (playing != nullptr && dumpStep < 0)
                Print(*playing);
            else if (playing != nullptr && dumpStep == step)
                std::printf("%s", playing->Describe().c_str());
        }
        if (dumpStep < 0)
            std::printf("\n");
        std::fflush(stdout); // a crash shall not take the lines with it
    }
}

int PlayRandom(int argc, char **argv) {
    if (argc != 5 && !(argc == 8 && std::strcmp(argv[5], "dump") == 0))
        return 2;
    const long first = std::atol(argv[2]), count = std::atol(argv[3]);
    const int steps = std::atoi(argv[4]);
    const long dumpSeed = argc == 8 ? std::atol(argv[6]) : -1;
    Deeds deeds;
    for (long seed = first; seed < first + count; ++seed) {
        if (dumpSeed >= 0 && dumpSeed != seed)
            continue;
        std::unique_ptr<Playing> all[2];
        const int worlds = seed % 2 == 0 ? 1 : 2;
        for (int i = 0; i < worlds; ++i)
            all[i] = std::make_unique<Playing>(std::make_unique<RandomGame>(seed),
                                               static_cast<unsigned long>(1000003 * i + seed));
        if (worlds == 2)
            all[0]->TheGame().SetOther(all[1].get());
        Play(std::to_string(seed).c_str(), all, steps, argc == 8 ? std::atoi(argv[7]) : -1);
        for (int i = 0; i < worlds; ++i)
            deeds += static_cast<RandomGame &>(all[i]->TheGame()).Done();
    }
    deeds.Print(stderr);
    return 0;
}

int PlayNamed(const std::vector<GameInfo> &games, int argc, char **argv) {
    for (const GameInfo &game : games) {
        if (std::strcmp(game.name, argv[1]) != 0)
            continue;
        std::unique_ptr<Playing> all[2];
        all[0] = std::make_unique<Playing>(game.create(), 1);
        Play(game.name, all, game.steps, argc == 4 ? std::atoi(argv[3]) : -1);
        return 0;
    }
    std::fprintf(stderr, "no game '%s'\n", argv[1]);
    return 2;
}

} // namespace

int main(int argc, char **argv) {
    std::vector<GameInfo> games;
    AddDisabling(games);
    AddShapes(games);
    AddSteps(games);
    if (argc < 2) {
        std::fprintf(stderr,
                     "usage: games list | NAME [dump STEP] | random FIRST COUNT STEPS [dump SEED STEP]\n");
        return 2;
    }
    if (std::strcmp(argv[1], "list") == 0) {
        for (const GameInfo &game : games)
            if (kReleased || !game.released)
                std::printf("%s\n", game.name);
        return 0;
    }
    InstallPlugin();
    const int status =
        std::strcmp(argv[1], "random") == 0 ? PlayRandom(argc, argv) : PlayNamed(games, argc, argv);
#if defined(BOX2D_BUILDS_ALLOCATOR)
    std::fprintf(stderr, "blocks %lu\n", box2dBlocks);
#endif
    return status;
}
