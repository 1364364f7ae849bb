// SPDX-License-Identifier: MIT
#include "shapes/outline_mass.h"

#include <cfloat>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "shapes/convex_geometry.h"
#include "shapes/outline_record.h"
#include "shapes/weighing.h"

namespace bmr {

namespace {

double Square(const b2Vec2 &v) {
    const double x = static_cast<double>(v.x), y = static_cast<double>(v.y);
    return x * x + y * y;
}

/// As it is, rounded once.
b2MassData ShareOf(registry::Handle piece, float density) {
    const bmr_mass32 &share = registry::Find(piece).block.load(std::memory_order_relaxed)->mass;
    b2MassData m = {density * share.area, b2Vec2(share.centroid.x, share.centroid.y), 0.0f};
    m.I = static_cast<float>(static_cast<double>(m.mass) * Square(m.center) +
                             static_cast<double>(density) * static_cast<double>(share.inertia));
    return m;
}

/// The sum of the shares, fixtures in the order that CreateFixtures gives them in a body's list.
Weighing WeighAll(const OutlineRecord &record, float density, const b2MassData &ofBalance) {
    Weighing all;
    for (uint32_t i = record.pieceCount; i-- > 0;)
        all.Add(i == record.balance ? ofBalance : ShareOf(record.pieces[i], density));
    return all;
}

/// Mass, centre and inertia of a body, in double.
struct Whole {
    double mass = 0.0, inertia = 0.0; ///< about the origin
    bmr_vec2 moment = {0.0, 0.0};

    /// `own`: about the centre.
    void Add(double m, bmr_vec2 centre, double own) {
        mass += m;
        moment = bmr_add(moment, bmr_scale(m, centre));
        inertia += own + m * bmr_dot(centre, centre);
    }
    /// `said`, a fixture's own mass data, is rounded; that of a piece is more than the piece has.
    void Add(const b2Fixture &fixture, const b2MassData &said) {
        if (const bmr_convex32_block *block = BigPolygonOf(*fixture.GetShape())) {
            const bmr_mass32 &share = block->mass;
            const OutlineRecord *record = OutlineRecordOf(*fixture.GetShape());
            const double density = static_cast<double>(fixture.GetDensity()),
                         part = record != nullptr ? record->ownPart : 1.0;
            return Add(density * static_cast<double>(share.area),
                       {static_cast<double>(share.centroid.x), static_cast<double>(share.centroid.y)},
                       part * density * static_cast<double>(share.inertia));
        }
        Weighing alone;
        alone.Add(said);
        Add(static_cast<double>(said.mass),
            {static_cast<double>(said.center.x), static_cast<double>(said.center.y)},
            static_cast<double>(said.I) - static_cast<double>(alone.OfCentre()));
    }
    double OfCentre() const { return bmr_dot(moment, moment) / mass; }
};

} // namespace

void WeighPiece(registry::Handle piece, float density, b2MassData *massData) {
    const auto &record =
        *static_cast<const OutlineRecord *>(registry::Find(piece).group.load(std::memory_order_relaxed));
    *massData = ShareOf(piece, density);
    const double own = static_cast<double>(density) * record.inertia;
    if (piece != record.pieces[record.balance])
        return;
    Weighing alone;
    alone.Add(*massData);
    // By itself it keeps some inertia, too.
    const double part = HeldInertia(record.pieceCount);
    const double least = (1.0 + 0.5 * part) * static_cast<double>(alone.OfCentre());
    // By the whole difference, and then bit by bit: a sum that lies midway between two floats goes to the
    // even one, so that the whole difference may pass by the odd one.
    constexpr int kMost = 10;
    double before = 0.0;
    for (int i = 0; i < kMost; ++i) {
        const Weighing all = WeighAll(record, density, *massData);
        const double ofCentre = static_cast<double>(all.OfCentre());
        const double right = static_cast<double>(static_cast<float>(ofCentre + own));
        const double more = right - static_cast<double>(all.Sum());
        if (own < part * ofCentre || more == 0.0 || (i > 1 && more * before < 0.0))
            return;
        const float next = i == 0 ? static_cast<float>(static_cast<double>(massData->I) + more)
                                  : std::nextafter(massData->I, more > 0.0 ? FLT_MAX : 0.0f);
        if (static_cast<double>(next) < least)
            return;
        massData->I = next;
        before = more;
    }
}

bmr_error CheckInertia(const b2Body &body, const OutlineRecord &record, float density) {
    if (body.GetType() != b2_dynamicBody || body.IsFixedRotation() || !(density > 0.0f))
        return BMR_OK;
    b2MassData ofBalance;
    WeighPiece(record.pieces[record.balance], density, &ofBalance);
    Weighing box2d = WeighAll(record, density, ofBalance);
    const double d = static_cast<double>(density);
    Whole whole;
    whole.Add(d * record.area, record.centroid, d * record.inertia);
    uint32_t count = record.pieceCount;
    for (const b2Fixture *fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
        if (fixture->GetDensity() == 0.0f)
            continue;
        b2MassData other;
        fixture->GetMassData(&other);
        box2d.Add(other);
        whole.Add(*fixture, other);
        ++count;
    }
    const double ofCentre = whole.OfCentre(), right = whole.inertia - ofCentre;
    const double held = static_cast<double>(box2d.Sum() - box2d.OfCentre());
    return right >= HeldInertia(count) * ofCentre && std::fabs(held - right) <= kInertiaTolerance * right
               ? BMR_OK
               : BMR_ERROR_FAR_FROM_ORIGIN;
}

} // namespace bmr
