// SPDX-License-Identifier: MIT
#include "try/verdict.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "try/place.h"

namespace bmr::trial {

namespace {

double Mean(const std::vector<float> &numbers, size_t count) {
    return std::accumulate(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
           static_cast<double>(count);
}

double Median(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const size_t half = numbers.size() / 2;
    return numbers.size() % 2 == 1 ? numbers[half] : 0.5 * (numbers[half - 1] + numbers[half]);
}

const char *NameOf(Outcome outcome) {
    switch (outcome) {
    case Outcome::kAtWork:
        return "at work";
    case Outcome::kDifference:
        return "difference";
    case Outcome::kNotAtWork:
        return "not at work";
    case Outcome::kFailsByItself:
        break;
    }
    return "fails by itself";
}

nlohmann::ordered_json JsonOf(const Run &run) {
    nlohmann::ordered_json json;
    json["seconds"] = run.seconds;
    json["end"] = EndOf(run);
    json["steps"] = run.steps;
    if (!run.microseconds.empty())
        json["microseconds_a_step"] = Mean(run.microseconds, run.microseconds.size());
    return json;
}

} // namespace

std::string EndOf(const Run &run) {
    if (!run.ended)
        return "did not end";
    if (WIFSIGNALED(run.status))
        return "was ended by signal " + std::to_string(WTERMSIG(run.status)) + " (" +
               strsignal(WTERMSIG(run.status)) + ")";
    return "exit status " + std::to_string(WEXITSTATUS(run.status));
}

bool EndedBadly(const Run &run) {
    return run.ended && run.status != 0;
}

bool EndOtherwise(const Run &a, const Run &b) {
    return a.ended && b.ended ? a.status != b.status : EndedBadly(a) || EndedBadly(b);
}

bool AnyEndsOtherwise(const Trial &trial) {
    const auto otherwise = [&](const Run &run) { return EndOtherwise(trial.asItIs, run); };
    return std::any_of(trial.off.begin(), trial.off.end(), otherwise) ||
           std::any_of(trial.on.begin(), trial.on.end(), otherwise) ||
           (trial.verify && otherwise(*trial.verify));
}

Ratio RatioOf(const Trial &trial) {
    Ratio ratio;
    size_t steps = trial.off.empty() || trial.off.size() != trial.on.size() ? 0 : TrialPage::kMostSteps;
    for (const std::vector<Run> *runs : {&trial.off, &trial.on})
        for (const Run &run : *runs)
            steps = std::min(steps, run.microseconds.size());
    if (steps == 0)
        return ratio;
    std::vector<double> stock, boomerang, ratios;
    for (size_t round = 0; round < trial.off.size(); ++round) {
        stock.push_back(Mean(trial.off[round].microseconds, steps));
        boomerang.push_back(Mean(trial.on[round].microseconds, steps));
        if (boomerang.back() <= 0.0)
            return ratio;
        ratios.push_back(stock.back() / boomerang.back());
    }
    ratio.steps = steps;
    ratio.rounds = ratios.size();
    ratio.stock = Median(stock);
    ratio.boomerang = Median(boomerang);
    ratio.ratio = ratio.stock / ratio.boomerang;
    ratio.least = *std::min_element(ratios.begin(), ratios.end());
    ratio.greatest = *std::max_element(ratios.begin(), ratios.end());
    return ratio;
}

Outcome JudgeAsItIs(const Trial &trial) {
    const bool crashed = trial.asItIs.ended && WIFSIGNALED(trial.asItIs.status);
    const bool notFound = EndOf(trial.asItIs) == kShellsStatus;
    return crashed || notFound ? Outcome::kFailsByItself : Outcome::kAtWork;
}

Outcome Judge(const Trial &trial) {
    if (JudgeAsItIs(trial) != Outcome::kAtWork)
        return Outcome::kFailsByItself;
    if (AnyEndsOtherwise(trial) || (trial.verify && trial.verify->differences > 0))
        return Outcome::kDifference;
    if (trial.on.empty() || trial.on.front().way.empty()) {
        // Without a step this is not known; a game that complains of something has not come as far.
        const bool noStep = trial.off.empty() || trial.off.front().steps == 0;
        const bool hasBox2D = !PlaceOfBox2D(trial).shared.empty();
        return noStep && EndedBadly(trial.asItIs) && hasBox2D ? Outcome::kFailsByItself : Outcome::kNotAtWork;
    }
    return Outcome::kAtWork;
}

std::string ExplainAsJson(const Trial &trial, Outcome outcome) {
    nlohmann::ordered_json json;
    json["outcome"] = NameOf(outcome);
    json["command"] = trial.command;
    json["as_it_is"] = JsonOf(trial.asItIs);
    for (const Run &run : trial.off)
        json["off"].push_back(JsonOf(run));
    for (const Run &run : trial.on)
        json["on"].push_back(JsonOf(run));
    if (!trial.on.empty()) {
        json["way"] = trial.on.front().way;
        json["why_contacts_alone"] = trial.on.front().noPass;
        json["why_not"] = trial.on.front().whyNot;
    }
    if (trial.verify) {
        json["verify"] = JsonOf(*trial.verify);
        json["verify"]["verified"] = trial.verify->verified;
        json["verify"]["differences"] = trial.verify->differences;
    }
    const Ratio ratio = RatioOf(trial);
    if (ratio.steps > 0)
        json["ratio"] = {{"steps", ratio.steps},
                         {"stock_microseconds", ratio.stock},
                         {"boomerang_microseconds", ratio.boomerang},
                         {"ratio", ratio.ratio},
                         {"least", ratio.least},
                         {"greatest", ratio.greatest}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace bmr::trial
