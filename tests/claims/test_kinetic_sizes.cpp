// SPDX-License-Identifier: MIT
// Bytes that the library asks for, where size_t has 32 bits: what does not fit is refused, nothing wraps.
#include "boomerang/polygon.h"
#include "cases.h"

extern "C" {
#include "convex32/convex32.h"
#include "geometry/memory.h"
}

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

TEST_CASE("there is no block for more vertices than a polygon may have") {
    CHECK(bmr_polygon_bytes(BMR_MAX_VERTICES) <= 16 * size_t{BMR_MAX_VERTICES} + 64);
    CHECK(bmr_convex32_bytes(BMR_CONVEX32_MOST) <= 40 * size_t{BMR_CONVEX32_MOST});
    for (const size_t count : {size_t{65536}, size_t{0xffffffffu}, SIZE_MAX / 16, SIZE_MAX}) {
        CHECK(bmr_polygon_bytes(count) == SIZE_MAX);
        CHECK(bmr_convex32_bytes(count) == SIZE_MAX);
    }
}
