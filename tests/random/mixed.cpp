// SPDX-License-Identifier: MIT
// The mixed hierarchy: its tiles fill the outside of the sum, each is a cell of this rotation, and the cell
// found for a point holds it and proves what it claims.
#include <cmath>
#include <vector>

#include "fuzz_hierarchy.h"
#include "harness.h"
#include "hierarchies.h"
#include "hierarchy/mixed_cells.h"
#include "motions.h" // test_distance
#include "points.h"

namespace {

constexpr size_t kMost = 24;
using Points = std::vector<bmr_vec2>;

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
        bmr_mixed_side sides[BMR_MIXED_MAX_SIDES];
        const size_t n = bmr_mixed_polygon(&s.mixed, cell, corners);
        FUZZ_CHECK(bmr_mixed_exists(&s.mixed, cell), "tile %u is no cell", i);
        FUZZ_CHECK(bmr_mixed_tiling_find(tiling, cell) == i, "tile %u is not found", i);
        FUZZ_CHECK(bmr_mixed_sides(&s.mixed, cell, sides) == n && n >= 3, "tile %u has %zu corners", i, n);
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
    bmr_mixed_side sides[BMR_MIXED_MAX_SIDES];
    const size_t count = bmr_mixed_sides(&s.mixed, cell, sides);
    const double rounding = 1e-12 * (s.size + std::hypot(x.x, x.y));
    bool inner = false;
    for (size_t i = 0; i < count; ++i) {
        const double value = bmr_mixed_side_value(&s.mixed, &sides[i], x);
        FUZZ_CHECK(value >= -rounding, "the point is %g outside of its cell", value);
        if (sides[i].role != BMR_MIXED_INNER)
            continue;
        inner = true;
        FUZZ_CHECK(value <= distance + rounding, "the cell claims %g, the distance is %g", value, distance);
    }
    FUZZ_CHECK(inner, "a cell without a certificate");
}

void CheckPoint(const Scene &s, const bmr_mixed_tiling *tiling, fuzz_bytes *bytes) {
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

} // namespace

void FuzzMixed(fuzz_bytes *bytes, const bmr_polygon *a, bmr_hierarchy_kind kind) {
    const uint8_t how = fuzz_u8(bytes);
    const uint32_t questions = fuzz_below(bytes, 12);
    const double angle = how % 3 == 0   ? 0.0
                         : how % 3 == 1 ? (how / 3) * 0.09817477042468103
                                        : fuzz_in(bytes, -3.2, 3.2);
    bmr_polygon *b = fuzz_polygon(bytes, kMost);
    // What is compared is relative to the sum's size: both about as large, and about the origin.
    if (b != nullptr && a->count >= 3 && b->count >= 3 && a->extent < 16.0 * a->radius &&
        b->extent < 16.0 * b->radius && a->radius < 1e6 * b->radius && b->radius < 1e6 * a->radius) {
        Scene s = {{a, b}, {nullptr, nullptr}, {}, a->extent + b->extent};
        bool built = true;
        for (int i = 0; i < 2; ++i)
            built = built && test_build_hierarchy(kind, s.polygons[i], fuzz_compass(), nullptr,
                                                  &s.hierarchies[i]) == BMR_OK;
        FUZZ_CHECK(built, "no hierarchies");
        s.mixed = bmr_mixed_make(s.hierarchies[0], s.hierarchies[1], std::cos(angle), std::sin(angle), 0.0);
        bmr_mixed_tiling *tiling = nullptr;
        const bmr_error error = bmr_mixed_tiling_create(&s.mixed, nullptr, &tiling);
        FUZZ_CHECK(error == BMR_OK, "tiling: error %d", error);
        CheckTiling(s, tiling);
        for (uint32_t i = 0; i < questions; ++i)
            CheckPoint(s, tiling, bytes);
        bmr_mixed_tiling_destroy(tiling, nullptr);
        for (bmr_hierarchy *h : s.hierarchies)
            bmr_hierarchy_destroy(h, nullptr);
    }
    bmr_polygon_destroy(b, nullptr);
}
