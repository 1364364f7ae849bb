// SPDX-License-Identifier: MIT
// Outlines that games ask for, as points of a ConvexShape.
#include <cmath>
#include <cstdlib>
#include <initializer_list>

#include "boomerang/convex_shape.h"
#include "shapes/convex_registry.h"
#include "shapes/shapes32.h"

namespace bmr {

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
