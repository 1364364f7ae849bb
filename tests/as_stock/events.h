// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_AS_STOCK_EVENTS_H
#define BOOMERANG_TEST_AS_STOCK_EVENTS_H

#include <map>

#include "as_stock.h"
#include "boomerang/convex_shape.h"

/// @file
/// Listens to the lives of contacts and of hulls, and holds each event against what the headers say of it.

namespace as_stock {

/// What the events of a contact have said of it so far.
enum class State { Unborn, Coarse, Apart, Contact };

class Witness : private b2ContactFilter {
public:
    explicit Witness(Run &run) : m_run(run) {}

    /// Of one world, from its beginning. Contacts begin where its filter is asked for them.
    void Watch(b2World *world) {
        world->SetContactFilter(this);
        m_world = world;
    }
    /// Prints a line for each event, from here on.
    void PrintEvents() { m_prints = true; }
    void Say(const char *what) {
        if (m_prints)
            m_run.Print("event -- %s", what);
    }

    void OnEvent(const b2Body *a, const b2Body *b, const bmr_event &event);
    void OnAnswer(const b2Contact &contact, bmr::Answer answer);
    /// Between two steps.
    void CheckContacts(const b2World &world);
    void CheckCounts();

    uint64_t Count(bmr_event_kind kind) const { return m_counts[kind]; }
    uint64_t OfSensors() const { return m_ofSensors; }
    uint64_t OfHulls() const { return m_ofHulls; }

private:
    using Key = std::pair<const b2Fixture *, const b2Fixture *>;
    static Key KeyOf(const b2Fixture *a, const b2Fixture *b) { return a < b ? Key(a, b) : Key(b, a); }
    static Key KeyOf(const b2Contact &contact) { return KeyOf(contact.GetFixtureA(), contact.GetFixtureB()); }

    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        m_states.erase(KeyOf(a, b)); // a contact is about to begin: another life
        return b2ContactFilter::ShouldCollide(a, b);
    }
    void Turn(State *state, const bmr_event &event);
    void TakeBelated(const b2Contact *next);
    void CheckCertificate(const bmr_event &event);

    Run &m_run;
    bool m_prints = false;
    std::map<Key, State> m_states;
    std::vector<bmr_event> m_pending;                          ///< of a contact whose answer is still to come
    const b2Body *m_pendingA = nullptr, *m_pendingB = nullptr; ///< the bodies of the first of them
    Key m_answered = Key(); ///< the contact that was answered for last, in this step
    uint64_t m_counts[BMR_EVENT_KIND_COUNT] = {}, m_answers[5] = {}, m_ofSensors = 0, m_ofHulls = 0;
    const b2World *m_world = nullptr;
};

/// Plays a scenario with a witness, in a child; what it printed.
using Lived = void (*)(Run &, Witness &);
std::string Told(Lived lived, bmr::Options options = bmr::Options());

} // namespace as_stock

#endif
