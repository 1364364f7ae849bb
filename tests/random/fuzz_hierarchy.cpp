// SPDX-License-Identifier: MIT
// Hierarchies of all kinds over fuzzed polygons: their own audit, what their header promises by brute force
// over all edges and vertices, the inflated envelopes, and the mixed hierarchy of two.
#include <algorithm>
#include <cmath>
#include <vector>

#include "boomerang/inflated.h"
#include "bytes.h"
#include "exact_distance.h"
#include "harness.h"
#include "hierarchies.h"
#include "hierarchy/mixed.h"
#include "hierarchy/tree.h"
#include "motions.h" // test_distance
#include "points.h"

namespace {

constexpr size_t kMost = 64;
/// Some ten roundings of 1.1e-16 each, and the same again: what the audit allows.
constexpr double kRounding = 4e-15;
/// Edges whose directions agree so far are one (hierarchy.h).
constexpr double kMergeAngle = 1e-11;

using Points = std::vector<bmr_vec2>;

double Slack(const bmr_hierarchy *h) {
    return kRounding * bmr_hierarchy_polygon(h)->extent;
}

bool Same(bmr_corner a, bmr_corner b) {
    return a.before == b.before && a.after == b.after && a.cut == b.cut;
}

uint32_t CeilLog2(uint32_t n) {
    uint32_t log = 0;
    while ((uint64_t{1} << log) < n)
        ++log;
    return log;
}

/// The bounds that the paper has of a kind; another kind has those of its row alone, which its audit asks.
void CheckSizes(const bmr_hierarchy *h) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const uint32_t n = p->count, log = CeilLog2(n), edges = bmr_hierarchy_edge_count(h);
    // Points and segments have four lines too, whatever their number.
    const uint32_t depths[] = {2 * log, CeilLog2(2 * n), log};
    const uint32_t counts[] = {std::max(5 * n, 4u), 2 * n + 4, n + 4};
    const bmr_hierarchy_kind kind = bmr_hierarchy_get_kind(h);
    if (kind <= BMR_HIERARCHY_DOBKIN_KIRKPATRICK) {
        FUZZ_CHECK(bmr_hierarchy_depth(h) <= depths[kind], "kind %d of %u vertices: depth %u", kind, n,
                   bmr_hierarchy_depth(h));
        FUZZ_CHECK(edges <= counts[kind], "kind %d of %u vertices: %u edges", kind, n, edges);
    }
    const double diameter = bmr_inflation_diameter(p), truth = test_diameter(p);
    FUZZ_CHECK(diameter >= truth * (1.0 - 1e-12) && diameter <= truth * 1.1548, "diameter %g, really %g",
               diameter, truth);
    FUZZ_CHECK(n < 64 || bmr_hierarchy_bytes(h) + bmr_polygon_bytes(n) <= 160 * size_t{n}, "%zu bytes for %u",
               bmr_hierarchy_bytes(h), n);
}

void CheckLines(const bmr_hierarchy *h) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id) {
        bmr_line line = bmr_hierarchy_line(h, id);
        if (fuzz_control("line"))
            line.offset -= 3.0 * Slack(h);
        const double most = test_farthest(p->vertices, p->count, line.normal);
        const double touch = bmr_dot(line.normal, p->vertices[bmr_hierarchy_touch(h, id)]);
        FUZZ_CHECK(std::fabs(std::hypot(line.normal.x, line.normal.y) - 1.0) <= 1e-15,
                   "edge %u: no unit normal", id);
        FUZZ_CHECK(std::fabs(most - line.offset) <= Slack(h) && std::fabs(touch - line.offset) <= Slack(h),
                   "kind %d, edge %u is no support line: off by %g and %g", bmr_hierarchy_get_kind(h), id,
                   most - line.offset, touch - line.offset);
        // Neither end of an edge that the polygon has sticks out, not even by rounding.
        const uint32_t first = bmr_hierarchy_touch(h, id), second = (first + 1) % p->count;
        FUZZ_CHECK(!h->nodes[id].wide || (bmr_dot(line.normal, p->vertices[first]) <= line.offset &&
                                          bmr_dot(line.normal, p->vertices[second]) <= line.offset),
                   "edge %u is beyond its line", id);
    }
}

/// From the nearest point of the polygon's border.
bmr_vec2 FromBorder(const bmr_polygon *p, bmr_vec2 x) {
    const exact::Place way = exact::GapOf(exact::PosedOf(p), exact::PosedOf(x)).way;
    return {way.x.get_d(), way.y.get_d()};
}

void CheckHeight(const bmr_hierarchy *h, bmr_edge id) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const bmr_vec2 apex = bmr_hierarchy_apex(h, id);
    const bmr_vec2 way = FromBorder(p, apex);
    const double least = std::hypot(way.x, way.y);
    const double height = bmr_hierarchy_height(h, id) * (fuzz_control("height") ? 1.5 : 1.0);
    FUZZ_CHECK(id < 4 ? height == 0.0 : std::fabs(height - least) <= 2.0 * Slack(h),
               "kind %d, edge %u: height %g, really %g", bmr_hierarchy_get_kind(h), id, height, least);
    if (id < 4)
        return;
    bmr_boomerang b = bmr_hierarchy_boomerang(h, id);
    if (fuzz_control("level"))
        ++b.level;
    FUZZ_CHECK(std::max(bmr_hierarchy_level(h, b.outer_before), bmr_hierarchy_level(h, b.outer_after)) + 1 ==
                   b.level,
               "edge %u of level %u is not between one of the level before", id, b.level);
    for (const bmr_edge child : {b.child_before, b.child_after}) // a part is no higher than the whole
        FUZZ_CHECK(child == BMR_NO_EDGE || bmr_hierarchy_height(h, child) <= least + 3.0 * Slack(h),
                   "edge %u is higher than edge %u", child, id);
}

/// Corners are seen alike from both sides, and turn by 2 pi in all.
void CheckRing(const bmr_hierarchy *h, const std::vector<bmr_corner> &corners, uint32_t level) {
    double turning = fuzz_control("ring") ? 1.0 : 0.0;
    for (const bmr_corner &corner : corners) {
        FUZZ_CHECK(Same(corner, bmr_hierarchy_corner_before(h, corner.after, level)) &&
                       Same(corner, bmr_hierarchy_corner(h, corner.before, corner.after)),
                   "level %u: the corner before edge %u is another", level, corner.after);
        const bmr_vec2 a = bmr_hierarchy_line(h, corner.before).normal,
                       b = bmr_hierarchy_line(h, corner.after).normal;
        const double turn = std::atan2(bmr_cross(a, b), bmr_dot(a, b));
        FUZZ_CHECK(turn > 0.5 * kMergeAngle, "level %u turns by %g before edge %u", level, turn,
                   corner.after);
        turning += turn;
    }
    FUZZ_CHECK(std::fabs(turning - 6.28318530717958647693) < 1e-9, "level %u turns by %g", level, turning);
}

/// The corners of P_level, by walking round.
Points Envelope(const bmr_hierarchy *h, uint32_t level, std::vector<bmr_corner> *corners) {
    Points points;
    bmr_edge edge = 0;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(h, edge, level);
        FUZZ_CHECK(points.size() < bmr_hierarchy_edge_count(h), "level %u does not close", level);
        points.push_back(bmr_hierarchy_corner_point(h, corner));
        corners->push_back(corner);
        edge = corner.after;
    } while (edge != 0);
    return points;
}

bmr_vec2 ReadDirection(const bmr_hierarchy *h, fuzz_bytes *bytes) {
    const uint8_t how = fuzz_u8(bytes);
    if (how % 4 == 0) { // a tie
        const bmr_edge edge = fuzz_u16(bytes) % bmr_hierarchy_edge_count(h);
        return bmr_hierarchy_line(h, edge).normal;
    }
    const double angle = fuzz_in(bytes, -3.2, 3.2),
                 scale = how % 4 == 1 ? std::ldexp(1.0, fuzz_u8(bytes) - 128) : 1.0;
    return bmr_vec2_make(scale * std::cos(angle), scale * std::sin(angle));
}

/// A level between its neighbours, as seen from a direction, and the ways from one level to another.
void CheckLevel(const bmr_hierarchy *h, fuzz_bytes *bytes) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    const uint32_t depth = bmr_hierarchy_depth(h), level = fuzz_below(bytes, depth + 2);
    std::vector<bmr_corner> corners, outer;
    const Points points = Envelope(h, level, &corners);
    const Points before = level > 0 ? Envelope(h, level - 1, &outer) : Points();
    uint32_t expected = 0;
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id)
        expected += bmr_hierarchy_level(h, id) <= level;
    FUZZ_CHECK(points.size() == expected, "level %u has %zu edges of %u", level, points.size(), expected);
    CheckRing(h, corners, level);
    for (int i = 0; i < 4; ++i) {
        const bmr_vec2 d = ReadDirection(h, bytes);
        const double size = std::hypot(d.x, d.y), slack = Slack(h) * size;
        bmr_corner corner = bmr_hierarchy_extreme(h, d, level);
        if (fuzz_control("extreme"))
            corner = bmr_hierarchy_extreme(h, bmr_neg(d), level);
        const double here = test_farthest(points.data(), static_cast<uint32_t>(points.size()), d);
        const double inside = test_farthest(p->vertices, p->count, d);
        FUZZ_CHECK(bmr_dot(d, bmr_hierarchy_corner_point(h, corner)) >= here - 2.0 * slack,
                   "level %u: the corner is not extreme by %g", level,
                   here - bmr_dot(d, bmr_hierarchy_corner_point(h, corner)));
        FUZZ_CHECK(here >= inside - slack, "level %u cuts into the polygon by %g", level, inside - here);
        FUZZ_CHECK(level < depth || here <= inside + 2.0 * slack + 4.0 * kMergeAngle * p->radius * size,
                   "the deepest level is not the polygon, by %g", here - inside);
        if (level > 0)
            FUZZ_CHECK(here <= test_farthest(before.data(), static_cast<uint32_t>(before.size()), d) + slack,
                       "level %u is not within the one before", level);
        const uint32_t from = fuzz_below(bytes, level + 1);
        FUZZ_CHECK(Same(corner, bmr_hierarchy_refine(h, bmr_hierarchy_extreme(h, d, from), d, level)),
                   "refined from %u to %u it is another corner", from, level);
        if (level > 0)
            FUZZ_CHECK(Same(bmr_hierarchy_coarsen(h, corner, level), bmr_hierarchy_extreme(h, d, level - 1)),
                       "coarsened from %u it is another corner", level);
    }
}

/// A point outside, near or far, and the direction from the polygon's nearest point to it.
bool ReadOutside(const bmr_polygon *p, fuzz_bytes *bytes, bmr_vec2 *x, bmr_vec2 *away) {
    const double angle = fuzz_in(bytes, -3.2, 3.2), gap = p->radius * std::exp2(fuzz_in(bytes, -20.0, 4.0));
    const bmr_vec2 at = p->vertices[fuzz_u8(bytes) % p->count], u = {std::cos(angle), std::sin(angle)};
    *x = bmr_add(at, bmr_scale(gap, u));
    *away = FromBorder(p, *x);
    return std::hypot(away->x, away->y) > 1e-6 * p->extent && !bmr_polygon_contains(p, *x, 0.0);
}

void CheckInflated(const bmr_hierarchy *h, fuzz_bytes *bytes) {
    const bmr_polygon *p = bmr_hierarchy_polygon(h);
    bmr_vec2 x, away;
    const bool outside = ReadOutside(p, bytes, &x, &away);
    const uint32_t level = fuzz_below(bytes, bmr_hierarchy_depth(h) + 1);
    const double offset = p->radius * std::exp2(fuzz_in(bytes, -20.0, 1.0));
    const double size = p->extent + std::hypot(x.x, x.y), rounding = 1e-13 * size;
    const bmr_vec2 d = bmr_sub(p->vertices[fuzz_u8(bytes) % p->count], x);
    if (d.x == 0.0 && d.y == 0.0)
        return;
    double most = -INFINITY, widest;
    bmr_entry entry = bmr_inflated_entry(h, level, offset, x, d);
    if (fuzz_control("entry"))
        entry.parameter += 1.0;
    FUZZ_CHECK(entry.steps <= level && entry.edge < bmr_hierarchy_edge_count(h), "entry by edge %u, %u steps",
               entry.edge, entry.steps);
    bool found = false;
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id) {
        if (bmr_hierarchy_level(h, id) > level)
            continue;
        const bmr_line line = bmr_hierarchy_line(h, id);
        const double rate = bmr_dot(line.normal, d), above = bmr_dot(line.normal, x) - line.offset;
        most = std::fmax(most, above);
        // At the entry the line is inside every edge, and on one.
        const double there = above - offset + entry.parameter * rate;
        FUZZ_CHECK(rate >= 0.0 || there <= rounding * (1.0 + std::fabs(entry.parameter)),
                   "level %u: at the entry still %g beyond edge %u", level, there, id);
        found = found || (id == entry.edge && rate < 0.0 &&
                          std::fabs(there) <= rounding * (1.0 + std::fabs(entry.parameter)));
    }
    FUZZ_CHECK(found, "level %u: the entry is not on its edge %u", level, entry.edge);
    FUZZ_CHECK(most <= offset + rounding || entry.parameter > 0.0, "level %u: entered before the point",
               level);
    if (outside && most > 1e-9 * size) {
        bmr_corner_widest_edge(h, bmr_hierarchy_extreme(h, away, level), x, &widest);
        if (fuzz_control("widest"))
            widest -= 1e-6 * size;
        FUZZ_CHECK(std::fabs(widest - most) <= 1e-11 * size, "level %u: slack %g, the widest is %g", level,
                   widest, most);
    }
}

void FuzzOne(fuzz_bytes *bytes, const bmr_polygon *p, bmr_hierarchy_kind kind) {
    bmr_hierarchy *h = nullptr;
    const bmr_error error = bmr_hierarchy_build(kind, p, test_compass(), nullptr, &h);
    FUZZ_CHECK(error == BMR_OK, "kind %d of %u vertices: %s", kind, p->count, bmr_error_describe(error));
    FUZZ_CHECK(bmr_hierarchy_audit(h) == BMR_OK, "kind %d of %u vertices: audit %d", kind, p->count,
               bmr_hierarchy_audit(h));
    CheckSizes(h);
    CheckLines(h);
    for (int i = 0; i < 4; ++i)
        CheckHeight(h, fuzz_u16(bytes) % bmr_hierarchy_edge_count(h));
    for (uint32_t questions = fuzz_below(bytes, 6); questions > 0; --questions)
        if (fuzz_u8(bytes) % 2 == 0 || p->count < 3)
            CheckLevel(h, bytes);
        else
            CheckInflated(h, bytes);
    bmr_hierarchy_destroy(h, nullptr);
}

// --- the mixed hierarchy: its tiles fill the outside of the sum, each is a cell of this rotation, and the
// cell found for a point holds it and proves what it claims ---

constexpr size_t kMostOfMixed = 24;

struct Scene {
    const bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2];
    bmr_mixed mixed;
    double size;
};

/// The area of the sum of envelope `level` of A and of B turned by half a turn and the rotation: by mixed
/// volumes.
double EnvelopeArea(const Scene &s, uint32_t level) {
    Points points[2];
    for (int i = 0; i < 2; ++i) {
        bmr_edge edge = 0;
        do {
            const bmr_corner corner = bmr_hierarchy_corner_after(s.hierarchies[i], edge, level);
            const bmr_vec2 p = bmr_hierarchy_corner_point(s.hierarchies[i], corner);
            points[i].push_back(i == 0 ? p
                                       : bmr_vec2_make(s.mixed.s * p.y - s.mixed.c * p.x,
                                                       -s.mixed.s * p.x - s.mixed.c * p.y));
            edge = corner.after;
        } while (edge != 0);
    }
    double area =
        test_area(points[0].data(), points[0].size()) + test_area(points[1].data(), points[1].size());
    for (size_t i = 0; i < points[0].size(); ++i) {
        const bmr_vec2 e = bmr_sub(points[0][(i + 1) % points[0].size()], points[0][i]);
        area += test_farthest(points[1].data(), static_cast<uint32_t>(points[1].size()),
                              bmr_vec2_make(e.y, -e.x));
    }
    return area;
}

void CheckTiling(const Scene &s, const bmr_mixed_tiling *tiling) {
    double tiles = 0.0;
    const uint32_t count = bmr_mixed_tiling_count(tiling);
    for (uint32_t i = 0; i < count; ++i) {
        const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(tiling, i);
        bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
        const size_t n = bmr_mixed_polygon(&s.mixed, cell, corners);
        FUZZ_CHECK(bmr_mixed_exists(&s.mixed, cell), "tile %u is no cell", i);
        FUZZ_CHECK(bmr_mixed_tiling_find(tiling, cell) == i, "tile %u is not found", i);
        FUZZ_CHECK(n >= 3, "tile %u has %zu corners", i, n);
        const double area = test_area(corners, n);
        FUZZ_CHECK(area > -1e-13 * s.size * s.size, "tile %u has area %g", i, area);
        tiles += area;
    }
    if (fuzz_control("area"))
        tiles *= 1.0 + 1e-9;
    const double outer = EnvelopeArea(s, 0), inner = EnvelopeArea(s, 64);
    FUZZ_CHECK(std::fabs(tiles - (outer - inner)) <= 1e-11 * s.size * s.size,
               "the tiles' area is off by %g of %g", tiles - (outer - inner), s.size * s.size);
}

/// A cell's certificate is true, up to rounding.
void CheckCertificate(const Scene &s, const bmr_mixed_cell *cell, bmr_vec2 x, double distance) {
    bmr_mixed_figure figure;
    bmr_mixed_draw(&s.mixed, cell, &figure);
    const double rounding = 1e-12 * (s.size + std::hypot(x.x, x.y));
    bool inner = false;
    for (size_t i = 0; i < figure.sides; ++i) {
        const double value = bmr_mixed_figure_value(&s.mixed, &figure, i, x);
        FUZZ_CHECK(value >= -rounding, "the point is %g outside of its cell", value);
        if (figure.parts[i].role != BMR_MIXED_INNER)
            continue;
        inner = true;
        FUZZ_CHECK(value <= distance + rounding, "the cell claims %g, the distance is %g", value, distance);
    }
    FUZZ_CHECK(inner, "a cell without a certificate");
}

void CheckMixedPoint(const Scene &s, const bmr_mixed_tiling *tiling, fuzz_bytes *bytes) {
    const double angle = fuzz_in(bytes, -3.2, 3.2), direction = fuzz_in(bytes, -3.2, 3.2);
    const double gap = s.size * std::exp2(fuzz_in(bytes, -24.0, 2.0));
    const bmr_vec2 x =
        test_pose_at(s.polygons[0], s.polygons[1], angle, std::atan2(s.mixed.s, s.mixed.c), gap).position;
    const bmr_pose pose = {x, s.mixed.c, s.mixed.s};
    const double distance =
        fuzz_control("certificate") ? -1e-6 * s.size : test_distance(s.polygons[0], s.polygons[1], &pose);
    const bmr_vec2 d = {std::cos(direction), std::sin(direction)};
    bmr_mixed_cell cell;
    if (!bmr_mixed_locate(&s.mixed, x, d, &cell, nullptr))
        return; // lost by rounding, and says so
    if (cell.kind == BMR_MIXED_INSIDE)
        return; // the sum was in the way
    CheckCertificate(s, &cell, x, distance);
    if (cell.kind == BMR_MIXED_OUTSIDE)
        return;
    FUZZ_CHECK(bmr_mixed_exists(&s.mixed, &cell), "a cell of another rotation");
    FUZZ_CHECK(bmr_mixed_tiling_find(tiling, &cell) != BMR_MIXED_NO_TILE, "the cell is no tile");
    uint32_t tile = BMR_MIXED_NO_TILE;
    bmr_mixed_kind kind;
    const bmr_vec2 far = bmr_add(x, bmr_scale(20.0 * s.size, d));
    if (bmr_mixed_tiling_walk(tiling, &tile, &kind, far, x, nullptr) && tile != BMR_MIXED_NO_TILE)
        CheckCertificate(s, bmr_mixed_tiling_cell(tiling, tile), x, distance);
}

/// The mixed hierarchy of a polygon and another one that is read.
void FuzzMixed(fuzz_bytes *bytes, const bmr_polygon *a, bmr_hierarchy_kind kind) {
    const uint8_t how = fuzz_u8(bytes);
    const uint32_t questions = fuzz_below(bytes, 12);
    const double angle = how % 3 == 0   ? 0.0
                         : how % 3 == 1 ? (how / 3) * 0.09817477042468103
                                        : fuzz_in(bytes, -3.2, 3.2);
    bmr_polygon *b = fuzz_polygon(bytes, kMostOfMixed);
    // What is compared is relative to the sum's size: both about as large, and about the origin.
    if (b != nullptr && a->count >= 3 && b->count >= 3 && a->extent < 16.0 * a->radius &&
        b->extent < 16.0 * b->radius && a->radius < 1e6 * b->radius && b->radius < 1e6 * a->radius) {
        Scene s = {{a, b}, {nullptr, nullptr}, {}, a->extent + b->extent};
        bool built = true;
        for (int i = 0; i < 2; ++i)
            built = built && bmr_hierarchy_build(kind, s.polygons[i], test_compass(), nullptr,
                                                 &s.hierarchies[i]) == BMR_OK;
        FUZZ_CHECK(built, "no hierarchies");
        s.mixed = bmr_mixed_make(s.hierarchies[0], s.hierarchies[1], std::cos(angle), std::sin(angle), 0.0);
        bmr_mixed_tiling *tiling = nullptr;
        const bmr_error error = bmr_mixed_tiling_create(&s.mixed, nullptr, &tiling);
        FUZZ_CHECK(error == BMR_OK, "tiling: %s", bmr_error_describe(error));
        CheckTiling(s, tiling);
        for (uint32_t i = 0; i < questions; ++i)
            CheckMixedPoint(s, tiling, bytes);
        bmr_mixed_tiling_destroy(tiling, nullptr);
        for (bmr_hierarchy *h : s.hierarchies)
            bmr_hierarchy_destroy(h, nullptr);
    }
    bmr_polygon_destroy(b, nullptr);
}

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    const uint8_t how = fuzz_u8(&bytes);
    bmr_polygon *a = fuzz_polygon(&bytes, kMost);
    if (a != nullptr && how % 2 == 0)
        FuzzOne(&bytes, a, static_cast<bmr_hierarchy_kind>(how / 2 % BMR_HIERARCHY_KIND_COUNT));
    if (a != nullptr && how % 2 != 0)
        FuzzMixed(&bytes, a, static_cast<bmr_hierarchy_kind>(how / 2 % 2));
    bmr_polygon_destroy(a, nullptr);
    return 0;
}
