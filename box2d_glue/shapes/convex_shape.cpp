// SPDX-License-Identifier: MIT
#include "boomerang/convex_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_collision.h>

#include "base/rounding_mode.h"
#include "glue/contacts/contact_register.h"
#include "shapes/convex_geometry.h"
#include "shapes/convex_registry.h"
#include "shapes/outline_record.h"
#include "shapes/shapes32.h"
#include "shapes/stock_polygon.h"
#include "shapes/weighing.h"

namespace bmr {

static_assert(sizeof(ConvexShape) == sizeof(b2PolygonShape), "Box2D frees sizeof(b2PolygonShape) bytes");
static_assert(ConvexShape::kMostVertices == BMR_CONVEX32_MOST);

std::atomic<const void *> internal::convexShapeTable{nullptr};

namespace {

#if !defined(BMR_CONVEX_HANDLE_IN_PADDING)
constexpr uint32_t kInnerVertices = b2_maxPolygonVertices - 1;
#endif

const bmr_convex32_block *Block(uint32_t handle) {
    return registry::Find(handle).block.load(std::memory_order_relaxed);
}

const b2Vec2 *Vectors(const bmr_vec32 *vectors) {
    return reinterpret_cast<const b2Vec2 *>(vectors);
}

} // namespace

const bmr_convex32_block *BigPolygonOf(const b2Shape &shape) {
    const uint32_t handle = internal::ConvexShapeAccess::HandleOf(shape);
    return handle != 0 ? Block(handle) : nullptr;
}

uint64_t NumberOfBigPolygon(const b2Shape &shape) {
    const uint32_t handle = internal::ConvexShapeAccess::HandleOf(shape);
    return handle != 0 ? registry::Find(handle).number.load(std::memory_order_relaxed) : 0;
}

const bmr_convex32_block *BigPolygonOfNumber(uint64_t number) {
    const registry::Entry *entry = registry::FindNumber(number);
    return entry != nullptr ? entry->block.load(std::memory_order_relaxed) : nullptr;
}

#if defined(BMR_CONVEX_HANDLE_IN_PADDING)
uint32_t ConvexShape::GetKeptHandle() const {
    return m_handle;
}

void ConvexShape::SetHandle(uint32_t handle) {
    m_handle = handle;
}
#else
uint32_t ConvexShape::GetKeptHandle() const {
    if (m_count > static_cast<int32>(kInnerVertices))
        return 0;
    uint32_t handle;
    std::memcpy(&handle, &m_normals[kInnerVertices], sizeof handle);
    return handle;
}

void ConvexShape::SetHandle(uint32_t handle) {
    if (m_count <= static_cast<int32>(kInnerVertices)) // a stock octagon has a normal there
        std::memcpy(static_cast<void *>(&m_normals[kInnerVertices]), &handle, sizeof handle);
}
#endif

uint32_t ConvexShape::GetHandle() const {
    const uint32_t handle = GetKeptHandle();
    return handle != 0 && registry::Find(handle).shown.IsOf(*this) ? handle : 0;
}

ConvexShape::ConvexShape() noexcept {
    SetHandle(0);
    if (internal::convexShapeTable.load(std::memory_order_relaxed) == nullptr)
        internal::convexShapeTable.store(internal::TableOf(*this), std::memory_order_relaxed);
}

ConvexShape::ConvexShape(const ConvexShape &other) noexcept : b2PolygonShape(other) {
    SetHandle(other.GetKeptHandle());
    registry::AddReference(GetKeptHandle());
}

ConvexShape &ConvexShape::operator=(const ConvexShape &other) noexcept {
    const uint32_t old = GetKeptHandle(), handle = other.GetKeptHandle();
    registry::AddReference(handle); // first: it may be the same
    b2PolygonShape::operator=(other);
    SetHandle(handle);
    registry::Release(old);
    return *this;
}

ConvexShape::~ConvexShape() {
    registry::Release(GetKeptHandle());
}

void ConvexShape::Adopt(uint32_t handle) {
    const uint32_t old = GetKeptHandle();
    const bmr_convex32_block &block = *Block(handle);
    const registry::Shown &shown = registry::Find(handle).shown;
    const uint32_t count = shown.count;
    std::copy_n(Vectors(shown.vertices), count, m_vertices);
    for (uint32_t i = 0; i < count; ++i) {
        const b2Vec2 &from = m_vertices[i], &to = m_vertices[(i + 1) % count];
        const double x = static_cast<double>(to.x) - static_cast<double>(from.x),
                     y = static_cast<double>(to.y) - static_cast<double>(from.y),
                     length = std::sqrt(x * x + y * y);
        m_normals[i].Set(static_cast<float>(y / length), static_cast<float>(-x / length));
    }
    m_count = static_cast<int32>(count);
    m_centroid.Set(block.mass.centroid.x, block.mass.centroid.y);
    SetHandle(handle);
    registry::Release(old);
}

bmr_error ConvexShape::AdoptBlock(bmr_convex32_block *block) {
    bmr_error error = block->mass.area > b2_epsilon ? RegisterConvexContacts() : BMR_ERROR_OUT_OF_RANGE;
    const uint32_t handle = error == BMR_OK ? registry::Add(block) : 0;
    if (handle != 0) {
        Adopt(handle);
        return BMR_OK;
    }
    bmr_convex32_destroy(block, registry::GetAllocator());
    return error != BMR_OK ? error : BMR_ERROR_NO_MEMORY;
}

bmr_error ConvexShape::Set(const b2Vec2 *points, int32 count) {
    Welded welded;
    return Set(points, count, &welded);
}

bmr_error ConvexShape::Set(const b2Vec2 *points, int32 count, Welded *welded) {
    return SetHull(points, count, Weld::Allowed, welded);
}

bmr_error ConvexShape::SetHull(const b2Vec2 *points, int32 count, Weld weld, Welded *welded) {
    if (points == nullptr || welded == nullptr)
        return BMR_ERROR_NULL_ARGUMENT;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    bmr_convex32_block *block = nullptr;
    Welded found;
    if (count > b2_maxPolygonVertices) {
        const NearestRounding nearest; // shapes outlast the mode that they are made in
        bmr_error error = bmr_convex32_create(Vectors32(points), static_cast<size_t>(count),
                                              registry::GetAllocator(), &block);
        if (error != BMR_OK)
            return error;
        found.count = static_cast<int32>(block->repeated);
        if (block->polygon.count > b2_maxPolygonVertices) {
            error = AdoptBlock(block);
            if (error == BMR_OK)
                *welded = found;
            return error;
        }
        points = Vectors(block->polygon.vertices);
        count = static_cast<int32>(block->polygon.count);
    }
    const uint32_t old = GetKeptHandle();
    const bmr_error error = SetStockPolygon(this, points, count, weld == Weld::Allowed, &found);
    if (error == BMR_OK) {
        SetHandle(0);
        registry::Release(old);
        *welded = found;
    }
    bmr_convex32_destroy(block, registry::GetAllocator());
    return error;
}

bmr_error ConvexShape::SetRaw(const b2Vec2 *vertices, int32 count) {
    if (vertices == nullptr)
        return BMR_ERROR_NULL_ARGUMENT;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (count > b2_maxPolygonVertices) {
        const NearestRounding nearest;
        bmr_convex32_block *block = nullptr;
        const bmr_error error = bmr_convex32_create_raw(Vectors32(vertices), static_cast<size_t>(count),
                                                        registry::GetAllocator(), &block);
        return error != BMR_OK ? error : AdoptBlock(block);
    }
    const uint32_t old = GetKeptHandle();
    const bmr_error error = SetStockPolygonRaw(this, vertices, count);
    if (error == BMR_OK) {
        SetHandle(0);
        registry::Release(old);
    }
    return error;
}

bmr_error ConvexShape::SetAsBox(float halfWidth, float halfHeight) {
    if (!std::isfinite(halfWidth) || !std::isfinite(halfHeight))
        return BMR_ERROR_NOT_FINITE;
    if (!(halfWidth > 0.0f && halfHeight > 0.0f))
        return BMR_ERROR_OUT_OF_RANGE;
    const uint32_t old = GetKeptHandle();
    b2PolygonShape::SetAsBox(halfWidth, halfHeight);
    SetHandle(0);
    registry::Release(old);
    return BMR_OK;
}

bmr_error ConvexShape::SetAsBox(float halfWidth, float halfHeight, const b2Vec2 &center, float angle) {
    if (!center.IsValid() || !std::isfinite(angle))
        return BMR_ERROR_NOT_FINITE;
    const bmr_error error = SetAsBox(halfWidth, halfHeight);
    if (error == BMR_OK)
        b2PolygonShape::SetAsBox(halfWidth, halfHeight, center, angle);
    return error;
}

int32 ConvexShape::GetVertexCount() const {
    const uint32_t handle = GetHandle();
    return handle != 0 ? static_cast<int32>(Block(handle)->polygon.count) : m_count;
}

const b2Vec2 *ConvexShape::GetVertices() const {
    const uint32_t handle = GetHandle();
    return handle != 0 ? Vectors(Block(handle)->polygon.vertices) : m_vertices;
}

const b2Vec2 &ConvexShape::GetVertex(int32 index) const {
    return GetVertices()[index];
}

const b2Vec2 &ConvexShape::GetNormal(int32 index) const {
    const uint32_t handle = GetHandle();
    return (handle != 0 ? Vectors(Block(handle)->polygon.normals) : m_normals)[index];
}

const ConvexShape *ConvexShape::From(const b2Shape *shape) {
    return shape != nullptr && internal::IsConvexShape(*shape) ? static_cast<const ConvexShape *>(shape)
                                                               : nullptr;
}

b2Shape *ConvexShape::Clone(b2BlockAllocator *allocator) const {
    return new (allocator->Allocate(sizeof(ConvexShape))) ConvexShape(*this);
}

bool ConvexShape::TestPoint(const b2Transform &xf, const b2Vec2 &p) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::TestPoint(xf, p);
    const b2Vec2 local = b2MulT(xf.q, p - xf.p);
    return bmr_convex32_contains(&Block(handle)->polygon, *Vectors32(&local));
}

bool ConvexShape::RayCast(b2RayCastOutput *output, const b2RayCastInput &input, const b2Transform &xf,
                          int32 childIndex) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::RayCast(output, input, xf, childIndex);
    const b2Vec2 p1 = b2MulT(xf.q, input.p1 - xf.p), p2 = b2MulT(xf.q, input.p2 - xf.p);
    const bmr_convex32_block &block = *Block(handle);
    float fraction;
    uint32_t edge;
    if (!bmr_convex32_ray(&block.polygon, *Vectors32(&p1), *Vectors32(&p2), input.maxFraction, &fraction,
                          &edge))
        return false;
    bmr_vec32 normal = block.polygon.normals[edge];
    if (block.seams.inner != nullptr &&
        !EntersOutline(handle, *Vectors32(&p1), *Vectors32(&p2), edge, &fraction, &normal))
        return false;
    output->fraction = fraction;
    output->normal = b2Mul(xf.q, *Vectors(&normal));
    return true;
}

void ConvexShape::ComputeAABB(b2AABB *aabb, const b2Transform &xf, int32 childIndex) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::ComputeAABB(aabb, xf, childIndex);
    bmr_vec32 lower, upper;
    bmr_convex32_box(&Block(handle)->polygon, Transform32(xf), &lower, &upper);
    const b2Vec2 skin(m_radius, m_radius);
    aabb->lowerBound = b2Vec2(lower.x, lower.y) - skin;
    aabb->upperBound = b2Vec2(upper.x, upper.y) + skin;
}

void ConvexShape::ComputeMass(b2MassData *massData, float density) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::ComputeMass(massData, density);
    if (registry::Find(handle).group.load(std::memory_order_relaxed) != nullptr)
        return WeighPiece(handle, density, massData);
    const bmr_mass32 &mass = Block(handle)->mass;
    massData->mass = density * mass.area;
    massData->center.Set(mass.centroid.x, mass.centroid.y);
    massData->I = 0.0f;
    Weighing alone;
    alone.Add(*massData);
    massData->I = InertiaAboutOrigin(alone.OfCentre(),
                                     static_cast<double>(density) * static_cast<double>(mass.inertia));
}

// Outlines that games ask for, as points.

namespace {

/// Points in memory of the registry's allocator.
class Points {
public:
    explicit Points(int32 most)
        : m_size(static_cast<size_t>(most) * sizeof(b2Vec2)), m_allocator(registry::GetAllocator()),
          m_points(static_cast<b2Vec2 *>(m_allocator != nullptr
                                             ? m_allocator->allocate(m_allocator->context, m_size)
                                             : std::malloc(m_size))) {}
    ~Points() {
        if (m_points != nullptr && m_allocator != nullptr)
            m_allocator->release(m_allocator->context, m_points, m_size);
        else
            std::free(m_points);
    }
    Points(const Points &) = delete;
    Points &operator=(const Points &) = delete;

    /// nullptr without memory.
    b2Vec2 *Get() { return m_points; }
    int32 GetCount() const { return m_count; }

    /// A point that equals the last one is not added again.
    void Add(double x, double y) {
        const b2Vec2 point(static_cast<float>(x), static_cast<float>(y));
        if (m_count == 0 || !(point == m_points[m_count - 1]))
            m_points[m_count++] = point;
    }
    /// Likewise of the last and the first.
    void Close() {
        if (m_count > 1 && m_points[m_count - 1] == m_points[0])
            --m_count;
    }

private:
    size_t m_size;
    const bmr_allocator *m_allocator;
    b2Vec2 *m_points;
    int32 m_count = 0;
};

struct Direction {
    double x, y;
};

/// Of a whole turn `i` parts in `count`: exact at the quarters, and the same in each quarter.
Direction PartOfTurn(int64_t i, int64_t count) {
    const int64_t quarter = 4 * i / count, rest = 4 * i % count;
    const double angle = static_cast<double>(rest) / static_cast<double>(count) * 1.57079632679489661923;
    const double c = std::cos(angle), s = std::sin(angle);
    switch (quarter % 4) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

bmr_error CheckSize(float size) {
    if (!std::isfinite(size))
        return BMR_ERROR_NOT_FINITE;
    return size > 0.0f ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
}

} // namespace

bmr_error ConvexShape::SetRegular(int32 count, float radius) {
    return SetEllipse(count, radius, radius);
}

bmr_error ConvexShape::SetEllipse(int32 count, float halfWidth, float halfHeight) {
    for (const float size : {halfWidth, halfHeight})
        if (const bmr_error error = CheckSize(size))
            return error;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (count > kMostVertices)
        return BMR_ERROR_TOO_MANY_POINTS;
    Points points(count);
    if (points.Get() == nullptr)
        return BMR_ERROR_NO_MEMORY;
    for (int32 i = 0; i < count; ++i) {
        const Direction d = PartOfTurn(i, count);
        points.Add(d.x * static_cast<double>(halfWidth), d.y * static_cast<double>(halfHeight));
    }
    Welded welded; // none
    return SetHull(points.Get(), points.GetCount(), Weld::Refused, &welded);
}

bmr_error ConvexShape::SetRounded(float halfWidth, float halfHeight, float cornerRadius,
                                  int32 cornerVertices) {
    for (const float size : {halfWidth, halfHeight, cornerRadius})
        if (const bmr_error error = CheckSize(size))
            return error;
    if (cornerRadius > halfWidth || cornerRadius > halfHeight)
        return BMR_ERROR_CORNER_TOO_LARGE;
    if (cornerVertices < 2)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (cornerVertices > kMostVertices / 4)
        return BMR_ERROR_TOO_MANY_POINTS;
    Points points(4 * cornerVertices);
    if (points.Get() == nullptr)
        return BMR_ERROR_NO_MEMORY;
    const double radius = static_cast<double>(cornerRadius);
    const double x = static_cast<double>(halfWidth) - radius, y = static_cast<double>(halfHeight) - radius;
    const Direction corners[] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
    const int32 steps = cornerVertices - 1;
    for (int32 corner = 0; corner < 4; ++corner)
        for (int32 i = 0; i <= steps; ++i) {
            const Direction d = PartOfTurn(int64_t{corner} * steps + i, int64_t{4} * steps);
            points.Add(corners[corner].x + radius * d.x, corners[corner].y + radius * d.y);
        }
    points.Close();
    Welded welded; // none
    return SetHull(points.Get(), points.GetCount(), Weld::Refused, &welded);
}

bmr_error ConvexShape::Simplify(float tolerance) {
    const int32 count = GetVertexCount();
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    Points points(count);
    if (points.Get() == nullptr)
        return BMR_ERROR_NO_MEMORY;
    const bmr_convex32 polygon = {Vectors32(GetVertices()),
                                  Vectors32(&GetNormal(0)),
                                  nullptr,
                                  static_cast<uint32_t>(count),
                                  0,
                                  {0.0f, 0.0f},
                                  nullptr};
    size_t left = 0;
    const bmr_error error = bmr_convex32_simplify(&polygon, tolerance, registry::GetAllocator(),
                                                  reinterpret_cast<bmr_vec32 *>(points.Get()), &left);
    if (error != BMR_OK || left == static_cast<size_t>(count))
        return error;
    Welded welded; // none
    return SetHull(points.Get(), static_cast<int32>(left), Weld::Refused, &welded);
}

} // namespace bmr
