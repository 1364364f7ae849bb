// SPDX-License-Identifier: MIT
// The glue against Box2D. The bytes are a script (script.h) that drives two worlds twice: once in a stock
// Box2D that was loaded into a link namespace of its own (dlmopen), once here, with the plugin in front of
// Box2D and all hooks on. After every step all bodies, contacts and events must have the same bits.
//
// Of polygons of more than eight vertices there is no stock. Those scripts run against the plugin in a third
// namespace, with another structure and without remembered edges.
//
// The plugin's environment (BOOMERANG_STRUCTURE, BOOMERANG_PREFILTER, BOOMERANG_HOOKS, BOOMERANG=verify) sets
// what is tested. BMR_FUZZ_ENDINGS=1: says at the end how scripts ended. BMR_FUZZ_MODULES: a directory with
// the two modules, instead of where they were built. Controls: one-ulp, and of sanitized builds freed-read.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include <boomerang/box2d.h>
#include <dlfcn.h>

#include "harness.h"
#include "script.h"

#if defined(BOOMERANG_FUZZ_POISON)
#    include <sanitizer/common_interface_defs.h>

#    include "poison.h"
#endif

extern "C" fuzz_glue_run_function fuzz_glue_run;

namespace {

using namespace fuzz;

fuzz_glue_run_function *Load(const char *built) {
    // A program that runs for hours keeps copies of its own.
    const char *elsewhere = std::getenv("BMR_FUZZ_MODULES");
    const std::string library =
        elsewhere != nullptr ? elsewhere + std::string(std::strrchr(built, '/')) : std::string(built);
    void *opened = dlmopen(LM_ID_NEWLM, library.c_str(), RTLD_NOW | RTLD_LOCAL);
    void *found = opened != nullptr ? dlsym(opened, "fuzz_glue_run") : nullptr;
    if (found == nullptr) {
        std::fprintf(stderr, "%s\n", dlerror());
        std::exit(3);
    }
    return reinterpret_cast<fuzz_glue_run_function *>(found);
}

struct Endings {
    unsigned long scripts = 0, records = 0, notFinite = 0, differentSizes = 0;
    std::map<std::string, unsigned long> asserted;
};
Endings endings;

void SayEndings() {
    const bmr::Statistics s = bmr::GetStatistics();
    std::fprintf(stderr, "%lu scripts (%lu of any size), %lu steps; %lu left the numbers; asserted:\n",
                 endings.scripts, endings.differentSizes, endings.records, endings.notFinite);
    for (const auto &[text, count] : endings.asserted)
        std::fprintf(stderr, "  %lu %s\n", count, text.c_str());
    std::fprintf(stderr,
                 "evaluations %" PRIu64 ", proved apart %" PRIu64 ", touching %" PRIu64 " (answered %" PRIu64
                 "); impacts %" PRIu64 " (%" PRIu64 "); overlaps %" PRIu64 " (%" PRIu64 "); pairs %" PRIu64
                 ", hulls %" PRIu64 "; verified %" PRIu64 "\n",
                 s.evaluations, s.provedApart, s.handedOverTouching, s.touchingAnswered, s.toiQueries,
                 s.toiAnswered, s.overlapQueries, s.overlapsAnswered, s.pairs, s.hulls, s.verified);
}

void Count(const RunResult &result, bool anySize) {
    ++endings.scripts;
    endings.records += static_cast<unsigned long>(result.records);
    endings.differentSizes += anySize;
    endings.notFinite += result.ending == Ending::NotFinite;
    if (result.ending == Ending::Asserted)
        ++endings.asserted[result.assertion];
}

void Start() {
    bmr::Options options;
    options.statistics = true;
    bmr::Install(options);
    if (std::getenv("BMR_FUZZ_ENDINGS") != nullptr)
        std::atexit(SayEndings);
}

[[noreturn]] void Differ(fuzz_glue_run_function *reference, RunRequest request, const char *what,
                         int32_t at) {
    RunResult result;
    request.dumpAt = at;
    std::fputs("---- reference\n", stderr);
    RunRequest plain = request;
    plain.perturbAt = -1;
    reference(&plain, &result);
    std::fputs("---- plugin\n", stderr);
    fuzz_glue_run(&request, &result);
    fuzz_fail("record %" PRId32 ": other %s", at, what);
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
    static fuzz_glue_run_function *const stock = (Start(), Load(BOOMERANG_FUZZ_STOCK));
    static fuzz_glue_run_function *const other = Load(BOOMERANG_FUZZ_OTHER_PLUGIN);
    const bool anySize = Script::AsksForAnySize(data, size);
    fuzz_glue_run_function *const reference = anySize ? other : stock;

    static Record expected[kMostRecords], found[kMostRecords];
    RunRequest request;
    request.data = data;
    request.size = size;
    request.records = expected;
    RunResult first, second;
    reference(&request, &first);
    Count(first, anySize);

    request.records = found;
    request.mostRecords = first.records;
    if (fuzz_control("one-ulp"))
        request.perturbAt = first.records / 2;
    fuzz_glue_run(&request, &second);
#if defined(BOOMERANG_FUZZ_POISON)
    if (fuzz_control("freed-read"))
        ReadFreed();
#endif
    FUZZ_CHECK(bmr::GetStatistics().differences == 0, "verify: differences");
    for (int32_t i = 0; i < first.records && i < second.records; ++i) {
        if (expected[i].bodies != found[i].bodies)
            Differ(reference, request, "bodies", i);
        if (expected[i].contacts != found[i].contacts)
            Differ(reference, request, "contacts", i);
        if (expected[i].events != found[i].events)
            Differ(reference, request, "events", i);
        if (expected[i].probes != found[i].probes)
            Differ(reference, request, "answers", i);
    }
    FUZZ_CHECK(second.records == first.records, "%" PRId32 " records of %" PRId32, second.records,
               first.records);
    return 0;
}
