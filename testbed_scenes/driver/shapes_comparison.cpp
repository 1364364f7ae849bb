// SPDX-License-Identifier: MIT
#include "shapes_comparison.h"

#include <algorithm>

#include "figures.h"

namespace testbed {
namespace {

constexpr int64_t kOctagon = 8;

std::vector<ShapesRow> RowsOf(const SceneInfo &scene, const ShapesOptions &options) {
    const int64_t steps = options.steps.value_or(scene.steps);
    if (IsOfOutlines(scene))
        return {{"outline", scene.vertices, steps, {}, {}},
                {"triangles", scene.vertices, steps, {}, {}},
                {"stock triangles", scene.vertices, steps, {}, {}}};
    const int64_t few = std::min(steps, options.manySteps);
    std::vector<ShapesRow> rows = {{"octagon", kOctagon, steps, {}, {}}};
    if (options.circles)
        rows.push_back({"circle", 0, steps, {}, {}});
    for (const int64_t vertices : options.vertices) {
        rows.push_back({"one", vertices, steps, {}, {}});
        if (!options.many || vertices > options.manyUpTo)
            continue;
        const bool whole = vertices <= kManyAtLength || few == steps;
        if (!whole) // the same steps of both
            rows.push_back({"one", vertices, few, {}, {}});
        rows.push_back({"many", vertices, whole ? steps : few, {}, {}});
    }
    return rows;
}

WorkerRequest RequestFor(const SceneInfo &scene, const ShapesRow &row, const char *mode) {
    const bool one = row.bodies == "one" || row.bodies == "outline";
    WorkerRequest request;
    request.side = one || row.bodies == "triangles" ? Side::Plugin : Side::Stock;
    request.scene = scene.name;
    request.steps = row.steps;
    request.mode = mode;
    request.extra = {"--bodies",
                     one                      ? "one"
                     : row.bodies == "circle" ? "circle"
                                              : "many",
                     "--vertices", std::to_string(row.vertices > 0 ? row.vertices : kOctagon)};
    return request;
}

std::string Describe(const SceneInfo &scene, const ShapesRow &row) {
    return scene.name + ", " + row.bodies + (row.vertices > 0 ? " " + std::to_string(row.vertices) : "");
}

} // namespace

int RunsOf(const SceneInfo &scene, const ShapesOptions &options) {
    return static_cast<int>(RowsOf(scene, options).size()) * (1 + options.repeat);
}

ShapesResult CompareShapes(const Workers &workers, const SceneInfo &scene, const ShapesOptions &options,
                           Progress &progress) {
    ShapesResult result{scene, options.steps.value_or(scene.steps), RowsOf(scene, options)};
    result.scene.size = options.worker.size.value_or(scene.size);
    result.scene.seed = options.worker.seed.value_or(scene.seed);
    auto run = [&](const ShapesRow &row, const char *mode) {
        progress.Show(Describe(scene, row), 0.0);
        nlohmann::json summary =
            workers.Summarise(RequestFor(scene, row, mode), options.worker, [&progress] { progress.Tick(); });
        progress.Finish();
        return summary;
    };
    for (ShapesRow &row : result.rows)
        row.count = run(row, "count");
    for (int i = 0; i < options.repeat; ++i)
        for (size_t turn = 0; turn < result.rows.size(); ++turn) {
            // Taking turns at who goes first, so that a machine that warms up or slows down favours nobody.
            ShapesRow &row = result.rows[(turn + static_cast<size_t>(i)) % result.rows.size()];
            row.times.push_back(run(row, "time"));
        }
    return result;
}

const ShapesRow *FindRow(const ShapesResult &result, const std::string &bodies, int64_t vertices,
                         int64_t steps) {
    for (const ShapesRow &row : result.rows)
        if (row.bodies == bodies && row.vertices == vertices && row.steps == steps)
            return &row;
    return nullptr;
}

std::optional<double> StepTime(const ShapesRow &row) {
    std::vector<double> times;
    for (const nlohmann::json &run : row.times)
        if (const std::optional<double> total = NumberAt(run, "/step_ns_total"))
            times.push_back(1e-3 * *total / static_cast<double>(row.steps));
    return Median(std::move(times));
}

std::optional<double> TimeRatio(const ShapesRow &row, const ShapesRow *other) {
    std::vector<double> ratios;
    for (size_t i = 0; other != nullptr && i < std::min(row.times.size(), other->times.size()); ++i) {
        const std::optional<double> time = NumberAt(row.times[i], "/step_ns_total");
        const std::optional<double> base = NumberAt(other->times[i], "/step_ns_total");
        if (time && base && *base > 0.0)
            ratios.push_back(*time / static_cast<double>(row.steps) /
                             (*base / static_cast<double>(other->steps)));
    }
    return Median(std::move(ratios));
}

} // namespace testbed
