// SPDX-License-Identifier: MIT
// The operations of one contact are those of ContactSolver::Solve, in its order, with x and y of both bodies
// side by side: a register holds vA.x vA.y vB.x vB.y.
#include "passes/ordered_velocities.h"

#include "exact32/float4.h"

namespace bmr {

/// What is read of a contact's two bodies while it is solved.
struct OrderedVelocities::Lanes {
    float4 v;       ///< A's x and y, B's x and y
    float4 w;       ///< A's twice, B's twice
    float4 invMass; ///< likewise
    float4 invI;
};

namespace {

/// x + y of lanes 0 and 1, in both; likewise of 2 and 3.
float4 SumOfTwo(float4 v) {
    return add4(v, swap4(v));
}

/// r x p of A in lanes 0 and 1, of B in 2 and 3.
float4 Cross(float4 arms, float4 p) {
    return SumOfTwo(mul4(arms, p));
}

/// The velocity of B against A at a point, in lanes 0 and 1.
template <typename Lanes> float4 Relative(const Lanes &two, float4 arms) {
    const float4 turning = mul4(two.w, arms);
    return sub4(sub4(exchange4(add4(two.v, turning)), two.v), turning);
}

/// An impulse p, and what it turns: taken from A, given to B.
template <typename Lanes> void Apply(float4 p, float4 turning, Lanes *two) {
    two->v = add4(two->v, flip_low4(mul4(two->invMass, p)));
    two->w = add4(two->w, flip_low4(mul4(two->invI, turning)));
}

/// One number of each point.
float4 OfPoints(const float *two) {
    return of4(two[0], two[0], two[1], two[1]);
}

/// A matrix, by columns, and a vector, of whose coordinates each stands in two lanes.
float4 Product(const float *matrix, float4 v) {
    const float4 m = load4(matrix);
    return add4(mul4(zip_low4(m, m), splat4(v, 0)), mul4(zip_high4(m, m), splat4(v, 2)));
}

} // namespace

bool OrderedVelocities::Reserve(uint32_t bodies, uint32_t contacts) {
    const uint32_t slots = bodies + 2 * contacts, all = kOverlapping * contacts;
    return m_records.Reserve(contacts) && m_velocities.Reserve(slots) && m_last.Reserve(slots) &&
           m_levels.Reserve(all) && m_starts.Reserve(all + 2) && m_order.Reserve(all);
}

bool OrderedVelocities::Solve(VelocityConstraint *constraints, uint32_t count, int32 iterations,
                              b2Velocity *velocities, uint32_t bodyCount) {
    if (!Pack(constraints, count, velocities, bodyCount))
        return false;
    uint32_t left = iterations > 0 ? static_cast<uint32_t>(iterations) : 0;
    while (left > 0) {
        const uint32_t some = left < kOverlapping ? left : kOverlapping;
        if (some != m_orderedIterations)
            FindOrder(count, some);
        for (uint32_t i = 0; i < m_orderCount; ++i)
            Solve(&m_records[m_order[i]], m_velocities.Data());
        left -= some;
    }
    if (!AreCopiesZero(bodyCount))
        return false;
    for (uint32_t i = 0; i < count; ++i) {
        for (int32 j = 0; j < constraints[i].pointCount; ++j) {
            constraints[i].points[j].normalImpulse = m_records[i].normalImpulse[j];
            constraints[i].points[j].tangentImpulse = m_records[i].tangentImpulse[j];
        }
    }
    for (uint32_t i = 0; i < bodyCount; ++i) {
        velocities[i].v.Set(m_velocities[i].x, m_velocities[i].y);
        velocities[i].w = m_velocities[i].w;
    }
    return true;
}

/// Reads constraints and velocities. False where Box2D might assert. The order that was found last is kept
/// where the same contacts follow each other, as in a pile from step to step.
bool OrderedVelocities::Pack(const VelocityConstraint *constraints, uint32_t count,
                             const b2Velocity *velocities, uint32_t bodyCount) {
    const uint32_t ordered = m_orderedIterations;
    bool isAsLast = count == m_count;
    m_orderedIterations = 0;
    m_count = count;
    m_slotCount = bodyCount;
    for (uint32_t i = 0; i < bodyCount; ++i)
        m_velocities[i] = {velocities[i].v.x, velocities[i].v.y, velocities[i].w, velocities[i].w};
    // The body's own slot, or a copy of one that nothing moves.
    const auto slotOf = [this](int32 body, float invMass, float invI) {
        const Velocity &velocity = m_velocities[static_cast<uint32_t>(body)];
        uint32_t bits[3];
        std::memcpy(bits, &velocity, sizeof bits);
        if (invMass != 0.0f || invI != 0.0f || (bits[0] | bits[1] | bits[2]) != 0)
            return static_cast<uint32_t>(body);
        m_velocities[m_slotCount] = {0.0f, 0.0f, 0.0f, 0.0f};
        return m_slotCount++;
    };
    for (uint32_t i = 0; i < count; ++i) {
        const VelocityConstraint &c = constraints[i];
        const ContactBodies &of = c.bodies;
        Record &r = m_records[i];
        for (int32 j = 0; j < c.pointCount; ++j) {
            const VelocityPoint &at = c.points[j];
            store4(r.arms[j], of4(-at.rA.y, at.rA.x, -at.rB.y, at.rB.x));
            r.normalImpulse[j] = at.normalImpulse;
            r.tangentImpulse[j] = at.tangentImpulse;
            r.normalMass[j] = at.normalMass;
            r.tangentMass[j] = at.tangentMass;
            r.bias[j] = at.velocityBias;
            if (c.pointCount == 2 && !(at.normalImpulse >= 0.0f))
                return false;
        }
        store4(r.invMass, of4(of.invMassA, of.invMassA, of.invMassB, of.invMassB));
        store4(r.invI, of4(of.invIA, of.invIA, of.invIB, of.invIB));
        store4(r.k, of4(c.K.ex.x, c.K.ex.y, c.K.ey.x, c.K.ey.y));
        store4(r.mass, of4(c.normalMass.ex.x, c.normalMass.ex.y, c.normalMass.ey.x, c.normalMass.ey.y));
        r.normal[0] = c.normal.x;
        r.normal[1] = c.normal.y;
        r.friction = c.friction;
        r.tangentSpeed = c.tangentSpeed;
        const Slots slots = {slotOf(of.indexA, of.invMassA, of.invIA),
                             slotOf(of.indexB, of.invMassB, of.invIB)};
        isAsLast = isAsLast && r.slots.a == slots.a && r.slots.b == slots.b;
        r.slots = slots;
        r.pointCount = c.pointCount;
    }
    m_orderedIterations = isAsLast ? ordered : 0;
    return true;
}

/// Counts how many contacts have each level, and puts them there.
void OrderedVelocities::FindOrder(uint32_t count, uint32_t iterations) {
    m_orderedIterations = iterations;
    m_orderCount = count * iterations;
    for (uint32_t i = 0; i < m_slotCount; ++i)
        m_last[i] = 0;
    for (uint32_t i = 0; i <= m_orderCount; ++i)
        m_starts[i] = 0;
    uint32_t highest = 0;
    for (uint32_t i = 0, at = 0; i < iterations; ++i) {
        for (uint32_t j = 0; j < count; ++j, ++at) {
            const Slots slots = m_records[j].slots;
            const uint32_t a = m_last[slots.a], b = m_last[slots.b], level = (a > b ? a : b) + 1;
            m_last[slots.a] = m_last[slots.b] = level;
            m_levels[at] = level;
            ++m_starts[level];
            highest = level > highest ? level : highest;
        }
    }
    for (uint32_t level = 1; level <= highest; ++level)
        m_starts[level] += m_starts[level - 1];
    for (uint32_t i = 0, at = 0; i < iterations; ++i)
        for (uint32_t j = 0; j < count; ++j, ++at)
            m_order[m_starts[m_levels[at] - 1]++] = j;
}

bool OrderedVelocities::AreCopiesZero(uint32_t bodyCount) const {
    bool zero = true;
    for (uint32_t i = bodyCount; i < m_slotCount; ++i) {
        const Velocity &copy = m_velocities[i];
        zero = zero && copy.x == 0.0f && copy.y == 0.0f && copy.w == 0.0f;
    }
    return zero;
}

void OrderedVelocities::Solve(Record *record, Velocity *velocities) {
    Record &r = *record;
    float *const a = &velocities[r.slots.a].x, *const b = &velocities[r.slots.b].x;
    const float4 slotA = load4(a), slotB = load4(b), normal = load_pairs4(r.normal, r.normal);
    Lanes two = {lows4(slotA, slotB), highs4(slotA, slotB), load4(r.invMass), load4(r.invI)};
    const float4 first = load4(r.arms[0]);
    SolveFriction(normal, first, 0, &r, &two);
    if (r.pointCount == 1) {
        SolveOnePoint(normal, first, &r, &two);
    } else {
        const float4 second = load4(r.arms[1]);
        SolveFriction(normal, second, 1, &r, &two);
        SolveTwoPoints(normal, first, second, &r, &two);
    }
    store4(a, lows4(two.v, two.w));
    store4(b, highs4(two.v, two.w));
}

void OrderedVelocities::SolveFriction(float4 normal, float4 arms, int32 i, Record *record, Lanes *two) {
    Record &r = *record;
    const float4 tangent = flip_odd4(swap4(normal));
    const float speed = first_of4(SumOfTwo(mul4(Relative(*two, arms), tangent))) - r.tangentSpeed;
    const float wanted = r.tangentImpulse[i] + r.tangentMass[i] * (-speed);
    const float most = r.friction * r.normalImpulse[i];
    const float impulse = b2Clamp(wanted, -most, most);
    const float more = impulse - r.tangentImpulse[i];
    r.tangentImpulse[i] = impulse;
    const float4 p = mul4(all4(more), tangent);
    Apply(p, Cross(arms, p), two);
}

void OrderedVelocities::SolveOnePoint(float4 normal, float4 arms, Record *record, Lanes *two) {
    Record &r = *record;
    const float speed = first_of4(SumOfTwo(mul4(Relative(*two, arms), normal)));
    const float impulse = b2Max(r.normalImpulse[0] + -r.normalMass[0] * (speed - r.bias[0]), 0.0f);
    const float more = impulse - r.normalImpulse[0];
    r.normalImpulse[0] = impulse;
    const float4 p = mul4(all4(more), normal);
    Apply(p, Cross(arms, p), two);
}

/// The first point in lanes 0 and 1, the second in 2 and 3.
void OrderedVelocities::SolveTwoPoints(float4 normal, float4 first, float4 second, Record *record,
                                       Lanes *two) {
    Record &r = *record;
    const float4 turningFirst = mul4(two->w, first), turningSecond = mul4(two->w, second);
    const float4 ofB = add4(highs4(two->v, two->v), highs4(turningFirst, turningSecond));
    const float4 relative = sub4(sub4(ofB, lows4(two->v, two->v)), lows4(turningFirst, turningSecond));
    const float4 before = OfPoints(r.normalImpulse);
    const float4 b = sub4(sub4(SumOfTwo(mul4(relative, normal)), OfPoints(r.bias)), Product(r.k, before));
    const float4 wanted = Product(r.mass, b);
    float4 impulses = flip_even4(flip_odd4(wanted));
    if (!every4(at_most4(zero4(), impulses)) && !SolveOneOfTwo(r, b, &impulses))
        return;
    const float4 p = mul4(sub4(impulses, before), normal);
    Apply(add4(p, exchange4(p)), add4(Cross(first, lows4(p, p)), Cross(second, highs4(p, p))), two);
    r.normalImpulse[0] = first_of4(impulses);
    r.normalImpulse[1] = first_of4(exchange4(impulses));
}

/// Where not both points press: one of them does, or none. False where there is no solution.
bool OrderedVelocities::SolveOneOfTwo(const Record &r, float4 wanted, float4 *impulses) {
    const float b[2] = {first_of4(wanted), first_of4(exchange4(wanted))};
    const float first = -r.normalMass[0] * b[0], second = -r.normalMass[1] * b[1];
    if (first >= 0.0f && r.k[1] * first + b[1] >= 0.0f)
        *impulses = of4(first, first, 0.0f, 0.0f);
    else if (second >= 0.0f && r.k[2] * second + b[0] >= 0.0f)
        *impulses = of4(0.0f, 0.0f, second, second);
    else if (b[0] >= 0.0f && b[1] >= 0.0f)
        *impulses = zero4();
    else
        return false;
    return true;
}

} // namespace bmr
