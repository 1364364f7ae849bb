// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_CONTACT_H
#define BOOMERANG_GLUE_CONVEX_CONTACT_H

#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "convex32/convex32_collide.h"
#include "glue/contacts/solid_contact.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"

class b2Contact;
class b2Fixture;

namespace bmr {

/// The polygon of a fixture as it really is: all vertices of a big ConvexShape, Box2D's own arrays of any
/// other. Good as long as the shape is.
inline bmr_convex32 RealPolygon(const b2Fixture &fixture) {
    const auto &shape = static_cast<const b2PolygonShape &>(*fixture.GetShape());
    if (const bmr_convex32_block *big = BigPolygonOf(shape))
        return big->polygon;
    const bmr_polygon32 small = Polygon32(shape);
    return bmr_convex32_small(&small);
}

/// No vertex of a fixture's polygon is farther from the body's origin.
double ReachOf(const b2Fixture &fixture);

/// Two fixtures in the order of a contact's: `a` is the polygon against a circle, and the edge or the chain
/// against a polygon.
struct TwoFixtures {
    const b2Fixture *a, *b;
    int32 childA;

    float RadiusSum() const { return a->GetShape()->m_radius + b->GetShape()->m_radius; }
};

/// An edge, or a link of a chain; and the same for core.
b2EdgeShape LinkOf(const b2Fixture &fixture, int32 child);
bmr_edge32 EdgeOf(const b2Fixture *fixture, int32 child);

enum class Seams { Known, Ignored };

/// The manifold of two fixtures at least one of which is a big polygon, by all vertices. Where seams are
/// ignored a piece of an outline is a polygon as any other.
void CollideConvex(const TwoFixtures &two, Seams seams, b2Manifold *manifold, const b2Transform &xfA,
                   const b2Transform &xfB, bmr_convex32_memory *memory);

/// Is the first fixture or the second a piece that has inner edges?
bool HasSeams(const TwoFixtures &two);

/// The answer of a contact of a piece if the rules of seams gave it no points (convex32_pieces.h). They leave
/// points to other pieces, of which they know nothing. Here these are asked. `manifold` gets points where the
/// plain polygons overlap at a point that no other piece touches, and at an impact. `memory`: as the search
/// by the rules of seams left it.
void AnswerForOthers(const b2Contact &contact, const TwoFixtures &two, bool isImpact, b2Manifold *manifold,
                     const b2Transform &xfA, const b2Transform &xfB, bmr_convex32_memory memory);

/// A contact of a big ConvexShape with another polygon of any size, a circle, an edge or a link of a chain:
/// the manifold of Box2D's algorithm run on all vertices.
class ConvexContact final : public SolidContact, public ContactClass<ConvexContact> {
public:
    // For the contact register. `fixtureA` is the polygon against a circle, the edge or the chain against a
    // polygon.
    static bool Serves(const b2Shape &a, const b2Shape &b);

    using ContactClass<ConvexContact>::AsOurs;

    /// That of the last update.
    bmr_vec2 KnownDirection() const override;

private:
    friend class ContactClass<ConvexContact>;
    ConvexContact() = default;
    using SolidContact::SolidContact;

    Answer SearchApart(const b2Transform &xfA, const b2Transform &xfB);
    float Margin() const;
    ProofResult ResultOf(Answer answer, bool points, const b2Transform &xfA, const b2Transform &xfB) const;
    Answer Ask(const b2Transform &xfA, const b2Transform &xfB);
    void Fill(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;
    bool IsAtImpact() const;
    TwoFixtures Two() const { return {m_fixtureA, m_fixtureB, m_indexA}; }
};

/// Contacts of big ConvexShapes with polygons, circles, edges and chains are ours from here on. To be called
/// before the first such shape is handed out; any number of times, from any thread. (A world that another
/// thread steps meanwhile makes its contacts as before or as after.) BMR_ERROR_UNSUPPORTED where the Box2D
/// of this process is none that the glue knows.
bmr_error RegisterConvexContacts();

static_assert(sizeof(ConvexContact) <= 224, "must stay in the block class of a stock contact");

} // namespace bmr

#endif
