// SPDX-License-Identifier: MIT
// The plugin's polygons in float. What is kept of the points is convex by rational arithmetic and near to all
// of them; what is asked of it has the bits of a loop over all vertices.
#include <algorithm>
#include <cmath>
#include <vector>

#include "bytes.h"
#include "convex32/convex32.h"
#include "convex32_reference.h"
#include "exact.h"
#include "exact_distance.h"
#include "harness.h"
#include "points.h"

namespace {

constexpr size_t kMost = 300;
/// A vertex that turns by some 1e-7 may be dropped; of all that are, the farthest is less than this outside,
/// in parts of the polygon's size. A hull thinner than that may be refused.
constexpr long double kThin = 1e-6L;

using Points = std::vector<bmr_vec32>;

bmr_vec2 Wide(bmr_vec32 v) {
    return {double{v.x}, double{v.y}};
}

std::vector<bmr_vec2> Wide(const Points &points) {
    std::vector<bmr_vec2> wide;
    for (const bmr_vec32 v : points)
        wide.push_back(Wide(v));
    return wide;
}

bool Same(bmr_vec32 a, bmr_vec32 b) {
    return a.x == b.x && a.y == b.y;
}

float Narrow(double value) {
    if (std::isfinite(value) && std::fabs(value) > double{FLT_MAX})
        return value > 0.0 ? FLT_MAX : -FLT_MAX;
    return static_cast<float>(value);
}

bmr_vec32 ReadVector(fuzz_bytes *bytes) {
    const float x = Narrow(fuzz_number(bytes));
    return {x, Narrow(fuzz_number(bytes))};
}

struct Box {
    bool finite = true, inRange = true;
    double side = 0.0; ///< the larger one
};

Box BoxOf(const Points &points) {
    Box box;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const bmr_vec32 v : points) {
        const double p[2] = {double{v.x}, double{v.y}};
        for (int i = 0; i < 2; ++i) {
            box.finite = box.finite && std::isfinite(p[i]);
            box.inRange = box.inRange && std::fabs(p[i]) <= BMR_MAX_COORDINATE;
            low[i] = std::fmin(low[i], p[i]);
            high[i] = std::fmax(high[i], p[i]);
        }
    }
    if (!points.empty())
        box.side = std::max(high[0] - low[0], high[1] - low[1]);
    return box;
}

/// The width of the hull of finite points, in some direction between two of them that are far apart: no less
/// than its true width, no more than some times it.
long double WidthAcross(const Points &points) {
    size_t far = 0, other = 0;
    const auto gap = [&points](size_t i, size_t j) {
        return std::hypot(static_cast<long double>(points[i].x) - points[j].x,
                          static_cast<long double>(points[i].y) - points[j].y);
    };
    for (size_t i = 0; i < points.size(); ++i)
        far = gap(i, 0) > gap(far, 0) ? i : far;
    for (size_t i = 0; i < points.size(); ++i)
        other = gap(i, far) > gap(other, far) ? i : other;
    const long double length = gap(far, other);
    const long double ex = static_cast<long double>(points[far].x) - points[other].x;
    const long double ey = static_cast<long double>(points[far].y) - points[other].y;
    long double low = 0.0L, high = 0.0L;
    for (const bmr_vec32 p : points) {
        const long double px = static_cast<long double>(p.x) - points[other].x;
        const long double py = static_cast<long double>(p.y) - points[other].y;
        const long double off = length > 0.0L ? (ex * py - ey * px) / length : 0.0L;
        low = std::min(low, off);
        high = std::max(high, off);
    }
    return high - low;
}

/// Are area and inertia numbers that float has?
bool HasMass(const Points &points) {
    const long double side = BoxOf(points).side, across = WidthAcross(points);
    return side * across > 1e-35L && side * across * side * side > 1e-34L;
}

void CheckRefusal(const Points &points, bmr_error error) {
    const Box box = BoxOf(points);
    if (fuzz_control("refusal"))
        error = error == BMR_OK ? BMR_ERROR_NOT_FINITE : BMR_OK;
    if (points.size() < 3)
        FUZZ_CHECK(error == BMR_ERROR_TOO_FEW_POINTS, "%zu points: error %d", points.size(), error);
    else if (!box.finite)
        FUZZ_CHECK(error == BMR_ERROR_NOT_FINITE, "not finite: error %d", error);
    else if (!box.inRange)
        FUZZ_CHECK(error == BMR_ERROR_OUT_OF_RANGE, "too large: error %d", error);
    else if (error == BMR_ERROR_TOO_FEW_POINTS)
        FUZZ_CHECK(WidthAcross(points) <= kThin * box.side, "refused as thin: %Lg of %g", WidthAcross(points),
                   box.side);
    else if (error == BMR_ERROR_OUT_OF_RANGE)
        FUZZ_CHECK(box.side < BMR_MIN_SIDE || !HasMass(points), "refused as small: %Lg by %g",
                   WidthAcross(points), box.side);
    else
        FUZZ_CHECK(error == BMR_OK, "refused with error %d", error);
    FUZZ_CHECK(error != BMR_OK || box.side >= BMR_MIN_SIDE, "taken though it is small: %g", box.side);
}

/// All that the header promises of a polygon made.
void CheckPolygon(const bmr_convex32_block *block) {
    const bmr_convex32 *p = &block->polygon;
    const std::vector<bmr_vec2> vertices = Wide(Points(p->vertices, p->vertices + p->count));
    FUZZ_CHECK(exact::IsConvex(vertices), "%u vertices are not convex", p->count);
    bmr_vec32 extent = {0.0f, 0.0f};
    for (uint32_t i = 0; i < p->count; ++i) {
        const uint32_t j = (i + 1) % p->count;
        const bmr_vec2 m = Wide(p->normals[i]), v = vertices[i], w = vertices[j];
        FUZZ_CHECK(!Same(p->normals[i], p->normals[j]), "normals %u and %u are one", i, j);
        const double ex = w.x - v.x, ey = w.y - v.y, length = std::hypot(ex, ey);
        FUZZ_CHECK(std::fabs(m.x * length - ey) <= 1e-7 * length &&
                       std::fabs(m.y * length + ex) <= 1e-7 * length,
                   "normal %u is none of its edge", i);
        extent.x = std::fmax(extent.x, std::fabs(p->vertices[i].x));
        extent.y = std::fmax(extent.y, std::fabs(p->vertices[i].y));
        FUZZ_CHECK(v.x * v.x + v.y * v.y <= double{block->reach} * double{block->reach},
                   "vertex %u is out of reach", i);
    }
    FUZZ_CHECK(Same(p->extent, extent), "the extent is (%g, %g)", double{p->extent.x}, double{p->extent.y});
    const loop_mass mass = loop_measure(p);
    const long double size = block->reach, slack = fuzz_control("mass") ? -1.0L : 1e-7L;
    FUZZ_CHECK(std::fabs(block->mass.area - mass.area) <= slack * mass.area + FLT_MIN, "area %g, really %Lg",
               double{block->mass.area}, mass.area);
    FUZZ_CHECK(std::fabs(block->mass.inertia - mass.inertia) <= slack * mass.inertia + FLT_MIN,
               "inertia %g, really %Lg", double{block->mass.inertia}, mass.inertia);
    FUZZ_CHECK(std::fabs(block->mass.centroid.x - mass.x) <= 1e-7L * size + FLT_MIN &&
                   std::fabs(block->mass.centroid.y - mass.y) <= 1e-7L * size + FLT_MIN,
               "the centroid is off");
}

/// Of the points: vertices are some of them, from the rightmost on, and the rest is inside or hardly outside.
void CheckHull(const Points &points, const bmr_convex32 *p) {
    const long double size = BoxOf(points).side;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 v = p->vertices[i];
        FUZZ_CHECK(std::any_of(points.begin(), points.end(), [v](bmr_vec32 q) { return Same(q, v); }),
                   "vertex (%a, %a) is none of the points", double{v.x}, double{v.y});
        FUZZ_CHECK(i == 0 || v.x < p->vertices[0].x || (v.x == p->vertices[0].x && v.y > p->vertices[0].y),
                   "the first vertex is not the rightmost");
    }
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 v = Wide(p->vertices[i]), w = Wide(p->vertices[(i + 1) % p->count]);
        const long double ex = static_cast<long double>(w.x) - v.x, ey = static_cast<long double>(w.y) - v.y;
        const long double allowed = kThin * size * std::hypot(ex, ey);
        long double most = 0.0L;
        for (const bmr_vec32 q : points)
            most = std::max(most, ey * (q.x - static_cast<long double>(v.x)) -
                                      ex * (q.y - static_cast<long double>(v.y)));
        FUZZ_CHECK(most <= allowed, "a point is %Lg of the size outside", most / allowed * kThin);
    }
}

/// Vertices kept to the bit, or a reason that rational arithmetic sees as well.
void CheckRaw(const Points &points) {
    bmr_convex32_block *raw = nullptr;
    const bmr_error error = bmr_convex32_create_raw(points.data(), points.size(), nullptr, &raw);
    const std::vector<bmr_vec2> wide = Wide(points);
    const Box box = BoxOf(points);
    if (error == BMR_OK) {
        FUZZ_CHECK(raw->polygon.count == points.size() &&
                       std::equal(points.begin(), points.end(), raw->polygon.vertices, Same),
                   "raw vertices were changed");
        CheckPolygon(raw);
        bmr_convex32_destroy(raw, nullptr);
    } else if (error != BMR_ERROR_NOT_CONVEX) {
        FUZZ_CHECK(error != BMR_ERROR_TOO_FEW_POINTS || points.size() < 3, "raw: too few points");
        CheckRefusal(points, error);
    } else {
        FUZZ_CHECK(points.size() >= 3 && box.finite && box.inRange && box.side >= BMR_MIN_SIDE,
                   "not convex, but for another reason");
        if (!exact::IsConvex(wide))
            return;
        // Then some vertex must turn by no more than floats can tell.
        bool straight = false;
        for (size_t i = 0; i < wide.size(); ++i) {
            const bmr_vec2 a = wide[i], b = wide[(i + 1) % wide.size()], c = wide[(i + 2) % wide.size()];
            const long double ux = static_cast<long double>(b.x) - a.x,
                              uy = static_cast<long double>(b.y) - a.y;
            const long double vx = static_cast<long double>(c.x) - b.x,
                              vy = static_cast<long double>(c.y) - b.y;
            straight =
                straight || std::fabs(ux * vy - uy * vx) <= 3e-7L * std::hypot(ux, uy) * std::hypot(vx, vy);
        }
        FUZZ_CHECK(straight, "%zu convex vertices were refused", points.size());
    }
}

void CheckSupport(const bmr_convex32 *p, fuzz_bytes *bytes) {
    const bmr_vec32 d = ReadVector(bytes);
    const uint32_t hint = fuzz_u16(bytes);
    uint32_t answers[2] = {bmr_convex32_support(p, d), bmr_convex32_support_from(p, d, hint)};
    if (fuzz_control("support"))
        answers[1] = (answers[1] + 1 + p->count / 2) % p->count;
    const float most = loop_support(p, d);
    for (const uint32_t i : answers) {
        FUZZ_CHECK(i < p->count, "no such vertex: %u", i);
        if (std::isnan(d.x) || std::isnan(d.y) || (d.x == 0.0f && d.y == 0.0f))
            FUZZ_CHECK(i == 0, "no direction: vertex %u", i);
        else if (std::isfinite(most))
            FUZZ_CHECK(p->vertices[i].x * d.x + p->vertices[i].y * d.y == most,
                       "support in (%a, %a): vertex %u", double{d.x}, double{d.y}, i);
    }
}

/// Anywhere, or by a byte a vertex, or between two.
bmr_vec32 ReadPoint(const bmr_convex32 *p, fuzz_bytes *bytes) {
    const uint8_t how = fuzz_u8(bytes);
    if (how % 4 == 0)
        return ReadVector(bytes);
    const bmr_vec32 a = p->vertices[fuzz_u8(bytes) % p->count];
    const bmr_vec32 b = how % 4 == 1 ? p->vertices[fuzz_u8(bytes) % p->count] : p->vertices[0];
    const double t = how % 4 == 3 ? fuzz_in(bytes, -4.0, 5.0) : fuzz_in(bytes, 0.0, 1.0);
    return {static_cast<float>(a.x + t * (double{b.x} - a.x)),
            static_cast<float>(a.y + t * (double{b.y} - a.y))};
}

void CheckContains(const bmr_convex32 *p, fuzz_bytes *bytes) {
    const bmr_vec32 q = ReadPoint(p, bytes);
    const bool holds = bmr_convex32_contains(p, q) != fuzz_control("contains");
    FUZZ_CHECK(holds == loop_contains(p, q), "(%a, %a): held %d", double{q.x}, double{q.y}, holds);
}

void CheckRay(const bmr_convex32 *p, fuzz_bytes *bytes) {
    const bmr_vec32 p1 = ReadPoint(p, bytes), p2 = ReadPoint(p, bytes);
    const float most = fuzz_u8(bytes) % 2 == 0 ? 1.0f : Narrow(fuzz_number(bytes));
    float expected = -1.0f, fraction = -1.0f;
    uint32_t edgeExpected = UINT32_MAX, edge = UINT32_MAX;
    const bool hit = loop_ray(p, p1, p2, most, UINT32_MAX, &expected, &edgeExpected);
    const bool ours = bmr_convex32_ray(p, p1, p2, most, &fraction, &edge) != fuzz_control("ray");
    FUZZ_CHECK(ours == hit, "ray (%a, %a) to (%a, %a), %a: hit %d", double{p1.x}, double{p1.y}, double{p2.x},
               double{p2.y}, double{most}, ours);
    if (!hit)
        FUZZ_CHECK(fraction == -1.0f && edge == UINT32_MAX, "a miss wrote its outputs");
    else
        FUZZ_CHECK(
            (fraction == expected || (std::isnan(fraction) && std::isnan(expected))) && edge == edgeExpected,
            "ray (%a, %a) to (%a, %a), %a: %a of edge %u, expected %a of %u", double{p1.x}, double{p1.y},
            double{p2.x}, double{p2.y}, double{most}, double{fraction}, edge, double{expected}, edgeExpected);
}

void CheckBox(const bmr_convex32 *p, fuzz_bytes *bytes) {
    const float angle = static_cast<float>(fuzz_in(bytes, -4.0, 4.0));
    const bmr_transform32 pose = {ReadVector(bytes), std::sin(angle), std::cos(angle)};
    if (!std::isfinite(pose.p.x) || !std::isfinite(pose.p.y))
        return;
    bmr_vec32 low, high, lower, upper;
    loop_box(p, &pose, &low, &high);
    bmr_convex32_box(p, &pose, &lower, &upper);
    if (fuzz_control("box"))
        upper.y = std::nextafter(upper.y, 0.0f);
    FUZZ_CHECK(Same(lower, low) && Same(upper, high), "the box differs");
}

/// How far one is from the loop of the first `count` points at most.
double FarthestVertex(const bmr_convex32 *p, const Points &loop, size_t count) {
    long double far = 0.0L;
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i)
        points.push_back({loop[i].x, loop[i].y});
    const exact::Posed wide = exact::PosedOf(points, bmr_pose_identity());
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 vertex = {p->vertices[i].x, p->vertices[i].y};
        far = std::max(far, exact::SignedDistance(exact::PosedOf(vertex), wide));
    }
    return static_cast<double>(far);
}

void CheckFewer(const bmr_convex32_block *block, fuzz_bytes *bytes) {
    const bmr_convex32 *p = &block->polygon;
    const uint32_t wanted = std::min(3u + fuzz_below(bytes, 6), p->count);
    uint32_t inner[9];
    inner[wanted] = 12345;
    bmr_convex32_inner(p, inner, wanted);
    for (uint32_t i = 0; i < wanted; ++i)
        FUZZ_CHECK(inner[i] < p->count && (i == 0 || inner[i - 1] < inner[i]),
                   "inner vertices do not ascend");
    FUZZ_CHECK(inner[wanted] == 12345, "inner vertices past their count");
    const float tolerance = fuzz_u8(bytes) % 2 == 0
                                ? block->reach * std::exp2(static_cast<float>(fuzz_in(bytes, -24.0, 1.0)))
                                : Narrow(fuzz_number(bytes));
    Points points(p->count);
    size_t count = 0;
    const bmr_error error = bmr_convex32_simplify(p, tolerance, nullptr, points.data(), &count);
    if (std::isnan(tolerance) || tolerance < 0.0f) {
        FUZZ_CHECK(error == (std::isnan(tolerance) ? BMR_ERROR_NOT_FINITE : BMR_ERROR_NEGATIVE) && count == 0,
                   "simplify by %g: error %d", double{tolerance}, error);
        return;
    }
    FUZZ_CHECK(error == BMR_OK && count >= 3 && count <= p->count, "simplify by %g: error %d, %zu vertices",
               double{tolerance}, error, count);
    const double allowed = fuzz_control("simplify") ? -1.0 : double{tolerance} * (1.0 + 1e-9);
    points.resize(count);
    const double far = FarthestVertex(p, points, count), rounding = 1e-15 * double{block->reach};
    FUZZ_CHECK(far <= allowed + rounding, "a vertex is %g away, allowed %g", far, allowed);
    const bmr_vec32 *at = p->vertices, *const end = at + p->count;
    for (const bmr_vec32 v : points)
        FUZZ_CHECK((at = std::find_if(at, end, [v](bmr_vec32 q) { return Same(q, v); })) != end,
                   "not the polygon's vertices in order");
    // None of them can be left out but the one that the others are counted from.
    const double within = double{tolerance} * (fuzz_control("needless") ? 1e6 : 1.0 - 1e-6) - rounding;
    size_t needless = 0;
    for (size_t i = 0; i < count && count > 3 && count < 64; ++i) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        needless += FarthestVertex(p, points, count - 1) < within;
    }
    FUZZ_CHECK(needless <= 1, "%zu of %zu vertices are needless", needless, count);
}

} // namespace

void FuzzPolygon32(fuzz_bytes *bytes); // of fuzz_polygon.cpp

void FuzzPolygon32(fuzz_bytes *bytes) {
    const uint8_t first = fuzz_u8(bytes), questions = first % 16;
    std::vector<bmr_vec2> wide(FUZZ_POINTS(kMost));
    wide.resize(fuzz_points(bytes, wide.data(), kMost));
    Points points;
    for (const bmr_vec2 p : wide)
        points.push_back({Narrow(p.x), Narrow(p.y)});
    if (first >= 240) // two far away, the others together
        for (size_t i = 0; i < points.size(); ++i) {
            const float size = std::fmax(std::fabs(points[i].x), std::fabs(points[i].y));
            const float scale = i < 2 && size > 0.0f ? 0x1p29f / size : 0x1p-24f;
            points[i].x *= scale;
            points[i].y *= scale;
        }
    CheckRaw(points);
    bmr_convex32_block *block = nullptr;
    const bmr_error error = bmr_convex32_create(points.data(), points.size(), nullptr, &block);
    CheckRefusal(points, error);
    FUZZ_CHECK((error == BMR_OK) == (block != nullptr), "error %d and a polygon %p", error,
               static_cast<const void *>(block));
    if (error != BMR_OK)
        return;
    CheckPolygon(block);
    CheckHull(points, &block->polygon);
    // From any vertex on it stays what it is.
    Points kept(block->polygon.vertices, block->polygon.vertices + block->polygon.count);
    std::rotate(kept.begin(), kept.begin() + questions % static_cast<int>(kept.size()), kept.end());
    bmr_convex32_block *again = nullptr;
    FUZZ_CHECK(bmr_convex32_create_raw(kept.data(), kept.size(), nullptr, &again) == BMR_OK &&
                   std::equal(kept.begin(), kept.end(), again->polygon.vertices, Same),
               "not taken as it was made");
    bmr_convex32_destroy(again, nullptr);
    for (uint8_t i = 0; i < questions; ++i)
        switch (fuzz_below(bytes, 5)) {
        case 0:
            CheckSupport(&block->polygon, bytes);
            break;
        case 1:
            CheckContains(&block->polygon, bytes);
            break;
        case 2:
            CheckRay(&block->polygon, bytes);
            break;
        case 3:
            CheckBox(&block->polygon, bytes);
            break;
        default:
            CheckFewer(block, bytes);
        }
    bmr_convex32_destroy(block, nullptr);
}
