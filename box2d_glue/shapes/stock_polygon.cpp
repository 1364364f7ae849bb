// SPDX-License-Identifier: MIT
#include "shapes/stock_polygon.h"

#include <cmath>
#include <cstring>

#include "base/rounding_mode.h"
#include "shapes/convex_registry.h"
#include "shapes/shapes32.h"

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

/// Set's polygon with vertex `first` as the first.
void Take(b2PolygonShape *shape, const b2PolygonShape &set, int32 first) {
    for (int32 i = 0; i < set.m_count; ++i) {
        const int32 from = (first + i) % set.m_count;
        shape->m_vertices[i] = set.m_vertices[from];
        shape->m_normals[i] = set.m_normals[from];
    }
    shape->m_count = set.m_count;
    shape->m_centroid = set.m_centroid;
}

/// The exact hull, of points where Set finds none.
bmr_error MakeHull(b2PolygonShape *set, const b2Vec2 *points, int32 count) {
    const NearestRounding nearest;
    const bmr_allocator *allocator = registry::GetAllocator();
    bmr_convex32_block *block = nullptr;
    const bmr_error error =
        bmr_convex32_create(Vectors32(points), static_cast<size_t>(count), allocator, &block);
    if (error != BMR_OK)
        return error;
    set->m_count = static_cast<int32>(block->polygon.count);
    std::memcpy(static_cast<void *>(set->m_vertices), block->polygon.vertices,
                block->polygon.count * sizeof(b2Vec2));
    std::memcpy(static_cast<void *>(set->m_normals), block->polygon.normals,
                block->polygon.count * sizeof(b2Vec2));
    set->m_centroid.Set(block->mass.centroid.x, block->mass.centroid.y);
    bmr_convex32_destroy(block, allocator);
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

} // namespace

bmr_error SetStockPolygon(b2PolygonShape *shape, const b2Vec2 *points, int32 count, bool mayWeld,
                          Welded *welded) {
    b2PolygonShape set;
    const bmr_error error = MakeStockPolygon(&set, points, count, mayWeld, welded);
    if (error == BMR_OK)
        Take(shape, set, 0);
    return error;
}

bmr_error SetStockPolygonRaw(b2PolygonShape *shape, const b2Vec2 *vertices, int32 count) {
    b2PolygonShape set;
    Welded welded; // none
    const bmr_error error = MakeStockPolygon(&set, vertices, count, false, &welded);
    if (error != BMR_OK)
        return error;
    if (set.m_count != count)
        return BMR_ERROR_NOT_CONVEX;
    int32 first = 0; // which of Set's vertices is the caller's first
    while (!(set.m_vertices[first] == vertices[0]))
        ++first;
    for (int32 i = 0; i < count; ++i)
        if (!(set.m_vertices[(first + i) % count] == vertices[i]))
            return BMR_ERROR_NOT_CONVEX;
    Take(shape, set, first);
    return BMR_OK;
}

} // namespace bmr
