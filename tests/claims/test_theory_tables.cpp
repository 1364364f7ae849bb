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
            run.outcome.run.events =
                static_cast<uint64_t>(std::lround(events(ratio) * (1.0 + 0.03 * static_cast<double>(seed))));
            run.outcome.run.lines = run.outcome.run.events / 2;
            bmr_optimum optimum = {};
            optimum.least = 11;
            run.optimum = optimum;
            runs.push_back(run);
        }
    return runs;
}

BoundVerdict VerdictOf(const char *structure, bool rigid, bool convex,
                       const std::function<double(double)> &events) {
    const std::vector<Run> runs = RunsWith(structure, rigid, convex, events);
    const std::optional<Growth> growth = GrowthOf(runs, "made-up", test_structure(structure));
    REQUIRE(growth);
    return growth->verdict;
}

double Root(double x) {
    return 10.0 * std::sqrt(x);
}
double Logarithm(double x) {
    return 10.0 * std::log2(x);
}
double Line(double x) {
    return 10.0 * x;
}

} // namespace

TEST_CASE("a bound holds where the growth is its own, and not where it is faster") {
    CHECK(VerdictOf("lazy-dudley", false, false, Root) == BoundVerdict::Holds);
    CHECK(VerdictOf("lazy-dudley", false, false, [](double x) { return 10.0 * std::pow(x, 0.6); }) ==
          BoundVerdict::Refuted);
    CHECK(VerdictOf("lazy-compass", false, true, Logarithm) == BoundVerdict::Holds);
    CHECK(VerdictOf("lazy-compass", false, true, Root) == BoundVerdict::Refuted);
    CHECK(VerdictOf("lazy-compass", false, false, [](double x) { return Root(x) * std::log2(x); }) ==
          BoundVerdict::Holds);
    CHECK(VerdictOf("lazy-compass", false, false, Line) == BoundVerdict::Refuted);
    CHECK(VerdictOf("lazy-dudley", true, false, Line) == BoundVerdict::Holds);
    CHECK(VerdictOf("lazy-dudley", true, false, [](double x) { return std::pow(x, 1.2); }) ==
          BoundVerdict::Refuted);
}

TEST_CASE("an interval that reaches the bound confirms nothing") {
    // The power 0.6, off by a half at every other ratio: the interval is from below 1/2 to far above.
    const auto shaky = [](double x) {
        return 20.0 * std::pow(x, 0.6) * (static_cast<int>(std::lround(std::log2(x))) % 4 == 1 ? 1.0 : 2.0);
    };
    CHECK(VerdictOf("lazy-dudley", false, false, shaky) == BoundVerdict::Open);
    CHECK(VerdictOf("lazy-dudley", true, false, shaky) == BoundVerdict::Holds); // far below 1
    const std::vector<Run> runs = RunsWith("lazy-dudley", false, false, shaky);
    const std::string text = TextOf(*GrowthOf(runs, "made-up", test_structure("lazy-dudley")));
    CHECK(text.substr(text.size() - 7) == " <1/2 ?");
}

TEST_CASE("the bounds are those of Table 1") {
    const auto bound = [](const char *structure, bool rigid, bool convex) {
        return BoundFor(*test_structure(structure), rigid, convex);
    };
    CHECK(bound("triangle-levels-compass", false, true) == Bound::Logarithmic);
    CHECK(bound("triangle-levels-dudley", false, true) == Bound::Logarithmic);
    CHECK(bound("triangle-levels-compass", false, false) == Bound::RootLog);
    CHECK(bound("triangle-levels-dudley", false, false) == Bound::Root);
    CHECK(bound("active-cell-compass", false, true) == Bound::Logarithmic);
    CHECK(bound("active-cell-dudley", false, true) == Bound::Root);
    CHECK(bound("active-cell-compass", false, false) == Bound::RootLog);
    CHECK(bound("active-cell-dudley", false, false) == Bound::Root);
    CHECK(bound("active-cell-compass", true, false) == Bound::LinearLog);
    CHECK(bound("active-cell-dudley", true, false) == Bound::Linear);
    CHECK(bound("closest-features", false, true) == Bound::None);
}

TEST_CASE("the exponent fitted is that of the growth, and rivals have no bound") {
    const std::vector<Run> runs = RunsWith("closest-features", false, false, Root);
    const std::optional<Growth> growth = GrowthOf(runs, "made-up", test_structure("closest-features"));
    REQUIRE(growth);
    CHECK(growth->fit.exponent == doctest::Approx(0.5).epsilon(0.02));
    CHECK(growth->verdict == BoundVerdict::None);
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
