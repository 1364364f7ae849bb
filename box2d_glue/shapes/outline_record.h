// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OUTLINE_RECORD_H
#define BOOMERANG_GLUE_OUTLINE_RECORD_H

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <box2d/b2_shape.h>

#include "boomerang/error.h"
#include "boomerang/outline.h"
#include "convex32/convex32.h"
#include "shapes/big_polygons.h"

class b2Body;

namespace bmr {

// Inertia as Box2D can hold it. b2Body::ResetMassData adds up the inertias of the fixtures about the body's
// origin, in float, and takes mass times the square of the centre's distance c off the sum. The difference
// of two floats that are about m c^2 is a multiple of their last bit, up to 2^-23 m c^2: no inertia is held
// better than to half of that. The best that fixtures can report is the float that is nearest to the right
// sum, with Box2D's own rounding of what it takes off.
//
// That is so of fixtures that are alone on a body. When some of them go, or others come, each of them is
// rounded about six times, by up to 2^-24 m c^2 and one way or the other, and what is left of the inertia
// has to be more than what that may come to, for Box2D asserts that it is above zero.

/// Of m c^2: the least inertia about the centre that a body of so many fixtures holds. For one it is an
/// eighth of 2^-18, and what is held is right to an eighth: the centre may be 1,448 times the radius of
/// gyration from the body's origin.
inline double HeldInertia(uint32_t fixtures) {
    return 0x1p-24 * std::max(8.0, 6.0 * std::sqrt(static_cast<double>(fixtures)));
}

/// Shapes report at least this part of m c^2: the difference then stays above zero beside other fixtures.
constexpr double kSafeInertia = 0x1p-17;

/// Of the right inertia: by so much what is held may be off.
constexpr double kInertiaTolerance = 0.125;

/// As b2Body::ResetMassData adds up fixtures, in the order of the body's list, rounding included.
class Weighing {
public:
    void Add(const b2MassData &fixture) {
        m_mass += fixture.mass;
        m_moment += fixture.mass * fixture.center;
        m_sum += fixture.I;
    }

    float Sum() const { return m_sum; }
    /// The part that Box2D subtracts from the sum.
    float OfCentre() const {
        b2Vec2 centre = m_moment;
        if (m_mass > 0.0f)
            centre *= 1.0f / m_mass;
        return m_mass * b2Dot(centre, centre);
    }

private:
    float m_mass = 0.0f, m_sum = 0.0f;
    b2Vec2 m_moment{0.0f, 0.0f};
};

/// The inertia about the origin that a shape reports. Box2D subtracts `ofCentre` from it: the difference is
/// above zero, and as near to `own` as floats hold it.
inline float InertiaAboutOrigin(float ofCentre, double own) {
    const auto square = static_cast<double>(ofCentre);
    return static_cast<float>(square + (own < HeldInertia(1) * square ? kSafeInertia * square : own));
}

/// Shared by the copies of an OutlineShape and their fixtures: its pieces, which are big polygons of the
/// registry, also if they have few vertices. One block of memory, besides those of the pieces.
struct OutlineRecord : registry::Group {
    double area;
    bmr_vec2 centroid;
    double inertia; ///< about the centroid
    double ownPart; ///< of the inertias that its pieces have of their own: the rest is for floats to hold
    float reach;    ///< no vertex of a piece is farther from the origin
    uint32_t pieceCount;
    uint32_t balance;           ///< which of the pieces makes up for the rounding of all (WeighPiece)
    registry::Handle pieces[1]; ///< as many as there are pieces
};

/// The record of an outline that was cut into these pieces, with one reference. `mass` is the outline's; the
/// pieces are given masses whose sum it is. BMR_ERROR_TOO_FEW_POINTS where no piece has an area as far as
/// floats can tell, BMR_ERROR_OUT_OF_RANGE, BMR_ERROR_NO_MEMORY; then `*record` is untouched.
bmr_error MakeOutlineRecord(const bmr_outline_pieces &pieces, const bmr_mass &mass, OutlineRecord **record);

/// The record that a shape is a piece of, also where it was changed in place; nullptr where it is none. A few
/// loads.
OutlineRecord *OutlineRecordOf(const b2Shape &shape);

/// A ray from p1 towards p2, in the shape's frame, hits a piece of an outline by an edge, at a fraction of
/// the way (bmr_convex32_ray) and with that edge's normal. Does it come into the outline there?
///
/// True also where a corner of the outline let it through by rounding, and it hits the piece behind the
/// corner by an inner edge. Then `*normal` becomes that of the outline's edge at the corner, and `*fraction`
/// may become less.
///
/// O(1), but for the parts of that edge; of a ray that passes an end of an inner edge by no more than
/// rounding, O(all the outline's vertices). Reads what never changes: on any thread.
bool EntersOutline(registry::Handle piece, bmr_vec32 p1, bmr_vec32 p2, uint32_t edge, float *fraction,
                   bmr_vec32 *normal);

/// The mass of a fixture of a piece: its share of the outline's mass. The inertias of all shares of one
/// density add up, in a body that has nothing else and in Box2D's rounding, to the float that is nearest to
/// the outline's, or to one beside it: midway between two, a sum goes to the even one. One of the pieces
/// makes up for the rounding of the others: of that one O(pieces), else O(1).
void WeighPiece(registry::Handle piece, float density, b2MassData *massData);

/// Will Box2D hold the inertia of a body to kInertiaTolerance when all pieces are on it, too? Else
/// BMR_ERROR_FAR_FROM_ORIGIN. Bodies that do not turn have none to be held. O(pieces and fixtures).
bmr_error CheckInertia(const b2Body &body, const OutlineRecord &record, float density);

} // namespace bmr

#endif
