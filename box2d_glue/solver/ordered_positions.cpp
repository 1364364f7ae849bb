// SPDX-License-Identifier: MIT
// The operations of a lane are those of ContactSolver::SolvePosition, in its order and with its signs.
#include "solver/ordered_contacts.h"

#include <cstddef>

#include "solver/contact_lanes.h"

namespace bmr {

namespace {

/// Sines and cosines of four bodies.
Vec4 Turned(const Vec4 &q, const Vec4 &v) {
    return {sub4(mul4(q.y, v.x), mul4(q.x, v.y)), add4(mul4(q.x, v.x), mul4(q.y, v.y))};
}

/// Four contacts of a face and as many points, of which no two share a body that moves.
struct FourPositions {
    const PositionConstraint *constraints[4];
    b2Position *positions;
    Rotations *rotations;
    float *a[4], *b[4];           ///< positions of the bodies
    int32 faces[4], incidents[4]; ///< the bodies again: whose face it is, and the other
    mask4 isFaceB, isNan, isDeep;
    Vec4 localNormal, localPoint, faceCenter, incidentCenter;
    float4 invMassA, invMassB, invIA, invIB, radiusA, radiusB, side;

    FourPositions(const PositionConstraint *all, const OrderedContacts::Group &group, uint32_t count,
                  b2Position *ofBodies, Rotations *ofAngles)
        : constraints{&all[group.contacts[0]], &all[group.Contact(1, count)], &all[group.Contact(2, count)],
                      &all[group.Contact(3, count)]},
          positions(ofBodies), rotations(ofAngles), isNan(less4(zero4(), zero4())), isDeep(isNan) {
        const Rows masses = Read(&constraints[0]->bodies.invMassA),
                   face = Read(&constraints[0]->localNormal.x),
                   centers = Read(&constraints[0]->localCenterA.x), rest = Read(&constraints[0]->radiusA);
        invMassA = masses.a;
        invMassB = masses.b;
        invIA = masses.c;
        invIB = masses.d;
        localNormal = {face.a, face.b};
        localPoint = {face.c, face.d};
        radiusA = rest.a;
        radiusB = rest.b;
        side = rest.c;
        isFaceB = less4(side, zero4());
        faceCenter = Select(isFaceB, {centers.c, centers.d}, {centers.a, centers.b});
        incidentCenter = Select(isFaceB, {centers.a, centers.b}, {centers.c, centers.d});
        for (int i = 0; i < 4; ++i) {
            const ContactBodies &of = constraints[i]->bodies;
            a[i] = &positions[of.indexA].c.x;
            b[i] = &positions[of.indexB].c.x;
            const bool isB = constraints[i]->side < 0.0f;
            faces[i] = isB ? of.indexB : of.indexA;
            incidents[i] = isB ? of.indexA : of.indexB;
        }
    }
    /// `row`: of the first constraint; and the same of the others.
    Rows Read(const float *row) const {
        const std::ptrdiff_t at = row - &constraints[0]->localNormal.x;
        return Transposed(load4(row), load4(&constraints[1]->localNormal.x + at),
                          load4(&constraints[2]->localNormal.x + at),
                          load4(&constraints[3]->localNormal.x + at));
    }
    Vec4 ReadRotations(const int32 *bodies) const {
        const auto of = [&](int i) { return &rotations->Of(bodies[i], positions[bodies[i]].a).s; };
        return ReadPairs(of(0), of(1), of(2), of(3));
    }
    Vec4 ReadPoints(int32 i) const {
        const auto of = [&](int j) { return &constraints[j]->localPoints[i].x; };
        return ReadPairs(of(0), of(1), of(2), of(3));
    }
    void SolvePoint(int32 i, uint32_t count) {
        Motion4 ofA = ReadMotions(a[0], a[1], a[2], a[3]), ofB = ReadMotions(b[0], b[1], b[2], b[3]);
        const Vec4 qFace = ReadRotations(faces), qIncident = ReadRotations(incidents);
        const Vec4 face = Minus(Select(isFaceB, ofB.v, ofA.v), Turned(qFace, faceCenter)),
                   incident = Minus(Select(isFaceB, ofA.v, ofB.v), Turned(qIncident, incidentCenter));
        const Vec4 ofFace = Turned(qFace, localNormal), plane = Plus(Turned(qFace, localPoint), face),
                   point = Plus(Turned(qIncident, ReadPoints(i)), incident);
        const float4 separation = sub4(sub4(Dot(Minus(point, plane), ofFace), radiusA), radiusB);
        const Vec4 normal = Times(side, ofFace), rA = Minus(point, ofA.v), rB = Minus(point, ofB.v);
        const float4 most = all4(-b2_maxLinearCorrection),
                     wanted = mul4(all4(b2_baumgarte), add4(separation, all4(b2_linearSlop)));
        const float4 correction = max4(most, min4(wanted, zero4()));
        const float4 rnA = Cross(rA, normal), rnB = Cross(rB, normal);
        const float4 stiffness =
            add4(add4(add4(invMassA, invMassB), mul4(mul4(invIA, rnA), rnA)), mul4(mul4(invIB, rnB), rnB));
        const float4 impulse = keep4(less4(zero4(), stiffness), div4(Negative(correction), stiffness));
        const Vec4 p = Times(impulse, normal);
        ofA = {Minus(ofA.v, Times(invMassA, p)), sub4(ofA.w, mul4(invIA, Cross(rA, p)))};
        ofB = {Plus(ofB.v, Times(invMassB, p)), add4(ofB.w, mul4(invIB, Cross(rB, p)))};
        WriteMotions(ofA, a, count);
        WriteMotions(ofB, b, count);
        isNan =
            either4(either4(isNan, unordered4(separation, separation)), either4(ofA.IsNan(), ofB.IsNan()));
        isDeep = either4(isDeep, less4(separation, all4(ContactSolver::kLeastSeparation)));
    }
};

} // namespace

/// Is the island likely to need all iterations?
bool OrderedPositions::IsDeep(const PositionConstraint *constraints, const Island &island) {
    bool isDeep = false;
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const float separation = constraints[i].separation;
        if (constraints[i].pointCount == 0 || separation != separation)
            return false;
        isDeep = isDeep || separation < ContactSolver::kLeastSeparation;
    }
    return isDeep;
}

void OrderedPositions::Add(const PositionConstraint *constraints, const Island &island,
                           const b2Position *positions) {
    const auto carries = [positions](int32 body, float invMass, float invI) {
        return CarriesNoOrder(invMass, invI, &positions[body].c.x) ? OrderedContacts::kNone
                                                                   : static_cast<uint32_t>(body);
    };
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const PositionConstraint &c = constraints[i];
        const ContactBodies &of = c.bodies;
        const bool isCircles = c.type == b2Manifold::e_circles;
        m_order.Add({i, isCircles ? 2u : static_cast<uint32_t>(c.pointCount - 1),
                     carries(of.indexA, of.invMassA, of.invIA), carries(of.indexB, of.invMassB, of.invIB)});
        m_unsolved[i] = 0;
    }
    for (uint32_t i = island.firstBody; i < island.endBody; ++i)
        m_before[i] = positions[i];
}

/// Returns false where a position or a separation became NaN.
bool OrderedPositions::SolveAll(ContactSolver *solver, b2Position *positions) {
    mask4 isNan = less4(zero4(), zero4());
    bool isAloneNan = false;
    m_order.ForEach([&](const OrderedContacts::Group &group, uint32_t count, uint32_t kind, uint32_t done) {
        unsigned deep = 0;
        if (count == 1 || kind == 2 || !BMR_FLOAT4_NATIVE) {
            for (uint32_t i = 0; i < count; ++i) {
                const float least = solver->SolvePosition(group.contacts[i]);
                isAloneNan = isAloneNan || least != least;
                deep |= least < ContactSolver::kLeastSeparation ? 1u << i : 0u;
            }
        } else {
            FourPositions four(solver->PositionConstraints(), group, count, positions,
                               &solver->GetRotations());
            four.SolvePoint(0, count);
            if (kind == 1)
                four.SolvePoint(1, count);
            isNan = either4(isNan, four.isNan);
            deep = bits4(four.isDeep);
        }
        for (uint32_t i = 0; i < count; ++i) {
            uint8_t &unsolved = m_unsolved[group.contacts[i]];
            unsolved = static_cast<uint8_t>(unsolved | (deep >> i & 1u) << (done + group.iterations[i]));
        }
    });
    return !any4(isNan) && !isAloneNan;
}

/// Puts the island's bodies back, and returns false, if something is no number or an iteration before the
/// last was enough.
bool OrderedPositions::Settle(uint32_t iterations, bool isNumber, b2Position *positions,
                              Island *island) const {
    unsigned unsolved = 0;
    for (uint32_t i = island->firstContact; i < island->endContact; ++i)
        unsolved |= m_unsolved[i];
    const unsigned last = 1u << (iterations - 1);
    island->isSolved = (unsolved & last) == 0;
    const bool isValid = isNumber && (unsolved | last) == 2 * last - 1 && !HasNan(&positions->c.x, *island);
    for (uint32_t i = island->firstBody; i < island->endBody && !isValid; ++i)
        positions[i] = m_before[i];
    return isValid;
}

void OrderedPositions::Solve(ContactSolver *solver, Island *islands, uint32_t count, b2Position *positions,
                             int32 iterations) {
    const auto all = static_cast<uint32_t>(iterations);
    const bool mayOverlap =
        iterations > 0 && all <= OrderedContacts::kOverlapping &&
        islands[count - 1].endContact - islands[0].firstContact >= OrderedContacts::kLeast;
    m_order.Begin();
    for (uint32_t i = 0; i < count; ++i) {
        islands[i].isDone = mayOverlap && islands[i].firstJoint == islands[i].endJoint &&
                            IsDeep(solver->PositionConstraints(), islands[i]);
        if (islands[i].isDone)
            Add(solver->PositionConstraints(), islands[i], positions);
    }
    const bool isOrdered = mayOverlap && m_order.Find(islands[count - 1].endBody, all);
    const bool isNumber = isOrdered && SolveAll(solver, positions);
    for (uint32_t i = 0; i < count; ++i)
        if (islands[i].isDone)
            islands[i].isDone = isOrdered && Settle(all, isNumber, positions, &islands[i]);
}

} // namespace bmr
