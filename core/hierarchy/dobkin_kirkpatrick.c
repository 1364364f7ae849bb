// SPDX-License-Identifier: MIT
#include "geometry/memory.h"
#include "hierarchy/builder.h"

bmr_error bmr_hierarchy_build_dobkin_kirkpatrick(const bmr_polygon *polygon, const bmr_allocator *allocator,
                                                 bmr_hierarchy **hierarchy) {
    if (!polygon || !hierarchy)
        return BMR_ERROR_NULL_ARGUMENT;
    const size_t size = polygon->count * sizeof(bmr_item);
    bmr_item *items = bmr_allocate(allocator, size);
    if (!items)
        return BMR_ERROR_NO_MEMORY;
    const uint32_t count = bmr_items_of_edges(polygon, items);
    bmr_items_start_at_east(items, count);
    const bmr_build build = {polygon, BMR_HIERARCHY_DOBKIN_KIRKPATRICK, items, count, NULL, 0, 0};
    const bmr_error error = bmr_build_tree(&build, allocator, hierarchy);
    bmr_release(allocator, items, size);
    return error;
}
