// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
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

std::vector<DumpField> DumpOf(const Workers &workers, Side side, int64_t step, const SceneResult &result,
                              const CompareOptions &options) {
    WorkerRequest request = RequestFor(side, result, options, "hash");
    request.steps = step + 1; // steps count from 0
    request.extra.insert(request.extra.end(), {"--dump", std::to_string(step)});
    std::vector<DumpField> fields;
    workers.Summarise(request, options.worker, nullptr, [&fields](const std::string &line) {
        if (!IsStepLine(line))
            fields.push_back(ParseDumpLine(line));
    });
    return fields;
}

/// Which field it is that the hashes of a step disagree about. By name, not by line: where one side has a
/// contact the other has not, every line after it is displaced, and none of those is the difference.
void FindField(const std::vector<DumpField> &stock, const std::vector<DumpField> &plugin,
               Difference &difference) {
    constexpr char kAbsent[] = "(none)";
    std::map<std::string, std::string> others;
    for (const DumpField &field : plugin)
        others.emplace(field.name, field.value);
    auto report = [&difference](const std::string &name, const std::string &left, const std::string &right) {
        if (difference.fields++ == 0) {
            difference.field = name;
            difference.stock = Readable(left);
            difference.plugin = Readable(right);
        }
    };
    for (const DumpField &field : stock) {
        const auto other = others.find(field.name);
        if (other == others.end()) {
            report(field.name, field.value, kAbsent);
            continue;
        }
        if (other->second != field.value)
            report(field.name, field.value, other->second);
        others.erase(other);
    }
    for (const DumpField &field : plugin)
        if (others.count(field.name) != 0)
            report(field.name, kAbsent, field.value);
}

/// What one side printed of its steps.
struct HashRun {
    Side side = Side::Stock;
    std::vector<std::string> lines;
    bool ended = false; ///< with a summary
    std::unique_ptr<Process> process;
};

/// Throws WorkerError unless a run gave all the steps asked for, and its summary.
void CheckComplete(const HashRun &run, int64_t steps) {
    if (!run.process->Succeeded())
        throw WorkerError(run.process->Describe());
    if (!run.ended || static_cast<int64_t>(run.lines.size()) != steps)
        throw WorkerError(run.process->CommandLine() + ": ended after " + std::to_string(run.lines.size()) +
                          " steps, or without a summary");
}

/// The first step of two complete runs whose hashes differ.
std::optional<Difference> FirstDifference(const HashRun &stock, const HashRun &other) {
    const auto [line, with] = std::mismatch(stock.lines.begin(), stock.lines.end(), other.lines.begin());
    if (line == stock.lines.end())
        return std::nullopt;
    Difference difference;
    difference.side = other.side;
    difference.step = line - stock.lines.begin();
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
std::vector<HashRun> RunHashes(const Workers &workers, const CompareOptions &options,
                               const SceneResult &result, Progress &progress) {
    std::vector<HashRun> runs(1 + result.variants.size());
    std::vector<Process *> processes;
    for (size_t i = 0; i < runs.size(); ++i) {
        HashRun &run = runs[i];
        run.side = i == 0 ? Side::Stock : result.variants[i - 1].side;
        run.process = workers.Start(RequestFor(run.side, result, options, "hash"), options.worker,
                                    [&run](const std::string &line) {
                                        if (IsStepLine(line))
                                            run.lines.push_back(line);
                                        else
                                            run.ended = run.ended || IsSummaryLine(line);
                                    });
        processes.push_back(run.process.get());
    }
    RunAll(processes, [&] {
        size_t least = runs[0].lines.size();
        for (const HashRun &run : runs)
            least = std::min(least, run.lines.size());
        progress.Show(result.scene.name + ": comparing",
                      static_cast<double>(least) / static_cast<double>(result.steps));
    });
    return runs;
}

void CompareHashes(const Workers &workers, const CompareOptions &options, SceneResult &result,
                   Progress &progress) {
    for (const Side side : {Side::Plugin, Side::Preloaded, Side::Accelerated})
        if ((side != Side::Preloaded || (workers.CanPreload() && !result.scene.NeedsPlugin())) &&
            (side != Side::Accelerated || workers.CanAccelerate()))
            result.variants.push_back({side, Verdict::Failed});
    const std::vector<HashRun> runs = RunHashes(workers, options, result, progress);
    for (const HashRun &run : runs)
        CheckComplete(run, result.steps);
    for (size_t i = 1; i < runs.size(); ++i) {
        const std::optional<Difference> difference = FirstDifference(runs[0], runs[i]);
        result.variants[i - 1].verdict = difference ? Verdict::Different : Verdict::Identical;
        if (difference && (!result.difference || difference->step < result.difference->step))
            result.difference = difference;
    }
    result.verdict = result.difference ? Verdict::Different : Verdict::Identical;
    if (result.difference)
        FindField(DumpOf(workers, Side::Stock, result.difference->step, result, options),
                  DumpOf(workers, result.difference->side, result.difference->step, result, options),
                  *result.difference);
}

/// Stock, the plugin; and the accelerated Box2D where there is one.
int TimedSides(const Workers &workers) {
    return workers.CanAccelerate() ? 3 : 2;
}

void Measure(const Workers &workers, const CompareOptions &options, SceneResult &result, Progress &progress) {
    progress.Show(result.scene.name + ": counting", 0.0);
    auto tick = [&progress] { progress.Tick(); };
    result.stockCount =
        workers.Summarise(RequestFor(Side::Stock, result, options, "count"), options.worker, tick);
    progress.Finish();
    result.pluginCount =
        workers.Summarise(RequestFor(Side::Plugin, result, options, "count"), options.worker, tick);
    progress.Finish();
    if (!options.worker.structure.empty()) {
        WorkerOptions asGamesHaveIt = options.worker;
        asGamesHaveIt.structure.clear();
        result.linesCount =
            workers.Summarise(RequestFor(Side::Plugin, result, options, "count"), asGamesHaveIt, tick);
        progress.Finish();
    }
    if (!options.time)
        return;
    for (int i = 0; i < options.repeat; ++i) {
        progress.Show(result.scene.name + ": timing", 0.0);
        // Taking turns at who goes first, so that a machine that warms up or slows down favours nobody.
        constexpr Side kSides[] = {Side::Stock, Side::Plugin, Side::Accelerated};
        std::vector<nlohmann::json> *const times[] = {&result.stockTimes, &result.pluginTimes,
                                                      &result.acceleratedTimes};
        const int sides = TimedSides(workers);
        for (int turn = 0; turn < sides; ++turn) {
            const int side = (turn + i) % sides;
            times[side]->push_back(
                workers.Summarise(RequestFor(kSides[side], result, options, "time"), options.worker, tick));
            progress.Finish();
        }
    }
}

} // namespace

const char *NameOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Identical:
        return "identical";
    case Verdict::Different:
        return "DIFFERENT";
    case Verdict::Failed:
        break;
    }
    return "failed";
}

int RunsPerScene(const Workers &workers, const CompareOptions &options) {
    constexpr int kHashing = 1; // all sides run at once
    const int counting = options.worker.structure.empty() ? 2 : 3;
    return kHashing + counting + (options.time ? TimedSides(workers) * options.repeat : 0);
}

const Variant *FindVariant(const SceneResult &result, Side side) {
    for (const Variant &variant : result.variants)
        if (variant.side == side)
            return &variant;
    return nullptr;
}

SceneResult CompareScene(const Workers &workers, const SceneInfo &scene, const CompareOptions &options,
                         Progress &progress) {
    SceneResult result;
    result.scene = scene;
    if (options.worker.size)
        result.scene.size = *options.worker.size;
    if (options.worker.seed)
        result.scene.seed = *options.worker.seed;
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
    if (!result.difference)
        return result.scene.name + ": identical over " + std::to_string(result.steps) + " steps";
    const Difference &difference = *result.difference;
    std::string text = result.scene.name + ": first difference at step " + std::to_string(difference.step) +
                       ", in the hash of " + difference.hashes + " (" + NameOf(difference.side);
    for (const Variant &variant : result.variants)
        if (variant.verdict == Verdict::Different && variant.side != difference.side)
            text += std::string(", ") + NameOf(variant.side);
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
