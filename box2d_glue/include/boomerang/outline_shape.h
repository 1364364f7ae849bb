// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_OUTLINE_SHAPE_H
#define BOOMERANG_OUTLINE_SHAPE_H

#include <cstdint>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "boomerang/convex_shape.h"
#include "boomerang/outline.h"

class b2Contact;

/// @file
/// A body of any outline: concave, with holes. Games include boomerang/box2d.h.
///
///     bmr::OutlineShape rock;
///     if (rock.Set(points, count) == BMR_OK)
///         rock.CreateFixtures(body, 1.0f);
///
/// The outline is cut into few convex pieces (boomerang/outline.h), each of which is one fixture. The pieces
/// know where they meet, so a body that slides or rolls along the outline feels no seam (docs/outlines.md).

namespace bmr {

struct OutlineRecord;

/// A hole of an outline: a ring of points, in either direction. Points that are repeated in a row are left
/// out.
struct OutlineHole {
    const b2Vec2 *points;
    int32 count;
};

/// An outline, cut once and shared by all bodies that have it: copies are cheap, and the last of the copies
/// and of the fixtures frees it. Outlines may be made, copied and destroyed on any thread.
class BMR_BOX2D_API OutlineShape {
public:
    OutlineShape() noexcept = default; ///< of no points
    OutlineShape(const OutlineShape &other) noexcept;
    OutlineShape &operator=(const OutlineShape &other) noexcept;
    ~OutlineShape();

    /// The outline of a ring of points, in either direction, less its holes. With tolerance 0 the pieces are
    /// exactly the outline, but for slivers thinner than floats can tell (1e-7 of their length). With a
    /// tolerance, in length units, there are fewer pieces, and outline and pieces are nowhere farther than
    /// that apart.
    ///
    /// Errors leave the outline as it was: BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_TOO_FEW_POINTS (of a ring; or
    /// no piece has an area, as far as floats can tell), BMR_ERROR_TOO_MANY_POINTS, BMR_ERROR_NOT_FINITE,
    /// BMR_ERROR_NEGATIVE (a count or the tolerance), BMR_ERROR_OUT_OF_RANGE (a coordinate beyond 1e9, an
    /// area that is no normal float), BMR_ERROR_CROSSING_EDGES, BMR_ERROR_OVERLAPPING_EDGES,
    /// BMR_ERROR_HOLE_OUTSIDE (these, rings of too few points, and coordinates that are not finite or beyond
    /// 1e9 say in `*fault` where), BMR_ERROR_FAR_FROM_ORIGIN (rings in doubles that are small and far from
    /// the origin: rounding them to floats could change the area by a hundredth), BMR_ERROR_NO_MEMORY,
    /// BMR_ERROR_UNSUPPORTED (a Box2D that the glue does not know). About O(n log n).
    ///
    /// A fault names two edges (boomerang/outline.h says which), or, of a coordinate that is not allowed, the
    /// one that begins at the point. Edges are numbered from 0, those of the outer ring first, then hole
    /// after hole; edge i begins at point i. Ring 0 is the outer one.
    bmr_error Set(const b2Vec2 *points, int32 count, const OutlineHole *holes = nullptr, int32 holeCount = 0,
                  float tolerance = 0.0f, bmr_outline_fault *fault = nullptr);
    /// The same of rings in doubles, the outer one first, as boomerang::repair returns them. The shape is of
    /// floats: of coordinates on a map subtract an origin near the outline first.
    bmr_error Set(const bmr_rings &rings, float tolerance = 0.0f, bmr_outline_fault *fault = nullptr);

    /// Makes a fixture of each piece on the body, all by `def`, whose shape is not read. The body's mass,
    /// centre and inertia then include those of the outline, also if the pieces are the outline only within a
    /// tolerance. Not during a step of the world.
    ///
    /// Box2D adds up inertias about the body's origin, in float, and takes m c^2 off the sum (m is the body's
    /// mass, c how far its centre is from its origin). So it holds an inertia about the centre to half of the
    /// last bit of m c^2, which is up to 2^-24 m c^2. The pieces' masses are chosen so that a body of this
    /// outline alone gets the float nearest to the right inertia, or the next one. The call refuses bodies
    /// that turn if their inertia is less than 2^-21 m c^2 (n > 1 fixtures: 0.75 sqrt(n) times that), or
    /// would be off by more than an eighth: put the body's origin near its shapes. A thing of 1 m may be 300
    /// m away.
    ///
    /// Errors leave the body as it was: BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_NO_POINTS (of no outline),
    /// BMR_ERROR_NOT_FINITE and BMR_ERROR_NEGATIVE (density, friction; restitution and its threshold not
    /// finite), BMR_ERROR_OUT_OF_RANGE (a density with which the body's mass or inertia is beyond floats),
    /// BMR_ERROR_WORLD_LOCKED, BMR_ERROR_FAR_FROM_ORIGIN (a dynamic body of no fixed rotation that could not
    /// hold its inertia. A body that becomes one later gets too large an inertia: one above zero).
    bmr_error CreateFixtures(b2Body *body, const b2FixtureDef &def) const;
    bmr_error CreateFixtures(b2Body *body, float density) const;
    /// Destroys all fixtures of this outline that the body has. Their densities are 0 before that: the body
    /// is weighed once. BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_WORLD_LOCKED.
    bmr_error DestroyFixtures(b2Body *body) const;
    /// Calls function(b2Fixture &) with each fixture of this outline that the body has, which it may destroy:
    ///
    ///     outline.ForEachFixture(body, [](b2Fixture &piece) { piece.SetFriction(0.2f); });
    template <typename Function> void ForEachFixture(b2Body *body, Function function) const {
        for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;) {
            b2Fixture *const next = fixture->GetNext();
            if (Has(*fixture))
                function(*fixture);
            fixture = next;
        }
    }

    /// The outline that a fixture is a piece of; if it is none, an outline without points. O(1).
    static OutlineShape From(const b2Fixture *fixture);
    /// Is this fixture a piece of this outline? O(1).
    bool Has(const b2Fixture &fixture) const;
    /// Are the two the same outline, made by one Set?
    bool operator==(const OutlineShape &other) const { return m_record == other.m_record; }
    bool operator!=(const OutlineShape &other) const { return m_record != other.m_record; }

    int32 GetPieceCount() const;
    /// Piece `index` as a shape of its own; without vertices if there is no such piece.
    ConvexShape GetPiece(int32 index) const;
    /// Does another piece go on behind all of this piece's edge from vertex `edge` to the next? False for a
    /// part of it, and if there is no such edge.
    bool IsInnerEdge(int32 index, int32 edge) const;
    /// The outline's mass at this density. Its inertia is about the origin, and such that b2Body::SetMassData
    /// makes the float nearest to the right one of it.
    void ComputeMass(b2MassData *massData, float density) const;

private:
    OutlineRecord *m_record = nullptr;
};

/// Is this the only contact that touches between its two outlines? (A fixture that is no piece counts as
/// one.) Box2D calls the listener for each pair of fixtures; this makes one begin and one end of all pairs of
/// two outlines:
///
///     void BeginContact(b2Contact *contact) override {
///         if (bmr::TouchesAlone(*contact))
///             ... the two outlines begin to touch
///
/// and the same in EndContact. O(contacts of the one of the two bodies that is dynamic).
BMR_BOX2D_API bool TouchesAlone(const b2Contact &contact);

} // namespace bmr

#endif
