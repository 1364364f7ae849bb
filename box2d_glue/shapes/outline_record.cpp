// SPDX-License-Identifier: MIT
#include "shapes/outline_record.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <new>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "convex32/convex32_pieces.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"

namespace bmr {

namespace {

size_t BytesOf(uint32_t pieceCount) {
    return sizeof(OutlineRecord) + (pieceCount - 1) * sizeof(registry::Handle);
}

void End(registry::Group *group) {
    auto *record = static_cast<OutlineRecord *>(group);
    const bmr_allocator *allocator = registry::GetAllocator();
    for (uint32_t i = 0; i < record->pieceCount; ++i)
        if (record->pieces[i] != 0)
            registry::Remove(record->pieces[i]);
    const size_t bytes = BytesOf(record->pieceCount);
    record->~OutlineRecord();
    bmr_release(allocator, record, bytes);
}

/// From pieces as they were cut to polygons of floats.
class Builder {
public:
    Builder(const bmr_outline_pieces &pieces, const bmr_allocator *allocator)
        : m_pieces(pieces), m_allocator(allocator), m_blocks(pieces.piece_count),
          m_slivers(pieces.piece_count), m_corners(MostCorners(pieces)) {}
    ~Builder() { Drop(); }
    Builder(const Builder &) = delete;
    Builder &operator=(const Builder &) = delete;

    bmr_error Build() {
        if (m_blocks.Get() == nullptr || m_slivers.Get() == nullptr || m_corners.Get() == nullptr)
            return BMR_ERROR_NO_MEMORY;
        // Where a piece turns out to be a sliver, edges of its neighbours become faces: all is made anew.
        for (bool again = true; again;) {
            again = false;
            Drop();
            for (uint32_t p = 0; p < m_pieces.piece_count; ++p) {
                if (m_slivers[p])
                    continue;
                const bmr_error error = MakePiece(p);
                if (error != BMR_OK && error != BMR_ERROR_TOO_FEW_POINTS)
                    return error;
                m_slivers[p] = error != BMR_OK;
                again = again || error != BMR_OK;
            }
        }
        return Count() > 0 ? BMR_OK : BMR_ERROR_TOO_FEW_POINTS;
    }

    uint32_t Count() {
        uint32_t count = 0;
        for (uint32_t p = 0; p < m_pieces.piece_count; ++p)
            count += m_blocks[p] != nullptr;
        return count;
    }

    float Reach() {
        float reach = 0.0f;
        for (uint32_t p = 0; p < m_pieces.piece_count; ++p)
            reach = m_blocks[p] != nullptr ? std::max(reach, m_blocks[p]->reach) : reach;
        return reach;
    }

    uint32_t FindBalance(double area, OutlineRecord *record);
    void ShareMass(OutlineRecord *record);

    /// Hands the polygons over to the registry; false without memory, then some are still here.
    bool Register(OutlineRecord *record) {
        uint32_t count = 0;
        for (uint32_t p = 0; p < m_pieces.piece_count; ++p) {
            if (m_blocks[p] == nullptr)
                continue;
            record->pieces[count] = registry::Add(m_blocks[p], record);
            if (record->pieces[count++] == 0)
                return false;
            m_blocks[p] = nullptr;
        }
        return true;
    }

private:
    template <typename Visit> void ForEachMass(Visit visit) {
        for (uint32_t p = 0; p < m_pieces.piece_count; ++p)
            if (m_blocks[p] != nullptr)
                visit(m_blocks[p]->mass);
    }
    static uint32_t MostCorners(const bmr_outline_pieces &pieces) {
        uint32_t most = 1;
        for (uint32_t p = 0; p < pieces.piece_count; ++p)
            most = std::max(most, pieces.first[p + 1] - pieces.first[p]);
        return most;
    }

    const bmr_outline_edge &Edge(uint32_t edge) const { return m_pieces.edges[edge]; }
    uint32_t Next(uint32_t edge) const {
        const uint32_t piece = Edge(edge).piece;
        return edge + 1 < m_pieces.first[piece + 1] ? edge + 1 : m_pieces.first[piece];
    }
    uint32_t Previous(uint32_t edge) const {
        const uint32_t piece = Edge(edge).piece;
        return (edge > m_pieces.first[piece] ? edge : m_pieces.first[piece + 1]) - 1;
    }
    bmr_vec32 Begin(uint32_t edge) const {
        const bmr_vec2 point = m_pieces.points[Edge(edge).point];
        return {static_cast<float>(point.x), static_cast<float>(point.y)};
    }
    bool IsOutline(uint32_t edge) const { return Edge(edge).twin == BMR_OUTLINE_NONE; }

    /// Does the sliver have a part of the outline? Then its neighbours take its place.
    bool HasOutline(uint32_t piece) const {
        for (uint32_t e = m_pieces.first[piece]; e < m_pieces.first[piece + 1]; ++e)
            if (IsOutline(e))
                return true;
        return false;
    }
    bool IsInner(uint32_t edge) {
        if (IsOutline(edge))
            return false;
        const uint32_t behind = Edge(Edge(edge).twin).piece;
        return !(m_slivers[behind] && HasOutline(behind));
    }

    /// The edge of the outline that ends where `edge` begins, if the edge ahead of `edge` is inner: its other
    /// end. And likewise of the edge of the outline that begins there, if `edge` is inner. Both walk around
    /// the corner, from piece to piece, to the first edge that has no other piece behind it.
    bmr_vec32 ComesFrom(uint32_t edge) const {
        uint32_t around = Previous(edge);
        while (!IsOutline(around))
            around = Previous(Edge(around).twin);
        return Begin(around);
    }
    bmr_vec32 GoesTo(uint32_t edge) const {
        uint32_t around = edge;
        while (!IsOutline(around))
            around = Next(Edge(around).twin);
        return Begin(Next(around));
    }

    bmr_error MakePiece(uint32_t piece) {
        const uint32_t first = m_pieces.first[piece], count = m_pieces.first[piece + 1] - first;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t edge = first + i;
            bmr_piece_corner32 &corner = m_corners[i];
            corner.vertex = corner.neighbour = Begin(edge);
            corner.inner = IsInner(edge);
            const bool innerBefore = IsInner(Previous(edge));
            if (corner.inner != innerBefore)
                corner.neighbour = corner.inner ? GoesTo(edge) : ComesFrom(edge);
        }
        return bmr_convex32_create_piece(m_corners.Get(), count, m_allocator, &m_blocks[piece]);
    }

    void Drop() {
        if (m_blocks.Get() == nullptr)
            return;
        for (uint32_t p = 0; p < m_pieces.piece_count; ++p) {
            bmr_convex32_destroy(m_blocks[p], m_allocator);
            m_blocks[p] = nullptr;
        }
    }

    const bmr_outline_pieces &m_pieces;
    const bmr_allocator *m_allocator;
    registry::Array<bmr_convex32_block *> m_blocks;
    registry::Array<bool> m_slivers;
    registry::Array<bmr_piece_corner32> m_corners;
};

/// The share that makes up for the rounding of all: the largest; but none of half and more, if there is
/// another: its last bits would be those of the sum. Returns how many shares there are.
uint32_t Builder::FindBalance(double area, OutlineRecord *record) {
    double best = 0.0;
    uint32_t count = 0;
    ForEachMass([&](const bmr_mass32 &mass) {
        const double a = static_cast<double>(mass.area), fit = a < 0.45 * area ? a : 0.1 * a;
        if (fit > best) {
            best = fit;
            record->balance = count;
        }
        ++count;
    });
    return count;
}

/// The pieces' masses become shares of the outline's, so that their sum is right also where the pieces are
/// not quite the outline: each by its area; and all of them are moved to the outline's centre, and scaled
/// about it until the inertia is right. So each share is a mass that there can be. Each of them also keeps an
/// inertia about its own centre that floats can hold (weighing.h); where that takes something, the shares
/// move together.
void Builder::ShareMass(OutlineRecord *record) {
    double area = 0.0;
    bmr_vec2 moment = {0.0, 0.0};
    ForEachMass([&](const bmr_mass32 &mass) {
        const double a = static_cast<double>(mass.area);
        area += a;
        moment = bmr_add(moment, bmr_scale(a, Double(mass.centroid)));
    });
    const uint32_t count = FindBalance(area, record);
    const bmr_vec2 centre = bmr_scale(1.0 / area, moment);
    const double share = record->area / area;
    // Of the shares about the outline's centre, as long as they are not scaled.
    double spread = 0.0, own = 0.0;
    ForEachMass([&](const bmr_mass32 &mass) {
        const bmr_vec2 away = bmr_sub(Double(mass.centroid), centre);
        spread += share * static_cast<double>(mass.area) * bmr_dot(away, away);
        own += share * static_cast<double>(mass.inertia);
    });
    const double square = record->inertia / (spread + own);
    const double ofCentre = record->area * bmr_dot(record->centroid, record->centroid);
    const bool held = record->inertia >= HeldInertia(count) * ofCentre;
    const double part = held ? HeldInertia(count) : kSafeInertia;
    // One of several makes up for the rounding of all: it gets half of what can be spared.
    const double balance = held && count > 1 ? 0.5 * (record->inertia - part * ofCentre) : 0.0;
    uint32_t number = 0;
    const auto leastOwn = [&](const bmr_mass32 &mass) {
        const bmr_vec2 at = bmr_add(record->centroid, bmr_sub(Double(mass.centroid), centre));
        const double least = part * share * static_cast<double>(mass.area) * bmr_dot(at, at);
        return number++ % count == record->balance ? least + std::min(balance, kSafeInertia * ofCentre)
                                                   : least;
    };
    double taken = 0.0;
    ForEachMass([&](const bmr_mass32 &mass) {
        taken += std::max(0.0, leastOwn(mass) - square * share * static_cast<double>(mass.inertia));
    });
    const double left =
        held && taken > 0.0 && spread > 0.0 ? std::max(0.0, 1.0 - taken / (square * spread)) : 1.0;
    const double scale = std::sqrt(square * left);
    double shared = 0.0;
    ForEachMass([&](bmr_mass32 &mass) {
        const double least = leastOwn(mass);
        const bmr_vec2 moved =
            bmr_add(record->centroid, bmr_scale(scale, bmr_sub(Double(mass.centroid), centre)));
        mass.inertia =
            static_cast<float>(std::max(square * share * static_cast<double>(mass.inertia), least));
        mass.area = static_cast<float>(share * static_cast<double>(mass.area));
        mass.centroid = {static_cast<float>(moved.x), static_cast<float>(moved.y)};
        shared += static_cast<double>(mass.inertia);
    });
    const double right = record->inertia - scale * scale * spread;
    record->ownPart = right < shared ? std::max(0.0, right / shared) : 1.0;
}

bool IsNormal(double value) {
    return value >= static_cast<double>(FLT_MIN) && value <= static_cast<double>(FLT_MAX);
}

} // namespace

bmr_error MakeOutlineRecord(const bmr_outline_pieces &pieces, const bmr_mass &mass, OutlineRecord **record) {
    const bmr_allocator *allocator = registry::GetAllocator();
    const double inertia = mass.inertia + mass.area * bmr_dot(mass.centroid, mass.centroid);
    if (!IsNormal(mass.area) || !IsNormal(mass.inertia) || !IsNormal(inertia))
        return BMR_ERROR_OUT_OF_RANGE;
    Builder builder(pieces, allocator);
    const bmr_error error = builder.Build();
    if (error != BMR_OK)
        return error;
    const uint32_t count = builder.Count();
    void *memory = bmr_allocate(allocator, BytesOf(count));
    if (memory == nullptr)
        return BMR_ERROR_NO_MEMORY;
    auto *made = new (memory) OutlineRecord();
    made->references.store(1, std::memory_order_relaxed);
    made->end = End;
    made->area = mass.area;
    made->centroid = mass.centroid;
    made->inertia = mass.inertia;
    made->reach = builder.Reach();
    made->pieceCount = count;
    std::fill_n(made->pieces, count, registry::Handle{0});
    builder.ShareMass(made);
    if (!builder.Register(made)) {
        End(made);
        return BMR_ERROR_NO_MEMORY;
    }
    *record = made;
    return BMR_OK;
}

OutlineRecord *OutlineRecordOf(const b2Shape &shape) {
    const uint32_t handle = internal::ConvexShapeAccess::KeptHandleOf(shape);
    return handle == 0
               ? nullptr
               : static_cast<OutlineRecord *>(registry::Find(handle).group.load(std::memory_order_relaxed));
}

// Rays.

bool EntersOutline(registry::Handle piece, bmr_vec32 p1, bmr_vec32 p2, uint32_t edge, float *fraction,
                   bmr_vec32 *normal) {
    // (A piece has a reference to the record, and so to all pieces.)
    const auto &record =
        static_cast<const OutlineRecord &>(*registry::Find(piece).group.load(std::memory_order_relaxed));
    const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, record.reach);
    double at = static_cast<double>(*fraction);
    bmr_vec32 corner;
    const bmr_entry32 entry = bmr_convex32_entry(&registry::BlockOf(piece), &ray, edge, &at, &corner);
    if (entry != BMR_ENTRY_CORNER)
        return entry == BMR_ENTRY_FACE;
    for (uint32_t i = 0; i < record.pieceCount; ++i)
        if (record.pieces[i] != piece &&
            bmr_convex32_comes_through(&registry::BlockOf(record.pieces[i]), &ray, at))
            return false;
    double against = 0.0;
    for (uint32_t i = 0; i < record.pieceCount; ++i)
        bmr_convex32_face_against(&registry::BlockOf(record.pieces[i]), &ray, corner, &against, normal);
    *fraction = static_cast<float>(at);
    return against < 0.0;
}

// Masses.

namespace {

/// As it is, rounded once.
b2MassData ShareOf(registry::Handle piece, float density) {
    const bmr_mass32 &share = registry::BlockOf(piece).mass;
    b2MassData m = {density * share.area, b2Vec2(share.centroid.x, share.centroid.y), 0.0f};
    const bmr_vec2 centre = Double(m.center);
    m.I = static_cast<float>(static_cast<double>(m.mass) * bmr_dot(centre, centre) +
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
            return Add(density * static_cast<double>(share.area), Double(share.centroid),
                       part * density * static_cast<double>(share.inertia));
        }
        Weighing alone;
        alone.Add(said);
        Add(static_cast<double>(said.mass), Double(said.center),
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
