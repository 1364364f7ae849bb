// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_POLYGON_CONTACT_H
#define BOOMERANG_GLUE_POLYGON_CONTACT_H

#include <cstdint>

#include <box2d/b2_contact.h>

#include "boomerang/box2d_glue.h"

namespace bmr {

struct BodyPair;

/// What a contact of ours knows besides what Box2D keeps: 16 bytes, for which Box2D's 224-byte block has
/// room.
struct ContactState {
    BodyPair *pair;       ///< the structure it shares with the other contacts of its two bodies, or nullptr
    uint32_t stamp;       ///< the pair's stamp when the hulls were last seen to hold this contact's fixtures
    uint8_t edge;         ///< remembered separating edge, kNoEdge where none is
    uint8_t edgeOfB : 1;  ///< whose edge it is
    uint8_t excluded : 1; ///< at this stamp the hulls do not hold this contact's fixtures
    uint8_t patience : 4; ///< log2 of how many evaluations go by after the next search in vain
    uint8_t unasked;      ///< evaluations that still go to Box2D before the next search for an edge
};
static_assert(sizeof(ContactState) == 16);

constexpr uint8_t kNoEdge = 0xff;

/// Box2D's polygon contact with a separation proof in front. Its results are those of stock's to the bit.
/// It is reached by two other parts of the glue through AsOurs: the pair registry and the slack query.
class PolygonContact : public b2Contact {
public:
    /// Puts itself into Box2D's contact register, remembers what was there. Once for a process.
    static void Register();

    /// `contact` as one of ours, or nullptr: contacts born before Register, and other shapes', are not.
    static PolygonContact *AsOurs(b2Contact *contact);
    static const PolygonContact *AsOurs(const b2Contact *contact);

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;

    /// What b2Contact::Update does, for a contact of which neither fixture is a sensor: the same manifold,
    /// flags, waking and calls of the listener in the same order. Nothing is copied where the two stay apart.
    void UpdateSolid(b2ContactListener *listener);

    // What b2ContactManager may do with any contact, and its stand-in otherwise could not.
    static void UpdateByBox2D(b2Contact *contact, b2ContactListener *listener);
    static bool WantsFiltering(const b2Contact &contact) { return (FlagsOf(contact) & e_filterFlag) != 0; }
    static void FilteringIsDone(b2Contact *contact) {
        contact->*(&PolygonContact::m_flags) &= ~uint32{e_filterFlag};
    }

    ContactState state;

private:
    PolygonContact() : state() {}
    PolygonContact(b2Fixture *fixtureA, b2Fixture *fixtureB);

    static b2Contact *Create(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB,
                             b2BlockAllocator *allocator);
    static void Destroy(b2Contact *contact, b2BlockAllocator *allocator);

    static uint32 FlagsOf(const b2Contact &contact) { return contact.*(&PolygonContact::m_flags); }

    void EvaluateHere(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
    void FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
    void KeepImpulses(const b2Manifold &old);
    Answer Ask(const b2Transform &xfA, const b2Transform &xfB);
    void CountAnswer(Answer answer) const;
    bool PairSaysApart(const b2Transform &xfA, const b2Transform &xfB);
    bool EdgeSaysApart(const b2Transform &xfA, const b2Transform &xfB) const;
    bool FindEdge(const b2Transform &xfA, const b2Transform &xfB);
    bool ManifoldIsMadeHere() const;
    bool CollideHere(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
    float RadiusSum() const;
};

static_assert(sizeof(PolygonContact) <= 224, "must stay in the block class of a stock contact");

} // namespace bmr

#endif
