// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <deque>
#include <map>

namespace testbed {
namespace {

/// The extra arguments of one side's run: the control perturbs the plugin's side alone.
std::vector<std::string> ExtraFor(Side side, const CompareOptions &options) {
    if (side == Side::Plugin && options.perturb)
        return {"--perturb", std::to_string(*options.perturb)};
    return {};
}

WorkerRequest RequestFor(Side side, const SceneResult &result, const CompareOptions &options,
                         const char *mode) {
    return {side, result.scene.name, result.steps, mode, ExtraFor(side, options)};
}

/// Matches two streams of steps as they arrive, whichever is ahead, and keeps only what the other has not
/// reached.
class StreamMatcher {
public:
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
        m_difference->step = stock.step;
        auto name = [this](bool differs, const char *what) {
            if (differs)
                m_difference->hashes += (m_difference->hashes.empty() ? "" : ", ") + std::string(what);
        };
        name(stock.bodies != plugin.bodies, "bodies");
        name(stock.contacts != plugin.contacts, "contacts");
        name(stock.events != plugin.events, "events");
    }

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

void CompareHashes(const Workers &workers, const CompareOptions &options, SceneResult &result,
                   Progress &progress) {
    const std::string what = result.scene.name + ": comparing";
    StreamMatcher matcher;
    std::unique_ptr<Process> processes[2];
    auto handler = [&](Side side) {
        return [&, side](const std::string &line) {
            matcher.Add(side, line);
            if (matcher.GetDifference()) {
                // The rest of both runs says nothing more: what follows a difference is its consequence.
                for (const auto &process : processes)
                    process->Kill();
            }
        };
    };
    // Side by side: each step is compared when both have reached it.
    for (Side side : {Side::Stock, Side::Plugin})
        processes[side == Side::Stock ? 0 : 1] =
            workers.Start(RequestFor(side, result, options, "hash"), options.worker, handler(side));
    RunAll({processes[0].get(), processes[1].get()}, [&] {
        progress.Show(what, static_cast<double>(matcher.Matched()) / static_cast<double>(result.steps));
    });
    if (matcher.GetDifference()) {
        result.difference = matcher.GetDifference();
        result.verdict = Verdict::Different;
        FindField(DumpOf(workers, Side::Stock, result.difference->step, result, options),
                  DumpOf(workers, Side::Plugin, result.difference->step, result, options),
                  *result.difference);
        return;
    }
    for (const auto &process : processes)
        if (!process->Succeeded())
            throw WorkerError(process->Describe());
    if (!matcher.IsComplete(result.steps))
        throw WorkerError(processes[1]->CommandLine() + ": ended after " + std::to_string(matcher.Matched()) +
                          " steps, or without a summary");
    result.verdict = Verdict::Identical;
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
    if (!options.time)
        return;
    for (int i = 0; i < options.repeat; ++i) {
        progress.Show(result.scene.name + ": timing", 0.0);
        // Alternating which side goes first, so that a machine that warms up or slows down favours neither.
        for (int turn = 0; turn < 2; ++turn) {
            const Side side = (turn + i) % 2 == 0 ? Side::Stock : Side::Plugin;
            auto &times = side == Side::Stock ? result.stockTimes : result.pluginTimes;
            times.push_back(
                workers.Summarise(RequestFor(side, result, options, "time"), options.worker, tick));
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

int RunsPerScene(const CompareOptions &options) {
    constexpr int kHashing = 1; // the two sides run at once
    constexpr int kCounting = 2;
    return kHashing + kCounting + (options.time ? 2 * options.repeat : 0);
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
                       ", in the hash of " + difference.hashes;
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
