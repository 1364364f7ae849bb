// SPDX-License-Identifier: MIT
#include "scene.h"

namespace testbed {
const std::vector<SceneInfo> &AllScenes() {
    static const std::vector<SceneInfo> scenes = [] {
        std::vector<SceneInfo> all;
        for (const auto add : {AddClassicStacks, AddClassicMotion, AddClassicJoints, AddClassicExamples,
                               AddLongThings, AddCoins, AddAsteroids, AddGears, AddCrowds, AddGames,
                               AddAnySizeBodies, AddAnySizeWorlds, AddOutlines})
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

} // namespace testbed
