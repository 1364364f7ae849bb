// SPDX-License-Identifier: MIT
//
//   games SEED [dump STEP]
//
// A plain Box2D program: plays a world of the actor's and prints a line for each step: the seed, the step,
// and hashes of bodies, contacts, events and answers. `dump` prints the whole state after one step, too, on
// stderr. At the end it says on stderr what its listeners did, and how often.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "actor.h"

/// All that a game does differently which knows of the plugin; called before the first step (plugin.cpp).
void InstallPlugin();

int main(int argc, char **argv) {
    if (argc != 2 && !(argc == 4 && std::strcmp(argv[2], "dump") == 0)) {
        std::fprintf(stderr, "usage: games SEED [dump STEP]\n");
        return 2;
    }
    InstallPlugin();
    const std::vector<uint8_t> bytes =
        actor::BytesOf(static_cast<uint32_t>(std::strtoul(argv[1], nullptr, 10)));
    actor::Actor player(bytes.data(), bytes.size());
    player.dumpAt = argc == 4 ? std::atoi(argv[3]) : -1;
    int step = 0;
    for (actor::Record r; player.PlayOn(&r); ++step) {
        std::printf("%s %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", argv[1], step,
                    r.bodies, r.contacts, r.events, r.probes);
        std::fflush(stdout); // a crash shall not take the lines with it
    }
    std::fputs(player.dump.c_str(), stderr);
    for (uint32_t i = 0; i < actor::kReactionCount; ++i)
        if (const uint64_t done = actor::reactionsDone[i])
            std::fprintf(stderr, "did \"%s\" %" PRIu64 "\n", actor::kReactions[i].name, done);
#if defined(BOX2D_BUILDS_ALLOCATOR)
    std::fprintf(stderr, "blocks %lu\n", box2dBlocks);
#endif
    return 0;
}
