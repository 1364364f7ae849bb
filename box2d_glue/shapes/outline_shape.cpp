// SPDX-License-Identifier: MIT
#include "boomerang/outline_shape.h"

#include <cmath>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_world.h>

#include "base/rounding_mode.h"
#include "glue/contacts/convex_contact.h"
#include "shapes/big_polygons.h"
#include "shapes/outline_record.h"

namespace bmr {

namespace {

bmr_error CheckRing(const b2Vec2 *points, int32 count) {
    if (points == nullptr && count > 0)
        return BMR_ERROR_NULL_ARGUMENT;
    return count < 0 ? BMR_ERROR_NEGATIVE : BMR_OK;
}

// Of an outline's area, the part that may come or go where its points are rounded to floats. For a shape of a
// metre within 10 km of the origin it is less.
constexpr double kMostOfArea = 0.01;

/// Are the points of the outline so far from the origin, for its size, that floats have another shape?
/// Rounding moves no point by more than `off`, and so the area by no more than `off` times the perimeter.
bool IsLostInFloats(const bmr_rings &rings, double area) {
    double off = 0.0, perimeter = 0.0;
    const bmr_vec2 *ring = rings.points;
    for (uint32_t r = 0; r < rings.ring_count; ring += rings.counts[r++])
        for (uint32_t i = 0; i < rings.counts[r]; ++i) {
            const bmr_vec2 p = ring[i], next = ring[i + 1 < rings.counts[r] ? i + 1 : 0];
            const auto lost = [](double x) { return x - static_cast<double>(static_cast<float>(x)); };
            off = std::fmax(off, std::hypot(lost(p.x), lost(p.y)));
            perimeter += std::hypot(next.x - p.x, next.y - p.y);
        }
    return off * perimeter > kMostOfArea * area;
}

/// The fault is that of a coordinate.
bmr_error CheckRange(const bmr_rings &rings, bmr_outline_fault *fault) {
    if (rings.counts == nullptr && rings.ring_count > 0)
        return BMR_ERROR_NULL_ARGUMENT;
    uint64_t count = 0;
    for (uint32_t r = 0; r < rings.ring_count; ++r)
        count += rings.counts[r];
    if (count > BMR_MAX_VERTICES)
        return BMR_ERROR_TOO_MANY_POINTS;
    if (rings.points == nullptr && count > 0)
        return BMR_ERROR_NULL_ARGUMENT;
    for (uint64_t i = 0; i < count; ++i) {
        const bmr_vec2 p = rings.points[i];
        const bool isFinite = std::isfinite(p.x) && std::isfinite(p.y);
        if (isFinite && std::fabs(p.x) <= BMR_MAX_COORDINATE && std::fabs(p.y) <= BMR_MAX_COORDINATE)
            continue;
        uint32_t ring = 0;
        for (uint64_t first = 0; i - first >= rings.counts[ring]; ++ring)
            first += rings.counts[ring];
        *fault = {isFinite ? BMR_ERROR_OUT_OF_RANGE : BMR_ERROR_NOT_FINITE,
                  {static_cast<uint32_t>(i), BMR_OUTLINE_NONE},
                  {ring, BMR_OUTLINE_NONE},
                  p};
        return fault->error;
    }
    return BMR_OK;
}

bmr_error MakeRecord(const bmr_rings *rings, float tolerance, const bmr_allocator *allocator,
                     bmr_outline_fault *fault, OutlineRecord **record) {
    bmr_outline_def def = bmr_default_outline_def();
    def.tolerance = static_cast<double>(tolerance);
    bmr_outline_pieces *pieces = nullptr;
    bmr_error error = bmr_outline_decompose(rings, &def, allocator, &pieces, fault);
    if (error != BMR_OK)
        return error;
    bmr_mass mass;
    error = bmr_outline_mass(rings, &mass);
    if (error == BMR_OK && IsLostInFloats(*rings, mass.area))
        error = BMR_ERROR_FAR_FROM_ORIGIN;
    if (error == BMR_OK)
        error = MakeOutlineRecord(*pieces, mass, record);
    bmr_outline_pieces_destroy(pieces, allocator);
    return error;
}

bmr_error CheckDef(const b2FixtureDef &def) {
    for (const float value : {def.density, def.friction, def.restitution, def.restitutionThreshold})
        if (!std::isfinite(value))
            return BMR_ERROR_NOT_FINITE;
    return def.density < 0.0f || def.friction < 0.0f ? BMR_ERROR_NEGATIVE : BMR_OK;
}

} // namespace

OutlineShape::OutlineShape(const OutlineShape &other) noexcept : m_record(other.m_record) {
    if (m_record != nullptr)
        m_record->references.fetch_add(1, std::memory_order_relaxed);
}

OutlineShape &OutlineShape::operator=(const OutlineShape &other) noexcept {
    OutlineShape copy(other);
    std::swap(m_record, copy.m_record);
    return *this;
}

OutlineShape::~OutlineShape() {
    if (m_record != nullptr)
        registry::ReleaseGroup(m_record);
}

bmr_error OutlineShape::Set(const b2Vec2 *points, int32 count, const OutlineHole *holes, int32 holeCount,
                            float tolerance, bmr_outline_fault *fault) {
    if (holes == nullptr && holeCount > 0)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = CheckRing(points, count);
    if (error == BMR_OK && holeCount < 0)
        error = BMR_ERROR_NEGATIVE;
    for (int32 h = 0; error == BMR_OK && h < holeCount; ++h)
        error = CheckRing(holes[h].points, holes[h].count);
    if (error != BMR_OK)
        return error;
    size_t all = static_cast<size_t>(count) + 1; // (memory of no size is none)
    for (int32 h = 0; h < holeCount; ++h)
        all += static_cast<size_t>(holes[h].count);
    const auto ringCount = static_cast<uint32_t>(holeCount) + 1;
    registry::Array<bmr_vec2> copied(all);
    registry::Array<uint32_t> counts(ringCount);
    if (copied.Get() == nullptr || counts.Get() == nullptr)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *next = copied.Get();
    for (uint32_t ring = 0; ring < ringCount; ++ring) {
        const OutlineHole from = ring == 0 ? OutlineHole{points, count} : holes[ring - 1];
        counts[ring] = static_cast<uint32_t>(from.count);
        for (int32 i = 0; i < from.count; ++i)
            *next++ = {static_cast<double>(from.points[i].x), static_cast<double>(from.points[i].y)};
    }
    return Set({copied.Get(), counts.Get(), ringCount}, tolerance, fault);
}

bmr_error OutlineShape::Set(const bmr_rings &rings, float tolerance, bmr_outline_fault *fault) {
    const NearestRounding nearest; // outlines outlast the mode that they are made in
    bmr_outline_fault found = {};
    OutlineRecord *made = nullptr;
    bmr_error error = CheckRange(rings, &found);
    if (error == BMR_OK)
        error = RegisterConvexContacts();
    if (error == BMR_OK)
        error = MakeRecord(&rings, tolerance, registry::GetAllocator(), &found, &made);
    if (found.error != BMR_OK && fault != nullptr)
        *fault = found;
    if (error != BMR_OK)
        return error;
    if (m_record != nullptr)
        registry::ReleaseGroup(m_record);
    m_record = made;
    return BMR_OK;
}

bmr_error OutlineShape::CreateFixtures(b2Body *body, const b2FixtureDef &def) const {
    if (body == nullptr)
        return BMR_ERROR_NULL_ARGUMENT;
    if (m_record == nullptr)
        return BMR_ERROR_NO_POINTS;
    const bmr_error error = CheckDef(def);
    if (error != BMR_OK)
        return error;
    b2MassData mass;
    ComputeMass(&mass, def.density);
    const float all = body->GetMass() + mass.mass, inertia = body->GetInertia() + mass.I;
    if (!std::isfinite(all) || !std::isfinite(inertia) || !std::isfinite(all * mass.center.LengthSquared()))
        return BMR_ERROR_OUT_OF_RANGE;
    if (body->GetWorld()->IsLocked())
        return BMR_ERROR_WORLD_LOCKED;
    if (const bmr_error held = CheckInertia(*body, *m_record, def.density))
        return held;
    // The body's mass is set once: with the fixtures' densities it would be with every one of them.
    b2FixtureDef each = def;
    each.density = 0.0f;
    for (int32 i = 0; i < GetPieceCount(); ++i) {
        const ConvexShape piece = GetPiece(i);
        each.shape = &piece;
        body->CreateFixture(&each)->SetDensity(def.density);
    }
    if (def.density > 0.0f)
        body->ResetMassData();
    return BMR_OK;
}

bmr_error OutlineShape::CreateFixtures(b2Body *body, float density) const {
    b2FixtureDef def;
    def.density = density;
    return CreateFixtures(body, def);
}

bmr_error OutlineShape::DestroyFixtures(b2Body *body) const {
    if (body == nullptr)
        return BMR_ERROR_NULL_ARGUMENT;
    if (body->GetWorld()->IsLocked())
        return BMR_ERROR_WORLD_LOCKED;
    // Box2D weighs the body anew with every fixture that goes: not what is left of the outline then.
    ForEachFixture(body, [](b2Fixture &piece) { piece.SetDensity(0.0f); });
    ForEachFixture(body, [body](b2Fixture &piece) { body->DestroyFixture(&piece); });
    return BMR_OK;
}

OutlineShape OutlineShape::From(const b2Fixture *fixture) {
    OutlineShape outline;
    outline.m_record = fixture != nullptr ? OutlineRecordOf(*fixture->GetShape()) : nullptr;
    if (outline.m_record != nullptr)
        outline.m_record->references.fetch_add(1, std::memory_order_relaxed);
    return outline;
}

bool OutlineShape::Has(const b2Fixture &fixture) const {
    return m_record != nullptr && OutlineRecordOf(*fixture.GetShape()) == m_record;
}

int32 OutlineShape::GetPieceCount() const {
    return m_record != nullptr ? static_cast<int32>(m_record->pieceCount) : 0;
}

ConvexShape OutlineShape::GetPiece(int32 index) const {
    ConvexShape piece;
    if (index < 0 || index >= GetPieceCount())
        return piece;
    registry::AddReference(m_record->pieces[index]);
    internal::ConvexShapeAccess::Adopt(&piece, m_record->pieces[index]);
    return piece;
}

bool OutlineShape::IsInnerEdge(int32 index, int32 edge) const {
    if (edge < 0 || edge >= GetPiece(index).GetVertexCount())
        return false;
    const bmr_convex32_block &block = registry::BlockOf(m_record->pieces[index]);
    return block.polygon.seams != nullptr && block.seams.inner[edge] != 0;
}

void OutlineShape::ComputeMass(b2MassData *massData, float density) const {
    if (m_record == nullptr) {
        *massData = {0.0f, b2Vec2(0.0f, 0.0f), 0.0f};
        return;
    }
    const double d = static_cast<double>(density);
    massData->mass = static_cast<float>(d * m_record->area);
    massData->center.Set(static_cast<float>(m_record->centroid.x), static_cast<float>(m_record->centroid.y));
    const b2Vec2 &centre = massData->center;
    massData->I = InertiaAboutOrigin(massData->mass * b2Dot(centre, centre), d * m_record->inertia);
}

} // namespace bmr
