// SPDX-License-Identifier: MIT
#include "contacts/contact_life.h"

#include <cmath>
#include <utility>

#include "contacts/convex_contact.h"
#include "contacts/polygon_contact.h"
#include "proofs/polygon_view.h"
#include "start/settings.h"
#include "tell/event.h"

namespace bmr {

namespace {

constexpr int8_t kCoarse = BMR_LEVEL_DISKS, kPolygons = 0;

constexpr Turn Quiet(Life life) {
    return {life, BMR_EVENT_KIND_COUNT, 0, 0};
}

/// A row for each life, a column for each finding: Nothing, ByDisks, Remembered, Another.
constexpr Turn kTurns[4][4] = {
    {{Life::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     {Life::Coarse, BMR_EVENT_START, kCoarse, kCoarse},
     {Life::Apart, BMR_EVENT_START, kCoarse, kPolygons},
     {Life::Apart, BMR_EVENT_START, kCoarse, kPolygons}},
    {{Life::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     Quiet(Life::Coarse),
     {Life::Apart, BMR_EVENT_STAB, kCoarse, kPolygons},
     {Life::Apart, BMR_EVENT_STAB, kCoarse, kPolygons}},
    {{Life::Contact, BMR_EVENT_CONTACT, kPolygons, kPolygons},
     {Life::Coarse, BMR_EVENT_COARSEN, kPolygons, kCoarse},
     Quiet(Life::Apart),
     {Life::Apart, BMR_EVENT_PUSH, kPolygons, kPolygons}},
    {Quiet(Life::Contact),
     {Life::Coarse, BMR_EVENT_LEAVE, kPolygons, kCoarse},
     {Life::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons},
     {Life::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons}},
};

bmr_pose PoseOf(const b2Transform &xf) {
    return {{static_cast<double>(xf.p.x), static_cast<double>(xf.p.y)},
            static_cast<double>(xf.q.c),
            static_cast<double>(xf.q.s)};
}

bmr_vec2 VectorOf(const bmr_vec32 &v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

bmr_vec2 Vertex(const bmr_convex32 &polygon, uint32_t at) {
    return VectorOf(polygon.vertices[at]);
}

/// Every vertex is tried: only who listens pays for it.
uint32_t FarthestOf(const bmr_convex32 &polygon, bmr_vec2 d) {
    uint32_t best = 0;
    for (uint32_t i = 1; i < polygon.count; ++i)
        if (bmr_dot(d, Vertex(polygon, i)) > bmr_dot(d, Vertex(polygon, best)))
            best = i;
    return best;
}

/// No coordinate of a vertex is larger.
double LargestCoordinate(const bmr_convex32 &polygon) {
    double most = 0.0;
    for (uint32_t i = 0; i < polygon.count; ++i) {
        const bmr_vec2 v = Vertex(polygon, i);
        const double larger = std::fmax(std::fabs(v.x), std::fabs(v.y));
        if (larger > most) // not fmax: of that gcc 12 dies where it compiles for ARM64
            most = larger;
    }
    return most;
}

bmr_vec2 UnitOf(bmr_vec2 d) {
    return bmr_scale(1.0 / std::sqrt(bmr_dot(d, d)), d);
}

/// Out of the polygon, across the side that begins at this vertex.
bmr_vec2 NormalOfSide(const bmr_convex32 &polygon, uint32_t at) {
    const uint32_t next = at + 1 < polygon.count ? at + 1 : 0;
    return UnitOf(bmr_neg(bmr_left(bmr_sub(Vertex(polygon, next), Vertex(polygon, at)))));
}

/// The line across `normal`, a unit vector in the owner's frame, that all of the owner lies behind, and the
/// other's vertex that is the nearest to it.
void FillLine(bmr_pair *pair, const bmr_convex32 &own, const bmr_convex32 &other, int owner, bmr_vec2 normal,
              const bmr_pose &other_in_owner) {
    constexpr uint32_t kLeast = 3; // a polygon that was never Set has fewer
    if (own.count < kLeast || other.count < kLeast)
        return;
    pair->owner = owner != 0 ? 1 : 0;
    pair->edge = FarthestOf(own, normal);
    const uint32_t at = FarthestOf(other, bmr_neg(bmr_unrotate(&other_in_owner, normal)));
    pair->other = pair->other_after = at;
    const bmr_vec2 window = Vertex(other, at);
    bmr_certificate_fill(&pair->certificate, normal, bmr_dot(normal, Vertex(own, pair->edge)), &window, 1,
                         NormalOfSide(other, at > 0 ? at - 1 : other.count - 1), NormalOfSide(other, at),
                         LargestCoordinate(own), LargestCoordinate(other));
}

/// Two disks around the origins of the bodies.
void FillDisks(bmr_pair *pair, const bmr_convex32 &a, const bmr_convex32 &b) {
    const auto radii = static_cast<float>(Extent(a) + Extent(b));
    pair->level = BMR_LEVEL_DISKS;
    pair->certificate.offset = std::nextafterf(radii, b2_maxFloat);
}

double GapOfDisks(const bmr_certificate &disks, const bmr_pose &b_in_a) {
    constexpr double kRounding = 0x1p-49; // of the few operations here
    const auto center = [](const float(&at)[2]) {
        return bmr_vec2{static_cast<double>(at[0]), static_cast<double>(at[1])};
    };
    const bmr_vec2 between = bmr_sub(bmr_transform(&b_in_a, center(disks.window[0])), center(disks.normal));
    const double gap =
        std::hypot(between.x, between.y) * (1.0 - kRounding) - static_cast<double>(disks.offset);
    return std::fmax(gap, 0.0);
}

/// As a kinetic pair would have it: what was found of a contact.
bmr_pair PairOf(const SolidContact &contact, Held held, const b2Transform &xfA, const b2Transform &xfB,
                const bmr_vec2 *along) {
    bmr_pair pair;
    bmr_pair_init(&pair);
    pair.structure = BMR_FREE_DIRECTION;
    pair.state = held == Held::Nothing ? BMR_PAIR_CONTACT : BMR_PAIR_APART;
    if (held == Held::Nothing)
        return pair;
    const bmr_convex32 polygons[2] = {RealPolygon(*contact.GetFixtureA()),
                                      RealPolygon(*contact.GetFixtureB())};
    if (held == Held::ByDisks) {
        FillDisks(&pair, polygons[0], polygons[1]);
        return pair;
    }
    const bmr_pose poses[2] = {PoseOf(xfA), PoseOf(xfB)};
    if (along == nullptr && PolygonContact::AsOurs(&contact) != nullptr) {
        const EdgeMemory &memory = contact.state.edge;
        const int owner = memory.ofB ? 1 : 0;
        FillLine(&pair, polygons[owner], polygons[1 - owner], owner,
                 UnitOf(VectorOf(polygons[owner].normals[memory.number])),
                 bmr_pose_relative(&poses[owner], &poses[1 - owner]));
    } else {
        const bmr_vec2 d =
            along != nullptr ? *along : static_cast<const ConvexContact &>(contact).ProvedDirection(xfA, xfB);
        FillLine(&pair, polygons[0], polygons[1], 0, UnitOf(bmr_unrotate(&poses[0], d)),
                 bmr_pose_relative(&poses[0], &poses[1]));
    }
    return pair;
}

bmr_pose Relative(const b2Transform &xfA, const b2Transform &xfB) {
    const bmr_pose a = PoseOf(xfA), b = PoseOf(xfB);
    return bmr_pose_relative(&a, &b);
}

/// The gap that the pair's certificate proves; 0: none.
double GapOf(const bmr_pair &pair, const bmr_pose &b_in_a) {
    double gap = 0.0;
    if (!bmr_pair_check(&pair, &b_in_a, 0.0, &gap))
        return 0.0;
    // Of disks the look says no more than that they are apart.
    return pair.level == BMR_LEVEL_DISKS ? GapOfDisks(pair.certificate, b_in_a) : gap;
}

/// With the pose, and what is certified there.
void TellOf(Turn turn, const bmr_pair &pair, const b2Body *bodyA, const b2Body *bodyB, const b2Transform &xfA,
            const b2Transform &xfB) {
    const bmr_pose relative = Relative(xfA, xfB);
    TellOfEvent(bodyA, bodyB,
                {turn.event, turn.levelBefore, turn.levelAfter, &pair, &relative, GapOf(pair, relative)});
}

} // namespace

Turn TurnOf(Life life, Held held) {
    return kTurns[static_cast<int>(life)][static_cast<int>(held)];
}

void SolidContact::Live(Held held, const b2Transform &xfA, const b2Transform &xfB, const bmr_vec2 *along) {
    const Turn turn = TurnOf(state.life, held);
    state.life = turn.next;
    if (turn.event == BMR_EVENT_KIND_COUNT)
        return;
    const b2Body *bodyA = m_fixtureA->GetBody(), *bodyB = m_fixtureB->GetBody();
    if (GetSettings().options.onEvent == nullptr) {
        TellOfEvent(bodyA, bodyB, {turn.event, turn.levelBefore, turn.levelAfter, nullptr, nullptr, 0.0});
        return;
    }
    TellOf(turn, PairOf(*this, held, xfA, xfB, along), bodyA, bodyB, xfA, xfB);
}

void SolidContact::LeaveAlong(bmr_vec2 d) {
    if (state.life == Life::Contact)
        Live(Held::Another, m_fixtureA->GetBody()->GetTransform(), m_fixtureB->GetBody()->GetTransform(), &d);
}

void SolidContact::LiveAsSensor(bmr_vec2 before) {
    const b2Transform &xfA = m_fixtureA->GetBody()->GetTransform(),
                      &xfB = m_fixtureB->GetBody()->GetTransform();
    if (IsTouching()) {
        Live(Held::Nothing, xfA, xfB);
        return;
    }
    const bmr_vec2 now = GuessDirection();
    const Held held = now.x == before.x && now.y == before.y ? Held::Remembered : Held::Another;
    // Where Box2D found the two apart, the direction is another time's, or none.
    if ((now.x != 0.0 || now.y != 0.0) &&
        GapOf(PairOf(*this, held, xfA, xfB, &now), Relative(xfA, xfB)) > 0.0)
        Live(held, xfA, xfB, &now);
}

} // namespace bmr
