// SPDX-License-Identifier: MIT
// The operations of a lane are those of ContactSolver::Solve and SolvePosition, in their order and with their
// signs.
#include "solver/ordered_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>

#include <box2d/b2_joint.h>
#include <box2d/box2d.h>

#include "base/private_members.h"
#include "exact32/float4.h"

namespace bmr {

/// Turns the signs of all lanes, of zeros, too.
FLOAT4_INLINE float4 Negative(float4 v) {
    return flip_low4(exchange4(flip_low4(exchange4(v))));
}

/// A vector of each of four contacts. Each operation is that of b2Vec2, in its order.
struct Vec4 {
    float4 x, y;
};
FLOAT4_INLINE Vec4 Plus(const Vec4 &a, const Vec4 &b) {
    return {add4(a.x, b.x), add4(a.y, b.y)};
}
FLOAT4_INLINE Vec4 Minus(const Vec4 &a, const Vec4 &b) {
    return {sub4(a.x, b.x), sub4(a.y, b.y)};
}
FLOAT4_INLINE Vec4 Times(float4 s, const Vec4 &a) {
    return {mul4(s, a.x), mul4(s, a.y)};
}
FLOAT4_INLINE float4 Dot(const Vec4 &a, const Vec4 &b) {
    return add4(mul4(a.x, b.x), mul4(a.y, b.y));
}
FLOAT4_INLINE float4 Cross(const Vec4 &a, const Vec4 &b) {
    return sub4(mul4(a.x, b.y), mul4(a.y, b.x));
}
FLOAT4_INLINE Vec4 Select(mask4 m, const Vec4 &inside, const Vec4 &outside) {
    return {select4(m, inside.x, outside.x), select4(m, inside.y, outside.y)};
}

/// Four floats of each of four contacts: one float of all of them in a register.
struct Rows {
    float4 a, b, c, d;
};
FLOAT4_INLINE Rows Transposed(float4 p, float4 q, float4 r, float4 s) {
    const float4 pq = zip_low4(p, q), rs = zip_low4(r, s), alsoPq = zip_high4(p, q), alsoRs = zip_high4(r, s);
    return {lows4(pq, rs), highs4(pq, rs), lows4(alsoPq, alsoRs), highs4(alsoPq, alsoRs)};
}
/// The same two floats of each of four contacts.
FLOAT4_INLINE Vec4 ReadPairs(const float *a, const float *b, const float *c, const float *d) {
    const float4 low = load_pairs4(a, b), high = load_pairs4(c, d);
    return {evens4(low, high), odds4(low, high)};
}

/// Where four bodies are, or how fast: a vector and an angle, as b2Position and b2Velocity have them.
struct Motion4 {
    Vec4 v;
    float4 w;

    mask4 IsNan() const { return either4(unordered4(v.x, v.y), unordered4(w, w)); }
};
FLOAT4_INLINE Motion4 ReadMotions(const float *a, const float *b, const float *c, const float *d) {
    return {ReadPairs(a, b, c, d), of4(a[2], b[2], c[2], d[2])};
}
/// Of the first `count` bodies alone.
FLOAT4_INLINE void WriteMotions(const Motion4 &motions, float *const *bodies, uint32_t count) {
    const float4 low = zip_low4(motions.v.x, motions.v.y), high = zip_high4(motions.v.x, motions.v.y);
    float w[4];
    store4(w, motions.w);
    for (uint32_t i = 0; i < 4 && i < count; ++i) {
        if (i % 2 == 0)
            store_low4(bodies[i], i < 2 ? low : high);
        else
            store_high4(bodies[i], i < 2 ? low : high);
        bodies[i][2] = w[i];
    }
}

namespace {

/// Bytes that a joint of two bodies has of its own.
template <typename Joint> constexpr std::size_t kOf = sizeof(Joint) - sizeof(b2Joint);
/// By b2JointType.
constexpr std::size_t kSizes[] = {0,
                                  kOf<b2RevoluteJoint>,
                                  kOf<b2PrismaticJoint>,
                                  kOf<b2DistanceJoint>,
                                  kOf<b2PulleyJoint>,
                                  kOf<b2MouseJoint>,
                                  0,
                                  kOf<b2WheelJoint>,
                                  kOf<b2WeldJoint>,
                                  kOf<b2FrictionJoint>,
                                  0,
                                  kOf<b2MotorJoint>};
static_assert(std::size(kSizes) == e_motorJoint + 1);
static_assert(*std::max_element(std::begin(kSizes), std::end(kSizes)) <= JointSolver::kMostBytes);

} // namespace

bool JointSolver::HaveTwoBodies(const Island &island) const {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        if (kSizes[m_joints[i]->GetType()] == 0)
            return false;
    return true;
}

void JointSolver::InitializeVelocities(const Island &island) {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i) {
        std::memcpy(&m_before[kMostBytes * i], static_cast<const void *>(m_joints[i] + 1),
                    kSizes[m_joints[i]->GetType()]);
        (m_joints[i]->*Named(InitVelocityConstraints()))(m_data);
    }
}

bool JointSolver::SolvePositions(const Island &island) const {
    bool solved = true;
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i) {
        const bool isSolved = (m_joints[i]->*Named(SolvePositionConstraints()))(m_data);
        solved = solved && isSolved;
    }
    return solved;
}

void JointSolver::PutBack(const Island &island) const {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        std::memcpy(static_cast<void *>(m_joints[i] + 1), &m_before[kMostBytes * i],
                    kSizes[m_joints[i]->GetType()]);
}

bool CarriesNoOrder(float invMass, float invI, const float *at) {
    const auto isNegativeZero = [](float x) { return x == 0.0f && std::signbit(x); };
    return invMass == 0.0f && invI == 0.0f && !isNegativeZero(at[0]) && !isNegativeZero(at[1]) &&
           !isNegativeZero(at[2]);
}

void OrderedContacts::Reserve(uint32_t bodies, uint32_t contacts) {
    const uint32_t all = kOverlapping * contacts;
    m_places.Reserve(contacts);
    m_groups.Reserve(all);
    m_levels.Reserve(all + 1);
    m_last.Reserve(bodies + 2);
}

bool OrderedContacts::Find(uint32_t bodies, uint32_t iterations) {
    const bool isKnown = m_isKnown && m_count == m_ordered && iterations == m_iterations;
    m_ordered = m_count;
    m_bodies = bodies;
    m_iterations = iterations;
    if (!isKnown)
        m_pays = m_count >= kLeast && FindAnew();
    return m_count >= kLeast && m_pays;
}

/// False where two iterations have hardly fewer groups than contacts: chains of few contacts each.
bool OrderedContacts::FindAnew() {
    const uint32_t rounds = (m_iterations + kOverlapping - 1) / kOverlapping, most = m_iterations / rounds;
    m_groupCount = m_levelCount = 0;
    for (uint32_t i = 0; i <= m_bodies; ++i)
        m_last[i] = 0;
    for (m_overlapping = 0; m_overlapping < most;) {
        FindLevels(m_overlapping);
        ++m_overlapping;
        const uint32_t all = m_overlapping * m_count;
        if (kEnoughInFour * m_groupCount <= 4 * all && m_iterations % m_overlapping == 0)
            return true;
        if (m_overlapping == 2 && 5 * m_groupCount > 4 * all)
            return false;
    }
    return true;
}

/// Of one more iteration. (Without branches that are hard to foretell: they would take most of the time.)
void OrderedContacts::FindLevels(uint32_t iteration) {
    const uint32_t none = m_bodies; // for a body that carries no order: m_last[none] stays 0
    for (uint32_t i = 0; i < m_count; ++i) {
        const Place &place = m_places[i];
        const uint32_t a = place.a < none ? place.a : none, b = place.b < none ? place.b : none,
                       afterA = m_last[a], afterB = m_last[b], level = afterA > afterB ? afterA : afterB;
        if (level == m_levelCount)
            m_levels[m_levelCount++] = {{kNone, kNone, kNone}};
        m_last[a + (a == none ? 1 : 0)] = level + 1;
        m_last[b + (b == none ? 1 : 0)] = level + 1;
        uint32_t &newest = m_levels[level].ofKinds[place.kind];
        const uint32_t before = newest;
        const bool isFull = before % 4 == 3; // and so is kNone
        newest = isFull ? 4 * m_groupCount : before + 1;
        m_groupCount += isFull ? 1 : 0;
        Group &group = m_groups[newest / 4];
        group.contacts[newest % 4] = place.contact;
        group.iterations[newest % 4] = static_cast<uint8_t>(iteration);
        group.next = isFull ? before : group.next;
    }
}

namespace {

constexpr uint32_t kJoint = 2; ///< the kind; that of a contact is the number of its points, less one

struct Point4 {
    Vec4 rA, rB;
    float4 normalImpulse, tangentImpulse, normalMass, tangentMass, bias;
};

/// Four contacts of as many points, of which no two share a body that moves; fewer, and the first one again.
template <typename Constraint> struct FourConstraints {
    Constraint *constraints[4];
    float4 invMassA, invMassB, invIA, invIB;

    FourConstraints(Constraint *all, const OrderedContacts::Group &group, uint32_t count) {
        for (uint32_t lane = 0; lane < 4; ++lane)
            constraints[lane] = &all[group.contacts[lane < count ? lane : 0]];
        const Rows rows = Read(&constraints[0]->bodies.invMassA);
        invMassA = rows.a;
        invMassB = rows.b;
        invIA = rows.c;
        invIB = rows.d;
    }
    /// `row`: of the first constraint; and the same of the others.
    Rows Read(const float *row) const {
        const std::ptrdiff_t at = row - &constraints[0]->bodies.invMassA;
        const auto of = [&](int lane) { return load4(&constraints[lane]->bodies.invMassA + at); };
        return Transposed(of(0), of(1), of(2), of(3));
    }
};

struct FourVelocities : FourConstraints<VelocityConstraint> {
    b2Velocity *velocities;
    Vec4 normal;
    float4 friction, tangentSpeed;
    Motion4 a, b;

    FourVelocities(VelocityConstraint *all, const OrderedContacts::Group &group, uint32_t count,
                   b2Velocity *ofBodies)
        : FourConstraints(all, group, count), velocities(ofBodies) {
        const Rows first = Read(&constraints[0]->normal.x);
        normal = {first.a, first.b};
        friction = first.c;
        tangentSpeed = first.d;
        a = ReadVelocities(&ContactBodies::indexA);
        b = ReadVelocities(&ContactBodies::indexB);
    }
    Point4 ReadPoint(int32 i) const {
        const Rows arms = Read(&constraints[0]->points[i].rA.x),
                   rest = Read(&constraints[0]->points[i].normalImpulse);
        const float4 bias =
            of4(constraints[0]->points[i].velocityBias, constraints[1]->points[i].velocityBias,
                constraints[2]->points[i].velocityBias, constraints[3]->points[i].velocityBias);
        return {{arms.a, arms.b}, {arms.c, arms.d}, rest.a, rest.b, rest.c, rest.d, bias};
    }
    Motion4 ReadVelocities(int32 ContactBodies::*index) const {
        const auto of = [&](int i) { return &velocities[constraints[i]->bodies.*index].v.x; };
        return ReadMotions(of(0), of(1), of(2), of(3));
    }
    void Write(const Motion4 &motions, int32 ContactBodies::*index, uint32_t count) const {
        float *of[4];
        for (int i = 0; i < 4; ++i)
            of[i] = &velocities[constraints[i]->bodies.*index].v.x;
        WriteMotions(motions, of, count);
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
        const Motion4 wasA = a, wasB = b;
        Apply(Plus(p, q), add4(Cross(first->rA, p), Cross(second->rA, q)),
              add4(Cross(first->rB, p), Cross(second->rB, q)));
        first->normalImpulse = toX;
        second->normalImpulse = toY;
        if (every4(solved))
            return;
        first->normalImpulse = select4(solved, toX, beforeFirst); // no solution: nothing changes
        second->normalImpulse = select4(solved, toY, beforeSecond);
        a = {Select(solved, a.v, wasA.v), select4(solved, a.w, wasA.w)};
        b = {Select(solved, b.v, wasB.v), select4(solved, b.w, wasB.w)};
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
        return either4(a.IsNan(), b.IsNan());
    }
};

} // namespace

bool OrderedVelocities::Order(const VelocityConstraint *constraints, const JointSolver &joints,
                              const Island &island, const b2Velocity *velocities, int32 iterations) {
    if (island.endContact - island.firstContact < OrderedContacts::kLeast || iterations <= 0 ||
        !joints.HaveTwoBodies(island))
        return false;
    const auto carries = [velocities](int32 body, float invMass, float invI) {
        return CarriesNoOrder(invMass, invI, &velocities[body].v.x) ? OrderedContacts::kNone
                                                                    : static_cast<uint32_t>(body);
    };
    const auto isTurned = [&carries](const b2Body *body) {
        return carries(body->*Named(IslandIndex()), body->*Named(InverseMass()),
                       body->*Named(InverseInertia()));
    };
    m_order.Begin();
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        m_order.Add(
            {i, kJoint, isTurned(joints.Joint(i)->GetBodyA()), isTurned(joints.Joint(i)->GetBodyB())});
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const VelocityConstraint &c = constraints[i];
        const ContactBodies &of = c.bodies;
        // A contact of no points has no place here. Of two, Box2D may assert.
        if (c.pointCount == 0 || (c.pointCount == 2 && !(c.points[0].normalImpulse >= 0.0f &&
                                                         c.points[1].normalImpulse >= 0.0f))) {
            m_order.Forget();
            return false;
        }
        m_order.Add({i, static_cast<uint32_t>(c.pointCount - 1), carries(of.indexA, of.invMassA, of.invIA),
                     carries(of.indexB, of.invMassB, of.invIB)});
    }
    return m_order.Find(island.endBody, static_cast<uint32_t>(iterations));
}

bool OrderedVelocities::Solve(ContactSolver *solver, const JointSolver &joints, const Island &island,
                              b2Velocity *velocities) const {
    VelocityConstraint *const all = solver->VelocityConstraints();
    mask4 nans = less4(zero4(), zero4());
    const uint32_t left =
        m_order.ForEach([&](const OrderedContacts::Group &group, uint32_t count, uint32_t kind, uint32_t) {
            if (kind == kJoint) {
                for (uint32_t i = 0; i < count; ++i)
                    joints.SolveVelocity(group.contacts[i]);
                return;
            }
            if (count == 1 || !BMR_FLOAT4_NATIVE) {
                for (uint32_t i = 0; i < count; ++i)
                    solver->SolveVelocity(group.contacts[i]);
                return;
            }
            FourVelocities four(all, group, count, velocities);
            nans = either4(nans, four.Solve(count, kind == 1));
        });
    for (uint32_t i = 0; i < left; ++i) {
        joints.SolveVelocities(island);
        solver->SolveVelocities(island);
    }
    return !any4(nans) && !HasNan(&velocities->v.x, island);
}

namespace {

/// Sines and cosines of four bodies.
Vec4 Turned(const Vec4 &q, const Vec4 &v) {
    return {sub4(mul4(q.y, v.x), mul4(q.x, v.y)), add4(mul4(q.x, v.x), mul4(q.y, v.y))};
}

/// Of contacts of a face.
struct FourPositions : FourConstraints<const PositionConstraint> {
    b2Position *positions;
    Rotations *rotations;
    float *a[4], *b[4];           ///< positions of the bodies
    int32 faces[4], incidents[4]; ///< the bodies again: whose face it is, and the other
    mask4 isFaceB, isNan, isDeep;
    Vec4 localNormal, localPoint, faceCenter, incidentCenter;
    float4 radiusA, radiusB, side;

    FourPositions(const PositionConstraint *all, const OrderedContacts::Group &group, uint32_t count,
                  b2Position *ofBodies, Rotations *ofAngles)
        : FourConstraints(all, group, count), positions(ofBodies), rotations(ofAngles),
          isNan(less4(zero4(), zero4())), isDeep(isNan) {
        const Rows face = Read(&constraints[0]->localNormal.x),
                   centers = Read(&constraints[0]->localCenterA.x), rest = Read(&constraints[0]->radiusA);
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
