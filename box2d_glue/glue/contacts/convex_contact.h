// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_CONTACT_H
#define BOOMERANG_GLUE_CONVEX_CONTACT_H

#include "glue/contacts/convex_manifold.h"
#include "glue/contacts/solid_contact.h"

namespace bmr {

/// A contact of a big ConvexShape with another polygon of any size, a circle, an edge or a link of a chain:
/// the manifold of Box2D's algorithm run on all vertices.
class ConvexContact final : public SolidContact {
public:
    // For the contact register. `fixtureA` is the polygon against a circle, the edge or the chain against a
    // polygon.
    static bool Serves(const b2Shape &a, const b2Shape &b);
    static b2Contact *Make(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB,
                           b2BlockAllocator *allocator);
    static void Unmake(ConvexContact *contact, b2BlockAllocator *allocator);
    /// Before the first is made.
    static void LearnVtable();

    /// `contact` as one of these, or nullptr.
    static ConvexContact *AsOurs(b2Contact *contact) {
        return VtableOf(*contact) == convexVtable.load(std::memory_order_relaxed)
                   ? static_cast<ConvexContact *>(contact)
                   : nullptr;
    }

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;
    void MakeManifold(bool touched, b2Manifold *old) override;
    /// That of the last look.
    bmr_vec2 KnownDirection() const override;

private:
    ConvexContact() = default;
    using SolidContact::SolidContact;

    Answer Look(const b2Transform &xfA, const b2Transform &xfB);
    float Margin() const;
    Held HeldBy(Answer answer, bool points, const b2Transform &xfA, const b2Transform &xfB) const;
    Answer Ask(const b2Transform &xfA, const b2Transform &xfB);
    void FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB,
                      const b2Manifold &old);
    bool IsAtImpact() const;
    TwoFixtures Two() const { return {m_fixtureA, m_fixtureB, m_indexA}; }
};

static_assert(sizeof(ConvexContact) <= 224, "must stay in the block class of a stock contact");

} // namespace bmr

#endif
