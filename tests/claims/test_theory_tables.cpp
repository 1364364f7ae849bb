// SPDX-License-Identifier: MIT
// What the tables of `boomerang-testbed events` conclude from runs: made-up runs with known growth.
#include "cases.h"
#include "kds_driver.h"
#include "theory/event_tables.h"

using namespace testbed;

namespace {

/// Runs of one structure whose number of events is a function of the ratio.
std::vector<Run> RunsWith(const char *structure, bool rigid, bool convex,
                          const std::function<double(double)> &events) {
    std::vector<Run> runs;
    size_t index = 0;
    for (double ratio = 8.0; ratio <= 8192.0; ratio *= 4.0, ++index)
        for (uint64_t seed = 1; seed <= 3; ++seed) {
            Run run;
            run.motion = "made-up";
            run.structure = test_structure(structure);
            run.ratio = ratio;
            run.ratioIndex = index;
            run.seed = seed;
            run.rigid = rigid;
            run.convex = convex;
            run.outcome.events =
                static_cast<uint64_t>(std::lround(events(ratio) * (1.0 + 0.03 * static_cast<double>(seed))));
            run.outcome.lines = run.outcome.events / 2;
            bmr_optimum optimum = {};
            optimum.least = 11;
            run.optimum = optimum;
            runs.push_back(run);
        }
    return runs;
}

double Root(double x) {
    return 10.0 * std::sqrt(x);
}

} // namespace

TEST_CASE("the bounds are those of Table 1") {
    const auto bound = [](const char *structure, bool rigid, bool convex) {
        return BoundFor(*test_structure(structure), rigid, convex);
    };
    CHECK(bound("triangle-levels-compass", false, true) == "log");
    CHECK(bound("triangle-levels-dudley", false, true) == "log");
    CHECK(bound("triangle-levels-compass", false, false) == "1/2 log");
    CHECK(bound("triangle-levels-dudley", false, false) == "1/2");
    CHECK(bound("active-cell-compass", false, true) == "log");
    CHECK(bound("active-cell-dudley", false, true) == "1/2");
    CHECK(bound("active-cell-compass", false, false) == "1/2 log");
    CHECK(bound("active-cell-dudley", false, false) == "1/2");
    CHECK(bound("active-cell-compass", true, false) == "1 log2");
    CHECK(bound("active-cell-dudley", true, false) == "1");
    CHECK(bound("closest-features", false, true) == "");
}

TEST_CASE("the exponent fitted is that of the growth, and rivals have no bound") {
    const std::vector<Run> runs = RunsWith("closest-features", false, false, Root);
    const std::optional<Growth> growth = GrowthOf(runs, "made-up", test_structure("closest-features"));
    REQUIRE(growth);
    CHECK(growth->fit.exponent == doctest::Approx(0.5).epsilon(0.02));
    CHECK(TextOf(*growth) == "0.50");
}

TEST_CASE("two ratios are too few for a growth") {
    std::vector<Run> runs = RunsWith("lazy-compass", false, false, Root);
    runs.resize(6);
    CHECK_FALSE(GrowthOf(runs, "made-up", test_structure("lazy-compass")));
}

TEST_CASE("lines over optimum leaves the first line of both out") {
    const std::vector<Run> runs = RunsWith("lazy-compass", false, false, [](double) { return 100.0; });
    // Lines 51, 53, 54 of 103, 106, 109 events; the optimum replaces 10 of its 11 lines.
    CHECK(*OverOptimum(runs, test_structure("lazy-compass"), 0) == doctest::Approx((51 + 53 + 54) / 30.0));
    CHECK_FALSE(OverOptimum(runs, test_structure("free-fd2"), 0));
}
