// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SNAPSHOT_H
#define BOOMERANG_TESTBED_SNAPSHOT_H

#include <box2d/box2d.h>

#include "sinks.h"

namespace testbed {

/// Hashes of a world's whole state after a step.
struct StateHashes {
    uint64_t bodies, contacts, events;
};

/// Collects the events of a step as they come, in hash and, if wanted, in words.
class EventRecorder {
public:
    uint64_t Hash() const { return m_hash.Value(); }
    const std::string &Text() const { return m_text.Text(); }

    /// Forgets what came before; the events to come are also kept as text if `inWords`.
    void StartStep(bool inWords);

    void OnBegin(const b2Contact &contact);
    void OnEnd(const b2Contact &contact);
    void OnPreSolve(const b2Contact &contact, const b2Manifold &old);
    void OnPostSolve(const b2Contact &contact, const b2ContactImpulse &impulse);
    void OnGoodbye(const b2Joint &joint);
    void OnGoodbye(const b2Fixture &fixture);

private:
    template <typename Visit> void Record(Visit visit);

    HashSink m_hash;
    TextSink m_text;
    bool m_inWords = false;
    uint64_t m_count = 0;
};

StateHashes HashState(const b2World &world, const EventRecorder &events);

/// The same state and events, a line per field.
std::string DescribeState(const b2World &world, const EventRecorder &events);

} // namespace testbed

#endif
