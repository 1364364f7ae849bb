// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/rounding_mode.h"
#include "boomerang/convex_shape.h"
#include "glue/contacts/convex_contact.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"

/// @file
/// How a ConvexShape gets its vertices. b2PolygonShape::Set ends the program on points that it does not like,
/// and welds points without a word.

namespace bmr {

namespace {

/// The sum that Set divides by, and that ComputeMass asserts on.
template <typename Vertex> float AreaOf(int32 count, Vertex vertex) {
    float area = 0.0f;
    const b2Vec2 origin = vertex(0);
    for (int32 i = 0; i < count; ++i)
        area += 0.5f * b2Cross(vertex(i) - origin, vertex(i + 1 < count ? i + 1 : 0) - origin);
    return area;
}

/// The hull as Set finds it: by gift wrapping, in its arithmetic.
struct Wrapping {
    const b2Vec2 *points;
    int32 count;
    int32 hull[b2_maxPolygonVertices];
    int32 hullCount = 0;

    int32 Rightmost() const {
        int32 best = 0;
        for (int32 i = 1; i < count; ++i)
            if (points[i].x > points[best].x ||
                (points[i].x == points[best].x && points[i].y < points[best].y))
                best = i;
        return best;
    }

    /// The point that has all others on its left, seen from point `from`; of those on a line the farthest.
    int32 Next(int32 from) const {
        int32 next = 0;
        for (int32 i = 1; i < count; ++i) {
            if (next == from) {
                next = i;
                continue;
            }
            const b2Vec2 best = points[next] - points[from], other = points[i] - points[from];
            const float turn = b2Cross(best, other);
            if (turn < 0.0f || (turn == 0.0f && other.LengthSquared() > best.LengthSquared()))
                next = i;
        }
        return next;
    }

    /// False where the hull does not close.
    bool Wrap() {
        const int32 first = Rightmost();
        int32 vertex = first;
        do {
            if (hullCount == b2_maxPolygonVertices)
                return false;
            hull[hullCount++] = vertex;
            vertex = Next(vertex);
        } while (vertex != first);
        return true;
    }

    b2Vec2 Vertex(int32 i) const { return points[hull[i < hullCount ? i : 0]]; }
};

/// Points as Set welds them.
struct WeldedPoints {
    b2Vec2 points[b2_maxPolygonVertices];
    int32 count = 0;
    Welded welded;

    void Add(const b2Vec2 &point) {
        constexpr float kWeld = 0.5f * b2_linearSlop;
        for (int32 i = 0; i < count; ++i) {
            const float square = b2DistanceSquared(point, points[i]);
            if (square < kWeld * kWeld) {
                ++welded.count; // (The square of a distance may be zero where that is not.)
                welded.distance =
                    b2Max(welded.distance, std::hypot(point.x - points[i].x, point.y - points[i].y));
                return;
            }
        }
        points[count++] = point;
    }
};

/// The result of Set of Box2D 2.4.1, which asserts unless it makes a polygon.
enum class Outcome { Polygon, NoHull, NoArea };

/// Of points that it does not weld.
Outcome OutcomeOfSet(const b2Vec2 *points, int32 count) {
    Wrapping wrapping = {points, count, {}};
    if (!wrapping.Wrap() || wrapping.hullCount < 3)
        return Outcome::NoHull;
    for (int32 i = 0; i < wrapping.hullCount; ++i)
        if (!((wrapping.Vertex(i + 1) - wrapping.Vertex(i)).LengthSquared() > b2_epsilon * b2_epsilon))
            return Outcome::NoHull;
    const float area = AreaOf(wrapping.hullCount, [&](int32 i) { return wrapping.Vertex(i); });
    return area > b2_epsilon ? Outcome::Polygon : Outcome::NoArea;
}

bool IsFinite(const b2PolygonShape &shape) {
    for (int32 i = 0; i < shape.m_count; ++i)
        // A normal whose length overflowed is zero.
        if (!shape.m_normals[i].IsValid() || !(shape.m_normals[i].LengthSquared() > 0.5f))
            return false;
    return shape.m_centroid.IsValid();
}

/// The exact hull, of points where Set finds none.
bmr_error MakeHull(b2PolygonShape *set, const b2Vec2 *points, int32 count) {
    const NearestRounding nearest;
    bmr_convex32_block *block = nullptr;
    const bmr_error error =
        bmr_convex32_create(Vectors32(points), static_cast<size_t>(count), registry::GetAllocator(), &block);
    if (error != BMR_OK)
        return error;
    set->m_count = static_cast<int32>(block->polygon.count);
    std::copy_n(Vectors(block->polygon.vertices), set->m_count, set->m_vertices);
    std::copy_n(Vectors(block->polygon.normals), set->m_count, set->m_normals);
    set->m_centroid.Set(block->mass.centroid.x, block->mass.centroid.y);
    bmr_convex32_destroy(block, registry::GetAllocator());
    return AreaOf(set->m_count, [set](int32 i) { return set->m_vertices[i]; }) > b2_epsilon
               ? BMR_OK
               : BMR_ERROR_OUT_OF_RANGE;
}

bmr_error MakeStockPolygon(b2PolygonShape *set, const b2Vec2 *points, int32 count, bool mayWeld,
                           Welded *welded) {
    WeldedPoints left;
    for (int32 i = 0; i < count; ++i) {
        if (!points[i].IsValid())
            return BMR_ERROR_NOT_FINITE;
        left.Add(points[i]);
    }
    if (left.welded.count > 0 && (!mayWeld || (left.count < 3 && left.welded.distance > 0.0f)))
        return BMR_ERROR_TOO_CLOSE;
    if (left.count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    welded->count += left.welded.count;
    welded->distance = left.welded.distance;
    const Outcome outcome = OutcomeOfSet(left.points, left.count);
    if (outcome != Outcome::Polygon) {
        const bmr_error error = MakeHull(set, left.points, left.count);
        return error != BMR_OK && outcome == Outcome::NoArea ? BMR_ERROR_OUT_OF_RANGE : error;
    }
    set->Set(points, count);
    if (set->m_count < 3)
        return BMR_ERROR_TOO_CLOSE; // Box2D 2.4.2 welds over longer ways, and leaves out what is nearly on a
                                    // line
    return IsFinite(*set) ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
}

/// Which vertex of Set's polygon is the first of these; -1 where Set keeps others or another order.
int32 FindFirst(const b2PolygonShape &set, const b2Vec2 *vertices, int32 count) {
    if (set.m_count != count)
        return -1;
    int32 first = 0;
    while (!(set.m_vertices[first] == vertices[0]))
        ++first;
    for (int32 i = 0; i < count; ++i)
        if (!(set.m_vertices[(first + i) % count] == vertices[i]))
            return -1;
    return first;
}

} // namespace

void ConvexShape::TakeSmall(const b2PolygonShape &small, int32 first) {
    const uint32_t old = GetKeptHandle();
    for (int32 i = 0; i < small.m_count; ++i) {
        const int32 from = (first + i) % small.m_count;
        m_vertices[i] = small.m_vertices[from];
        m_normals[i] = small.m_normals[from];
    }
    m_count = small.m_count;
    m_centroid = small.m_centroid;
    SetHandle(0);
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
    return SetHull(points, count, Weld::Allowed, nullptr);
}

bmr_error ConvexShape::Set(const b2Vec2 *points, int32 count, Welded *welded) {
    return welded != nullptr ? SetHull(points, count, Weld::Allowed, welded) : BMR_ERROR_NULL_ARGUMENT;
}

bmr_error ConvexShape::SetHull(const b2Vec2 *points, int32 count, Weld weld, Welded *welded) {
    if (points == nullptr)
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
            if (error == BMR_OK && welded != nullptr)
                *welded = found;
            return error;
        }
        points = Vectors(block->polygon.vertices);
        count = static_cast<int32>(block->polygon.count);
    }
    b2PolygonShape set;
    const bmr_error error = MakeStockPolygon(&set, points, count, weld == Weld::Allowed, &found);
    if (error == BMR_OK)
        TakeSmall(set, 0);
    if (error == BMR_OK && welded != nullptr)
        *welded = found;
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
    b2PolygonShape set;
    Welded welded; // none
    const bmr_error error = MakeStockPolygon(&set, vertices, count, false, &welded);
    if (error != BMR_OK)
        return error;
    const int32 first = FindFirst(set, vertices, count);
    if (first < 0)
        return BMR_ERROR_NOT_CONVEX;
    TakeSmall(set, first);
    return BMR_OK;
}

bmr_error ConvexShape::SetAsBox(float halfWidth, float halfHeight) {
    if (!std::isfinite(halfWidth) || !std::isfinite(halfHeight))
        return BMR_ERROR_NOT_FINITE;
    if (!(halfWidth > 0.0f && halfHeight > 0.0f))
        return BMR_ERROR_OUT_OF_RANGE;
    b2PolygonShape box;
    box.SetAsBox(halfWidth, halfHeight);
    TakeSmall(box, 0);
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

// SetEllipse, SetRounded and Simplify compute points, of which SetHull takes the hull.

namespace {

/// Points that are added up to a number that is known.
class Points {
public:
    explicit Points(int32 most) : m_points(static_cast<size_t>(most)) {}

    /// nullptr without memory.
    b2Vec2 *Get() { return m_points.Get(); }
    int32 GetCount() const { return m_count; }

    /// A point that equals the last one is not added again.
    void Add(double x, double y) {
        const b2Vec2 point(static_cast<float>(x), static_cast<float>(y));
        if (m_count == 0 || !(point == Get()[m_count - 1]))
            Get()[m_count++] = point;
    }
    /// Likewise of the last and the first.
    void Close() {
        if (m_count > 1 && Get()[m_count - 1] == Get()[0])
            --m_count;
    }

private:
    registry::Array<b2Vec2> m_points;
    int32 m_count = 0;
};

struct Direction {
    double x, y;
};

/// Of a whole turn `i` parts in `count`: exact at the quarters, and the same in each quarter.
Direction PartOfTurn(int64_t i, int64_t count) {
    const int64_t quarter = 4 * i / count, rest = 4 * i % count;
    const double angle = static_cast<double>(rest) / static_cast<double>(count) * 1.57079632679489661923;
    Direction direction = {std::cos(angle), std::sin(angle)};
    for (int64_t turn = 0; turn < quarter % 4; ++turn)
        direction = {-direction.y, direction.x};
    return direction;
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
    return SetHull(points.Get(), points.GetCount(), Weld::Refused, nullptr);
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
    return SetHull(points.Get(), points.GetCount(), Weld::Refused, nullptr);
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
    return SetHull(points.Get(), static_cast<int32>(left), Weld::Refused, nullptr);
}

} // namespace bmr
