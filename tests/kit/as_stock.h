// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_AS_STOCK_H
#define BOOMERANG_TEST_AS_STOCK_H

#include "game.h"

/// @file
/// Games that must have stock Box2D's bits. A game is a test case: it builds worlds, plays them, and hands
/// what happens to a listener or a filter as lambdas. `AsStock` plays it in child processes: once on stock
/// Box2D, and once for each form of the library. What is written down of each step, and of each call of a
/// listener or filter, must be the same.

namespace as_stock {

/// How the library is installed.
struct Form {
    const char *name;
    bool everywhere, counts;
    bmr::Mode mode = bmr::Mode::On;
    const char *structure = nullptr; ///< that holds all pairs
};
constexpr Form kVerifying = {"verifying", true, true, bmr::Mode::Verify};
/// As games have it; also where it costs more than it gains; verifying; and by one structure. (The actor
/// plays by each of the structures.)
constexpr Form kForms[] = {{"on", false, false},
                           {"everywhere, counting", true, true},
                           kVerifying,
                           {"lazy-compass", false, true, bmr::Mode::On, "lazy-compass"}};

/// What is different of a game, all of that together.
enum How : unsigned {
    kAsAny = 0,
    kMayBeSilent = 1, ///< the library may have nothing to answer in it
    kInstalls = 2     ///< it calls Run::Install itself
};

inline std::string Played(const Scenario &play, const Form &form, unsigned how) {
    bmr::Options options;
    setenv("BOOMERANG_EVERYWHERE", form.everywhere ? "on" : "off", 1);
    const PairsBy by(form.structure);
    options.statistics = form.counts;
    options.mode = form.mode;
    const auto counted = [&](Run &run) {
        const bmr::Counted before = bmr::internal::ReadCounts();
        play(run);
        const bmr::Counted after = bmr::internal::ReadCounts();
        if (form.counts && (how & kMayBeSilent) == 0)
            run.Expect(after.evaluations != before.evaluations, "something is answered");
        run.Expect(after.differences == 0 || run.HasBrokenRules(), "the answers are Box2D's");
    };
    const std::string played =
        InChild(counted, &options, (how & kInstalls) != 0 ? Installed::ByPlay : Installed::Before);
    unsetenv("BOOMERANG_EVERYWHERE");
    return played;
}

/// Both games once more, which write all numbers of the lines that differ: the first that is another.
inline std::string DifferenceInWords(const Scenario &play, const Form &form, unsigned how,
                                     const FirstDifference &lines) {
    const auto words = [](const std::string &line, const std::function<std::string()> &again) {
        Run::InWords() = line;
        const std::string text = "\n" + again();
        Run::InWords().clear();
        const size_t begin = text.find("\nin words\n");
        return begin != std::string::npos ? text.substr(begin + 1, text.find("\n" + line) - begin) : "";
    };
    return FirstDifference(words(lines.ofStock, [&] { return InChild(play); }),
                           words(lines.ofPlugin, [&] { return Played(play, form, how); }))
        .Say("in words: number");
}

/// The claim of every game, which also counts what its name describes, and requires more than none of it
/// (Game::TookPlace, or Game::Stage): a game that does not is a failure.
inline void AsStock(const Scenario &play, unsigned how = kAsAny) {
    const std::string stock = InChild([&play](Run &run) {
        play(run);
        run.Stage(run.SaysWhatTookPlace(), "what took place is counted");
    });
    REQUIRE(stock != "");
    REQUIRE(Difference(stock, stock) == "");
    std::string differences, same;
    for (const Form &form : kForms) {
        const std::string played = Played(play, form, how), difference = Difference(stock, played);
        const FirstDifference lines(WithinRules(stock), WithinRules(played));
        if (difference.empty())
            same += "\nthe same as stock: " + std::string(form.name);
        else
            differences += "\n" + std::string(form.name) + ":\n" + difference;
        if (lines.Is())
            differences += DifferenceInWords(play, form, how, lines);
    }
    if (!differences.empty())
        FAIL_CHECK(differences, same);
}

} // namespace as_stock

/// A test case that is one game: AS_STOCK("name") { Game game(run); ... }
#define AS_STOCK_OF(play, how, name)                                                                         \
    static void play(as_stock::Run &run);                                                                    \
    TEST_CASE(name) {                                                                                        \
        as_stock::AsStock(play, how);                                                                        \
    }                                                                                                        \
    static void play(as_stock::Run &run)
#define AS_STOCK_HOW(how, name) AS_STOCK_OF(DOCTEST_ANONYMOUS(game_), how, name)
#define AS_STOCK(name) AS_STOCK_HOW(as_stock::kAsAny, name)

#endif
