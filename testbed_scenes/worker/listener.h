// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_LISTENER_H
#define BOOMERANG_TESTBED_LISTENER_H

#include <nlohmann/json.hpp>

#include "scene.h"

namespace testbed {

/// What the contact listener of a game does.
enum class Listening {
    None,   ///< there is none, except in scenes that listen themselves
    Counts, ///< counts its calls
    Reads,  ///< reads manifolds, impulses and bodies, too
    Acts    ///< disables contacts, changes friction and pushes bodies, too
};

/// A scene with a listener: all that the scene does, and what the listener does ahead of it.
class ListenedScene final : public Scene {
public:
    ListenedScene(Scene &scene, Listening listening) : m_scene(scene), m_listening(listening) {}

    /// Calls of each kind, and the sum of all numbers that were read.
    nlohmann::json ToJson() const;

private:
    void Build(Stage &stage, int size) override { m_scene.Build(stage, size); }
    void BeforeStep(Stage &stage, int step) override;
    bool Listens() const override { return true; }
    void OnBegin(b2Contact &contact) override;
    void OnEnd(b2Contact &contact) override;
    void OnPreSolve(b2Contact &contact, const b2Manifold &old) override;
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &impulse) override;
    void OnGoodbye(b2Joint &joint) override { m_scene.OnGoodbye(joint); }

    bool Reads() const { return m_listening >= Listening::Reads; }
    bool Acts() const { return m_listening == Listening::Acts; }
    void Read(b2Contact &contact);

    Scene &m_scene;
    const Listening m_listening;
    int m_step = -1;
    long m_begins = 0, m_ends = 0, m_preSolves = 0, m_postSolves = 0;
    double m_read = 0.0;
};

} // namespace testbed

#endif
