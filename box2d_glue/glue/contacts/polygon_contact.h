// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_POLYGON_CONTACT_H
#define BOOMERANG_GLUE_POLYGON_CONTACT_H

#include "boomerang/box2d_glue.h"
#include "glue/contacts/solid_contact.h"

namespace bmr {

/// Box2D's polygon contact with a separation proof in front. Its results are those of stock's to the bit.
/// It serves polygons of Box2D's own size alone.
class PolygonContact final : public SolidContact, public ContactClass<PolygonContact> {
public:
    // For the contact register.
    static bool Serves(const b2Shape &a, const b2Shape &b);

    using ContactClass<PolygonContact>::AsOurs;

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;
    void MakeManifold(bool touched, b2Manifold *old) override;
    /// The remembered edge's.
    bmr_vec2 KnownDirection() const override;

    /// The edge that is asked first.
    EdgeMemory *Memory() { return &state.edge; }

private:
    friend class ContactClass<PolygonContact>;
    PolygonContact() = default;
    PolygonContact(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB)
        : SolidContact(fixtureA, indexA, fixtureB, indexB) {
        state.edge.number = kNoEdge;
    }

    Answer Ask(const b2Transform &xfA, const b2Transform &xfB);
    void FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
    void CountAnswer(Answer answer) const;
    bool EdgeSeparates(uint8_t number, bool ofB, const b2Transform &xfA, const b2Transform &xfB) const;
    bool EdgeSaysApart(const b2Transform &xfA, const b2Transform &xfB) const;
    bool ManifoldIsMadeHere() const;
    bool CollideHere(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
};

static_assert(sizeof(PolygonContact) <= 224, "must stay in the block class of a stock contact");

} // namespace bmr

#endif
