// SPDX-License-Identifier: MIT
// The operations of a lane are those of ContactSolver::Solve, in its order and with its signs.
#include "passes/ordered_velocities.h"

#include <cmath>
#include <cstddef>

#include "exact32/float4.h"

namespace bmr {

namespace {

float4 Negative(float4 v) {
    return flip_low4(exchange4(flip_low4(exchange4(v))));
}

/// Vectors of four contacts.
struct Vec4 {
    float4 x, y;
};
Vec4 Plus(const Vec4 &a, const Vec4 &b) {
    return {add4(a.x, b.x), add4(a.y, b.y)};
}
Vec4 Minus(const Vec4 &a, const Vec4 &b) {
    return {sub4(a.x, b.x), sub4(a.y, b.y)};
}
Vec4 Times(float4 s, const Vec4 &a) {
    return {mul4(s, a.x), mul4(s, a.y)};
}
float4 Dot(const Vec4 &a, const Vec4 &b) {
    return add4(mul4(a.x, b.x), mul4(a.y, b.y));
}
float4 Cross(const Vec4 &a, const Vec4 &b) {
    return sub4(mul4(a.x, b.y), mul4(a.y, b.x));
}

/// Four floats of each of four contacts: one float of all of them in a register.
struct Rows {
    float4 a, b, c, d;
};
FLOAT4_INLINE Rows Transposed(float4 p, float4 q, float4 r, float4 s) {
    const float4 pq = zip_low4(p, q), rs = zip_low4(r, s), alsoPq = zip_high4(p, q), alsoRs = zip_high4(r, s);
    return {lows4(pq, rs), highs4(pq, rs), lows4(alsoPq, alsoRs), highs4(alsoPq, alsoRs)};
}

struct Point4 {
    Vec4 rA, rB;
    float4 normalImpulse, tangentImpulse, normalMass, tangentMass, bias;
};

struct Velocity4 {
    Vec4 v;
    float4 w;
};

/// Four contacts of as many points, of which no two share a body that moves.
struct Four {
    VelocityConstraint *constraints[4];
    b2Velocity *velocities;
    Vec4 normal;
    float4 friction, tangentSpeed, invMassA, invMassB, invIA, invIB;
    Velocity4 a, b;

    Four(VelocityConstraint *all, const uint32_t *four, b2Velocity *ofBodies)
        : constraints{&all[four[0]], &all[four[1]], &all[four[2]], &all[four[3]]}, velocities(ofBodies) {
        const Rows rows = Read(&constraints[0]->bodies.invMassA), first = Read(&constraints[0]->normal.x);
        normal = {first.a, first.b};
        friction = first.c;
        tangentSpeed = first.d;
        invMassA = rows.a;
        invMassB = rows.b;
        invIA = rows.c;
        invIB = rows.d;
        a = ReadVelocities(&ContactBodies::indexA);
        b = ReadVelocities(&ContactBodies::indexB);
    }
    /// `row`: of the first constraint; and the same of the others.
    Rows Read(const float *row) const {
        const std::ptrdiff_t at = row - &constraints[0]->normal.x;
        return Transposed(load4(row), load4(&constraints[1]->normal.x + at),
                          load4(&constraints[2]->normal.x + at), load4(&constraints[3]->normal.x + at));
    }
    Point4 ReadPoint(int32 i) const {
        const Rows arms = Read(&constraints[0]->points[i].rA.x),
                   rest = Read(&constraints[0]->points[i].normalImpulse);
        const float4 bias =
            of4(constraints[0]->points[i].velocityBias, constraints[1]->points[i].velocityBias,
                constraints[2]->points[i].velocityBias, constraints[3]->points[i].velocityBias);
        return {{arms.a, arms.b}, {arms.c, arms.d}, rest.a, rest.b, rest.c, rest.d, bias};
    }
    Velocity4 ReadVelocities(int32 ContactBodies::*index) const {
        const b2Velocity *of[4];
        for (int i = 0; i < 4; ++i)
            of[i] = &velocities[constraints[i]->bodies.*index];
        const float4 low = load_pairs4(&of[0]->v.x, &of[1]->v.x),
                     high = load_pairs4(&of[2]->v.x, &of[3]->v.x);
        return {{evens4(low, high), odds4(low, high)}, of4(of[0]->w, of[1]->w, of[2]->w, of[3]->w)};
    }
    void Write(const Velocity4 &velocity, int32 ContactBodies::*index, uint32_t count) const {
        const float4 low = zip_low4(velocity.v.x, velocity.v.y), high = zip_high4(velocity.v.x, velocity.v.y);
        float w[4];
        store4(w, velocity.w);
        for (uint32_t i = 0; i < 4 && i < count; ++i) {
            b2Velocity &of = velocities[constraints[i]->bodies.*index];
            const float4 two = i < 2 ? low : high;
            if (i % 2 == 0)
                store_low4(&of.v.x, two);
            else
                store_high4(&of.v.x, two);
            of.w = w[i];
        }
    }
    void Write(int32 i, const Point4 &at, uint32_t count) const {
        const float4 low = zip_low4(at.normalImpulse, at.tangentImpulse),
                     high = zip_high4(at.normalImpulse, at.tangentImpulse);
        for (uint32_t j = 0; j < 4 && j < count; ++j) {
            float *const two = &constraints[j]->points[i].normalImpulse;
            if (j % 2 == 0)
                store_low4(two, j < 2 ? low : high);
            else
                store_high4(two, j < 2 ? low : high);
        }
    }

    Vec4 Relative(const Point4 &at) const {
        const Vec4 ofB = {sub4(b.v.x, mul4(b.w, at.rB.y)), add4(b.v.y, mul4(b.w, at.rB.x))};
        const Vec4 more = Minus(ofB, a.v);
        return {add4(more.x, mul4(a.w, at.rA.y)), sub4(more.y, mul4(a.w, at.rA.x))};
    }
    void Apply(const Vec4 &p, float4 turnA, float4 turnB) {
        a.v = Minus(a.v, Times(invMassA, p));
        a.w = sub4(a.w, mul4(invIA, turnA));
        b.v = Plus(b.v, Times(invMassB, p));
        b.w = add4(b.w, mul4(invIB, turnB));
    }
    void SolveFriction(Point4 *at) {
        const Vec4 tangent = {normal.y, Negative(normal.x)};
        const float4 speed = sub4(Dot(Relative(*at), tangent), tangentSpeed);
        const float4 wanted = sub4(at->tangentImpulse, mul4(at->tangentMass, speed));
        const float4 most = mul4(friction, at->normalImpulse);
        const float4 impulse = max4(Negative(most), min4(wanted, most));
        const Vec4 p = Times(sub4(impulse, at->tangentImpulse), tangent);
        at->tangentImpulse = impulse;
        Apply(p, Cross(at->rA, p), Cross(at->rB, p));
    }
    void SolveOnePoint(Point4 *at) {
        const float4 speed = sub4(Dot(Relative(*at), normal), at->bias);
        const float4 impulse = max4(sub4(at->normalImpulse, mul4(at->normalMass, speed)), zero4());
        const Vec4 p = Times(sub4(impulse, at->normalImpulse), normal);
        at->normalImpulse = impulse;
        Apply(p, Cross(at->rA, p), Cross(at->rB, p));
    }
    void SolveTwoPoints(Point4 *first, Point4 *second) {
        const Rows k = Read(&constraints[0]->K.ex.x), inverse = Read(&constraints[0]->normalMass.ex.x);
        const float4 zero = zero4(), beforeFirst = first->normalImpulse, beforeSecond = second->normalImpulse;
        const float4 x = sub4(sub4(Dot(Relative(*first), normal), first->bias),
                              Dot({k.a, k.c}, {beforeFirst, beforeSecond}));
        const float4 y = sub4(sub4(Dot(Relative(*second), normal), second->bias),
                              Dot({k.b, k.d}, {beforeFirst, beforeSecond}));
        const float4 bothX = Negative(Dot({inverse.a, inverse.c}, {x, y})),
                     bothY = Negative(Dot({inverse.b, inverse.d}, {x, y}));
        const float4 oneX = Negative(mul4(first->normalMass, x)),
                     oneY = Negative(mul4(second->normalMass, y));
        const mask4 both = both4(at_most4(zero, bothX), at_most4(zero, bothY));
        const mask4 isFirst = both4(at_most4(zero, oneX), at_most4(zero, add4(mul4(k.b, oneX), y)));
        const mask4 isSecond = both4(at_most4(zero, oneY), at_most4(zero, add4(mul4(k.c, oneY), x)));
        const mask4 none = both4(at_most4(zero, x), at_most4(zero, y));
        const mask4 solved = either4(either4(both, isFirst), either4(isSecond, none));
        const float4 toX = select4(both, bothX, keep4(isFirst, oneX)),
                     toY = select4(both, bothY, select4(isFirst, zero, keep4(isSecond, oneY)));
        const Vec4 p = Times(sub4(toX, beforeFirst), normal), q = Times(sub4(toY, beforeSecond), normal);
        const Velocity4 wasA = a, wasB = b;
        Apply(Plus(p, q), add4(Cross(first->rA, p), Cross(second->rA, q)),
              add4(Cross(first->rB, p), Cross(second->rB, q)));
        first->normalImpulse = toX;
        second->normalImpulse = toY;
        if (every4(solved))
            return;
        first->normalImpulse = select4(solved, toX, beforeFirst); // no solution: nothing changes
        second->normalImpulse = select4(solved, toY, beforeSecond);
        a = {{select4(solved, a.v.x, wasA.v.x), select4(solved, a.v.y, wasA.v.y)},
             select4(solved, a.w, wasA.w)};
        b = {{select4(solved, b.v.x, wasB.v.x), select4(solved, b.v.y, wasB.v.y)},
             select4(solved, b.w, wasB.w)};
    }
    /// Returns where a velocity is NaN.
    mask4 Solve(uint32_t count, bool two) {
        Point4 first = ReadPoint(0);
        SolveFriction(&first);
        if (two) {
            Point4 second = ReadPoint(1);
            SolveFriction(&second);
            SolveTwoPoints(&first, &second);
            Write(1, second, count);
        } else {
            SolveOnePoint(&first);
        }
        Write(0, first, count);
        Write(a, &ContactBodies::indexA, count);
        Write(b, &ContactBodies::indexB, count);
        return either4(either4(unordered4(a.v.x, a.v.y), unordered4(b.v.x, b.v.y)), unordered4(a.w, b.w));
    }
};

bool CarriesNoOrder(float invMass, float invI, const b2Velocity &velocity) {
    const auto isNegativeZero = [](float x) { return x == 0.0f && std::signbit(x); };
    return invMass == 0.0f && invI == 0.0f && !isNegativeZero(velocity.v.x) &&
           !isNegativeZero(velocity.v.y) && !isNegativeZero(velocity.w);
}

} // namespace

bool OrderedVelocities::Reserve(uint32_t bodies, uint32_t contacts) {
    const uint32_t all = kOverlapping * contacts;
    return m_places.Reserve(contacts) && m_groups.Reserve(all) && m_levels.Reserve(all + 1) &&
           m_last.Reserve(bodies);
}

bool OrderedVelocities::Order(const VelocityConstraint *constraints, uint32_t count,
                              const b2Velocity *velocities, uint32_t bodyCount, int32 iterations) {
    if (iterations <= 0)
        return false;
    const uint32_t all = static_cast<uint32_t>(iterations);
    m_rounds = (all + kOverlapping - 1) / kOverlapping;
    const uint32_t overlapping = all / m_rounds;
    m_left = all - m_rounds * overlapping;
    bool isKnown = count == m_count && overlapping == m_iterations;
    m_bodyCount = bodyCount;
    m_count = count;
    m_iterations = overlapping;
    for (uint32_t i = 0; i < count; ++i) {
        const VelocityConstraint &c = constraints[i];
        const ContactBodies &of = c.bodies;
        const auto a = static_cast<uint32_t>(of.indexA), b = static_cast<uint32_t>(of.indexB);
        const Place place = {CarriesNoOrder(of.invMassA, of.invIA, velocities[a]) ? kNone : a,
                             CarriesNoOrder(of.invMassB, of.invIB, velocities[b]) ? kNone : b, c.pointCount};
        Place &last = m_places[i];
        isKnown = isKnown && last.a == place.a && last.b == place.b && last.pointCount == place.pointCount;
        last = place;
        if (c.pointCount == 2 && !(c.points[0].normalImpulse >= 0.0f && c.points[1].normalImpulse >= 0.0f)) {
            m_count = 0;
            return false; // Box2D may assert
        }
    }
    if (!isKnown)
        m_pays = FindOrder();
    return m_pays;
}

/// False where two iterations have hardly fewer groups than contacts: chains of few contacts each.
bool OrderedVelocities::FindOrder() {
    m_groupCount = m_levelCount = 0;
    for (uint32_t i = 0; i < m_bodyCount; ++i)
        m_last[i] = 0;
    for (uint32_t i = 0; i < m_iterations; ++i) {
        for (uint32_t j = 0; j < m_count; ++j) {
            const Place place = m_places[j];
            const uint32_t a = place.a != kNone ? m_last[place.a] : 0,
                           b = place.b != kNone ? m_last[place.b] : 0, level = a > b ? a : b;
            if (level == m_levelCount)
                m_levels[m_levelCount++] = {{kNone, kNone}};
            if (place.a != kNone)
                m_last[place.a] = level + 1;
            if (place.b != kNone)
                m_last[place.b] = level + 1;
            Put(j, place.pointCount, &m_levels[level]);
        }
        if (i == 1 && 5 * m_groupCount > 8 * m_count)
            return false;
    }
    return true;
}

void OrderedVelocities::Put(uint32_t contact, int32 pointCount, Level *level) {
    uint32_t &newest = level->ofPoints[pointCount - 1];
    if (newest == kNone || m_groups[newest].count == 4) {
        m_groups[m_groupCount] = {{contact, contact, contact, contact}, 0, newest};
        newest = m_groupCount++;
    }
    Group &group = m_groups[newest];
    group.contacts[group.count++] = contact;
}

bool OrderedVelocities::Solve(ContactSolver *solver, b2Velocity *velocities) {
    VelocityConstraint *const all = solver->VelocityConstraints();
    mask4 nans = less4(zero4(), zero4());
    for (uint32_t level = 0, round = 0; round < m_rounds;) {
        for (uint32_t two = 0; two < 2; ++two) {
            for (uint32_t at = m_levels[level].ofPoints[two]; at != kNone; at = m_groups[at].next) {
                const Group &group = m_groups[at];
                if (group.count == 1 || !BMR_FLOAT4_NATIVE) {
                    for (uint32_t i = 0; i < group.count; ++i)
                        solver->SolveVelocity(group.contacts[i]);
                    continue;
                }
                Four four(all, group.contacts, velocities);
                nans = either4(nans, four.Solve(group.count, two == 1));
            }
        }
        if (++level == m_levelCount) {
            level = 0;
            ++round;
        }
    }
    for (uint32_t i = 0; i < m_left; ++i)
        solver->SolveVelocities();
    bool isNan = any4(nans);
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        const b2Velocity &of = velocities[i];
        isNan = isNan || of.v.x != of.v.x || of.v.y != of.v.y || of.w != of.w;
    }
    return !isNan;
}

} // namespace bmr
