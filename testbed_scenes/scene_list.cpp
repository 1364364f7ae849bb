// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <numeric>

namespace testbed {
namespace {

std::size_t EditDistance(std::string_view from, std::string_view to) {
    // row[j]: from the part of `from` read so far to the first j letters of `to`.
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

const std::vector<SceneInfo> &AllScenes() {
    static const std::vector<SceneInfo> scenes = [] {
        std::vector<SceneInfo> all;
        for (const auto add :
             {AddClassicStacks, AddClassicMotion, AddClassicJoints, AddClassicExamples, AddTerrain,
              AddLongThings, AddCoins, AddAsteroids, AddGears, AddBullets, AddSensors, AddSleepers, AddChurn,
              AddAnySizeCoins, AddAnySizeBodies, AddAnySizeWorlds, AddOutlines})
            add(all);
        return all;
    }();
    return scenes;
}

const SceneInfo *FindScene(std::string_view name) {
    for (const SceneInfo &scene : AllScenes())
        if (name == scene.name)
            return &scene;
    return nullptr;
}

const SceneInfo &NearestScene(std::string_view name) {
    const std::vector<SceneInfo> &scenes = AllScenes();
    return *std::min_element(scenes.begin(), scenes.end(), [&](const SceneInfo &a, const SceneInfo &b) {
        return EditDistance(name, a.name) < EditDistance(name, b.name);
    });
}

} // namespace testbed
