// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SHAPES_COMPARISON_H
#define BOOMERANG_TESTBED_SHAPES_COMPARISON_H

#include <optional>
#include <string>
#include <vector>

#include "progress.h"
#include "workers.h"

/// @file
/// The same world of polygons of many vertices in three ways, each in processes of its own: one fixture a
/// body with the plugin, many stock fixtures, circles; beside them stock octagons of the same size. Their
/// bits cannot agree, for the worlds are not the same: what is compared is what a step costs and how the
/// world behaves.

namespace testbed {

struct ShapesOptions {
    WorkerOptions worker;
    std::vector<int64_t> vertices = {16, 64, 256, 1024, 4096}; ///< ascending; of outlines the scene's own
    bool many = true, circles = true;
    int64_t manyUpTo = 256;  ///< bodies of more fixtures than these vertices need are left out
    int64_t manySteps = 100; ///< of those that take long: of more vertices than kManyAtLength
    std::optional<int64_t> steps;
    int repeat = 3;
};

/// Is the scene one of concave bodies? These are compared as outlines with the plugin, as triangles with it,
/// and as triangles on stock Box2D.
inline bool IsOfOutlines(const SceneInfo &scene) {
    return scene.group == "outlines";
}

/// Bodies of many fixtures run all steps up to here.
constexpr int64_t kManyAtLength = 64;

/// One world.
struct ShapesRow {
    std::string bodies;   ///< octagon, circle, one, many; of outlines: outline, triangles, stock triangles
    int64_t vertices = 0; ///< 0 of a circle
    int64_t steps = 0;
    nlohmann::json count;              ///< summary of the counting run
    std::vector<nlohmann::json> times; ///< of the timed runs, by repeat
};

struct ShapesResult {
    SceneInfo scene;
    int64_t steps = 0;
    std::vector<ShapesRow> rows; ///< octagons first, circles, then by vertices
};

/// Throws WorkerError. The timed runs of all rows take turns.
ShapesResult CompareShapes(const Workers &workers, const SceneInfo &scene, const ShapesOptions &options,
                           Progress &progress);
/// Worker runs that it takes.
int RunsOf(const SceneInfo &scene, const ShapesOptions &options);

/// The row of these bodies that ran as many steps, or nullptr.
const ShapesRow *FindRow(const ShapesResult &result, const std::string &bodies, int64_t vertices,
                         int64_t steps);

/// Microseconds a step, the median over the timed runs.
std::optional<double> StepTime(const ShapesRow &row);
/// How many times as long a step of `row` takes as one of `other`: the median over pairs of runs.
std::optional<double> TimeRatio(const ShapesRow &row, const ShapesRow *other);

} // namespace testbed

#endif
