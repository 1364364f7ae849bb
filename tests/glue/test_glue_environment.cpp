// SPDX-License-Identifier: MIT
// What the environment says outweighs what the program says; what it says badly counts as not said, and gets
// one line.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "start/environment.h"
#include "stderr_text.h"

namespace {

/// The options under this value of one variable, which is gone afterwards.
bmr::Options Under(const char *name, const char *value, const bmr::Options &options = bmr::Options()) {
    setenv(name, value, 1);
    const bmr::Options made = bmr::WithEnvironment(options);
    unsetenv(name);
    return made;
}

uint32_t Hooks(const char *value, uint32_t given = bmr::kAllHooks) {
    bmr::Options options;
    options.hooks = given;
    return Under("BOOMERANG_HOOKS", value, options).hooks;
}

} // namespace

TEST_CASE("hooks are named one by one, from left to right") {
    CHECK(Hooks("") == bmr::kAllHooks);
    CHECK(Hooks("none") == bmr::kNoHooks);
    CHECK(Hooks("all", bmr::kNoHooks) == bmr::kAllHooks);
    CHECK(Hooks("none,+solve-toi") == Bit(bmr::Hook::SolveToi));
    CHECK(Hooks("+solve-toi,none") == bmr::kNoHooks);
    CHECK(Hooks("-test-overlap,-contact-loop") ==
          (bmr::kAllHooks & ~Bit(bmr::Hook::TestOverlap) & ~Bit(bmr::Hook::ContactLoop)));
}

TEST_CASE("every hook has a name, which takes it away and brings it back") {
    uint32_t named = bmr::kNoHooks;
    for (int i = 0; bmr::NameOfHook(i) != nullptr; ++i) {
        named |= 1u << i;
        CHECK(Hooks((std::string("-") + bmr::NameOfHook(i)).c_str()) == (bmr::kAllHooks & ~(1u << i)));
        CHECK(Hooks((std::string("+") + bmr::NameOfHook(i)).c_str(), bmr::kNoHooks) == 1u << i);
    }
    CHECK(named == bmr::kAllHooks);
    CHECK(bmr::NameOfHook(-1) == nullptr);
}

TEST_CASE("every mode and every structure has a name that chooses it") {
    for (const bmr::Mode mode : {bmr::Mode::On, bmr::Mode::Off, bmr::Mode::Verify})
        CHECK(Under("BOOMERANG", bmr::NameOf(mode)).mode == mode);
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i) {
        const auto structure = static_cast<bmr_structure>(i);
        CHECK(Under("BOOMERANG_STRUCTURE", bmr_structure_name(structure)).structure == structure);
    }
}

TEST_CASE("the other variables are taken over") {
    CHECK(!Under("BOOMERANG_PREFILTER", "off").prefilter);
    CHECK(Under("BOOMERANG_PREFILTER", "on").prefilter);
    CHECK(Under("BOOMERANG_VERBOSE", "1").verbosity == 1);
    bmr::Options loud;
    loud.verbosity = 1;
    CHECK(Under("BOOMERANG_VERBOSE", "0", loud).verbosity == 0);
    setenv("BOOMERANG_STATISTICS", "some.json", 1);
    CHECK(std::string(bmr::WithEnvironment(bmr::Options()).statisticsFile) == "some.json");
    unsetenv("BOOMERANG_STATISTICS");
    CHECK(bmr::WithEnvironment(bmr::Options()).statisticsFile == nullptr);
}

TEST_CASE("a value that is not understood changes nothing, and is named once with what is understood") {
    const struct {
        const char *name, *value, *line;
    } bad[] = {
        {"BOOMERANG", "perhaps",
         "boomerang: BOOMERANG=perhaps is not understood, so it does nothing; known: on, off, verify\n"},
        {"BOOMERANG_STRUCTURE", "magic",
         "boomerang: BOOMERANG_STRUCTURE=magic is not understood, so it does nothing; known: lazy-compass, "
         "lazy-dudley, lazy-dobkin-kirkpatrick, free-direction\n"},
        {"BOOMERANG_HOOKS", "none,-everything",
         "boomerang: BOOMERANG_HOOKS=none,-everything is not understood, so it does nothing; known: all, "
         "none, and + "
         "or - before time-of-impact test-overlap solve-toi contact-loop pair-finding profile-clock "
         "touching-manifold fixture-boxes tree-updates ledger\n"},
        {"BOOMERANG_PREFILTER", "yes",
         "boomerang: BOOMERANG_PREFILTER=yes is not understood, so it does nothing; known: off, on\n"},
        {"BOOMERANG_VERBOSE", "very",
         "boomerang: BOOMERANG_VERBOSE=very is not understood, so it does nothing; known: 0, 1\n"},
    };
    bmr::Options given;
    given.mode = bmr::Mode::Verify;
    given.structure = BMR_LAZY_DUDLEY;
    given.hooks = Bit(bmr::Hook::SolveToi);
    given.prefilter = false;
    given.verbosity = 1;
    for (const auto &b : bad) {
        CAPTURE(std::string(b.name));
        CHECK(StderrOf([&] {
                  const bmr::HeldComplaints held;
                  Under(b.name, b.value, given);
              }) == "");
        bmr::Options made;
        CHECK(StderrOf([&] { made = Under(b.name, b.value, given); }) == b.line);
        CHECK(StderrOf([&] { Under(b.name, b.value, given); }) == "");
        CHECK(made.mode == given.mode);
        CHECK(made.structure == given.structure);
        CHECK(made.hooks == given.hooks);
        CHECK(made.prefilter == given.prefilter);
        CHECK(made.verbosity == given.verbosity);
    }
    // Neither a word without its sign nor one that is empty, though nothing is said of them any more.
    for (const char *value : {"solve-toi", ",", "all,", "+", "-nothing"})
        CHECK(Hooks(value, Bit(bmr::Hook::SolveToi)) == Bit(bmr::Hook::SolveToi));
}
