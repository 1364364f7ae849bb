// SPDX-License-Identifier: MIT
//
// boomerang-scene: runs one scene on whatever Box2D it is linked with. boomerang-testbed starts it twice,
// once stock and once with the plugin, and compares what the two print: stock must be stock, so they are
// never one process.
#include <cstdio>
#include <exception>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "scene.h"
#include "worker/options.h"

namespace testbed {
namespace {

void PrintList() {
    nlohmann::json list = nlohmann::json::array();
    for (const SceneInfo &scene : AllScenes())
        list.push_back({{"name", scene.name},
                        {"description", scene.description},
                        {"group", scene.group},
                        {"size", scene.size},
                        {"seed", scene.seed},
                        {"steps", scene.steps},
                        {"vertices", scene.polygons.vertices},
                        {"bodies", NameOf(scene.polygons.bodies)}});
    std::puts(list.dump(2).c_str());
}

int Run(int argc, char **argv) {
    Options options;
    if (const std::optional<int> code = ParseOptions(argc, argv, options))
        return *code;
    if (options.listJson)
        PrintList();
    else if (!options.course.empty())
        RunScene(CourseScene(options.course), options);
    else
        RunScene(*FindScene(options.scene), options);
    return exitOk;
}

} // namespace
} // namespace testbed

int main(int argc, char **argv) {
    try {
        return testbed::Run(argc, argv);
    } catch (const std::exception &error) {
        std::fflush(stdout);
        std::fprintf(stderr, "%s: %s\n", std::filesystem::path(argv[0]).filename().c_str(), error.what());
        return testbed::exitInternal;
    }
}
