// SPDX-License-Identifier: MIT
//
//   games list                                          the named games, one a line
//   games NAME [dump STEP]
//   games random SEED [dump STEP]                       a world of the actor's
//
// Plays and prints a line for each step: the game or the seed, the step, and for each world the hashes of its
// bodies, contacts, events and of what the game saw beside. `dump` prints the whole state after one step
// instead. An ending of its own: 0, or 2 where it was asked for something that there is not.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "actor.h"
#include "install.h"
#include "playing.h"

using namespace box2d_builds;

namespace {

void Print(Playing &playing) {
    const testbed::StateHashes h = playing.Hashes();
    std::printf(" %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64, h.bodies, h.contacts, h.events,
                playing.TheGame().Probes());
}

/// Step by step. `dumpStep` < 0: hashes.
void Play(const char *name, Playing &playing, int steps, int dumpStep) {
    for (int step = 0; step < steps; ++step) {
        playing.Step(step, step == dumpStep);
        if (dumpStep < 0)
            std::printf("%s %d", name, step);
        if (dumpStep < 0)
            Print(playing);
        else if (dumpStep == step)
            std::printf("%s", playing.Describe().c_str());
        if (dumpStep < 0)
            std::printf("\n");
        std::fflush(stdout); // a crash shall not take the lines with it
    }
}

int PlayRandom(int argc, char **argv) {
    if (argc != 3 && !(argc == 5 && std::strcmp(argv[3], "dump") == 0))
        return 2;
    const std::vector<uint8_t> bytes =
        actor::BytesOf(static_cast<uint32_t>(std::strtoul(argv[2], nullptr, 10)));
    actor::Actor player(bytes.data(), bytes.size());
    player.dumpAt = argc == 5 ? std::atoi(argv[4]) : -1;
    int step = 0;
    for (actor::Record r; player.PlayOn(&r); ++step) {
        std::printf("%s %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", argv[2], step,
                    r.bodies, r.contacts, r.events, r.probes);
        std::fflush(stdout); // a crash shall not take the lines with it
    }
    return 0;
}

int PlayNamed(const std::vector<GameInfo> &games, int argc, char **argv) {
    for (const GameInfo &game : games) {
        if (std::strcmp(game.name, argv[1]) != 0)
            continue;
        Playing playing(game.create(), 1);
        Play(game.name, playing, game.steps, argc == 4 ? std::atoi(argv[3]) : -1);
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
        std::fprintf(stderr, "usage: games list | NAME [dump STEP] | random SEED [dump STEP]\n");
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
