// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OPTIONS_H
#define BOOMERANG_TESTBED_OPTIONS_H

#include <cstdint>
#include <optional>
#include <string>

#include "scene.h"
#include "worker/frame_maker.h"
#include "worker/plugin.h"

namespace testbed {

enum class Mode { Hash, Count, Time };

/// What the contact listener of a game does.
enum class Listening {
    None,   ///< there is none, except in scenes that listen themselves
    Counts, ///< counts its calls
    Reads,  ///< reads manifolds, impulses and bodies, too
    Acts    ///< disables contacts, changes friction and pushes bodies, too
};

/// What the command line asks for. Steps count from 0.
struct Options {
    bool listJson = false;
    std::string scene;
    std::string course; ///< file of a course, instead of a scene
    Mode mode = Mode::Hash;
    std::optional<int> steps, size;
    std::optional<unsigned long> seed;
    std::optional<int> vertices;
    std::optional<BodyKind> bodies;
    std::optional<int> dump, perturb;
    std::optional<FrameRange> frames;
    Listening listening = Listening::None;
    std::string structure; ///< for the plugin alone; empty: as games have it
};

/// The scene's own choice, where the options do not say otherwise.
PolygonChoice PolygonsOf(const SceneInfo &scene, const Options &options);

/// Runs a scene and prints what the options ask for. Throws std::runtime_error if it cannot.
void RunScene(const SceneInfo &info, const Options &options);

} // namespace testbed

#endif
