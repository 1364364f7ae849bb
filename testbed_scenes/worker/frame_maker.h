// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FRAME_MAKER_H
#define BOOMERANG_TESTBED_FRAME_MAKER_H

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <box2d/box2d.h>

#include "picture/frame.h"
#include "worker/plugin.h"

namespace testbed {

/// The steps whose frames are printed: first, first + every, ... up to last.
struct FrameRange {
    int first = 0, last = 0, every = 1;

    bool Has(int step) const { return step >= first && step <= last && (step - first) % every == 0; }
};

/// Makes frames of a world's steps (picture/frame.h). Changes nothing in the world.
class FrameMaker final : public PluginObserver {
public:
    FrameMaker(const FrameRange &range, std::string scene) : m_range(range), m_scene(std::move(scene)) {}

    const FrameRange &Range() const { return m_range; }
    /// Before the step: from now on events and answers are this step's.
    void BeginStep(int step);
    /// After a step that the range has.
    shown::Frame Take(const b2World &world);

private:
    using Bodies = std::pair<int, int>;
    /// A pair in the making, and what its proofs stand on: one structure has one proof.
    struct Draft {
        shown::Pair pair;
        std::vector<std::pair<const void *, std::size_t>> shared;
    };

    void OnKineticEvent(const b2Body &bodyA, const b2Body &bodyB, const char *kind) override;
    void OnAnswer(const b2Contact &contact, bool handedOver) override;

    void AddPairs(const b2World &world, shown::Frame *frame);
    void AddContact(const b2Contact &contact, Draft *draft);
    void AddProof(const b2Contact &contact, bool swapped, Draft *draft);

    const FrameRange m_range;
    const std::string m_scene;
    int m_step = 0;
    // Of this step.
    std::map<Bodies, int> m_handedOver;
    std::vector<shown::Event> m_events;
};

} // namespace testbed

#endif
