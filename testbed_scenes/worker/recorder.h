// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RECORDER_H
#define BOOMERANG_TESTBED_RECORDER_H

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include "count/count.h"
#include "recording/recording.h"
#include "stage.h"
#include "worker/plugin.h"

namespace testbed {

/// Which steps are recorded: first, first + every, ... up to last.
struct RecordRange {
    int first = 0, last = 0, every = 1;
    bool boxes = false; ///< with the boxes of the broad phase
    /// For a replay, as bytes (recording/bytes.h): no closest points; and of a run without the plugin
    /// bodies and calls alone.
    bool compact = false;

    bool Has(int step) const { return step >= first && step <= last && (step - first) % every == 0; }
};

/// Listens to a run and makes frames of it. Calls are counted where the counting library is preloaded.
class Recorder final : public EventObserver, public PluginObserver {
public:
    explicit Recorder(const RecordRange &range) : m_range(range) {}
    ~Recorder() override;

    const RecordRange &Range() const { return m_range; }
    bool CountsCalls() const;

    /// Before the step: from now on events are this step's, and calls are counted.
    void BeginStep(const b2World &world, int step);
    /// After a step that the range has.
    recording::Frame Take(const b2World &world);

private:
    using Bodies = std::pair<int, int>;
    struct BodiesHash {
        std::size_t operator()(const Bodies &bodies) const;
    };
    template <typename Value> using ByBodies = std::unordered_map<Bodies, Value, BodiesHash>;
    struct Counters {
        int64_t asked = 0, handedOver = 0;
        recording::Calls calls;
    };
    /// A pair of the frame in the making, and what its proofs stand on: one structure has one proof.
    struct Draft {
        recording::Pair pair;
        std::vector<std::pair<const void *, std::size_t>> shared;
    };
    struct Shown {
        int step = 0;
        std::vector<recording::Proof> proofs; ///< their slack is 0
    };

    void OnKineticEvent(const b2Body &bodyA, const b2Body &bodyB, recording::Event event) override;
    void OnAnswer(const b2Contact &contact, bool handedOver) override;
    void OnBegin(const b2Contact &contact) override;
    void OnEnd(const b2Contact &contact) override;
    void OnPreSolve(const b2Contact &, const b2Manifold &) override {}
    void OnPostSolve(const b2Contact &, const b2ContactImpulse &) override {}
    void OnGoodbye(const b2Joint &) override {}
    void OnGoodbye(const b2Fixture &) override {}

    static void OnCall(void *recorder, boomerang_counted what, const void *a, const void *b);
    void AddEvent(recording::Event event, const Bodies &bodies);
    void WatchCalls(bool on);
    void RecordChanges(const b2World &world, recording::Frame *frame);
    void RecordPairs(const b2World &world, recording::Frame *frame);
    void AddContact(const b2Contact &contact, recording::Frame *frame, Draft *draft);
    void AddProof(const b2Contact &contact, bool swapped, recording::Frame *frame, Draft *draft);
    void LeaveOutKept(recording::Pair *pair);
    void NameHulls(const b2Contact &contact, bool swapped, recording::Frame *frame, recording::Proof *proof);
    int NameOutline(int body, const std::vector<recording::Vec> &points, recording::Frame *frame);

    const RecordRange m_range;
    int m_step = 0;
    std::map<std::pair<int, int>, recording::Fixture>
        m_sent; ///< as the reader knows them, by body and number
    std::map<std::pair<int, std::vector<float>>, int> m_outlines; ///< ids, by body and coordinates
    std::unordered_map<const void *, int> m_bodyOf; ///< by the address of a shape's first vertex
    ByBodies<Shown> m_shown;                        ///< where it is: what the reader knows of a pair
    // Since the last frame.
    ByBodies<Counters> m_recent;
    std::vector<recording::Event> m_events;
    recording::Calls m_calls;
};

/// What the options ask for as the head of a recording.
recording::Head MakeHead(const Recorder &recorder, const PluginOptions &plugin);

} // namespace testbed

#endif
