// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>

namespace testbed {
namespace {

/// The extra arguments of one side's run: the control perturbs all but stock.
std::vector<std::string> ExtraFor(Side side, const CompareOptions &options) {
    if (side != Side::Stock && options.perturb)
        return {"--perturb", std::to_string(*options.perturb)};
    return {};
}

WorkerRequest RequestFor(Side side, const SceneResult &result, const CompareOptions &options,
                         const char *mode) {
    const std::vector<std::string> extra = ExtraFor(side, options);
    if (side == Side::Stock)
        side = StockFor(result.scene);
    return {side, result.scene.name, result.steps, mode, extra};
}

/// Matches two streams of steps as they arrive, whichever is ahead, and keeps only what the other has not
/// reached.
class StreamMatcher {
public:
    explicit StreamMatcher(Side side) : m_side(side) {}

    Side GetSide() const { return m_side; }
    void Add(Side side, const std::string &line) {
        if (IsSummaryLine(line)) {
            ParseSummaryLine(line);
            m_ended[Index(side)] = true;
            return;
        }
        StepHash hash = ParseStepLine(line);
        if (hash.step != m_next[Index(side)]++)
            throw WorkerError("printed a step out of turn: \"" + line + "\"");
        m_waiting[Index(side)].push_back(std::move(hash));
        while (!m_difference && !m_waiting[0].empty() && !m_waiting[1].empty()) {
            Match(m_waiting[0].front(), m_waiting[1].front());
            m_waiting[0].pop_front();
            m_waiting[1].pop_front();
        }
    }

    const std::optional<Difference> &GetDifference() const { return m_difference; }
    int64_t Matched() const { return m_matched; }
    /// Both sides gave all the steps asked for, and their summaries.
    bool IsComplete(int64_t steps) const { return m_ended[0] && m_ended[1] && m_matched == steps; }

private:
    static size_t Index(Side side) { return side == Side::Stock ? 0 : 1; }

    void Match(const StepHash &stock, const StepHash &plugin) {
        if (stock == plugin) {
            ++m_matched;
            return;
        }
        m_difference.emplace();
        m_difference->side = m_side;
        m_difference->step = stock.step;
        auto name = [this](bool differs, const char *what) {
            if (differs)
                m_difference->hashes += (m_difference->hashes.empty() ? "" : ", ") + std::string(what);
        };
        name(stock.bodies != plugin.bodies, "bodies");
        name(stock.contacts != plugin.contacts, "contacts");
        name(stock.events != plugin.events, "events");
    }

    Side m_side;
    std::deque<StepHash> m_waiting[2];
    int64_t m_next[2] = {0, 0};
    bool m_ended[2] = {false, false};
    int64_t m_matched = 0;
    std::optional<Difference> m_difference;
};

std::vector<DumpField> DumpOf(const Workers &workers, Side side, int64_t step, const SceneResult &result,
                              const CompareOptions &options) {
    WorkerRequest request = RequestFor(side, result, options, "hash");
    request.steps = step + 1; // steps count from 0
    request.extra.insert(request.extra.end(), {"--dump", std::to_string(step)});
    std::vector<DumpField> fields;
    const auto process = workers.Start(request, options.worker, [&fields](const std::string &line) {
        if (!IsStepLine(line) && !IsSummaryLine(line))
            fields.push_back(ParseDumpLine(line));
    });
    RunAll({process.get()});
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
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
    std::map<std::string, std::string> missed;
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

/// Stock and all variants side by side: each step is compared when both have reached it. A variant that
/// differs is ended, for what follows a difference is its consequence; so is stock when nobody is left.
class HashComparison {
public:
    HashComparison(const Workers &workers, const CompareOptions &options, const SceneResult &result) {
        for (const Variant &variant : result.variants)
            m_matchers.emplace_back(variant.side);
        m_processes.push_back(workers.Start(RequestFor(Side::Stock, result, options, "hash"), options.worker,
                                            [this](const std::string &line) {
                                                for (StreamMatcher &matcher : m_matchers)
                                                    Add(matcher, Side::Stock, line);
                                            }));
        for (StreamMatcher &matcher : m_matchers)
            m_processes.push_back(workers.Start(
                RequestFor(matcher.GetSide(), result, options, "hash"), options.worker,
                [this, &matcher](const std::string &line) { Add(matcher, matcher.GetSide(), line); }));
    }

    void Run(const std::function<void(int64_t matched)> &onTick) {
        std::vector<Process *> processes;
        for (const auto &process : m_processes)
            processes.push_back(process.get());
        RunAll(processes, [&] {
            int64_t matched = 0;
            for (const StreamMatcher &matcher : m_matchers)
                matched = std::max(matched, matcher.Matched());
            onTick(matched);
        });
    }

    /// Throws where a worker did not do its job.
    std::optional<Difference> Take(SceneResult &result) const {
        std::optional<Difference> earliest;
        for (size_t i = 0; i < m_matchers.size(); ++i) {
            const StreamMatcher &matcher = m_matchers[i];
            if (const std::optional<Difference> &difference = matcher.GetDifference()) {
                result.variants[i].verdict = Verdict::Different;
                if (!earliest || difference->step < earliest->step)
                    earliest = difference;
                continue;
            }
            for (const auto *process : {m_processes[0].get(), m_processes[i + 1].get()})
                if (!process->Succeeded())
                    throw WorkerError(process->Describe());
            if (!matcher.IsComplete(result.steps))
                throw WorkerError(m_processes[i + 1]->CommandLine() + ": ended after " +
                                  std::to_string(matcher.Matched()) + " steps, or without a summary");
            result.variants[i].verdict = Verdict::Identical;
        }
        return earliest;
    }

private:
    void Add(StreamMatcher &matcher, Side side, const std::string &line) {
        if (matcher.GetDifference())
            return;
        matcher.Add(side, line);
        if (!matcher.GetDifference())
            return;
        const auto index = static_cast<size_t>(&matcher - m_matchers.data());
        m_processes[index + 1]->Kill();
        if (std::all_of(m_matchers.begin(), m_matchers.end(),
                        [](const StreamMatcher &each) { return each.GetDifference().has_value(); }))
            m_processes[0]->Kill();
    }

    std::vector<StreamMatcher> m_matchers;
    std::vector<std::unique_ptr<Process>> m_processes; ///< stock, then one for each matcher
};

void CompareHashes(const Workers &workers, const CompareOptions &options, SceneResult &result,
                   Progress &progress) {
    const std::string what = result.scene.name + ": comparing";
    for (const Side side : {Side::Plugin, Side::Preloaded, Side::Accelerated})
        if ((side != Side::Preloaded || (workers.CanPreload() && !result.scene.NeedsPlugin())) &&
            (side != Side::Accelerated || workers.CanAccelerate()))
            result.variants.push_back({side, Verdict::Failed});
    HashComparison comparison(workers, options, result);
    comparison.Run([&](int64_t matched) {
        progress.Show(what, static_cast<double>(matched) / static_cast<double>(result.steps));
    });
    result.difference = comparison.Take(result);
    result.verdict = result.difference ? Verdict::Different : Verdict::Identical;
    if (result.difference)
        FindField(DumpOf(workers, Side::Stock, result.difference->step, result, options),
                  DumpOf(workers, result.difference->side, result.difference->step, result, options),
                  *result.difference);
}

/// Everything twice in one process: the plugin itself compares.
void CompareAnswers(const Workers &workers, const CompareOptions &options, SceneResult &result,
                    Progress &progress) {
    progress.Show(result.scene.name + ": verifying", 0.0);
    const auto process = workers.Start(RequestFor(Side::Verify, result, options, "count"), options.worker,
                                       [&result](const std::string &line) {
                                           if (IsSummaryLine(line))
                                               result.verifyCount = ParseSummaryLine(line);
                                       });
    RunAll({process.get()}, [&progress] { progress.Tick(); });
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
    const std::optional<double> differences = NumberAt(result.verifyCount, "/plugin/differences");
    if (!differences)
        throw WorkerError(process->CommandLine() + ": ended without saying what it compared");
    for (const std::string &line : process->Errors())
        result.verifyWords += (result.verifyWords.empty() ? "" : "\n  ") + line;
    result.verdict = *differences == 0.0 ? Verdict::Identical : Verdict::Different;
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
    if (options.verify)
        return 1;
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
        if (options.verify) {
            CompareAnswers(workers, options, result, progress);
            progress.Finish();
            return result;
        }
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
    if (!result.verifyWords.empty())
        return result.scene.name + ": " + result.verifyWords;
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
