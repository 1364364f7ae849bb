// SPDX-License-Identifier: MIT
#include "protocol.h"

#include <cstdlib>
#include <sstream>

#include "process.h"

namespace testbed {
namespace {

constexpr char kStepPrefix[] = "step ";
constexpr char kSummaryPrefix[] = "summary ";
/// As much of an unexpected line as helps to recognise it.
constexpr size_t kQuotedLength = 100;

bool StartsWith(const std::string &text, const std::string &prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

std::string Quote(const std::string &line) {
    return "\"" + (line.size() > kQuotedLength ? line.substr(0, kQuotedLength) + "..." : line) + "\"";
}

bool IsHash(const std::string &word) {
    return !word.empty() && word.find_first_not_of("0123456789abcdef") == std::string::npos;
}

} // namespace

std::vector<SceneInfo> ParseSceneList(const std::string &text) {
    std::vector<SceneInfo> scenes;
    try {
        for (const nlohmann::json &entry : nlohmann::json::parse(text)) {
            SceneInfo scene;
            entry.at("name").get_to(scene.name);
            entry.at("description").get_to(scene.description);
            entry.at("group").get_to(scene.group);
            entry.at("size").get_to(scene.size);
            entry.at("seed").get_to(scene.seed);
            entry.at("steps").get_to(scene.steps);
            entry.at("vertices").get_to(scene.vertices);
            entry.at("bodies").get_to(scene.bodies);
            scenes.push_back(scene);
        }
    } catch (const nlohmann::json::exception &error) {
        throw WorkerError(std::string("the worker's list of scenes cannot be read: ") + error.what());
    }
    return scenes;
}

nlohmann::json ToJson(const SceneInfo &scene) {
    return {{"name", scene.name},         {"description", scene.description},
            {"group", scene.group},       {"size", scene.size},
            {"seed", scene.seed},         {"steps", scene.steps},
            {"vertices", scene.vertices}, {"bodies", scene.bodies}};
}

bool IsStepLine(const std::string &line) {
    return StartsWith(line, kStepPrefix);
}

StepHash ParseStepLine(const std::string &line) {
    std::istringstream words(line.substr(sizeof kStepPrefix - 1));
    StepHash hash;
    std::string rest;
    if (!(words >> hash.step >> hash.bodies >> hash.contacts >> hash.events) || words >> rest ||
        !IsHash(hash.bodies) || !IsHash(hash.contacts) || !IsHash(hash.events))
        throw WorkerError("printed a step that cannot be read: " + Quote(line));
    return hash;
}

bool IsSummaryLine(const std::string &line) {
    return StartsWith(line, kSummaryPrefix);
}

nlohmann::json ParseSummaryLine(const std::string &line) {
    try {
        nlohmann::json summary = nlohmann::json::parse(line.substr(sizeof kSummaryPrefix - 1));
        if (summary.is_object())
            return summary;
    } catch (const nlohmann::json::exception &) {
        // Reported below, like a summary that is no object.
    }
    throw WorkerError("printed a summary that cannot be read: " + Quote(line));
}

DumpField ParseDumpLine(const std::string &line) {
    const size_t space = line.rfind(' ');
    if (space == std::string::npos || space == 0 || space + 1 == line.size())
        throw WorkerError("printed something unexpected: " + Quote(line));
    return {line.substr(0, space), line.substr(space + 1)};
}

std::string Readable(const std::string &value) {
    if (!StartsWith(value, "0x") && !StartsWith(value, "-0x"))
        return value;
    char *end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    // A hash or a set of flags in hexadecimal has no exponent, and is clearer as it is.
    if (*end != '\0' || value.find('p') == std::string::npos)
        return value;
    std::ostringstream text;
    text.precision(9);
    text << number << " (" << value << ")";
    return text.str();
}

std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer) {
    const nlohmann::json::json_pointer path(pointer);
    if (!json.contains(path) || !json.at(path).is_number())
        return std::nullopt;
    return json.at(path).get<double>();
}

} // namespace testbed
