// SPDX-License-Identifier: MIT
#include "report/numbers.h"

#include <algorithm>
#include <fstream>

#include "theory/event_tables.h"

namespace testbed {

std::optional<double> SceneNumbers::operator[](const std::string &figure) const {
    std::string path = "/figures/" + figure;
    std::replace(path.begin(), path.end(), '.', '/');
    const nlohmann::json::json_pointer pointer(path);
    if (!entry.contains(pointer) || !entry.at(pointer).is_number())
        return std::nullopt;
    return entry.at(pointer).get<double>();
}

std::string SceneNumbers::VariantOf(const std::string &way) const {
    const nlohmann::json::json_pointer pointer("/variants/" + way);
    return entry.contains(pointer) ? entry.at(pointer).get<std::string>() : std::string();
}

void Numbers::AddScenes(const nlohmann::json &json, const std::string &source) {
    const nlohmann::json &options = json.at("options");
    const int timed = options.at("repeat");
    repeat = repeat == 0 ? timed : timed == 0 ? repeat : std::min(repeat, timed);
    verified = verified || options.at("mode") == "verify";
    const std::string setting = "structure: " + options.at("structure").get<std::string>() +
                                ", prefilter: " + options.at("prefilter").get<std::string>();
    if (std::find(settings.begin(), settings.end(), setting) == settings.end())
        settings.push_back(setting);
    size_t known = 0;
    for (const nlohmann::json &entry : json.at("scenes")) {
        SceneNumbers scene = {entry.at("name"), entry.at("group"), entry.at("verdict"),
                              entry.at("size"), entry.at("steps"), entry};
        const bool isKnown = std::any_of(scenes.begin(), scenes.end(), [&scene](const SceneNumbers &other) {
            return other.name == scene.name;
        });
        known += isKnown ? 1 : 0;
        (isKnown ? others : scenes).push_back(std::move(scene));
    }
    const size_t count = json.at("scenes").size();
    std::string line = source + ": " + std::to_string(count) + (count == 1 ? " scene" : " scenes");
    if (known != 0)
        line += ", " + std::to_string(known) + " of them known already: shown only where cost grows";
    sources.push_back(line);
}

void Numbers::AddJson(const nlohmann::json &json, const std::string &source) {
    try {
        if (json.is_object() && json.contains("scenes"))
            AddScenes(json, source);
        else if (json.is_array() && !json.empty() && json.front().contains("structure"))
            AddRuns(RunsFromJson(json), source);
        else
            throw NumbersError(source + ": neither what `compare --json` nor what `events --json` writes");
    } catch (const nlohmann::json::exception &error) {
        throw NumbersError(source + ": not what `compare --json` writes: " + error.what());
    } catch (const FileError &error) {
        throw NumbersError(source + ": " + error.what());
    }
}

void Numbers::AddJsonFile(const std::string &path) {
    std::ifstream file(path);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_discarded())
        throw NumbersError(path + ": cannot be read as JSON");
    AddJson(json, path);
}

void Numbers::AddRuns(std::vector<Run> more, const std::string &source) {
    sources.push_back(source + ": " + std::to_string(more.size()) + " runs of kinetic structures");
    runs.insert(runs.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void Numbers::AddCosts(const std::string &path) {
    try {
        costs.push_back(ReadSeriesFile(path));
    } catch (const SeriesFileError &error) {
        throw NumbersError(path + ": " + error.what());
    }
    sources.push_back(path + ": " + std::to_string(costs.back().series.size()) + " series of costs");
}

std::vector<size_t> Numbers::Vertices() const {
    std::vector<size_t> all;
    for (const Run &run : runs)
        all.push_back(run.n);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<Run> Numbers::RunsOf(size_t n) const {
    std::vector<Run> some;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(some),
                 [n](const Run &run) { return run.n == n; });
    CountRatios(some);
    return some;
}

} // namespace testbed
