// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_WEIGHING_H
#define BOOMERANG_GLUE_WEIGHING_H

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <box2d/b2_shape.h>

/// @file
/// Inertia as Box2D can hold it. b2Body::ResetMassData adds up the inertias of the fixtures about the body's
/// origin, in float, and takes mass times the square of the centre's distance c off the sum. The difference
/// of two floats that are about m c^2 is a multiple of their last bit, up to 2^-23 m c^2: no inertia is held
/// better than to half of that. The best that fixtures can report is the float that is nearest to the right
/// sum, with Box2D's own rounding of what it takes off.
///
/// That is so of fixtures that are alone on a body. When some of them go, or others come, each of them is
/// rounded about six times, by up to 2^-24 m c^2 and one way or the other, and what is left of the inertia
/// has to be more than what that may come to, for Box2D asserts that it is above zero.

namespace bmr {

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

/// The sum of which Box2D takes off `ofCentre`: what is left is above zero, and as near to `own` as floats
/// hold it.
inline float InertiaAboutOrigin(float ofCentre, double own) {
    const auto square = static_cast<double>(ofCentre);
    return static_cast<float>(square + (own < HeldInertia(1) * square ? kSafeInertia * square : own));
}

} // namespace bmr

#endif
