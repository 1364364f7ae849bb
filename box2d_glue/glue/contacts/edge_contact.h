// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EDGE_CONTACT_H
#define BOOMERANG_GLUE_EDGE_CONTACT_H

#include <box2d/b2_contact.h>

namespace bmr {

/// A contact of an edge, or a link of a chain, with a polygon of up to 8 vertices: as Box2D's own contact,
/// with b2CollideEdgeAndPolygon's manifold made in lanes.
class EdgeContact final : public b2Contact {
public:
    // For the contact register. `fixtureA` is the edge or the chain.
    static bool Serves(const b2Shape &a, const b2Shape &b);
    static b2Contact *Make(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB,
                           b2BlockAllocator *allocator);
    static void Unmake(EdgeContact *contact, b2BlockAllocator *allocator);
    /// Before the first is made.
    static void LearnVtable();
    /// `contact` as one of these, or nullptr.
    static EdgeContact *AsOurs(b2Contact *contact);

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;

private:
    EdgeContact() = default;
    using b2Contact::b2Contact;

    bool EvaluateHere(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) const;
    void EvaluateByBox2D(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) const;
};

} // namespace bmr

#endif
