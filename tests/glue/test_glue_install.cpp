// SPDX-License-Identifier: MIT
// What Install and the end of a process say, on stderr and in the file of statistics. What the environment
// says outweighs what the program says; what it says badly counts as not said, and gets one line.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <sys/wait.h>

#include "forked_world.h"
#include "start/environment.h"
#include "start/recognise.h"
#include "start/this_process.h"
#include "stderr_text.h"
#include "tell/statistics_file.h"

using forked::Run;

namespace {

/// What a scenario prints in a process of its own, in which nothing is installed yet.
std::string Alone(forked::Scenario scenario) {
    return forked::InChild(scenario, nullptr, forked::When::kByScenario);
}

void PrintInstall(Run &run, const bmr::Options &options) {
    bool done = false;
    const std::string said = StderrOf([&] { done = bmr::Install(options); });
    run.Print("%s, %s: %s", done ? "done" : "not done", bmr::IsInstalled() ? "installed" : "not installed",
              said.c_str());
}

std::string TextOf(const std::string &name) {
    std::string text;
    std::FILE *file = std::fopen(name.c_str(), "r");
    if (file == nullptr)
        return "no file";
    for (int c; (c = std::fgetc(file)) != EOF;)
        text += static_cast<char>(c);
    std::fclose(file);
    std::remove(name.c_str());
    return text;
}

/// A name in the directory of temporary files that no other process uses.
std::string NameFor(const char *end) {
    const char *room = std::getenv("TMPDIR");
    return std::string(room != nullptr ? room : "/tmp") + "/boomerang-" + std::to_string(bmr::ThisProcess()) +
           end;
}

/// Ends a child, and where asked a child of that, with exit handlers that write the statistics into `file`;
/// what both say, and the number of the last.
struct End {
    std::string said;
    long child = 0;
};
End EndWith(const std::string &file, bool forks = false) {
    End end;
    end.said = StderrOf([&] {
        std::fflush(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            if (!bmr::WriteStatisticsAtExit(file.c_str()))
                test_leave(3);
            if (forks && fork() != 0) {
                int status = 0;
                wait(&status);
                test_leave(WEXITSTATUS(status)); // the parent writes nothing: the child's file is looked at
            }
            std::exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        end.child = status == 0 ? child : -1;
    });
    return end;
}

} // namespace

TEST_CASE("Install works once") {
    CHECK(Alone([](Run &run) {
              run.Print("%d", bmr::IsInstalled());
              PrintInstall(run, bmr::Options());
              PrintInstall(run, bmr::Options());
          }) == "0\ndone, installed: \nnot done, installed: \n");
}

TEST_CASE("Install does nothing where it is told off") {
    CHECK(Alone([](Run &run) {
              bmr::Options options;
              options.mode = bmr::Mode::Off;
              PrintInstall(run, options);
              PrintInstall(run, bmr::Options());
          }) == "not done, not installed: \ndone, installed: \n");
}

TEST_CASE("a refusal is said once, with its reason, and is for good") {
    CHECK(Alone([](Run &run) {
              bmr::SetLibraryCheck([] { return "this one is another"; });
              PrintInstall(run, bmr::Options());
              bmr::SetLibraryCheck(nullptr);
              PrintInstall(run, bmr::Options());
          }) ==
          "not done, not installed: boomerang: not at work, Box2D runs as it is: this one is another\n\n"
          "not done, not installed: \n");
}

TEST_CASE("who asks is told what is at work, and what is not reached without the shared library") {
    const std::string said = Alone([](Run &run) {
        bmr::Options options;
        options.verbosity = 1;
        PrintInstall(run, options);
    });
    CHECK(said.find("done, installed: boomerang: on; contacts alone of Box2D 2.4.1; rounds ") == 0);
    CHECK(said.find(" Box2D; contacts alone: calls of b2World::Step do not come by this library\n") !=
          std::string::npos);
}

TEST_CASE("of processes that share their announcement one claims it") {
    CHECK(Alone([](Run &run) {
              bmr::ShareAnnouncement();
              run.Print("%d", bmr::IsAnnounced());
              const pid_t child = fork();
              if (child == 0)
                  test_leave(bmr::ClaimAnnouncement() ? 0 : 1);
              int status = 0;
              waitpid(child, &status, 0);
              run.Print("%d %d %d", status == 0, bmr::IsAnnounced(), bmr::ClaimAnnouncement());
          }) == "0\n1 1 0\n");
}

TEST_CASE("a name for the statistics that is too long is refused when installing") {
    CHECK(Alone([](Run &run) {
              const std::string name(5000, 'x');
              bmr::Options options;
              options.statisticsFile = name.c_str();
              bool done = false;
              const std::string said = StderrOf([&] { done = bmr::Install(options); });
              run.Print("%d %d", done,
                        said == "boomerang: the statistics will not be written to " + name + "\n");
          }) == "1 1\n");
}

TEST_CASE("the statistics are one JSON object of the options and all counts") {
    const std::string text = Alone([](Run &run) {
        bmr::Options options;
        options.statistics = true;
        const forked::PairsBy by(BMR_LAZY_DUDLEY);
        bmr::Install(options);
        std::FILE *file = std::tmpfile();
        bmr::WriteStatistics(file);
        std::rewind(file);
        std::string written;
        for (int c; (c = std::fgetc(file)) != EOF;)
            if (c != '\n' && c != ' ')
                written += static_cast<char>(c);
        std::fclose(file);
        for (size_t at = 0; at < written.size(); at += 300)
            run.Print("%s", written.substr(at, 300).c_str());
    });
    std::string line;
    for (const char c : text)
        if (c != '\n')
            line += c;
    CHECK(line ==
          "{\"mode\":\"on\",\"structure\":\"lazy-dudley\","
          "\"way\":\"contactsaloneofBox2D\",\"box2d\":\"2.4.1\",\"rounds_as_box2d\":true,"
          "\"passes_run\":false,"
          "\"steps\":0,"
          "\"evaluations\":0,\"edge_checks\":0,\"edge_searches\":0,\"verdicts_reused\":0,\"proved_apart\":0,"
          "\"handed_over\":0,\"handed_over_touching\":0,\"touching_answered\":0,\"toi_queries\":0,\"toi_"
          "answered\":0,"
          "\"overlap_queries\":0,\"overlaps_answered\":0,\"pairs_watched\":0,\"looks\":0,\"renewals\":"
          "0,"
          "\"verified\":0,\"differences\":0,\"pairs\":0,\"hulls\":0,"
          "\"checks\":0,\"kinetic_steps\":0,\"events\":{\"start\":0,\"push\":0,\"stab\":0,\"roll\":0,"
          "\"coarsen\":0,"
          "\"contact\":0,\"leave\":0}}");
}

TEST_CASE("the statistics are written when the process ends, under its number where the name asks for it") {
    const std::string name = NameFor(".json");
    CHECK(EndWith(name).said == "");
    CHECK(TextOf(name).find("\"steps\": 0,\n") != std::string::npos);
    const std::string before = NameFor("-of-"), place = before + "%p.json";
    const End end = EndWith(place);
    CHECK(end.said == "");
    CHECK(TextOf(before + std::to_string(end.child) + ".json").find("\"steps\": 0,\n") != std::string::npos);
}

TEST_CASE("a forked child leaves its parent's file alone") {
    const std::string name = NameFor(".json");
    const End end = EndWith(name, true);
    CHECK(end.said == "");
    CHECK(end.child > 0);
    CHECK(TextOf(name) == "no file");
}

TEST_CASE("where the statistics cannot be written, one line says so") {
    const std::string nowhere = NameFor("/no/such/place.json");
    CHECK(EndWith(nowhere).said == "boomerang: cannot write the statistics to " + nowhere + "\n");
    CHECK(EndWith("/dev/full").said == "boomerang: the statistics in /dev/full are not complete\n");
    // As long as a name may be, but longer with the number in it.
    const std::string longest = std::string(4096 - 1 - 4, 'x') + "%p%p";
    CHECK(EndWith(longest).said.find("boomerang: cannot write the statistics to xxx") == 0);
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
    CHECK(!bmr::StructureOfEnvironment());
    for (const bmr::Mode mode : {bmr::Mode::On, bmr::Mode::Off, bmr::Mode::Verify})
        CHECK(Under("BOOMERANG", bmr::NameOf(mode)).mode == mode);
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i) {
        const auto structure = static_cast<bmr_structure>(i);
        const forked::PairsBy by(structure);
        CHECK(bmr::StructureOfEnvironment() == structure);
    }
}

TEST_CASE("the other variables are taken over") {
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
        {"BOOMERANG_VERBOSE", "very",
         "boomerang: BOOMERANG_VERBOSE=very is not understood, so it does nothing; known: 0, 1\n"},
    };
    bmr::Options given;
    given.mode = bmr::Mode::Verify;
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
        CHECK(made.verbosity == given.verbosity);
    }
}
