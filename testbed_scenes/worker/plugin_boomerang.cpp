// SPDX-License-Identifier: MIT
#include "worker/plugin.h"

#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <boomerang/box2d.h>

#include "debug/inspect.h"
#include "debug/statistics.h"

namespace testbed {
namespace {

// The plugin's options are for the whole process, and so is the observer.
PluginObserver *pluginObserver = nullptr;

void OnEvent(void *, const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event) {
    pluginObserver->OnKineticEvent(*bodyA, *bodyB, bmr_event_name(event.kind));
}

void OnAnswer(const b2Contact &contact, bmr::Answer answer) {
    pluginObserver->OnAnswer(contact, answer >= bmr::Answer::HandedOver);
}

bool IsSwitchedOff() {
    const char *asked = std::getenv("BOOMERANG");
    return asked != nullptr && std::strcmp(asked, "off") == 0;
}

} // namespace

void InstallPlugin(const std::string &structure, bool count, PluginObserver *observer) {
    bmr::Options install;
    for (int i = 0; i < BMR_STRUCTURE_COUNT && !structure.empty(); ++i)
        if (structure == bmr_structure_name(static_cast<bmr_structure>(i)))
            install.pairsBy = static_cast<bmr_structure>(i);
    install.statistics = count;
    pluginObserver = observer;
    if (pluginObserver != nullptr) {
        bmr::internal::ObserveAnswers(OnAnswer);
        install.onEvent = OnEvent;
    }
    // Switched off, it still has the polygons of any size.
    if (!bmr::Install(install) && !IsSwitchedOff())
        throw std::runtime_error("the plugin would not install");
}

const char *PluginName() {
    return IsSwitchedOff() ? "off" : "plugin";
}

nlohmann::json PluginStatistics() {
    const bmr::Counted counted = bmr::internal::ReadCounts();
    nlohmann::json counts, events;
    bmr::VisitCounts([&counts](const char *name, uint64_t count) { counts[name] = count; }, counted);
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        events[bmr_event_name(static_cast<bmr_event_kind>(kind))] = counted.events[kind];
    counts["events"] = events;
    return counts;
}

ShownProof ShowProof(const b2Contact &contact) {
    const bmr::internal::Proof found = bmr::internal::Inspect(contact);
    ShownProof shown;
    shown::Proof &proof = shown.proof;
    proof.kind = found.kind;
    if (proof.kind == "none")
        return shown;
    shown.structure = found.structure;
    proof.slack = found.slack;
    for (std::size_t side = 0; side < 2; ++side) {
        if (proof.kind == "disks")
            proof.centres[side] = ToVec(found.supports[side]);
        else if (proof.kind == "direction")
            proof.supports[side] = ToVec(found.supports[side]);
        proof.radii[side] = found.radii[side];
    }
    proof.owner = found.owner;
    proof.normal = ToVec(found.normal);
    proof.edge = {ToVec(found.edge[0]), ToVec(found.edge[1])};
    if (proof.kind != "disks" && proof.kind != "direction")
        proof.opposite = ToVec(found.supports[1 - found.owner]);
    return shown;
}

} // namespace testbed
