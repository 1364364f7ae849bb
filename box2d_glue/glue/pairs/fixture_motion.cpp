// SPDX-License-Identifier: MIT
#include "glue/pairs/fixture_motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <box2d/b2_polygon_shape.h>

#include "base/private_members.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "shapes/small_polygon.h"
#include "start/settings.h"

namespace bmr {

namespace {

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

// Two rows may have gone on by so much, one update and one mark more, and what comes with the next pass,
// before the difference to a deadline wraps.
constexpr uint32_t kMostLate = 1u << 29;

/// Where it has one and no more.
int32 ProxyOf(const b2Fixture *fixture) {
    return FixtureAccess::ProxyCount(fixture) == 1 ? FixtureAccess::ProxyOf(fixture, 0)
                                                   : int32{b2BroadPhase::e_nullProxy};
}

/// kActive, kBulletOrStatic and kIsSensor as they are now.
uint8_t FlagsOf(const FixtureMotion &motion) {
    uint8_t bits = 0;
    if (IsActive(motion.body))
        bits |= kActive;
    if (IsBulletOrStatic(motion.body))
        bits |= kBulletOrStatic;
    if (motion.fixture->IsSensor())
        bits |= kIsSensor;
    return bits;
}

/// What a game may change of it in a locked world, and more: its body's flags, and whether it is a sensor.
uint32_t ChangeableOf(const FixtureMotion &motion) {
    return BodyInIsland::OtherFlags(motion.body) | (motion.fixture->IsSensor() ? 1u : 0u);
}

/// Does a static body have a velocity, from its definition? It then moves on in each island that it is in, so
/// that its sweep does not begin where its fixture was updated.
bool MovesThoughStatic(const b2Body &body) {
    const b2Vec2 &v = body.GetLinearVelocity();
    return body.GetType() == b2_staticBody &&
           !(v.x == 0.0f && v.y == 0.0f && body.GetAngularVelocity() == 0.0f);
}

bool SamePlace(const b2Transform &a, const b2Transform &b) {
    return a.p.x == b.p.x && a.p.y == b.p.y && a.q.s == b.q.s && a.q.c == b.q.c;
}

constexpr double kReachRoundedUp = 1.0 + 0x1p-40;

} // namespace

/// The part that depends only on the shape. False if pairs of it have no budget.
static bool Measure(FixtureMotion *motion, const b2PolygonShape &polygon) {
    motion->radius = polygon.m_radius;
    motion->shortest = 0.0f;
    const bmr_vec2 pivot = motion->mover.pivot;
    if (const bmr_convex32_block *big = AnyBigPolygon() ? BigPolygonOf(polygon) : nullptr) {
        motion->mover.reach =
            (static_cast<double>(big->reach) + std::sqrt(bmr_dot(pivot, pivot))) * kReachRoundedUp;
        return polygon.m_radius >= 0.0f;
    }
    motion->mover.reach = 0.0;
    if (polygon.m_count < 3 || polygon.m_count > b2_maxPolygonVertices || !VerticesTellAll(polygon) ||
        !TurnsOnce(polygon) || !(polygon.m_radius >= 0.0f))
        return false;
    const Sides sides = MeasureSides(polygon, pivot);
    motion->mover.reach = sides.reach * kReachRoundedUp;
    motion->shortest = sides.shortest;
    return true;
}

uint32_t FixtureMotions::Acquire(const b2Fixture *fixture, const b2BroadPhase &broadPhase, uint64_t stamp) {
    const auto keyOf = [this](uint32_t row) { return KeyOf(m_rows[row].fixture); };
    uint32_t row = m_byFixture.Find(KeyOf(fixture), keyOf);
    if (row != kNone) {
        ++m_rows[row].pairs;
        return row;
    }
    m_byFixture.ReserveRow(keyOf);
    row = m_free;
    if (row == kNone) {
        row = m_count;
        m_rows.Reserve(row + 1);
        m_moved.Reserve(row + 1);
        m_ends.Reserve(row + 1);
        m_stamps.Reserve(row + 1);
        m_bits.Reserve(row + 1);
        m_sweepBits.Reserve(row + 1);
        m_changeable.Reserve(row + 1);
        ++m_count;
    } else {
        m_free = m_rows[row].nextFree;
    }
    FixtureMotion &motion = m_rows[row];
    motion = {};
    motion.fixture = fixture;
    m_byFixture.Add(row, keyOf);
    motion.body = fixture->GetBody();
    motion.pairs = 1;
    motion.proxy = ProxyOf(fixture);
    m_sweepBits[row] = kBulletOrStatic; // as far as is known
    m_changeable[row] = 0;
    m_moved[row] = 0;
    m_bits[row] = kBulletOrStatic; // no news: its pairs are new
    Update(row, broadPhase, stamp, false);
    return row;
}

void FixtureMotions::Release(uint32_t row) {
    if (--m_rows[row].pairs > 0)
        return;
    m_byFixture.Remove(row, [this](uint32_t other) { return KeyOf(m_rows[other].fixture); });
    m_bits[row] = 0;
    m_rows[row].nextFree = m_free;
    m_free = row;
}

void FixtureMotions::Clear() {
    m_rows.Clear();
    m_moved.Clear();
    m_ends.Clear();
    m_stamps.Clear();
    m_bits.Clear();
    m_sweepBits.Clear();
    m_changeable.Clear();
    m_byFixture.Clear();
    m_count = 0;
    m_free = kNone;
}

/// Is the shape another one than at the last update? Measures it anew then. About 10 ns where it is the same.
bool FixtureMotions::UpdateShape(FixtureMotion *motion, uint8_t *bits) const {
    const b2PolygonShape *polygon = PolygonOf(*motion->fixture);
    if (polygon == nullptr) {
        *bits |= kNoBudget;
        return false;
    }
    const uint64_t digest = DigestOf(*polygon);
    const bool changed = digest != motion->shape;
    if (changed) {
        motion->shape = digest;
        motion->sound = Measure(motion, *polygon);
    }
    if (!motion->sound)
        *bits |= kNoBudget;
    return changed;
}

/// Finds the row's band. True where it is another one than before: in a farther one its pairs' margins are
/// too small; in a nearer one they become smaller, and what was proved of impacts went by the larger. A
/// nearer one it is only when well within that, or a body that trembles about the border would be measured
/// anew each time.
bool FixtureMotions::ChangesBand(FixtureMotion *motion, uint8_t *bits) {
    constexpr double kReach0 = static_cast<double>(kBandReach), kWellWithin = 0.75;
    const b2Vec2 place = b2Abs(motion->place.p);
    const double reach = static_cast<double>(kBandReachOfExtent) * motion->Extent();
    const double farthest = static_cast<double>(b2Max(place.x, place.y)) + reach;
    if (farthest <= kReach0 && motion->band == 0) // nearly all
        return false;
    const uint8_t before = motion->band;
    // (A number that is none is far.)
    if (!(reach <= kReach0 && farthest <= std::ldexp(kReach0, kBands - 1))) {
        *bits |= kNoBudget;
        motion->band = kBands;
        return motion->band != before;
    }
    motion->band = std::min<uint8_t>(motion->band, kBands - 1);
    while (motion->band > 0 && farthest <= kWellWithin * std::ldexp(kReach0, motion->band - 1))
        --motion->band;
    while (farthest > std::ldexp(kReach0, motion->band))
        ++motion->band;
    return motion->band != before;
}

void FixtureMotions::Begin(uint32_t row, const b2BroadPhase &broadPhase, uint64_t stamp) {
    FixtureMotion &motion = m_rows[row];
    const uint32_t moved = motion.mover.moved, turned = motion.mover.turned;
    const bmr_pose pose = PoseOf(motion.body->GetTransform());
    const double reach = motion.mover.reach;
    // The pivot stays, or is another one at the update that follows; with it goes the reach.
    bmr_mover_start(&motion.mover, &pose, motion.mover.pivot, reach, kUnits);
    motion.place = motion.body->GetTransform();
    motion.mover.moved = moved;
    motion.mover.turned = turned;
    motion.proved = 1; // for this update
    Update(row, broadPhase, stamp, false);
    motion.proved = 0;
    // No pair uses the row yet: its beginning is no mark.
    motion.mover.moved = m_moved[row] = moved;
}

void FixtureMotions::Update(uint32_t row, const b2BroadPhase &broadPhase, uint64_t stamp, bool late) {
    FixtureMotion &motion = m_rows[row];
    const b2Body &body = *motion.body;
    const uint8_t before = m_bits[row];
    uint8_t bits = FlagsOf(motion) | kUpdated;
    m_stamps[row] = stamp;
    m_newBullets = m_newBullets || (bits & ~before & kBulletOrStatic) != 0;
    if (motion.proved == 0) {
        m_bits[row] = bits;
        return;
    }

    const b2Transform &xf = body.GetTransform();
    const bool stays = SamePlace(xf, motion.place);
    const bmr_pose pose = PoseOf(xf);
    if (!stays) {
        bmr_mover_update(&motion.mover, &pose, kUnits);
        motion.place = xf;
    }
    bool changed = ((bits ^ before) & kIsSensor) != 0 || (!late && (before & kChangedLate) != 0);
    const bmr_vec2 pivot = Double(body.GetLocalCenter());
    if (pivot.x != motion.mover.pivot.x || pivot.y != motion.mover.pivot.y) {
        // The sums so far are those of the fixture's points, about any pivot.
        motion.mover.pivot = pivot;
        motion.mover.center = bmr_mover_place(&pose, pivot, kUnits);
        motion.shape = 0; // its reach is another one: UpdateShape measures it, and says so
    }
    changed = UpdateShape(&motion, &bits) || changed;
    changed = ChangesBand(&motion, &bits) || changed;
    // Its pairs with others that sleep are to be put out of sight.
    const bool fellAsleep = (before & kActive) != 0 && (bits & kActive) == 0;
    bool mark = changed || fellAsleep;
    if (motion.proxy == b2BroadPhase::e_nullProxy) // by now, if its body is in the world again
        motion.proxy = ProxyOf(motion.fixture);
    if (motion.proxy != b2BroadPhase::e_nullProxy) {
        const b2AABB &box = broadPhase.GetFatAABB(motion.proxy);
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, of what is no number, too
        if (std::memcmp(&box, &motion.box, sizeof box) != 0) {
            motion.box = box;
            mark = true;
        }
    }
    if (changed)
        bits |= late ? kChanged | kChangedLate : kChanged;
    else if (late)
        bits |= before & (kChanged | kChangedLate);
    if (mark)
        bmr_mover_mark(&motion.mover);
    motion.late = late ? motion.late + (motion.mover.moved - m_moved[row]) : 0;
    m_sumsLost = m_sumsLost || motion.late > kMostLate;
    m_bits[row] = bits;
    m_moved[row] = motion.mover.moved;
}

bool FixtureMotions::ConfirmAsBefore(uint32_t row, uint64_t stamp) {
    constexpr uint8_t kFlags = kActive | kBulletOrStatic | kIsSensor;
    const FixtureMotion &motion = m_rows[row];
    if (motion.proved == 0 || (m_bits[row] & kUpdated) == 0 || (FlagsOf(motion) ^ m_bits[row]) & kFlags)
        return false;
    const b2PolygonShape *polygon = PolygonOf(*motion.fixture);
    if (polygon != nullptr && DigestOf(*polygon) != motion.shape)
        return false;
    m_stamps[row] = stamp;
    return true;
}

void FixtureMotions::FindSweepBits(uint32_t row, uint64_t stamp) {
    m_rows[row].sweptAt = stamp;
    m_sweepBits[row] = FlagsOf(m_rows[row]);
    m_newBullets = m_newBullets || (m_sweepBits[row] & ~m_bits[row] & kBulletOrStatic) != 0;
}

void FixtureMotions::UpdateAllSweeps(uint64_t stamp) {
    constexpr uint32_t kAhead = 8;
    for (uint32_t row = 0; row < m_count; ++row) {
        Prefetch(row + kAhead);
        if (m_rows[row].pairs == 0)
            continue;
        FindSweepBits(row, stamp);
        m_changeable[row] = static_cast<uint16_t>(ChangeableOf(m_rows[row]));
    }
}

uint32_t FixtureMotions::NextChangedSweep(uint32_t row) {
    for (; row < m_count; ++row) {
        if (m_rows[row].pairs == 0)
            continue;
        const uint32_t now = ChangeableOf(m_rows[row]);
        if (now == m_changeable[row])
            continue;
        m_changeable[row] = static_cast<uint16_t>(now);
        return row;
    }
    return kNone;
}

void FixtureMotions::FindEnd(uint32_t row, bool careful, uint64_t stamp) {
    FixtureMotion &motion = m_rows[row];
    const b2Body &body = *motion.body;
    const b2Sweep &sweep = SweepOf(body);
    motion.endedAt = stamp;
    const double a = static_cast<double>(sweep.a), a0 = static_cast<double>(sweep.a0);
    // The world was locked since the update. So the body turns from where it was then or, if it sleeps, has
    // turned to there.
    const double turn = std::fabs(a - a0);
    const b2Vec2 from = b2Abs(sweep.c0), to = b2Abs(sweep.c);
    const double farthest = static_cast<double>(b2Max(b2Max(from.x, from.y), b2Max(to.x, to.y)));
    const b2PolygonShape *polygon = careful ? PolygonOf(*motion.fixture) : nullptr;
    const double reach = std::ldexp(static_cast<double>(kImpactReach), motion.band);
    const bool known = (polygon == nullptr || DigestOf(*polygon) == motion.shape) &&
                       farthest + motion.mover.reach <= reach &&
                       std::fabs(a) <= static_cast<double>(kImpactAngle) &&
                       std::fabs(a0) <= static_cast<double>(kImpactAngle) && !MovesThoughStatic(body) &&
                       Double(sweep.localCenter).x == motion.mover.pivot.x &&
                       Double(sweep.localCenter).y == motion.mover.pivot.y;
    m_ends[row] = motion.mover.moved +
                  (known ? bmr_mover_sweep(&motion.mover, Double(sweep.c0), Double(sweep.c), turn, kUnits)
                         : BMR_BUDGET_MARK);
}

} // namespace bmr
