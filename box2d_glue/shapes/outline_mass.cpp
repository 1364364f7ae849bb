// SPDX-License-Identifier: MIT
#include "shapes/outline_mass.h"

#include <cfloat>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

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

/// What the shares come to, fixtures in the order that CreateFixtures gives them in a body's list.
Weighing WeighAll(const OutlineRecord &record, float density, const b2MassData &ofBalance) {
    Weighing all;
    for (uint32_t i = record.pieceCount; i-- > 0;)
        all.Add(i == record.balance ? ofBalance : ShareOf(record.pieces[i], density));
    return all;
}

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
    double mass = d * record.area,
           inertia = d * (record.inertia + record.area * bmr_dot(record.centroid, record.centroid));
    bmr_vec2 moment = bmr_scale(mass, record.centroid);
    uint32_t count = record.pieceCount;
    for (const b2Fixture *fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
        if (fixture->GetDensity() == 0.0f)
            continue;
        b2MassData other;
        fixture->GetMassData(&other);
        box2d.Add(other);
        ++count;
        Weighing alone;
        alone.Add(other);
        const double m = static_cast<double>(other.mass);
        mass += m;
        moment = bmr_add(
            moment, bmr_scale(m, {static_cast<double>(other.center.x), static_cast<double>(other.center.y)}));
        inertia +=
            static_cast<double>(other.I) - static_cast<double>(alone.OfCentre()) + m * Square(other.center);
    }
    const double ofCentre = bmr_dot(moment, moment) / mass, right = inertia - ofCentre;
    const double held = static_cast<double>(box2d.Sum() - box2d.OfCentre());
    return right >= HeldInertia(count) * ofCentre && std::fabs(held - right) <= kInertiaTolerance * right
               ? BMR_OK
               : BMR_ERROR_FAR_FROM_ORIGIN;
}

} // namespace bmr
