// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_FIXTURE_MOTION_H
#define BOOMERANG_GLUE_FIXTURE_MOTION_H

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_fixture.h>

#include "base/columns.h"
#include "base/compiler.h"
#include "boomerang/budget.h"
#include "glue/pairs/bodies.h"
#include "glue/proofs/thresholds.h"

namespace bmr {

/// Sweeps of times of impact have budgets within this distance of the origin, in band 0 (kBandReach): in band
/// k within 2^k times as much. And up to kImpactAngle.
constexpr float kImpactReach = 256.0f * b2_lengthUnitsPerMeter, kImpactAngle = 500.0f;

/// Budgets count in these (core/budget): 2^-16 of a metre.
constexpr double kUnits = 65536.0 / static_cast<double>(b2_lengthUnitsPerMeter);

/// A fixture as it was at its last update, and how far it has moved, for all its contacts. One row a fixture
/// that has contacts. As long as no contact of it has a proof that it may end, only its body's flags are
/// read.
///
/// A game does most things without a call that we could see: it moves and wakes bodies and makes them bullets
/// by inline functions, and writes to vertices and radii in place. So a row holds what the last update
/// read, and the next update compares.
struct alignas(64) FixtureMotion {
    // A renewal reads these two cache lines. The second one has what is compared in the middle of a pass.
    bmr_mover mover;
    b2AABB box;     ///< the fat one of its proxy
    float radius;   ///< skin
    float shortest; ///< length of the shortest side; 0 if it is not known
    uint64_t shape; ///< a digest of all that contacts read of the shape; see UpdateShape
    const b2Body *body;
    const b2Fixture *fixture;
    uint32_t pairs;  ///< contacts of it
    uint32_t proved; ///< of these, the ones that have a proof (kHasProof)
    union {
        uint32_t awake;    ///< of `pairs`, the ones of which one body at least is awake
        uint32_t nextFree; ///< of a free row
    };

    // An update compares and writes these, too.
    int32 proxy;       ///< b2BroadPhase::e_nullProxy where it has none or several: then there is no box here
    b2Transform place; ///< of the body, at the last update
    bool sound;        ///< a polygon as Box2D makes them: its vertices tell all
    uint8_t band;      ///< how far out it is at most (glue/proofs/thresholds.h); kBands: beyond all
    uint32_t late;     ///< units that were added in the middle of the present pass
    uint64_t sweptAt;  ///< the table's stamp when its sweep was last compared
    uint64_t endedAt;  ///< the same for how far that may come

    /// No point of it is farther from its body's origin.
    double Extent() const { return mover.reach + std::fabs(mover.pivot.x) + std::fabs(mover.pivot.y); }
};
static_assert(sizeof(void *) < 8 || (offsetof(FixtureMotion, place) == 128 && sizeof(FixtureMotion) == 192),
              "three cache lines");

/// The bits of a row that the loop over pairs reads.
enum MotionBit : uint8_t {
    kActive = 1,         ///< its body is awake, and not static
    kBulletOrStatic = 2, ///< its body is a bullet, or not dynamic: nothing is to tunnel through it
    kIsSensor = 4,       ///< as the fixture says
    kNoBudget = 8,       ///< for its contacts: no polygon, a broken one, or farther out than all bands
    kChanged = 16,       ///< its shape or its band, since the update before: lines of its pairs prove nothing
    kChangedLate = 32,   ///< the same, seen in the middle of a pass: to be said again in the next one
    kUpdated = 64        ///< since the last pass over pairs began
};

/// The rows of one world. Rows are numbered; a number is used again when the last contact of a fixture is
/// gone.
class FixtureMotions {
public:
    /// The row of this fixture, made if there is none. Counts one contact more.
    uint32_t Acquire(const b2Fixture *fixture, const b2BroadPhase &broadPhase, uint64_t stamp);
    /// One contact less; the last one frees the row.
    void Release(uint32_t row);
    void Clear();

    /// Compares the row with what its fixture and body are now: sums, bits, box. Marks it if all its contacts
    /// are to be updated.
    void Update(uint32_t row, const b2BroadPhase &broadPhase, uint64_t stamp, bool late);
    /// The same for a row that was updated in this pass, of a world that was locked ever since: Box2D then
    /// refuses to move bodies, and nothing changes their boxes. What a game still can change is compared, a
    /// third of an update. False if that has changed: then update.
    bool ConfirmAsBefore(uint32_t row, uint64_t stamp);
    /// A contact of the row gets a proof. With the first one the row is read in full, and what it finds is no
    /// motion.
    void AddProof(uint32_t row, const b2BroadPhase &broadPhase, uint64_t stamp) {
        if (m_rows[row].proved == 0)
            Begin(row, broadPhase, stamp);
        ++m_rows[row].proved;
    }
    void DropProof(uint32_t row) { --m_rows[row].proved; }
    /// Sets SweepBits.
    void UpdateSweep(uint32_t row, uint64_t stamp) {
        if (m_rows[row].sweptAt != stamp)
            FindSweepBits(row, stamp);
    }
    void UpdateAllSweeps(uint64_t stamp);
    /// Reads the flags of sweeps anew, from this row on up to one that has others than before; kNone where
    /// there is none.
    uint32_t NextChangedSweep(uint32_t row);
    /// Sets End: how far the row can come in the sweep of its body. The world is the one, and in the step, of
    /// the last update, and was locked ever since. `careful`: code of the game ran, and the shape is
    /// compared.
    void UpdateEnd(uint32_t row, bool careful, uint64_t stamp) {
        if (m_rows[row].endedAt != stamp)
            FindEnd(row, careful, stamp);
    }

    /// Code of the game moved or changed a row so often in the middle of a pass that sums may wrap before all
    /// pairs were asked: every pair is due.
    bool AreSumsLost() const { return m_sumsLost; }
    void ForgetSums() { m_sumsLost = false; }
    /// Has a row kBulletOrStatic that it had not at its update before? Since this was asked last.
    bool TakeNewBullets() {
        const bool taken = m_newBullets;
        m_newBullets = false;
        return taken;
    }

    /// The margin for rounding of a pair of these two rows, as far out as they are.
    double RoundingMargin(uint32_t a, uint32_t b) const { return BandMargin(Band(a, b)); }
    /// The farther one's.
    int Band(uint32_t a, uint32_t b) const { return b2Max(m_rows[a].band, m_rows[b].band); }

    static constexpr uint32_t kNone = 0xffffffffu;
    /// Rows are numbered below this; some may be free (pairs == 0).
    uint32_t Count() const { return m_count; }

    FixtureMotion &operator[](uint32_t row) { return m_rows[row]; }
    const FixtureMotion &operator[](uint32_t row) const { return m_rows[row]; }
    uint32_t Moved(uint32_t row) const { return m_moved[row]; }
    /// kActive, kBulletOrStatic and kIsSensor when its sweep was last compared.
    uint8_t SweepBits(uint32_t row) const { return m_sweepBits[row]; }
    /// Moved, and what the sweep may add.
    uint32_t End(uint32_t row) const { return m_ends[row]; }
    /// The table's stamp when this row was last updated.
    uint64_t StampOf(uint32_t row) const { return m_stamps[row]; }
    uint8_t Bits(uint32_t row) const { return m_bits[row]; }
    void SetBits(uint32_t row, uint8_t bits) { m_bits[row] = bits; }
    /// A pass begins that does not update this row.
    void PassOver(uint32_t row) { m_bits[row] &= static_cast<uint8_t>(~kUpdated); }
    bool IsActive(uint32_t row) const { return (m_bits[row] & kActive) != 0; }
    /// Is its body awake by now? (A step's own code and listeners wake bodies.)
    bool IsActiveNow(uint32_t row) const { return bmr::IsActive(m_rows[row].body); }
    /// Ahead of an update: asks memory for the body and the fixture; and, for a row that this was done for
    /// some rows ago, for the shape.
    void Prefetch(uint32_t row) const {
        if (row >= m_count || m_rows[row].pairs == 0)
            return;
        BMR_PREFETCH(m_rows[row].body);
        BMR_PREFETCH(m_rows[row].fixture);
    }
    void PrefetchShape(uint32_t row) const {
        if (row < m_count && m_rows[row].proved > 0)
            PrefetchLines(m_rows[row].fixture->GetShape(), 3);
    }

private:
    void FindSweepBits(uint32_t row, uint64_t stamp);
    void FindEnd(uint32_t row, bool careful, uint64_t stamp);
    void Begin(uint32_t row, const b2BroadPhase &broadPhase, uint64_t stamp);
    bool UpdateShape(FixtureMotion *motion, uint8_t *bits) const;
    static bool ChangesBand(FixtureMotion *motion, uint8_t *bits);

    Column<FixtureMotion> m_rows;
    Column<uint32_t> m_moved, m_ends;
    Column<uint64_t> m_stamps;
    Column<uint8_t> m_bits, m_sweepBits;
    Column<uint16_t> m_changeable; ///< see NextChangedSweep
    KeyTable m_byFixture;
    bool m_sumsLost = false, m_newBullets = false;
    uint32_t m_count = 0, m_free = kNone;
};

} // namespace bmr

#endif
