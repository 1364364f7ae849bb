// SPDX-License-Identifier: MIT
#include "boomerang/contact_recorder.h"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_world.h>

namespace bmr {

namespace {

/// A growing array that says no where there is no memory.
template <typename Event> class Log {
    static_assert(std::is_trivially_copyable_v<Event>,
                  "user data in b2_user_settings.h must be trivially copyable");

public:
    Log() = default;
    ~Log() { std::free(m_events); }
    Log(const Log &) = delete;
    Log &operator=(const Log &) = delete;

    bool Add(const Event &event) {
        if (m_count == m_capacity && !Grow())
            return false;
        std::memcpy(static_cast<void *>(m_events + m_count++), &event, sizeof event);
        return true;
    }
    void Clear() { m_count = 0; }
    ContactEventList<Event> List() const { return {m_events, m_count}; }

private:
    bool Grow() {
        constexpr int32 kFirst = 16, kMost = std::numeric_limits<int32>::max() / 2;
        if (m_capacity > kMost)
            return false;
        const int32 capacity = m_capacity == 0 ? kFirst : 2 * m_capacity;
        void *events = std::realloc(m_events, static_cast<size_t>(capacity) * sizeof(Event));
        if (events == nullptr)
            return false;
        m_events = static_cast<Event *>(events);
        m_capacity = capacity;
        return true;
    }

    Event *m_events = nullptr;
    int32 m_count = 0, m_capacity = 0;
};

ContactSide SideOf(b2Fixture *fixture, int32 child) {
    b2Body *body = fixture->GetBody();
    return {fixture, body, child, fixture->GetUserData(), body->GetUserData()};
}
ContactSide SideA(b2Contact *contact) {
    return SideOf(contact->GetFixtureA(), contact->GetChildIndexA());
}
ContactSide SideB(b2Contact *contact) {
    return SideOf(contact->GetFixtureB(), contact->GetChildIndexB());
}

} // namespace

struct ContactRecorder::Events {
    Log<ContactTouchEvent> begins, ends;
    Log<SensorTouchEvent> sensorBegins, sensorEnds;
    Log<ContactHitEvent> hits;

    /// A beginning or an end, in one of two lists. False without memory.
    static bool AddTouch(b2Contact *contact, bool mayBeGone, Log<ContactTouchEvent> *solid,
                         Log<SensorTouchEvent> *ofSensors) {
        const bool sensorA = contact->GetFixtureA()->IsSensor(), sensorB = contact->GetFixtureB()->IsSensor();
        if (!sensorA && !sensorB)
            return solid->Add({SideA(contact), SideB(contact), mayBeGone});
        return ofSensors->Add(sensorA ? SensorTouchEvent{SideA(contact), SideB(contact), mayBeGone}
                                      : SensorTouchEvent{SideB(contact), SideA(contact), mayBeGone});
    }
    void Clear() {
        begins.Clear();
        ends.Clear();
        sensorBegins.Clear();
        sensorEnds.Clear();
        hits.Clear();
    }
};

ContactRecorder::ContactRecorder() noexcept : m_hitThreshold(std::numeric_limits<float>::infinity()) {
    for (Events *&events : m_events)
        events = new (std::nothrow) Events();
}

ContactRecorder::~ContactRecorder() {
    for (Events *events : m_events)
        delete events;
}

ContactEvents ContactRecorder::Take() noexcept {
    std::swap(m_events[0], m_events[1]);
    if (m_events[0] != nullptr)
        m_events[0]->Clear();
    ContactEvents events = {};
    if (const Events *taken = m_events[1])
        events = {taken->begins.List(),     taken->ends.List(), taken->sensorBegins.List(),
                  taken->sensorEnds.List(), taken->hits.List(), 0};
    events.lost = std::exchange(m_lost, 0);
    return events;
}

void ContactRecorder::BeginContact(b2Contact *contact) {
    Events *events = m_events[0];
    if (events == nullptr || !Events::AddTouch(contact, false, &events->begins, &events->sensorBegins))
        ++m_lost;
}

void ContactRecorder::EndContact(b2Contact *contact) {
    Events *events = m_events[0];
    const bool mayBeGone = !contact->GetFixtureA()->GetBody()->GetWorld()->IsLocked();
    if (events == nullptr || !Events::AddTouch(contact, mayBeGone, &events->ends, &events->sensorEnds))
        ++m_lost;
}

void ContactRecorder::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    float sum = 0.0f;
    int32 most = 0;
    for (int32 i = 0; i < impulse->count; ++i) {
        sum += impulse->normalImpulses[i];
        if (impulse->normalImpulses[i] > impulse->normalImpulses[most])
            most = i;
    }
    if (!(sum >= m_hitThreshold))
        return;
    b2WorldManifold where;
    contact->GetWorldManifold(&where);
    Events *events = m_events[0];
    if (events == nullptr ||
        !events->hits.Add({SideA(contact), SideB(contact), where.points[most], where.normal, sum}))
        ++m_lost;
}

} // namespace bmr
