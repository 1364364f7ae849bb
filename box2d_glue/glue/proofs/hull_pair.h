// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_HULL_PAIR_H
#define BOOMERANG_GLUE_HULL_PAIR_H

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <box2d/b2_math.h>

#include "base/memory.h"
#include "boomerang/pair.h"

class b2Body;
class b2Contact;
class b2Fixture;

namespace bmr {

template <typename T> using HullVector = std::vector<T, GlueAllocator<T>>;
template <typename Key, typename T>
using HullMap =
    std::unordered_map<Key, T, std::hash<Key>, std::equal_to<Key>, GlueAllocator<std::pair<const Key, T>>>;

/// The convex hull of a body's polygon fixtures, or of one fixture of it, in the body's frame, with the
/// hierarchy that Options::pairsBy walks on. Sensors are left out. Big ConvexShapes are there with their real
/// polygons.
class Hull {
public:
    /// `fixture`: the only one that it holds; nullptr: all of the body.
    Hull(const b2Body *body, const b2Fixture *fixture) : m_body(body), m_fixture(fixture) { Build(); }
    ~Hull() { Forget(); }
    Hull(const Hull &) = delete;
    Hull &operator=(const Hull &) = delete;

    /// Makes the hull hold this polygon fixture as it is now, which is no sensor, by building it anew if need
    /// be. (Vertices may be changed in place, and Box2D reuses addresses of fixtures.) False if it does not:
    /// of some polygons no hull is built. About 10 ns if it did before.
    bool MakeHold(const b2Fixture &fixture);

    const b2Body *Body() const { return m_body; }
    const b2Fixture *Fixture() const { return m_fixture; }
    const bmr_shape &Shape() const { return m_shape; } ///< its polygon is NULL where none could be built
    /// The hierarchy of the chosen structure; nullptr if it needs none.
    const bmr_hierarchy *Hierarchy() const;
    float Radius() const { return m_radius; }      ///< the largest skin of the fixtures
    double Reach() const { return m_reach; }       ///< no vertex is farther from the body's origin
    uint32_t Version() const { return m_version; } ///< another one whenever it was built

private:
    /// A fixture when the hull was built of it.
    struct Member {
        const b2Fixture *fixture;
        uint64_t digest; ///< DigestOf its shape
    };

    bool Holds(const b2Fixture &fixture) const;
    void Build();
    bool Gather(HullVector<bmr_vec2> *points);
    void Forget();

    const b2Body *m_body;
    const b2Fixture *m_fixture;
    bmr_shape m_shape = {};
    double m_reach = 0.0;
    float m_radius = 0.0f;
    uint32_t m_version = 0;
    HullVector<Member> m_members;
};

/// A compass has directions for hulls of up to so many vertices. Larger ones work as a free direction, which
/// needs no hierarchy.
constexpr uint32_t kMostCompassVertices = 4096;

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

    HullVector<HullPair *> m_ofContacts; ///< by number; nullptr: it has not asked
    HullMap<uint64_t, HullPair> m_pairs; ///< by the numbers of both hulls
    HullMap<const void *, Used> m_hulls; ///< by body or, of a static one, by fixture
    uint32_t m_made = 0;                 ///< hulls
};

/// The direction of the line that keeps the two hulls apart, in the world, from fixture A of the contact to
/// B. Zero if they are not apart, or if it is disks that say so.
bmr_vec2 DirectionOf(const HullPair &pair, const b2Contact &contact);

/// The kinetic pair as a question at the bodies' present poses would leave it, and what it proves there: a
/// lower bound of the hulls' distance, 0 if none. Leaves the pair as it is.
bmr_pair KineticPairNow(const HullPair &pair, double *gap);

} // namespace bmr

#endif
