// SPDX-License-Identifier: MIT
// The table of all structures, in the order of the paper.
#include "kds/registry.h"

#include <stdio.h>
#include <string.h>

static const bmr_kds_info *const structures[] = {
    // One point, one polygon (section 5)
    &bmr_kds_triangle_levels_compass, &bmr_kds_triangle_levels_dudley, &bmr_kds_triangle_binary_dudley,
    &bmr_kds_point_lazy_dudley,
    // Two polygons, translating or rigid (section 5)
    &bmr_kds_active_cell_compass, &bmr_kds_active_cell_dudley, &bmr_kds_tiling_dudley,
    &bmr_kds_sum_triangle_dudley, &bmr_kds_lazy_compass, &bmr_kds_lazy_dudley,
    // Inflation and hysteresis (section 6)
    &bmr_kds_point_inflated_compass, &bmr_kds_point_inflated_dudley, &bmr_kds_point_complex,
    &bmr_kds_inflated_translation, &bmr_kds_inflated_window,
    // The open question (section 7), and beyond
    &bmr_kds_hybrid, &bmr_kds_two_lines, &bmr_kds_coarse, &bmr_kds_free_fd2, &bmr_kds_predict_adaptive,
    // Rivals (the introduction of section 5)
    &bmr_kds_closest_features, &bmr_kds_inner_tangent, &bmr_kds_separating_edge_walk, NULL};

size_t bmr_kds_count(void) {
    return sizeof structures / sizeof structures[0] - 1;
}

const bmr_kds_info *bmr_kds_at(size_t index) {
    return index < bmr_kds_count() ? structures[index] : NULL;
}

bmr_error bmr_kds_find(const char *name, const bmr_kds_info **info) {
    if (!name || !info)
        return BMR_ERROR_NULL_ARGUMENT;
    for (size_t i = 0; i < bmr_kds_count(); i++)
        if (strcmp(structures[i]->name, name) == 0) {
            *info = structures[i];
            return BMR_OK;
        }
    return BMR_ERROR_UNKNOWN_NAME;
}

/// Appends to a text that is `length` bytes long; returns how long it would be with that. A text that is too
/// long for `size` is cut, and what comes behind is counted all the same.
static size_t append(char *text, size_t size, size_t length, const char *format, const char *word) {
    const size_t left = length < size ? size - length : 0;
    const int written = snprintf(left > 0 ? text + length : NULL, left, format, word);
    return length + (written > 0 ? (size_t)written : 0);
}

size_t bmr_kds_describe_unknown(const char *name, char *text, size_t size) {
    if (!text)
        size = 0;
    size_t length = append(text, size, 0, "there is no structure \"%.64s\"; there are ", name ? name : "");
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        length = append(text, size, length, i + 1 < bmr_kds_count() ? "%s, " : "%s", structures[i]->name);
    return length;
}
