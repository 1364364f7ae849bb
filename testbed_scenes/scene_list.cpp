// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <iterator>

namespace testbed {
const std::vector<SceneInfo> &AllScenes() {
    static const std::vector<SceneInfo> scenes = [] {
        std::vector<SceneInfo> all;
        for (const auto add : {AddClassicStacks, AddClassicMotion, AddClassicJoints, AddClassicExamples,
                               AddLongThings, AddCoins, AddAsteroids, AddGears, AddCrowds, AddGames,
                               AddAnySizeBodies, AddAnySizeWorlds, AddOutlines})
            add(all);
        const auto rank = [](const SceneInfo &scene) {
            constexpr std::string_view groups[] = {"classic", "hard", "games", "any-size", "outlines"};
            return std::find(std::begin(groups), std::end(groups), scene.group) - groups;
        };
        std::stable_sort(all.begin(), all.end(),
                         [&](const SceneInfo &a, const SceneInfo &b) { return rank(a) < rank(b); });
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

} // namespace testbed
