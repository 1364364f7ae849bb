// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PROTOCOL_H
#define BOOMERANG_TESTBED_PROTOCOL_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// @file
/// What workers print, read. Workers write for this program alone, so whatever they print that is not
/// expected is an error (WorkerError, which quotes the line), never something to skip.

namespace testbed {

/// A scene as a worker's --list-json describes it.
struct SceneInfo {
    std::string name;
    std::string description;
    std::string group;
    int64_t size = 0;
    uint64_t seed = 0;
    int64_t steps = 0;
    int64_t vertices = 0; ///< of its polygons unless told otherwise; 0: that cannot be chosen
    std::string bodies;   ///< and what they are: one, many or circle
    /// Whether it is made of what stock Box2D does not have.
    bool NeedsPlugin() const { return vertices > 8 && bodies == "one"; }
};

std::vector<SceneInfo> ParseSceneList(const std::string &text);
nlohmann::json ToJson(const SceneInfo &scene);

/// `step <i> <bodies> <contacts> <events>`: the hashes stay text, they are only ever compared.
struct StepHash {
    int64_t step = 0;
    std::string bodies, contacts, events;
    bool operator==(const StepHash &other) const {
        return step == other.step && bodies == other.bodies && contacts == other.contacts &&
               events == other.events;
    }
};

bool IsStepLine(const std::string &line);
StepHash ParseStepLine(const std::string &line);

bool IsSummaryLine(const std::string &line);
nlohmann::json ParseSummaryLine(const std::string &line);

/// A line of --dump: everything but the last word names the field ("body 12 position.x"), the last word is
/// its value.
struct DumpField {
    std::string name;
    std::string value;
};

DumpField ParseDumpLine(const std::string &line);
/// A value as people read it: "0x1.8p+3" becomes "12 (0x1.8p+3)"; what is no hexadecimal float stays as it
/// is.
std::string Readable(const std::string &value);

/// The number at a JSON pointer ("/plugin/checks"), or nothing where there is none (absent, null, not a
/// number).
std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer);

} // namespace testbed

#endif
