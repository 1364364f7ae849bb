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
#include "game.h"
#include "state/snapshot.h"

using namespace box2d_builds;

namespace {

/// A game while it is played: its world, and a record of all that can be seen of it.
class Playing {
public:
    Playing(std::unique_ptr<Game> game, unsigned long seed)
        : m_game(std::move(game)), m_stage(*m_game, seed, &m_recorder) {
        m_recorder.StartStep(false);
        m_game->Build(m_stage, kSize);
    }
    Playing(const Playing &) = delete;
    Playing &operator=(const Playing &) = delete;

    Game &TheGame() { return *m_game; }

    /// What the game does between steps, and a step. `inWords`: its events are kept as text, too.
    void Step(int step, bool inWords) {
        m_recorder.StartStep(inWords);
        m_game->BeforeStep(m_stage, step);
        m_stage.World().Step(1.0f / 60.0f, 8, 3);
    }

    testbed::StateHashes Hashes() { return testbed::HashState(m_stage.World(), m_recorder); }
    std::string Describe() { return testbed::DescribeState(m_stage.World(), m_recorder); }

private:
    static constexpr int kSize = 12;

    // In this order: the world goes first, and tells the game of its joints.
    std::unique_ptr<Game> m_game;
    testbed::EventRecorder m_recorder;
    testbed::Stage m_stage;
};

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

int PlayNamed(int argc, char **argv) {
    for (const GameInfo &game : kGames) {
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
    if (argc < 2) {
        std::fprintf(stderr, "usage: games list | NAME [dump STEP] | random SEED [dump STEP]\n");
        return 2;
    }
    if (std::strcmp(argv[1], "list") == 0) {
        for (const GameInfo &game : kGames)
            std::printf("%s\n", game.name);
        return 0;
    }
    InstallPlugin();
    const int status = std::strcmp(argv[1], "random") == 0 ? PlayRandom(argc, argv) : PlayNamed(argc, argv);
#if defined(BOX2D_BUILDS_ALLOCATOR)
    std::fprintf(stderr, "blocks %lu\n", box2dBlocks);
#endif
    return status;
}
