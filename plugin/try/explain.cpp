// SPDX-License-Identifier: MIT
// What was found, and what to do next, in words.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <sstream>

#include "try/elf_file.h"
#include "try/place.h"
#include "try/verdict.h"

namespace bmr::trial {

namespace {

/// A blank where no line may end.
constexpr char kFirmBlank = '\x1f';

std::string Format(const char *format, double number) {
    char text[64];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string Count(uint64_t number) {
    std::string text = std::to_string(number);
    for (size_t place = text.size(); place > 3;)
        text.insert(place -= 3, ",");
    return text;
}

std::string Time(double microseconds) {
    return microseconds < 1000.0 ? Format("%.3g\x1f"
                                          "us",
                                          microseconds)
                                 : Format("%.3g\x1f"
                                          "ms",
                                          1e-3 * microseconds);
}

std::string LastWordsOf(const Run &run) {
    if (run.lastWords.empty())
        return "";
    std::string text = " Its last words:\n";
    for (const std::string &line : run.lastWords)
        text += "    " + line + "\n";
    return text;
}

/// As a shell wants it.
std::string Quoted(const std::string &word) {
    const auto isPlain = [](unsigned char c) {
        return std::isalnum(c) != 0 || std::strchr("_-./:=,+%@", c) != nullptr;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain))
        return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string CommandOf(const Trial &trial) {
    std::string text;
    for (const std::string &word : trial.command)
        text += (text.empty() ? "" : " ") + Quoted(word);
    return text;
}

/// With which the library ends a sentence on a Box2D that both libraries in LD_PRELOAD bring into sight.
constexpr const char *kNameBoth = ". Name both: ";

std::string ExplainNotAtWork(const Trial &trial) {
    const Run &off = trial.off.empty() ? trial.asItIs : trial.off.front();
    const std::string whyNot = trial.on.empty() ? off.whyNot : trial.on.front().whyNot;
    const ElfFile file = LookAtFile(trial.program);
    const Place place = PlaceOfBox2D(trial);
    if (!whyNot.empty())
        return "Boomerang leaves this game's Box2D alone: " + whyNot.substr(0, whyNot.find(kNameBoth)) + ".";
    if (!off.noStep.empty() && !place.shared.empty())
        return std::string(place.boomerang.empty() ? ""
                                                   : "This game is linked with Boomerang already, but ") +
               off.noStep + ".";
    if (file.kind == ElfFile::Kind::kStatic)
        return trial.program + " is linked statically, so that nothing can be preloaded into it." +
               (file.hasBox2D2 ? " Box2D is inside." : "");
    if (file.kind == ElfFile::Kind::kOtherWidth)
        return trial.program + " is a program for " + (sizeof(void *) == 8 ? "32" : "64") +
               " bits, and this Boomerang is built for " + (sizeof(void *) == 8 ? "64." : "32.");
    if (file.kind == ElfFile::Kind::kForeign)
        return trial.program + " is a program for another processor than this Boomerang is built for.";
    if (!off.loaded)
        return "The library did not get into the game: it starts its programs with another environment (a "
               "sandbox, sudo), or with rights of somebody else's. Name the program itself.";
    if (!place.inside.empty() && place.shared.empty())
        return "This game has Box2D inside " + place.inside + ", where nothing that is preloaded reaches it.";
    if (off.steps > 0 && !place.shared.empty())
        return "This game steps a Box2D (" + place.shared +
               ") that a module of its own has loaded (dlopen), where it "
               "is out of the library's sight.";
    if (!place.shared.empty() && off.ended)
        return "This game uses Box2D (" + place.shared + "), but ended by itself after " +
               Format("%.3g", off.seconds) + " seconds and took no step." + LastWordsOf(trial.asItIs);
    if (!place.shared.empty())
        return "This game uses Box2D (" + place.shared + "), but took no step in " +
               Format("%.3g", off.seconds) +
               " seconds. Does it wait for somebody in a menu? --seconds gives "
               "it more time.";
    if (!place.version3.empty())
        return "This game has Box2D 3 or later (" + place.version3 +
               "), which is written anew; Boomerang is for 2.4.1 and 2.4.2.";
    std::string text = "No Box2D was found in this game: neither a shared one nor one inside a program or a "
                       "library that it loads.";
    if (EndedBadly(trial.asItIs))
        text += " It did not get far, either: " + EndOf(trial.asItIs) + "." + LastWordsOf(trial.asItIs);
    return text;
}

std::string NextWhereNotAtWork(const Trial &trial) {
    const Place place = PlaceOfBox2D(trial);
    const std::string whyNot = trial.on.empty() ? "" : trial.on.front().whyNot;
    const bool outOfSight = whyNot.empty() ? !trial.off.empty() && trial.off.front().steps > 0
                                           : whyNot.find(kNameBoth) != std::string::npos;
    if (outOfSight && !place.shared.empty())
        return "It is in sight where both libraries are preloaded:\n\n    LD_PRELOAD=" +
               Quoted(trial.preload + ":" + place.shared) + " " + CommandOf(trial) +
               "\n\nTo try it so:\n\n    LD_PRELOAD=" + Quoted(place.shared) + " boomerang try " +
               CommandOf(trial);
    if (place.shared.empty() && !place.inside.empty())
        return "Who has its sources adds one line to its CMake: boomerang_accelerate(TARGET), where TARGET "
               "is "
               "what compiles Box2D (docs/compile-box2d.md has recipes).";
    return "";
}

std::string ExplainFailure(const Trial &trial) {
    const Run &run = trial.asItIs;
    const std::string words = LastWordsOf(run);
    std::string text = trial.command[0] + " does not run well without Boomerang either";
    if (words.find("error while loading shared libraries") != std::string::npos)
        text += ": a library is missing";
    else if (EndOf(run) == kShellsStatus)
        text += ": it, or what it starts, could not be found";
    return text + " (" + EndOf(run) + " after " + Format("%.3g s", run.seconds) + ")." + words;
}

/// Who plays cannot tell a frame from one that is shorter by a fiftieth.
constexpr double kLittle = 0.02;

std::string Percent(double part) {
    return Format("%.0f\x1f%%", 100.0 * part);
}

std::string ExplainRatio(const Ratio &ratio) {
    std::string text = "A step takes " + Time(ratio.stock) + " in stock Box2D and " + Time(ratio.boomerang) +
                       " with Boomerang: ";
    if (!ratio.Tells() && ratio.least > 1.0 - kLittle && ratio.greatest < 1.0 + kLittle)
        text += "no difference";
    else if (!ratio.Tells())
        return text + "too noisy to tell, between " +
               (ratio.least == 1.0 ? "0" : Percent(1.0 - ratio.least) + " slower") + " and " +
               Percent(ratio.greatest - 1.0) + " faster in rounds of " + Count(ratio.steps) + kFirmBlank +
               "steps. Try --rounds " + Count(std::max<size_t>(10, 3 * ratio.rounds)) + ".";
    else if (ratio.ratio > 1.0)
        text += Format("%.3g times as fast", ratio.ratio);
    else
        text += Format("slower, %.3g of stock's speed", ratio.ratio);
    const std::string steps = Count(ratio.steps) + kFirmBlank + "steps).";
    if (ratio.rounds == 1)
        return text + " (one round of " + steps + " (More rounds would tell how sure that is: --rounds.)";
    return text + " (" + Format("%.3g", ratio.least) + " to " + Format("%.3g", ratio.greatest) +
           " in rounds of " + steps;
}

/// The share of the clock's time that is spent in steps.
double ShareOf(const Run &run) {
    const double inSteps = std::accumulate(run.microseconds.begin(), run.microseconds.end(), 0.0);
    return run.seconds > 0.0 ? 1e-6 * inSteps / run.seconds : 0.0;
}

std::string ExplainWork(const Trial &trial) {
    const Run &on = trial.on.front();
    const Place place = PlaceOfBox2D(trial);
    const Ratio ratio = RatioOf(trial);
    std::string text;
    switch (AlreadyIn(trial, place)) {
    case Already::kCompiled:
        text = "This game has Boomerang in it already, " + on.way + ". ";
        break;
    case Already::kNot:
        text = "Box2D is " + (place.shared.empty() ? "there" : "a shared library here, " + place.shared) +
               "; Boomerang is " + on.way + ". ";
        break;
    case Already::kPreloaded:
        text = "Boomerang is preloaded already (LD_PRELOAD), " + on.way + ". ";
        break;
    case Already::kInstalled:
    case Already::kLinked:
        text = "This game is linked with Boomerang already (" + place.boomerang + "), " + on.way + ". ";
        break;
    }
    text += on.noPass.empty() ? "It runs whole steps. "
                              : "It answers for contacts alone, because " + on.noPass + ". ";
    text += ratio.steps == 0 ? "No step was taken in all runs, so nothing is compared by the clock. "
                             : ExplainRatio(ratio) + " ";
    const double share = 100.0 * ShareOf(trial.off.front());
    text += "In stock, steps are " + Format(share < 9.95 ? "%.2g\x1f%%" : "%.0f\x1f%%", share) +
            " of the time that the game runs. ";
    if (!trial.verify)
        return text;
    text +=
        "Under verify " + Count(trial.verify->verified) + " answers were compared with Box2D's: " +
        (trial.verify->differences == 0 ? "none differs." : Count(trial.verify->differences) + " differ.");
    return text;
}

std::string ExplainDifference(const Trial &trial) {
    std::string text = trial.on.empty() ? "" : ExplainWork(trial);
    if (!AnyEndsOtherwise(trial))
        return text;
    text += "\n\nThe game ends otherwise with the library: as it is, " + EndOf(trial.asItIs);
    const Run *last = &trial.asItIs;
    const auto add = [&](const char *name, const Run &run) {
        if (!EndOtherwise(trial.asItIs, run))
            return;
        last = &run;
        text += std::string("; ") + name + ", " + EndOf(run);
    };
    for (const Run &run : trial.off)
        add("off", run);
    for (const Run &run : trial.on)
        add("on", run);
    if (trial.verify)
        add("verify", *trial.verify);
    return text + "." + LastWordsOf(*last);
}

/// A line that begins with blanks stays as it is.
std::string Wrap(const std::string &text, size_t columns) {
    std::istringstream lines(text);
    std::string wrapped;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] == ' ') {
            wrapped += line + "\n";
            continue;
        }
        std::istringstream words(line);
        size_t at = 0;
        for (std::string word; words >> word;) {
            if (at > 0 && at + 1 + word.size() > columns) {
                wrapped += "\n";
                at = 0;
            }
            wrapped += (at == 0 ? "" : " ") + word;
            at += (at == 0 ? 0 : 1) + word.size();
        }
        wrapped += "\n";
    }
    std::replace(wrapped.begin(), wrapped.end(), kFirmBlank, ' ');
    return wrapped;
}

std::string NextWhereAlready(const Trial &trial, Already already, bool slower) {
    if (already == Already::kLinked)
        return "But nothing in it calls bmr::Install(), so that as it is the library does nothing. " +
               (slower ? std::string("It would not pay here: leave the game as it is.")
                       : "Call it before the first step; or play the game so:\n\n    BOOMERANG=on " +
                             CommandOf(trial));
    const std::string off = "BOOMERANG=off in its environment turns Boomerang off.";
    return slower ? "It does not pay here: " + off
                  : "Nothing is left to do: the game as it is plays with Boomerang. " + off;
}

std::string Next(const Trial &trial, Outcome outcome) {
    switch (outcome) {
    case Outcome::kNotAtWork:
        return NextWhereNotAtWork(trial);
    case Outcome::kFailsByItself:
        return "Mend that first; then try again.";
    case Outcome::kDifference:
        return "This should not be: the bits of a simulation are to be Box2D's. Please report it, with the "
               "line "
               "that names the first difference (BOOMERANG=verify in the environment prints it).";
    case Outcome::kAtWork:
        break;
    }
    const Ratio ratio = RatioOf(trial);
    const bool slower = ratio.steps > 0 && ratio.rounds > 1 && ratio.Tells() && ratio.ratio < 1.0;
    const Already already = AlreadyIn(trial, PlaceOfBox2D(trial));
    if (already != Already::kNot)
        return NextWhereAlready(trial, already, slower);
    if (slower)
        return "It does not pay here: leave the game as it is.";
    if (ShareOf(trial.off.front()) < kLittle)
        return "Steps take so little of this game's time that nobody will notice: leave the game as it is, "
               "unless other "
               "levels have more bodies.";
    return "To play it so, without building anything:\n\n    LD_PRELOAD=" + Quoted(trial.preload) + " " +
           CommandOf(trial) +
           "\n\nTo build it in: link boomerang::box2d ahead of Box2D, and call bmr::Install() "
           "before the first step.";
}

} // namespace

std::string Explain(const Trial &trial, Outcome outcome, int columns) {
    std::string text;
    switch (outcome) {
    case Outcome::kAtWork:
        text = ExplainWork(trial);
        break;
    case Outcome::kDifference:
        text = ExplainDifference(trial);
        break;
    case Outcome::kNotAtWork:
        text = ExplainNotAtWork(trial);
        break;
    case Outcome::kFailsByItself:
        text = ExplainFailure(trial);
        break;
    }
    const std::string next = Next(trial, outcome);
    return Wrap(text + (next.empty() ? "" : "\n\n" + next), static_cast<size_t>(columns));
}

} // namespace bmr::trial
