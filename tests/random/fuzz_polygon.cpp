// SPDX-License-Identifier: MIT
// Polygons from raw bytes. Whatever is accepted is what the header promises, by rational arithmetic; whatever
// is refused has the reason that is given; what is asked of it is what a loop over all vertices finds.

#include <algorithm>
#include <cmath>

#include "boomerang/polygon.h"
#include "bytes.h"
#include "exact.h"
#include "geometry/predicates.h"
#include "harness.h"
#include "points.h"

namespace {

constexpr size_t kMost = 300;

using Points = std::vector<bmr_vec2>;

bool Same(bmr_vec2 a, bmr_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/// Is the error the one that the header gives for such points? Of raw vertices equal ones are not made one.
void CheckRefusal(const Points &points, bool raw, bmr_error error) {
    bool finite = true, inRange = true;
    bmr_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (const bmr_vec2 &p : points) {
        finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
        inRange = inRange && std::fabs(p.x) <= BMR_MAX_COORDINATE && std::fabs(p.y) <= BMR_MAX_COORDINATE;
        low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y)};
        high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y)};
    }
    bmr_error expected = BMR_OK;
    if (points.empty())
        expected = BMR_ERROR_NO_POINTS;
    else if (points.size() > BMR_MAX_VERTICES)
        expected = BMR_ERROR_TOO_MANY_POINTS;
    else if (!finite)
        expected = BMR_ERROR_NOT_FINITE;
    else if (!inRange)
        expected = BMR_ERROR_OUT_OF_RANGE;
    else if (raw ? points.size() > 1 : !Same(low, high)) {
        // An extent that rounds to the least one may be either.
        const long double side =
            std::max(static_cast<long double>(high.x) - low.x, static_cast<long double>(high.y) - low.y);
        const long double least = BMR_MIN_SIDE;
        if (side < least)
            expected = error == BMR_OK && side >= least * (1.0L - 0x1p-52L) ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
    }
    if (fuzz_control("refusal"))
        error = error == BMR_OK ? BMR_ERROR_NOT_FINITE : BMR_OK;
    FUZZ_CHECK(error == expected, "%zu points: error %d, expected %d", points.size(), error, expected);
}

/// Of any three finite points, also such as no polygon takes.
void CheckOrientations(const Points &points) {
    for (size_t i = 2; i < points.size(); ++i) {
        const bmr_vec2 a = points[i - 2], b = points[i - 1], c = points[i];
        if (!std::isfinite(a.x + a.y) || !std::isfinite(b.x + b.y) || !std::isfinite(c.x + c.y))
            continue;
        const double plain = bmr_cross(bmr_sub(b, a), bmr_sub(c, a));
        const int turn =
            fuzz_control("orientation") ? (plain > 0.0) - (plain < 0.0) : bmr_orientation(a, b, c);
        FUZZ_CHECK(turn == exact::Orientation(a, b, c), "orientation %d of (%a, %a), (%a, %a), (%a, %a)",
                   turn, a.x, a.y, b.x, b.y, c.x, c.y);
    }
}

/// What bmr_polygon has besides its vertices.
void CheckMeasures(const bmr_polygon *polygon) {
    const uint32_t n = polygon->count;
    double extent = 0.0;
    const mpq_class square = mpq_class(polygon->radius) * mpq_class(polygon->radius);
    FUZZ_CHECK(polygon->lowest < n && polygon->highest < n, "lowest %u, highest %u", polygon->lowest,
               polygon->highest);
    const bmr_vec2 low = polygon->vertices[polygon->lowest], high = polygon->vertices[polygon->highest];
    for (uint32_t i = 0; i < n; ++i) {
        const bmr_vec2 v = polygon->vertices[i];
        extent = std::fmax(extent, std::fmax(std::fabs(v.x), std::fabs(v.y)));
        FUZZ_CHECK(low.y < v.y || (low.y == v.y && low.x <= v.x), "vertex %u is below the lowest", i);
        FUZZ_CHECK(high.y > v.y || (high.y == v.y && high.x >= v.x), "vertex %u is above the highest", i);
        const mpq_class dx = mpq_class(v.x) - mpq_class(polygon->center.x);
        const mpq_class dy = mpq_class(v.y) - mpq_class(polygon->center.y);
        FUZZ_CHECK(dx * dx + dy * dy <= square, "vertex %u is outside the disk", i);
        const bmr_vec2 m = bmr_polygon_normal(polygon, i), w = polygon->vertices[i + 1 < n ? i + 1 : 0];
        FUZZ_CHECK(std::fabs(std::hypot(m.x, m.y) - 1.0) < 1e-15, "normal %u has no unit length", i);
        const long double ex = static_cast<long double>(w.x) - v.x, ey = static_cast<long double>(w.y) - v.y;
        FUZZ_CHECK(n == 1 || (std::fabs(m.x * ex + m.y * ey) <= 1e-15L * std::hypot(ex, ey) &&
                              m.x * ey - m.y * ex > 0.0L),
                   "normal %u is none of its edge", i);
    }
    FUZZ_CHECK(extent == polygon->extent, "extent %g, really %g", polygon->extent, extent);
    FUZZ_CHECK(bmr_polygon_audit(polygon) == BMR_OK, "audit: %s",
               bmr_error_describe(bmr_polygon_audit(polygon)));
}

/// The hull of the points, exactly: vertices are points of them, strictly convex, and hold all.
void CheckHull(const Points &points, const bmr_polygon *polygon) {
    Points hull(polygon->vertices, polygon->vertices + polygon->count);
    if (fuzz_control("lost-vertex") && hull.size() > 3)
        hull.pop_back();
    if (fuzz_control("moved-vertex"))
        hull.back().x = std::nextafter(hull.back().x, INFINITY);
    FUZZ_CHECK(hull.size() <= points.size(), "more vertices than points");
    FUZZ_CHECK(exact::IsConvex(hull), "the hull of %zu points is not convex", points.size());
    for (const bmr_vec2 &p : points)
        FUZZ_CHECK(exact::Holds(hull, p), "point (%a, %a) is outside the hull", p.x, p.y);
    for (const bmr_vec2 &v : hull)
        FUZZ_CHECK(std::any_of(points.begin(), points.end(), [&v](bmr_vec2 p) { return Same(p, v); }),
                   "vertex (%a, %a) is none of the points", v.x, v.y);
    FUZZ_CHECK(polygon->lowest == 0, "the first vertex is not the lowest");
}

/// Is the direction one for which the header promises how near the answer is?
bool IsModerate(bmr_vec2 d) {
    const double size = std::fmax(std::fabs(d.x), std::fabs(d.y));
    return size > 1e-290 && size < 1e290;
}

void CheckSupport(const bmr_polygon *polygon, fuzz_bytes *bytes) {
    const double x = fuzz_number(bytes);
    const bmr_vec2 d = {x, fuzz_number(bytes)};
    const uint32_t hint = fuzz_u32(bytes);
    uint32_t answers[2] = {bmr_polygon_support(polygon, d), bmr_polygon_support_from(polygon, d, hint)};
    FUZZ_CHECK(answers[0] < polygon->count && answers[1] < polygon->count, "no such vertex: %u %u",
               answers[0], answers[1]);
    if (std::isnan(d.x) || std::isnan(d.y) || (d.x == 0.0 && d.y == 0.0)) {
        FUZZ_CHECK(answers[1] == hint % polygon->count, "hint %u: vertex %u", hint, answers[1]);
        return;
    }
    if (!IsModerate(d))
        return;
    if (fuzz_control("support"))
        answers[1] = (answers[1] + 1 + polygon->count / 2) % polygon->count;
    long double most = -INFINITY;
    const auto product = [&](uint32_t i) {
        return static_cast<long double>(d.x) * polygon->vertices[i].x +
               static_cast<long double>(d.y) * polygon->vertices[i].y;
    };
    for (uint32_t i = 0; i < polygon->count; ++i)
        most = std::max(most, product(i));
    const long double length = std::hypot(static_cast<long double>(d.x), static_cast<long double>(d.y));
    for (const uint32_t i : answers)
        FUZZ_CHECK(most - product(i) <= 1e-15L * polygon->extent * length,
                   "support in (%a, %a): vertex %u of %u is nearer by %Lg", d.x, d.y, i, polygon->count,
                   most - product(i));
}

/// How far the point is beyond the line of an edge, at most; of a point or a segment its distance.
long double Beyond(const bmr_polygon *polygon, bmr_vec2 p) {
    const bmr_vec2 *v = polygon->vertices;
    const uint32_t n = polygon->count;
    long double most = -INFINITY;
    for (uint32_t i = 0; i < n; ++i) {
        const bmr_vec2 a = v[i], b = v[i + 1 < n ? i + 1 : 0];
        const long double ex = static_cast<long double>(b.x) - a.x, ey = static_cast<long double>(b.y) - a.y;
        const long double px = static_cast<long double>(p.x) - a.x, py = static_cast<long double>(p.y) - a.y;
        const long double length = std::hypot(ex, ey);
        if (n >= 3) {
            most = std::max(most, (ey * px - ex * py) / length);
            continue;
        }
        const long double along = n == 1 ? 0.0L : (px * ex + py * ey) / length;
        const long double t = std::min(std::max(along, 0.0L), length);
        return n == 1 ? std::hypot(px, py) : std::hypot(px - t * ex / length, py - t * ey / length);
    }
    return most;
}

void CheckContains(const bmr_polygon *polygon, fuzz_bytes *bytes) {
    const Points vertices(polygon->vertices, polygon->vertices + polygon->count);
    const bmr_vec2 p = fuzz_point(bytes, vertices.data(), vertices.size());
    const double tolerance = std::fabs(fuzz_number(bytes));
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
    bool holds = bmr_polygon_contains(polygon, p, 0.0);
    if (fuzz_control("contains"))
        holds = !holds;
    if (!finite) {
        FUZZ_CHECK(!holds, "a point that is none is held");
        return;
    }
    FUZZ_CHECK(holds == exact::Holds(vertices, p), "(%a, %a): held %d", p.x, p.y, holds);
    const double size = std::fmax(std::fabs(p.x), std::fabs(p.y)) + polygon->extent;
    if (!(size < 1e150) || !std::isfinite(tolerance))
        return;
    const long double beyond = Beyond(polygon, p), rounding = 1e-14L * size;
    if (std::fabs(beyond - tolerance) > rounding)
        FUZZ_CHECK(bmr_polygon_contains(polygon, p, tolerance) == (beyond < tolerance),
                   "(%a, %a): %Lg beyond, tolerance %g", p.x, p.y, beyond, tolerance);
}

/// As given, in this order: the audit says whether that was right.
void CheckRaw(const Points &points) {
    bmr_polygon *raw = nullptr;
    const bmr_error error = bmr_polygon_create_raw(points.data(), points.size(), nullptr, &raw);
    CheckRefusal(points, true, error);
    if (error != BMR_OK) {
        FUZZ_CHECK(raw == nullptr, "an error wrote a polygon");
        return;
    }
    FUZZ_CHECK(raw->count == points.size() && std::equal(points.begin(), points.end(), raw->vertices, Same),
               "raw vertices were changed");
    const bmr_error audit = bmr_polygon_audit(raw);
    FUZZ_CHECK((audit == BMR_OK) == exact::IsConvex(points), "audit of %zu raw vertices: error %d",
               points.size(), audit);
    bmr_polygon_destroy(raw, nullptr);
}

void FuzzDouble(fuzz_bytes *bytes) {
    const uint8_t questions = fuzz_u8(bytes) % 8;
    Points points(FUZZ_POINTS(kMost));
    points.resize(fuzz_points(bytes, points.data(), kMost));
    CheckOrientations(points);
    CheckRaw(points);
    bmr_polygon *polygon = nullptr;
    const bmr_error error = bmr_polygon_create(points.data(), points.size(), nullptr, &polygon);
    CheckRefusal(points, false, error);
    FUZZ_CHECK((error == BMR_OK) == (polygon != nullptr), "error %d and a polygon %p", error,
               static_cast<const void *>(polygon));
    if (error != BMR_OK)
        return;
    CheckHull(points, polygon);
    CheckMeasures(polygon);
    for (uint8_t i = 0; i < questions; ++i)
        if (fuzz_u8(bytes) % 2 == 0)
            CheckSupport(polygon, bytes);
        else
            CheckContains(polygon, bytes);
    bmr_polygon_destroy(polygon, nullptr);
}

} // namespace

/// The half that makes and asks the plugin's polygons in float (convex32.h): polygon32.cpp.
void FuzzPolygon32(fuzz_bytes *bytes);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    if (fuzz_u8(&bytes) % 2 == 0)
        FuzzDouble(&bytes);
    else
        FuzzPolygon32(&bytes);
    return 0;
}
