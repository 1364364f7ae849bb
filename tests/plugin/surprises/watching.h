// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_WATCHING_H
#define BOOMERANG_TEST_PLUGIN_WATCHING_H

#include <functional>
#include <set>
#include <vector>

#include "../small_world.h"
#include "crowd.h"

namespace surprises {

/// Where in a step a game does what it does.
enum Place {
    kBetween, ///< between two steps
    kBeginFirst,
    kBeginLast,
    kBeginImpact,
    kEndFirst,
    kEndLast,
    kEndImpact,
    kPreFirst,
    kPreLast,
    kPreImpact,
    kPostFirst,
    kPostImpact,
    kFilterFirst,
    kFilterLast,
    kFilterNew,
    kUnlocked, ///< in a BeginContact, after a step of no time has unlocked the world
    kPlaces
};
extern const char *const kPlaceNames[kPlaces];

/// The listener and the filter of a world. Takes down all that a game can see inside each callback: which
/// callback it is, and of every contact of the world, in the list's order, whose it is, whether it touches
/// and whether it is enabled; and the order of each body's contacts.
class Watching : public b2ContactListener, public b2ContactFilter {
public:
    explicit Watching(b2World *world);
    /// Calls `act` once, at the next callback of this place.
    void At(Place place, std::function<void()> act) { m_waiting.push_back({place, std::move(act)}); }
    /// False: the contacts are not looked at, which takes most of the time; callbacks are still noted.
    bool looks = true;
    /// Places at which a callback came since this was emptied.
    std::set<Place> places;
    /// What was taken down.
    Hash hash;
    /// Bodies that the filter lets collide with nobody.
    std::set<const b2Body *> refused;
    /// Prints every callback.
    bool tells = false;

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override;

private:
    struct Waiting {
        Place place;
        std::function<void()> act;
    };
    void Note(char what, b2Fixture *a, b2Fixture *b, std::initializer_list<Place> byDrum);
    void Look(bool edges);
    bool Act(Place place);

    b2World *m_world;
    std::vector<Waiting> m_waiting;
    bool m_inside = false;
};

} // namespace surprises

#endif
