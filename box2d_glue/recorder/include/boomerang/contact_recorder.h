// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONTACT_RECORDER_H
#define BOOMERANG_CONTACT_RECORDER_H

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_math.h>
#include <box2d/b2_world_callbacks.h>

#include "boomerang/box2d_glue.h"

/// @file
/// What touched, parted and hit in a step, as lists that a game reads after the step. In C++11 or later, with
/// the plugin or without. docs/contact-recorder.md has examples.

namespace bmr {

/// One of the two sides of an event. User data are copies, made at the moment of the event.
struct ContactSide {
    b2Fixture *fixture;
    b2Body *body;
    int32 child; ///< of the fixture's shape, e.g. the link of a chain
    b2FixtureUserData userData;
    b2BodyUserData bodyUserData;
};

/// Two solid fixtures begin or cease to touch.
struct ContactTouchEvent {
    ContactSide a, b; ///< as the contact has them
    /// True: the touch ended outside of a step (b2World::DestroyBody, b2Body::DestroyFixture,
    /// b2Body::SetEnabled, b2Body::SetType). The fixtures and bodies may be gone: compare these pointers, do
    /// not follow them.
    bool mayBeGone;
};

/// The same where a fixture is a sensor.
struct SensorTouchEvent {
    ContactSide sensor, visitor; ///< where both are sensors, as the contact has them
    bool mayBeGone;              ///< see ContactTouchEvent
};

/// Two solid fixtures pressed against each other harder than the threshold.
struct ContactHitEvent {
    ContactSide a, b;
    b2Vec2 point;  ///< in the world, between the two: where most of the impulse was
    b2Vec2 normal; ///< of unit length, in the world, from a to b
    float impulse; ///< along the normal, all points together, in kg m/s
};

/// Events of one kind, in the order of Box2D's calls.
template <typename Event> struct ContactEventList {
    const Event *events;
    int32 count;

    const Event *begin() const { return events; }
    const Event *end() const { return events + count; }
    int32 size() const { return count; }
    const Event &operator[](int32 i) const { return events[i]; }
};

/// All that was recorded between one ContactRecorder::Take and the next.
struct ContactEvents {
    ContactEventList<ContactTouchEvent> begins, ends;
    ContactEventList<SensorTouchEvent> sensorBegins, sensorEnds;
    ContactEventList<ContactHitEvent> hits;
    int32 lost; ///< events for which there was no memory
};

/// A contact listener that records each call and does nothing else. To the plugin it is a listener like any
/// other. A recorder records the same with the plugin and without it.
///
/// It only records. A game that decides in the middle of a step (to disable a contact in PreSolve, to change
/// friction) needs a listener of its own.
///
/// One recorder serves one world, on the thread that uses the world. It allocates by malloc when more events
/// come between two calls of Take than ever before, and never throws.
class BMR_BOX2D_API ContactRecorder final : public b2ContactListener {
public:
    ContactRecorder() noexcept;
    /// The world must have another listener by then, or have ended.
    ~ContactRecorder() override;
    ContactRecorder(const ContactRecorder &) = delete;
    ContactRecorder &operator=(const ContactRecorder &) = delete;

    /// Records a hit if the normal impulses of a contact's points add up to `impulse` or more. Without this
    /// call there are no hits. A body at rest presses with its weight times the length of the step, in every
    /// step: choose a threshold above that. A pair may hit several times in one step.
    void SetHitThreshold(float impulse) { m_hitThreshold = impulse; }

    /// The events since the last call, or since the beginning. The lists are good until the next call or the
    /// recorder's end. Unless `mayBeGone`, their fixtures and bodies still exist if the game destroyed none
    /// between the step and this call. O(1).
    ContactEvents Take() noexcept;

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;

private:
    struct Events;

    Events *m_events[2] = {nullptr, nullptr}; ///< the first is written to, the second was taken
    float m_hitThreshold;
    int32 m_lost = 0;
};

} // namespace bmr

#endif
