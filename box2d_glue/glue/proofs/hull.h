// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_HULL_H
#define BOOMERANG_GLUE_HULL_H

#include <cstdint>
#include <vector>

#include "boomerang/pair.h"

class b2Body;
class b2Fixture;

namespace bmr {

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
    /// of some polygons no hull is built. About 10 ns if it did before, less if that was in this step.
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
    bool Gather(std::vector<bmr_vec2> *points);
    void Forget();

    const b2Body *m_body;
    const b2Fixture *m_fixture;
    bmr_shape m_shape = {};
    double m_reach = 0.0;
    float m_radius = 0.0f;
    uint32_t m_version = 0;
    std::vector<Member> m_members;     ///< by address
    const b2Fixture *m_held = nullptr; ///< seen to be held, in this step
    uint64_t m_heldIn = 0;
};

/// A compass has directions for hulls of up to so many vertices. Larger ones work as a free direction, which
/// needs no hierarchy.
constexpr uint32_t kMostCompassVertices = 4096;

} // namespace bmr

#endif
