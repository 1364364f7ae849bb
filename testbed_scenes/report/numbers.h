// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_NUMBERS_H
#define BOOMERANG_TESTBED_NUMBERS_H

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "drawing/series_file.h"
#include "theory/experiment.h"

namespace testbed {

/// What is wrong with numbers that somebody else wrote: "results.json: ...".
class NumbersError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// One scene of `compare --json`.
struct SceneNumbers {
    std::string name, group, verdict;
    int64_t size = 0, steps = 0;
    nlohmann::json entry;

    /// A figure by its name of driver/figures.h, such as "ratio.step"; nothing where it is unknown.
    std::optional<double> operator[](const std::string &figure) const;
    /// "identical", "DIFFERENT" or "failed" of one way to have the plugin at work; empty if it was not run.
    std::string VariantOf(const std::string &way) const;
};

/// Everything that a report may show, from as many files as there are.
struct Numbers {
    std::vector<SceneNumbers> scenes; ///< each name once: the first that came
    std::vector<SceneNumbers> others; ///< the same scenes again, of other sizes: they show how cost grows
    int repeat = 0;                   ///< timed runs of a side, the fewest of all files; 0: none
    bool verified = false;            ///< there are scenes of `compare --mode verify`
    std::vector<std::string> settings;
    std::vector<Run> runs;
    std::vector<SeriesFile> costs;
    std::vector<std::string> sources; ///< where it all came from, one line each

    /// Takes what `compare --json` or `events --json` wrote. Throws NumbersError on anything else.
    void AddJson(const nlohmann::json &json, const std::string &source);
    /// The same from a file.
    void AddJsonFile(const std::string &path);
    void AddRuns(std::vector<Run> more, const std::string &source);
    /// A file of series,x,y.
    void AddCosts(const std::string &path);

    bool IsEmpty() const { return scenes.empty() && runs.empty() && costs.empty(); }
    /// Runs of one number of vertices, with ratios counted anew.
    std::vector<Run> RunsOf(size_t n) const;
    /// The numbers of vertices, ascending.
    std::vector<size_t> Vertices() const;

private:
    void AddScenes(const nlohmann::json &json, const std::string &source);
};

} // namespace testbed

#endif
