// SPDX-License-Identifier: MIT
// Bytes that the library asks for, where size_t has 32 bits: what does not fit is refused, nothing wraps.
#include "boomerang/kds.h"
#include "boomerang/minkowski.h"
#include "cases.h"
#include "convex32/convex32.h"
#include "hierarchy/mixed_cells.h"

extern "C" {
#include "convex32/convex32.h"
#include "geometry/memory.h"
}

namespace {

constexpr size_t k32 = 0xffffffffu;

} // namespace

TEST_CASE("a product is exact, or is refused and leaves its place alone") {
    size_t product = 77;
    CHECK_FALSE(bmr_size_product(SIZE_MAX, 2, &product));
    CHECK_FALSE(bmr_size_product(SIZE_MAX / 3 + 1, 3, &product));
    CHECK(product == 77);
    CHECK(bmr_size_product(SIZE_MAX, 1, &product));
    CHECK(product == SIZE_MAX);
    CHECK(bmr_size_product(3, SIZE_MAX / 3, &product));
    CHECK(product == SIZE_MAX / 3 * 3);
    CHECK(bmr_size_product(SIZE_MAX, 0, &product));
    CHECK(product == 0);
}

TEST_CASE("points of a polygon in float that cannot be addressed are refused") {
    const bmr_vec32 point = {0.0f, 0.0f};
    bmr_convex32_block *block = nullptr;
    CHECK(bmr_convex32_create(&point, SIZE_MAX / 16, nullptr, &block) == BMR_ERROR_TOO_MANY_POINTS);
    CHECK(block == nullptr);
}

TEST_CASE("there is no block for more vertices than a polygon may have") {
    CHECK(bmr_polygon_bytes(BMR_MAX_VERTICES) <= 16 * size_t{BMR_MAX_VERTICES} + 64);
    CHECK(bmr_convex32_bytes(BMR_CONVEX32_MOST) <= 40 * size_t{BMR_CONVEX32_MOST});
    for (const size_t count : {size_t{65536}, size_t{k32}, SIZE_MAX / 16, SIZE_MAX}) {
        CHECK(bmr_polygon_bytes(count) == SIZE_MAX);
        CHECK(bmr_convex32_bytes(count) == SIZE_MAX);
    }
}

namespace {

/// Notes the largest block that was asked for.
struct Ledger {
    size_t largest = 0;
    bmr_allocator allocator = {[](void *context, size_t size) -> void * {
                                   auto *ledger = static_cast<Ledger *>(context);
                                   ledger->largest = size > ledger->largest ? size : ledger->largest;
                                   return std::malloc(size);
                               },
                               [](void *, void *block, size_t) { std::free(block); }, this};
};

} // namespace

TEST_CASE("all that is made of the largest polygons fits 32 bits") {
    // Counts of vertices are limited, so these sums need no check of their own: this is it. On a machine with
    // smaller pointers none is larger.
    Ledger ledger;
    const bmr_allocator *memory = &ledger.allocator;
    const auto ellipse = [&](size_t count) {
        std::vector<bmr_vec2> points;
        for (size_t i = 0; i < count; ++i) {
            const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
            points.push_back({1e6 * std::cos(angle), 7e5 * std::sin(angle)});
        }
        bmr_polygon *polygon = nullptr;
        REQUIRE(bmr_polygon_create(points.data(), count, memory, &polygon) == BMR_OK);
        REQUIRE(polygon->count == count);
        return polygon;
    };
    size_t made_of_two = 0;
    bmr_compass *compass = nullptr;
    REQUIRE(bmr_compass_create(BMR_MAX_VERTICES, memory, &compass) == BMR_OK);
    for (const size_t count : {size_t{BMR_MAX_VERTICES}, size_t{BMR_MAX_VERTICES} / 2}) { // the second: sums
        bmr_polygon *polygon = ellipse(count);
        bmr_hierarchy *made[BMR_HIERARCHY_KIND_COUNT] = {};
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            REQUIRE(bmr_hierarchy_build(static_cast<bmr_hierarchy_kind>(kind), polygon, compass, memory,
                                        &made[kind]) == BMR_OK);
            CHECK(bmr_hierarchy_audit(made[kind]) == BMR_OK);
        }
        const bmr_shape shape = {polygon, {made[0], made[1], made[2]}, {}};
        bmr_polygon *difference = nullptr;
        if (bmr_minkowski_difference(polygon, polygon, {1.0, 0.0}, memory, &difference) == BMR_OK)
            bmr_polygon_destroy(difference, memory);
        const bmr_kds_def def = bmr_default_kds_def();
        for (size_t i = 0; i < bmr_kds_count(); ++i) {
            bmr_kds *kds = nullptr;
            const bmr_kds_info *info = bmr_kds_at(i);
            const bmr_error error = bmr_kds_create(info, &def, &shape, &shape, memory, &kds);
            bmr_kds_destroy(kds, memory);
            made_of_two += info->domain != BMR_KDS_POINT && error == BMR_OK;
        }
        for (bmr_hierarchy *hierarchy : made)
            bmr_hierarchy_destroy(hierarchy, memory);
        bmr_polygon_destroy(polygon, memory);
    }
    bmr_compass_destroy(compass, memory);
    CHECK(made_of_two > 30);
    CHECK(ledger.largest > size_t{1} << 24); // 25 MB
    CHECK(ledger.largest <= k32);
}
