// SPDX-License-Identifier: MIT
#include "glue/pairs/bodies.h"

#include "base/compiler.h"
#include "base/private_members.h"

namespace bmr {

namespace {

// In smaller worlds there is nothing to be gained; and where more than an eighth of the bodies is awake,
// their own simulation is what a step costs.
constexpr uint32_t kFewBodies = 256, kMostAwakeOf = 8;
constexpr uint32_t kStepsToWait = 32;

} // namespace

bool Bodies::Follow(b2Body *newest, int32 count) {
    const auto wanted = static_cast<uint32_t>(count);
    if (wanted < kFewBodies)
        return false;
    if (m_waits > 0) {
        --m_waits;
        return false;
    }
    if (m_count > wanted)
        m_count = 0;
    if (m_count == wanted && m_bodies[m_count - 1] == newest)
        return true;
    m_bodies.Reserve(wanted);
    // From the newest back to the last one that is known.
    const b2Body *known = m_count > 0 && m_count < wanted ? m_bodies[m_count - 1] : nullptr;
    b2Body *body = newest;
    uint32_t i = wanted;
    while (i > 0 && body != nullptr && body != known) {
        m_bodies[--i] = body;
        body = body->*Named(NextBody());
    }
    if (i != (known != nullptr ? m_count : 0u)) { // not as it was known
        m_count = 0;
        return false; // and the next step begins anew
    }
    m_count = wanted;
    return true;
}

bool Bodies::FindAwake() {
    constexpr uint32_t kAhead = 8;
    m_awakeCount = 0;
    const uint32_t most = m_count / kMostAwakeOf;
    m_awake.Reserve(most + 1);
    for (uint32_t i = m_count; i-- > 0;) {
        if (i >= kAhead)
            BMR_PREFETCH(m_bodies[i - kAhead]);
        b2Body *const body = m_bodies[i];
        if (BodyInIsland::Is(body))
            BodyInIsland::Clear(body);
        if (!body->IsAwake() || body->GetType() == b2_staticBody)
            continue;
        if (m_awakeCount == most) {
            m_waits = kStepsToWait;
            return false;
        }
        m_awake[m_awakeCount++] = body;
    }
    return true;
}

} // namespace bmr
