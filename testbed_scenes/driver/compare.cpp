// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <sstream>

namespace testbed {
namespace {

WorkerRequest RequestFor(Side side, const SceneResult &result, const CompareOptions &options,
                         const char *mode) {
    std::vector<std::string> extra;
    if (side != Side::Stock && options.perturb) // the control perturbs all but stock
        extra = {"--perturb", std::to_string(*options.perturb)};
    if (side == Side::Stock)
        side = StockFor(result.scene);
    return {side, result.scene.name, result.steps, mode, extra};
}

/// All that is hashed after a step: fields and their values, in order.
using Dump = std::vector<std::pair<std::string, std::string>>;

Dump DumpOf(const Workers &workers, Side side, int64_t step, const SceneResult &result,
            const CompareOptions &options) {
    WorkerRequest request = RequestFor(side, result, options, "hash");
    request.steps = step + 1; // steps count from 0
    request.extra.insert(request.extra.end(), {"--dump", std::to_string(step)});
    Dump fields;
    workers.Run(request, options.worker, [&fields](const std::string &line) {
        if (const size_t is = line.find(" = "); is != std::string::npos)
            fields.emplace_back(line.substr(0, is), line.substr(is + 3));
    });
    return fields;
}

/// Which field it is that the hashes of a step disagree about. By name, not by line: where one side has a
/// contact the other has not, every line after it is displaced, and none of those is the difference.
void FindField(const Dump &stock, const Dump &plugin, Difference &difference) {
    constexpr char kAbsent[] = "(none)";
    std::map<std::string, std::string> others(plugin.begin(), plugin.end());
    auto report = [&difference](const std::string &name, const std::string &left, const std::string &right) {
        if (difference.fields++ == 0) {
            difference.field = name;
            difference.stock = left;
            difference.plugin = right;
        }
    };
    for (const auto &[name, value] : stock) {
        const auto other = others.find(name);
        if (other == others.end()) {
            report(name, value, kAbsent);
            continue;
        }
        if (other->second != value)
            report(name, value, other->second);
        others.erase(other);
    }
    for (const auto &[name, value] : plugin)
        if (others.count(name) != 0)
            report(name, kAbsent, value);
}

/// The lines that one side printed of its steps: `step I BODIES CONTACTS EVENTS`, the last three hashes.
/// Throws WorkerError unless it gave all that were asked for.
using Hashes = std::vector<std::string>;
Hashes HashesOf(const Workers &workers, Side side, const CompareOptions &options, const SceneResult &result,
                const std::function<void(size_t)> &onStep = nullptr) {
    Hashes lines;
    workers.Run(RequestFor(side, result, options, "hash"), options.worker, [&](const std::string &line) {
        lines.push_back(line);
        if (onStep)
            onStep(lines.size());
    });
    if (static_cast<int64_t>(lines.size()) != result.steps)
        throw WorkerError(std::string("the worker of ") + NameOf(side) + " ended after " +
                          std::to_string(lines.size()) + " steps");
    return lines;
}

/// The first step whose hashes differ.
std::optional<Difference> FirstDifference(const Hashes &stock, const Hashes &other, Side side) {
    const auto [line, with] = std::mismatch(stock.begin(), stock.end(), other.begin());
    if (line == stock.end())
        return std::nullopt;
    Difference difference;
    difference.side = side;
    difference.step = line - stock.begin();
    std::istringstream words(*line), others(*with);
    for (const char *name : {"word", "number", "bodies", "contacts", "events"}) {
        std::string word, otherWord;
        words >> word;
        others >> otherWord;
        if (word != otherWord)
            difference.hashes += (difference.hashes.empty() ? "" : ", ") + std::string(name);
    }
    return difference;
}

/// Stock and all variants side by side.
void CompareHashes(const Workers &workers, const CompareOptions &options, SceneResult &result,
                   Progress &progress) {
    result.variants[Side::Plugin] = Verdict::Failed;
    if (workers.CanPreload() && !result.scene.NeedsPlugin())
        result.variants[Side::Preloaded] = Verdict::Failed;
    std::map<Side, std::future<Hashes>> others;
    for (const auto &variant : result.variants)
        others[variant.first] = std::async(std::launch::async, [&, side = variant.first] {
            return HashesOf(workers, side, options, result);
        });
    const Hashes stock = HashesOf(workers, Side::Stock, options, result, [&](size_t steps) {
        progress.Show(result.scene.name + ": comparing",
                      static_cast<double>(steps) / static_cast<double>(result.steps));
    });
    for (auto &[side, verdict] : result.variants) {
        const std::optional<Difference> difference = FirstDifference(stock, others[side].get(), side);
        verdict = difference ? Verdict::Different : Verdict::Identical;
        if (difference && (!result.difference || difference->step < result.difference->step))
            result.difference = difference;
    }
    result.verdict = result.difference ? Verdict::Different : Verdict::Identical;
    if (result.difference)
        FindField(DumpOf(workers, Side::Stock, result.difference->step, result, options),
                  DumpOf(workers, result.difference->side, result.difference->step, result, options),
                  *result.difference);
}

void Measure(const Workers &workers, const CompareOptions &options, SceneResult &result, Progress &progress) {
    const auto run = [&](Side side, const char *mode) {
        nlohmann::json summary = workers.Run(RequestFor(side, result, options, mode), options.worker);
        progress.Finish();
        return summary;
    };
    progress.Show(result.scene.name + ": counting");
    result.stockCount = run(Side::Stock, "count");
    result.pluginCount = run(Side::Plugin, "count");
    for (int i = 0; options.time && i < options.repeat; ++i) {
        progress.Show(result.scene.name + ": timing");
        // Taking turns at who goes first, so that a machine that warms up or slows down favours nobody.
        for (const bool isStock : {i % 2 == 0, i % 2 != 0})
            (isStock ? result.stockTimes : result.pluginTimes)
                .push_back(run(isStock ? Side::Stock : Side::Plugin, "time"));
    }
}

} // namespace

const char *NameOf(Verdict verdict) {
    static constexpr const char *names[] = {"identical", "DIFFERENT", "failed"};
    return names[static_cast<size_t>(verdict)];
}

int RunsPerScene(const CompareOptions &options) {
    constexpr int kHashing = 1; // all sides run at once
    constexpr int kCounting = 2;
    return kHashing + kCounting + (options.time ? 2 * options.repeat : 0);
}

SceneResult CompareScene(const Workers &workers, const SceneInfo &scene, const CompareOptions &options,
                         Progress &progress) {
    SceneResult result;
    result.scene = scene;
    result.steps = options.steps.value_or(scene.steps);
    try {
        CompareHashes(workers, options, result, progress);
        progress.Finish();
        // Two simulations that went different ways cannot be held against each other.
        if (result.verdict == Verdict::Identical)
            Measure(workers, options, result, progress);
    } catch (const WorkerError &error) {
        result.verdict = Verdict::Failed;
        result.failure = error.what();
    }
    return result;
}

std::string Explain(const SceneResult &result) {
    if (result.verdict == Verdict::Failed)
        return result.scene.name + ": a worker failed\n  " + result.failure;
    const Difference &difference = *result.difference;
    std::string text = result.scene.name + ": first difference at step " + std::to_string(difference.step) +
                       ", in the hash of " + difference.hashes + " (" + NameOf(difference.side);
    for (const auto &[side, verdict] : result.variants)
        if (verdict == Verdict::Different && side != difference.side)
            text += std::string(", ") + NameOf(side);
    text += ")";
    if (difference.field.empty())
        return text +
               "\n  the dumps of that step agree: what differs is in the order or arguments of events, or a "
               "run does not repeat itself";
    text += "\n  " + difference.field + "\n    stock   " + difference.stock + "\n    plugin  " +
            difference.plugin;
    if (difference.fields > 1)
        text += "\n  and " + std::to_string(difference.fields - 1) + " more field(s) at that step";
    return text;
}

} // namespace testbed
