// SPDX-License-Identifier: MIT
// What Install and the end of a process say, on stderr and in a file for tests. What the
// environment says outweighs what the program says; what it says badly counts as not said, and gets one line.
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

#include "as_stock.h"
#include "start/install.h"
#include "start/settings.h"

using namespace as_stock;

namespace {

void PrintInstall(Run &run, const bmr::Options &options) {
    bool done = false;
    const std::string said = StderrOf([&] { done = bmr::Install(options); });
    run.Print("%s, %s: %s", done ? "done" : "not done", bmr::IsInstalled() ? "installed" : "not installed",
              said.c_str());
}

/// A name in the directory of temporary files that no other process uses.
std::string NameFor(const char *end) {
    const char *folder = std::getenv("TMPDIR");
    return std::string(folder != nullptr ? folder : "/tmp") + "/boomerang-" + std::to_string(getpid()) + end;
}

} // namespace

TEST_CASE("Install works once") {
    CHECK(InChild([](Run &run) {
              run.Print("%d", bmr::IsInstalled());
              PrintInstall(run, bmr::Options());
              PrintInstall(run, bmr::Options());
          }) == "0\ndone, installed: \nnot done, installed: \n");
}

TEST_CASE("Install does nothing where it is switched off") {
    CHECK(InChild([](Run &run) {
              bmr::Options options;
              options.mode = bmr::Mode::Off;
              PrintInstall(run, options);
              PrintInstall(run, bmr::Options());
          }) == "not done, not installed: \ndone, installed: \n");
}

TEST_CASE("a structure that is none is refused") {
    CHECK(InChild([](Run &run) {
              bmr::Options options;
              options.pairsBy = static_cast<bmr_structure>(BMR_STRUCTURE_COUNT + 1);
              PrintInstall(run, options);
          }) ==
          "not done, not installed: boomerang: not at work, Box2D runs as it is: Options::pairsBy is none of "
          "the structures of boomerang/pair.h\n\n");
}

TEST_CASE("a refusal is said once, with its reason, and is for good") {
    CHECK(InChild([](Run &run) {
              bmr::SetLibraryCheck([] { return "this one is another"; });
              PrintInstall(run, bmr::Options());
              bmr::SetLibraryCheck(nullptr);
              PrintInstall(run, bmr::Options());
          }) ==
          "not done, not installed: boomerang: not at work, Box2D runs as it is: this one is another\n\n"
          "not done, not installed: \n");
}

TEST_CASE("who asks learns what is at work") {
    const std::string said = InChild([](Run &run) {
        bmr::Options options;
        options.verbosity = 1;
        PrintInstall(run, options);
    });
    CHECK(said == "done, installed: boomerang: on; ahead of Box2D 2.4.1\n\n");
}

TEST_CASE("a file that BOOMERANG_COUNTS names gets what is counted, when the process ends") {
    const std::string name = NameFor(".counts");
    setenv("BOOMERANG_COUNTS", name.c_str(), 1);
    CHECK(InChild([](Run &) {
              bmr::Install();
              std::exit(bmr::GetSettings().options.statistics ? 0 : 1);
          }) == "");
    unsetenv("BOOMERANG_COUNTS");
    std::ifstream file(name);
    const std::string counts((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::remove(name.c_str());
    CHECK(counts.find("evaluations 0\n") != std::string::npos);
    CHECK(counts.find("way ahead of Box2D 2.4.1\n") != std::string::npos);
}

namespace {

/// The options under this value of one variable, which is gone afterwards.
bmr::Options Under(const char *name, const char *value, const bmr::Options &options = bmr::Options()) {
    setenv(name, value, 1);
    const bmr::Options made = bmr::WithEnvironment(options);
    unsetenv(name);
    return made;
}

} // namespace

TEST_CASE("every mode and every structure has a name that chooses it") {
    CHECK(bmr::WithEnvironment(bmr::Options()).pairsBy == BMR_STRUCTURE_COUNT);
    for (const bmr::Mode mode : {bmr::Mode::On, bmr::Mode::Off, bmr::Mode::Verify})
        CHECK(Under("BOOMERANG", bmr::NameOf(mode)).mode == mode);
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i) {
        const auto structure = static_cast<bmr_structure>(i);
        CHECK(Under("BOOMERANG_PAIRS_BY", bmr_structure_name(structure)).pairsBy == structure);
    }
}

TEST_CASE("the verbosity is taken over") {
    CHECK(Under("BOOMERANG_VERBOSE", "1").verbosity == 1);
    bmr::Options loud;
    loud.verbosity = 1;
    CHECK(Under("BOOMERANG_VERBOSE", "0", loud).verbosity == 0);
}

TEST_CASE("a value that is not understood changes nothing, and is named once with what is understood") {
    const struct {
        const char *name, *value, *line;
    } bad[] = {
        {"BOOMERANG", "perhaps",
         "boomerang: BOOMERANG=perhaps is not understood, so it does nothing; known: on, off, verify\n"},
        {"BOOMERANG_VERBOSE", "very",
         "boomerang: BOOMERANG_VERBOSE=very is not understood, so it does nothing; known: 0, 1\n"},
    };
    bmr::Options given;
    given.mode = bmr::Mode::Verify;
    given.verbosity = 1;
    for (const auto &b : bad) {
        CAPTURE(std::string(b.name));
        bmr::Options made;
        CHECK(StderrOf([&] { made = Under(b.name, b.value, given); }) == b.line);
        CHECK(StderrOf([&] { Under(b.name, b.value, given); }) == "");
        CHECK(made.mode == given.mode);
        CHECK(made.verbosity == given.verbosity);
    }
}
