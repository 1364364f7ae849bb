// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RUN_H
#define BOOMERANG_TESTBED_RUN_H

#include "scene.h"
#include "worker/options.h"

namespace testbed {

/// Runs a scene and prints what the options ask for. Throws std::runtime_error if it cannot.
void RunScene(const SceneInfo &info, const Options &options);

} // namespace testbed

#endif
