// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EDGE_CONTACT_H
#define BOOMERANG_GLUE_EDGE_CONTACT_H

#include "glue/contacts/solid_contact.h"

namespace bmr {

/// A contact of an edge, or a link of a chain, with a polygon of up to 8 vertices: as Box2D's own contact,
/// with b2CollideEdgeAndPolygon's manifold made in lanes.
class EdgeContact final : public b2Contact, public ContactClass<EdgeContact> {
public:
    // For the contact register. `fixtureA` is the edge or the chain.
    static bool Serves(const b2Shape &a, const b2Shape &b);

    using ContactClass<EdgeContact>::AsOurs;

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;

private:
    friend class ContactClass<EdgeContact>;
    EdgeContact() = default;
    using b2Contact::b2Contact;

    bool EvaluateHere(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) const;
    void EvaluateByBox2D(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) const;
};

} // namespace bmr

#endif
