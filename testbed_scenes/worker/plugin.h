// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PLUGIN_H
#define BOOMERANG_TESTBED_PLUGIN_H

#include <string>

#include <box2d/b2_math.h>
#include <nlohmann/json.hpp>

#include "picture/frame.h"

/// @file
/// All that the two workers do differently. boomerang-scene links plugin_absent.cpp, in which nothing
/// happens; boomerang-scene-plugin links plugin_boomerang.cpp.

class b2Body;
class b2Contact;

namespace testbed {

/// Hears what the plugin does while a world steps.
class PluginObserver {
public:
    virtual ~PluginObserver() = default;
    /// An event of a structure of hulls or of a contact: bmr_event_name.
    virtual void OnKineticEvent(const b2Body &bodyA, const b2Body &bodyB, const char *kind) = 0;
    /// An evaluation of two polygons.
    virtual void OnAnswer(const b2Contact &contact, bool handedOver) = 0;
};

/// Before the first world. Throws if the plugin will not install. `structure` holds every pair; empty: as
/// games have it. The observer (nullptr: none) must live as long as the process steps.
void InstallPlugin(const std::string &structure, bool count, PluginObserver *observer);

/// "stock", "plugin", or "off": linked with the plugin, which is switched off.
const char *PluginName();
/// What the plugin counted, or null.
nlohmann::json PluginStatistics();

/// What proves the two fixtures of a contact apart, as the plugin shows it. Element 0 is of the contact's
/// fixture A.
struct ShownProof {
    shown::Proof proof;
    const void *structure = nullptr; ///< the same for contacts that share the proof; nullptr: this one's own
};
/// Of kind none without the plugin. Between steps.
ShownProof ShowProof(const b2Contact &contact);

inline shown::Vec ToVec(const b2Vec2 &v) {
    return {v.x, v.y};
}
} // namespace testbed

#endif
