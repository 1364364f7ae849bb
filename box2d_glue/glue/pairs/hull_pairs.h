// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_HULL_PAIRS_H
#define BOOMERANG_GLUE_HULL_PAIRS_H

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <box2d/b2_math.h>

#include "boomerang/pair.h"
#include "glue/proofs/hull.h"

class b2Body;
class b2Contact;
class b2Fixture;

namespace bmr {

/// The kinetic structure of two bodies: of their hulls, the one that was made first being A.
struct HullPair {
    bmr_pair kinetic = {};
    Hull *a = nullptr, *b = nullptr;
    uint32_t contacts = 0; ///< that ask it
    bool apart = false;    ///< when it was last advanced: to these poses, with the hulls of these versions
    b2Transform poseA, poseB;
    uint32_t versionA = 0, versionB = 0; ///< 0: it never was

    bool IsSwapped(const b2Contact &contact) const; ///< is fixture A of the contact in hull B?
};

/// Takes the pair to these poses of its bodies, if it is not there. True if the hulls are so far apart that
/// b2CollidePolygons gives no points of two fixtures in them.
bool KnownApart(HullPair *pair, const b2Transform &poseA, const b2Transform &poseB);

/// What Options::pairsBy asks for: a kinetic structure of core for each pair of bodies that have a contact
/// which is due. Each question takes it to where the bodies are. The contacts of two bodies share it, so it
/// is advanced once for each pair of poses, and its answer is given again to the others. A static body has a
/// hull, and structures, for each of its fixtures: one hull of a whole level would hold all that moves in it.
///
/// It is a part of the world's table of pairs: a contact is known by its number there, and what the table
/// forgets is forgotten here.
class HullPairs {
public:
    /// Room for contacts of numbers below this.
    void Reserve(uint32_t count);
    /// The contact of this number has ended.
    void End(uint32_t number);
    void Renumber(uint32_t from, uint32_t to);
    void Clear();

    /// KnownApart of the structure of the contact's bodies, which is made if need be. For two solid polygons.
    bool SayApart(uint32_t number, const b2Contact &contact, const b2Transform &xfA, const b2Transform &xfB);
    /// The structure that the contact asked, or nullptr.
    const HullPair *Find(uint32_t number) const {
        return number < m_ofContacts.size() ? m_ofContacts[number] : nullptr;
    }

private:
    /// A hull, and how many structures it is in.
    struct Used {
        Hull hull;
        uint32_t number; ///< how many were made before it
        uint32_t pairs = 0;
        Used(const b2Body *body, const b2Fixture *fixture, uint32_t madeBefore)
            : hull(body, fixture), number(madeBefore) {}
    };
    Used *Acquire(const b2Fixture &fixture);
    HullPair *PairOf(const b2Contact &contact);

    std::vector<HullPair *> m_ofContacts;           ///< by number; nullptr: it has not asked
    std::unordered_map<uint64_t, HullPair> m_pairs; ///< by the numbers of both hulls
    std::unordered_map<const void *, Used> m_hulls; ///< by body or, of a static one, by fixture
    uint32_t m_made = 0;                            ///< hulls
};

/// The direction of the line that keeps the two hulls apart, in the world, from fixture A of the contact to
/// B. Zero if they are not apart, or if it is disks that say so.
bmr_vec2 DirectionOf(const HullPair &pair, const b2Contact &contact);

/// The kinetic pair as a question at the bodies' present poses would leave it, and what it proves there: a
/// lower bound of the hulls' distance, 0 if none. Leaves the pair as it is.
bmr_pair KineticPairNow(const HullPair &pair, double *gap);

} // namespace bmr

#endif
