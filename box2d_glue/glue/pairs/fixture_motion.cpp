// SPDX-License-Identifier: MIT
#include "glue/pairs/fixture_motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <box2d/b2_polygon_shape.h>

#include "base/private_members.h"
#include "shapes/convex_geometry.h"
#include "shapes/digest.h"
#include "shapes/side_normals.h"
#include "start/settings.h"

namespace bmr {

namespace {

bmr_pose PoseOf(const b2Body &body) {
    const b2Transform &xf = body.GetTransform();
    return {{static_cast<double>(xf.p.x), static_cast<double>(xf.p.y)},
            static_cast<double>(xf.q.c),
            static_cast<double>(xf.q.s)};
}

bmr_vec2 Double(const b2Vec2 &v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

uint64_t KeyOf(const b2Fixture *fixture) {
    return static_cast<uint64_t>(reinterpret_cast<uintptr_t>(fixture));
}

/// Of a small polygon.
struct Sides {
    double reach = 0.0; ///< from the pivot
    float shortest;
};
Sides MeasureSides(const b2PolygonShape &polygon, bmr_vec2 pivot) {
    Sides sides;
    sides.shortest = b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 &v = polygon.m_vertices[i], &w = polygon.m_vertices[i + 1 < polygon.m_count ? i + 1 : 0];
        const bmr_vec2 arm = bmr_sub(Double(v), pivot);
        sides.reach = std::max(sides.reach, std::sqrt(bmr_dot(arm, arm)));
        sides.shortest = std::min(sides.shortest, (w - v).Length());
    }
    return sides;
}

const b2PolygonShape *PolygonOf(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon ? static_cast<const b2PolygonShape *>(fixture.GetShape())
                                                   : nullptr;
}

// Two rows may have gone on by so much, one look and one mark more, and what comes with the next pass, before
// the difference to a deadline wraps.
constexpr uint32_t kMostLate = 1u << 29;

/// Where it has one and no more.
int32 ProxyOf(const b2Fixture *fixture) {
    return FixtureAccess::ProxyCount(fixture) == 1 ? FixtureAccess::ProxyOf(fixture, 0)
                                                   : int32{b2BroadPhase::e_nullProxy};
}

/// kActive, kStops and kIsSensor as they are now.
uint8_t FlagsOf(const Mover &mover) {
    const b2Body &body = *mover.body;
    uint8_t bits = 0;
    if (body.IsAwake() && body.GetType() != b2_staticBody)
        bits |= kActive;
    if (body.IsBullet() || body.GetType() != b2_dynamicBody)
        bits |= kStops;
    if (mover.fixture->IsSensor())
        bits |= kIsSensor;
    return bits;
}

/// What a game may change of it in a locked world, and more: its body's flags, and whether it is a sensor.
uint32_t ChangeableOf(const Mover &mover) {
    return BodyInIsland::OtherFlags(mover.body) | (mover.fixture->IsSensor() ? 1u : 0u);
}

/// Does a static body have a velocity, from its definition? It then moves on in each island that it is in, so
/// that its sweep does not begin where it was looked at.
bool MovesThoughStatic(const b2Body &body) {
    const b2Vec2 &v = body.GetLinearVelocity();
    return body.GetType() == b2_staticBody &&
           !(v.x == 0.0f && v.y == 0.0f && body.GetAngularVelocity() == 0.0f);
}

bool SamePlace(const b2Transform &a, const b2Transform &b) {
    return a.p.x == b.p.x && a.p.y == b.p.y && a.q.s == b.q.s && a.q.c == b.q.c;
}

constexpr uint32_t kBodiesAhead = 8;

constexpr double kReachRoundedUp = 1.0 + 0x1p-40;

} // namespace

/// The part that depends only on the shape. False if pairs of it have no budget.
static bool Measure(Mover *mover, const b2PolygonShape &polygon) {
    mover->radius = polygon.m_radius;
    mover->shortest = 0.0f;
    const bmr_vec2 pivot = mover->motion.pivot;
    if (const bmr_convex32_block *big = AnyBigPolygon() ? BigPolygonOf(polygon) : nullptr) {
        mover->motion.reach =
            (static_cast<double>(big->reach) + std::sqrt(bmr_dot(pivot, pivot))) * kReachRoundedUp;
        return polygon.m_radius >= 0.0f;
    }
    mover->motion.reach = 0.0;
    if (polygon.m_count < 3 || polygon.m_count > b2_maxPolygonVertices || !VerticesTellAll(polygon) ||
        !TurnsOnce(polygon) || !(polygon.m_radius >= 0.0f))
        return false;
    const Sides sides = MeasureSides(polygon, pivot);
    mover->motion.reach = sides.reach * kReachRoundedUp;
    mover->shortest = sides.shortest;
    return true;
}

uint32_t Movers::Acquire(const b2Fixture *fixture, const b2BroadPhase &broadPhase, uint64_t look) {
    const auto keyOf = [this](uint32_t row) { return KeyOf(m_rows[row].fixture); };
    uint32_t row = m_byFixture.Find(KeyOf(fixture), keyOf);
    if (row != kNone) {
        ++m_rows[row].records;
        return row;
    }
    m_byFixture.MakeRoom(keyOf);
    row = m_free;
    if (row == kNone) {
        row = m_count;
        m_rows.Reserve(row + 1);
        m_moved.Reserve(row + 1);
        m_ends.Reserve(row + 1);
        m_lookedAt.Reserve(row + 1);
        m_bits.Reserve(row + 1);
        m_sweepBits.Reserve(row + 1);
        m_changeable.Reserve(row + 1);
        ++m_count;
    } else {
        m_free = m_rows[row].watched;
    }
    Mover &mover = m_rows[row];
    mover = {};
    mover.fixture = fixture;
    m_byFixture.Add(row, keyOf);
    mover.body = fixture->GetBody();
    mover.records = 1;
    mover.proxy = ProxyOf(fixture);
    m_ends[row] = 0;
    m_sweepBits[row] = kStops; // as far as is known
    m_changeable[row] = 0;
    m_moved[row] = 0;
    m_bits[row] = kStops; // no news: its pairs are new
    Look(row, broadPhase, look, false);
    return row;
}

void Movers::Release(uint32_t row) {
    if (--m_rows[row].records > 0)
        return;
    m_byFixture.Remove(row, [this](uint32_t other) { return KeyOf(m_rows[other].fixture); });
    m_bits[row] = 0;
    m_rows[row].watched = m_free; // the next free row
    m_free = row;
}

void Movers::Clear() {
    m_rows.Clear();
    m_moved.Clear();
    m_ends.Clear();
    m_lookedAt.Clear();
    m_bits.Clear();
    m_sweepBits.Clear();
    m_changeable.Clear();
    m_byFixture.Clear();
    m_count = 0;
    m_free = kNone;
}

void Movers::Mark(uint32_t row) {
    bmr_mover_mark(&m_rows[row].motion);
}

/// Is the shape another one than at the last look? Measures it anew then. About 10 ns where it is the same.
bool Movers::LookAtShape(Mover *mover, uint8_t *bits) const {
    const b2PolygonShape *polygon = PolygonOf(*mover->fixture);
    if (polygon == nullptr) {
        *bits |= kPlain;
        return false;
    }
    const uint64_t digest = DigestOf(*polygon);
    const bool changed = digest != mover->shape;
    if (changed) {
        mover->shape = digest;
        mover->sound = Measure(mover, *polygon);
    }
    if (!mover->sound)
        *bits |= kPlain;
    return changed;
}

/// Finds the row's band. True where it is another one than before: in a farther one its pairs' margins are
/// too small; in a nearer one they become smaller, and what was proved of impacts went by the larger. A
/// nearer one it is only when well within that, or a body that trembles about the border would be looked at
/// anew each time.
bool Movers::ChangesBand(Mover *mover, uint8_t *bits) {
    constexpr double kReach0 = static_cast<double>(kBandReach), kWellWithin = 0.75;
    const b2Vec2 place = b2Abs(mover->place.p);
    const double reach =
        static_cast<double>(kBandReachOfExtent) *
        (mover->motion.reach + std::fabs(mover->motion.pivot.x) + std::fabs(mover->motion.pivot.y));
    const double farthest = static_cast<double>(b2Max(place.x, place.y)) + reach;
    if (farthest <= kReach0 && mover->band == 0) // nearly all
        return false;
    const uint8_t before = mover->band;
    // (A number that is none is far.)
    if (!(reach <= kReach0 && farthest <= std::ldexp(kReach0, kBands - 1))) {
        *bits |= kPlain;
        mover->band = kBands;
        return mover->band != before;
    }
    mover->band = std::min<uint8_t>(mover->band, kBands - 1);
    while (mover->band > 0 && farthest <= kWellWithin * std::ldexp(kReach0, mover->band - 1))
        --mover->band;
    while (farthest > std::ldexp(kReach0, mover->band))
        ++mover->band;
    return mover->band != before;
}

void Movers::Begin(uint32_t row, const b2BroadPhase &broadPhase, uint64_t look) {
    Mover &mover = m_rows[row];
    const uint32_t moved = mover.motion.moved, turned = mover.motion.turned;
    const bmr_pose pose = PoseOf(*mover.body);
    const double reach = mover.motion.reach;
    // The pivot stays, or is another one at the look that follows; with it goes the reach.
    bmr_mover_start(&mover.motion, &pose, mover.motion.pivot, reach, kUnits);
    mover.place = mover.body->GetTransform();
    mover.motion.moved = moved;
    mover.motion.turned = turned;
    mover.proved = 1; // for this look
    Look(row, broadPhase, look, false);
    mover.proved = 0;
    // No pair uses the row yet: its beginning is no mark.
    mover.motion.moved = m_moved[row] = moved;
    m_bits[row] &= static_cast<uint8_t>(~(kChanged | kChangedLate));
}

void Movers::Look(uint32_t row, const b2BroadPhase &broadPhase, uint64_t look, bool late) {
    Mover &mover = m_rows[row];
    const b2Body &body = *mover.body;
    const uint8_t before = m_bits[row];
    uint8_t bits = FlagsOf(mover) | kLookedAt;
    m_lookedAt[row] = look;
    m_newStops = m_newStops || (bits & ~before & kStops) != 0;
    if (mover.proved == 0) {
        m_bits[row] = bits;
        return;
    }

    const b2Transform &xf = body.GetTransform();
    const bool stays = SamePlace(xf, mover.place);
    const bmr_pose pose = PoseOf(body);
    if (!stays) {
        bmr_mover_look(&mover.motion, &pose, kUnits);
        mover.place = xf;
    }
    bool changed = ((bits ^ before) & kIsSensor) != 0 || (!late && (before & kChangedLate) != 0);
    const bmr_vec2 pivot = Double(body.GetLocalCenter());
    if (pivot.x != mover.motion.pivot.x || pivot.y != mover.motion.pivot.y) {
        // The sums so far are those of the fixture's points, about any pivot.
        mover.motion.pivot = pivot;
        mover.motion.center = bmr_mover_place(&pose, pivot, kUnits);
        mover.shape = 0; // its reach is another one
        changed = true;
    }
    changed = LookAtShape(&mover, &bits) || changed;
    changed = ChangesBand(&mover, &bits) || changed;
    // Its pairs with others that sleep are to be put out of sight.
    const bool fellAsleep = (before & kActive) != 0 && (bits & kActive) == 0;
    bool mark = changed || fellAsleep;
    if (mover.proxy == b2BroadPhase::e_nullProxy) // by now, if its body is in the world again
        mover.proxy = ProxyOf(mover.fixture);
    if (mover.proxy != b2BroadPhase::e_nullProxy) {
        const b2AABB &box = broadPhase.GetFatAABB(mover.proxy);
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, of what is no number, too
        if (std::memcmp(&box, &mover.box, sizeof box) != 0) {
            mover.box = box;
            mark = true;
        }
    }
    if (changed)
        bits |= late ? kChanged | kChangedLate : kChanged;
    else if (late)
        bits |= before & (kChanged | kChangedLate);
    if (mark)
        Mark(row);
    mover.late = late ? mover.late + (mover.motion.moved - m_moved[row]) : 0;
    m_sumsLost = m_sumsLost || mover.late > kMostLate;
    m_bits[row] = bits;
    m_moved[row] = mover.motion.moved;
}

bool Movers::ConfirmAsBefore(uint32_t row, uint64_t look) {
    constexpr uint8_t kFlags = kActive | kStops | kIsSensor;
    const Mover &mover = m_rows[row];
    if (mover.proved == 0 || (m_bits[row] & kLookedAt) == 0 || (FlagsOf(mover) ^ m_bits[row]) & kFlags)
        return false;
    const b2PolygonShape *polygon = PolygonOf(*mover.fixture);
    if (polygon != nullptr && DigestOf(*polygon) != mover.shape)
        return false;
    m_lookedAt[row] = look;
    return true;
}

void Movers::FindSweepBits(uint32_t row, uint64_t look) {
    m_rows[row].sweptAt = look;
    m_sweepBits[row] = FlagsOf(m_rows[row]);
    m_newStops = m_newStops || (m_sweepBits[row] & ~m_bits[row] & kStops) != 0;
}

void Movers::LookAtAllSweeps(uint64_t look) {
    for (uint32_t row = 0; row < m_count; ++row) {
        PrefetchBody(row + kBodiesAhead);
        if (m_rows[row].records == 0)
            continue;
        FindSweepBits(row, look);
        m_changeable[row] = static_cast<uint16_t>(ChangeableOf(m_rows[row]));
    }
}

uint32_t Movers::NextNewSweep(uint32_t row) {
    for (; row < m_count; ++row) {
        if (m_rows[row].records == 0)
            continue;
        const uint32_t now = ChangeableOf(m_rows[row]);
        if (now == m_changeable[row])
            continue;
        m_changeable[row] = static_cast<uint16_t>(now);
        return row;
    }
    return kNone;
}

void Movers::FindEnd(uint32_t row, bool careful, uint64_t look) {
    Mover &mover = m_rows[row];
    const b2Body &body = *mover.body;
    const b2Sweep &sweep = SweepOf(body);
    mover.endedAt = look;
    const double a = static_cast<double>(sweep.a), a0 = static_cast<double>(sweep.a0);
    // The world was locked since the look. So the body turns from where it was then or, if it sleeps, has
    // turned to there.
    const double turn = std::fabs(a - a0);
    const b2Vec2 from = b2Abs(sweep.c0), to = b2Abs(sweep.c);
    const double farthest = static_cast<double>(b2Max(b2Max(from.x, from.y), b2Max(to.x, to.y)));
    const b2PolygonShape *polygon = careful ? PolygonOf(*mover.fixture) : nullptr;
    const double reach = std::ldexp(static_cast<double>(kImpactReach), mover.band);
    const bool known = (polygon == nullptr || DigestOf(*polygon) == mover.shape) &&
                       farthest + mover.motion.reach <= reach &&
                       std::fabs(a) <= static_cast<double>(kImpactAngle) &&
                       std::fabs(a0) <= static_cast<double>(kImpactAngle) && !MovesThoughStatic(body) &&
                       Double(sweep.localCenter).x == mover.motion.pivot.x &&
                       Double(sweep.localCenter).y == mover.motion.pivot.y;
    m_ends[row] = mover.motion.moved +
                  (known ? bmr_mover_sweep(&mover.motion, Double(sweep.c0), Double(sweep.c), turn, kUnits)
                         : BMR_BUDGET_MARK);
}

} // namespace bmr
