// SPDX-License-Identifier: MIT
// The actor's bytes from libFuzzer or a corpus: played here, with the plugin in front of Box2D and all hooks
// on, and by a stock Box2D in another process. After every step all bodies, contacts, events and answers must
// have the same bits. Stock plays twice, in memory of other contents: what that decides is no difference.
//
// Of polygons of more than eight vertices there is no stock. Those scripts are played against the plugin
// without its hooks.
//
// The plugin's environment (BOOMERANG=verify) sets what is tested. BMR_FUZZ_ENDINGS=1: says at the end what
// was played. BMR_FUZZ_MODULES: a directory with actor_stock and libactor_poison.so, instead of where they
// were built. Controls: one-ulp, and of sanitized builds freed-read.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include <boomerang/box2d.h>
#include <fcntl.h>
#include <unistd.h>

#include "actor.h"
#include "debug/statistics.h"
#include "harness.h"
#include "plugin.h"

#if defined(BOOMERANG_FUZZ_POISON)
#    include <sanitizer/common_interface_defs.h>
#endif

namespace {

using namespace actor;

struct {
    unsigned long scripts = 0, records = 0, anySize = 0;
} played;

void SayEndings() {
    const bmr::Counted s = bmr::internal::ReadCounts();
    std::fprintf(stderr, "%lu scripts (%lu of any size), %lu steps;", played.scripts, played.anySize,
                 played.records);
    bmr::VisitCounts(
        [](const char *name, uint64_t count) { std::fprintf(stderr, " %s %" PRIu64, name, count); }, s);
    std::fputc('\n', stderr);
}

/// A program that runs for hours keeps copies of its own.
std::string Built(const char *path) {
    const char *elsewhere = std::getenv("BMR_FUZZ_MODULES");
    return elsewhere != nullptr ? elsewhere + std::string(std::strrchr(path, '/')) : std::string(path);
}

void ServeAsStock(int in, int out, const char *poison) {
    const std::string program = Built(BOOMERANG_ACTOR_STOCK),
                      preloaded = "LD_PRELOAD=" + Built(BOOMERANG_ACTOR_POISON);
    const std::string byte = std::string("BMR_ACTOR_POISON=") + poison,
                      perturb = std::string("MALLOC_PERTURB_=") + poison;
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    const char *words[] = {program.c_str(), "serve", nullptr};
    const char *environment[] = {preloaded.c_str(), byte.c_str(), perturb.c_str(),
                                 "LLVM_PROFILE_FILE=/dev/null", nullptr};
    execve(program.c_str(), const_cast<char **>(words), const_cast<char **>(environment));
    std::perror(program.c_str());
}

void ServeSwitchedOff(int in, int out) {
    setenv("BOOMERANG", "off", 1);
    Install();
    Serve(in, out);
}

/// The servers, started before the plugin is at work here.
struct Servers {
    Server stock{[](int in, int out) { ServeAsStock(in, out, "165"); }};
    Server stockAgain{[](int in, int out) { ServeAsStock(in, out, "85"); }};
    Server switchedOff{ServeSwitchedOff};
    Servers() {
        Install();
        if (std::getenv("BMR_FUZZ_ENDINGS") != nullptr)
            std::atexit(SayEndings);
    }
};

bool Same(const Record &a, const Record &b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

std::vector<Record> Expected(const uint8_t *data, size_t size, int dumpAt = -1, std::string *dump = nullptr) {
    static Servers servers;
    if (Actor::AsksForAnySize(data, size))
        return servers.switchedOff.Ask(data, size, dumpAt, dump);
    std::vector<Record> records = servers.stock.Ask(data, size, dumpAt, dump);
    const std::vector<Record> again = servers.stockAgain.Ask(data, size);
    size_t same = 0;
    while (same < records.size() && same < again.size() && Same(records[same], again[same]))
        ++same;
    records.resize(same);
    return records;
}

/// The next line that is about an object of the kind; "" if there is none.
std::string NextLine(std::istream &dump, const std::string &kind) {
    std::string line;
    while (std::getline(dump, line) && line.compare(0, kind.size(), kind) != 0)
        line.clear();
    return line;
}

/// Says the first field that is another: of contacts first, whose impulses move the bodies.
[[noreturn]] void Differ(const uint8_t *data, size_t size, int at) {
    std::string dump;
    Expected(data, size, at, &dump);
    Actor player(data, size);
    player.dumpAt = at;
    for (Record record; player.dump.empty() && player.PlayOn(&record);) {
    }
    for (const char *kind : {"contact ", "body ", "event "}) {
        std::istringstream stock(dump), plugin(player.dump);
        for (std::string a = kind, b; !a.empty();) {
            a = NextLine(stock, kind);
            b = NextLine(plugin, kind);
            FUZZ_CHECK(a == b, "record %d\nstock:  %s\nplugin: %s", at, a.c_str(), b.c_str());
        }
    }
    fuzz_fail("record %d: other answers", at);
}

#if defined(BOOMERANG_FUZZ_POISON)
void ReadFreed() {
    // The sanitizer is to end the process there, which is what the control looks for.
    __sanitizer_set_death_callback([] { fuzz_fail("a freed block was read"); });
    if (const volatile char *freed = static_cast<const volatile char *>(LastFreed()))
        std::fprintf(stderr, "%d\n", *freed);
}
#endif

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const std::vector<Record> expected = Expected(data, size);
    ++played.scripts;
    played.records += expected.size();
    played.anySize += Actor::AsksForAnySize(data, size);
    if (expected.empty()) // not one action: it may be what Box2D does not allow
        return 0;

    std::vector<Record> found;
    {
        Actor player(data, size);
        if (fuzz_control("one-ulp"))
            player.perturbAt = static_cast<int>(expected.size() / 2);
        for (Record record; found.size() < expected.size() && player.PlayOn(&record);)
            found.push_back(record);
    }
#if defined(BOOMERANG_FUZZ_POISON)
    if (fuzz_control("freed-read"))
        ReadFreed();
#endif
    FUZZ_CHECK(bmr::internal::ReadCounts().differences == 0, "verify: differences");
    for (size_t i = 0; i < expected.size() && i < found.size(); ++i)
        if (!Same(expected[i], found[i]))
            Differ(data, size, static_cast<int>(i));
    FUZZ_CHECK(found.size() == expected.size(), "%zu records of %zu", found.size(), expected.size());
    return 0;
}
