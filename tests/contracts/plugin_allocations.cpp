// SPDX-License-Identifier: MIT
// Every allocation of the shared library fails once, and once all from there on: the game goes on with
// stock's bits, nothing is said that is not about memory, and no more blocks stay out than without a failure.
//
// The build says where GAME is, a plain Box2D program, and PLUGIN, the library linked with
// failing_malloc.cpp.
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "process.h"
#include "test_scale.h"

using namespace contracts;

namespace {

struct Way {
    const char *name;
    std::vector<std::string> environment;
};

const Way kWays[] = {
    {"as it is", {}},
    {"free-direction", {"BOOMERANG_PAIRS_BY=free-direction"}},
    {"lazy-dudley", {"BOOMERANG_PAIRS_BY=lazy-dudley"}},
    {"lazy-compass", {"BOOMERANG_PAIRS_BY=lazy-compass"}},
    {"verify, complaints",
     {"BOOMERANG=verify", "BOOMERANG_PAIRS_BY=none of that name", "BOOMERANG_VERBOSE=very",
      "BOOMERANG_COUNTS=/nowhere/counts"}},
};

size_t failures = 0;

void Fail(const Way &way, const std::string &setting, const std::string &what) {
    ++failures;
    std::printf("FAILED: %s, %s: %s\n", way.name, setting.c_str(), what.c_str());
}

/// What failing_malloc.h says at the end.
struct Report {
    unsigned long long asked = 0, failed = 0;
    long long out = 0;
    bool found = false;
};

Report ReportOf(const Ended &ended) {
    Report report;
    const size_t at = ended.errors.rfind("allocations ");
    report.found = at != std::string::npos &&
                   std::sscanf(ended.errors.c_str() + at, "allocations %llu failed %llu out %lld",
                               &report.asked, &report.failed, &report.out) == 3;
    return report;
}

Ended Play(const Way &way, const std::string &setting) {
    std::vector<std::string> environment = way.environment;
    environment.push_back(std::string("LD_PRELOAD=") + PLUGIN);
    environment.emplace_back("BOOMERANG_TEST_REPORT=1");
    if (!setting.empty())
        environment.push_back(setting);
    return RunProgram({GAME}, environment);
}

/// One failure; how many allocations the library asked for.
void PlayFailing(const Way &way, const std::string &setting, const Ended &stock, const Report &whole) {
    const Ended ended = Play(way, setting);
    const Report report = ReportOf(ended);
    if (ended.signal != 0 || ended.status != 0)
        Fail(way, setting,
             "ends by signal " + std::to_string(ended.signal) + ", status " + std::to_string(ended.status));
    else if (!report.found)
        Fail(way, setting, "no report");
    else if (ended.output != stock.output)
        Fail(way, setting, "other output than stock's");
    else if (report.failed == 0)
        Fail(way, setting, "nothing failed");
    else if (report.out > whole.out)
        Fail(way, setting,
             std::to_string(report.out) + " blocks stay out, without a failure " + std::to_string(whole.out));
}

size_t PlayWay(const Way &way, const Ended &stock) {
    const Ended ended = Play(way, "");
    const Report whole = ReportOf(ended);
    if (!whole.found || ended.output != stock.output || whole.asked < 10) {
        Fail(way, "no failure", "the plugin does not play as stock, or asks for next to nothing");
        return 0;
    }
    // All of them in a night's run; else the first ones and some of the others, all different.
    const size_t most = test_scaled(24);
    const auto count = static_cast<size_t>(whole.asked);
    size_t played = 0;
    for (size_t at = 0; at < count; at += at < most || count <= 2 * most ? 1 : (count - most) / most + 1) {
        PlayFailing(way, "BOOMERANG_TEST_FAIL_AT=" + std::to_string(at), stock, whole);
        ++played;
    }
    for (size_t from = 0; from < count; from += count / 4 + 1) {
        PlayFailing(way, "BOOMERANG_TEST_FAIL_FROM=" + std::to_string(from), stock, whole);
        ++played;
    }
    std::printf("%s: %zu allocations, %zu runs, %lld blocks stay\n", way.name, count, played, whole.out);
    std::fflush(stdout);
    return played;
}

} // namespace

int main() {
    for (const char *name :
         {"BOOMERANG", "BOOMERANG_PAIRS_BY", "BOOMERANG_COUNTS", "BOOMERANG_VERBOSE", "LD_PRELOAD"})
        unsetenv(name);
    const Ended stock = RunProgram({GAME});
    size_t played = 0;
    for (const Way &way : kWays)
        played += PlayWay(way, stock);
    std::printf("%zu runs, %zu failures\n", played, failures);
    return failures == 0 && played > 0 && stock.status == 0 && stock.signal == 0 ? 0 : 1;
}
