// SPDX-License-Identifier: MIT
// The table of all structures, in the order of the paper.
#include "kds/registry.h"

#include <string.h>

static const bmr_kds_info *const structures[] = {
    // One point, one polygon (section 5)
    &bmr_kds_triangle_levels_compass, &bmr_kds_triangle_levels_dudley, &bmr_kds_triangle_binary_compass,
    &bmr_kds_triangle_binary_dudley, &bmr_kds_point_lazy_compass, &bmr_kds_point_lazy_dudley,
    &bmr_kds_point_lazy_dk,
    // Two polygons, translating or rigid (section 5)
    &bmr_kds_active_cell_compass, &bmr_kds_active_cell_dudley, &bmr_kds_tiling_compass,
    &bmr_kds_tiling_dudley, &bmr_kds_sum_triangle_compass, &bmr_kds_sum_triangle_dudley,
    &bmr_kds_sum_lazy_compass, &bmr_kds_sum_lazy_dudley, &bmr_kds_sum_inflated_compass, &bmr_kds_lazy_compass,
    &bmr_kds_lazy_dudley, &bmr_kds_lazy_dk,
    // Inflation and hysteresis (section 6)
    &bmr_kds_point_inflated_compass, &bmr_kds_point_inflated_dudley, &bmr_kds_point_inflated_slack,
    &bmr_kds_point_complex, &bmr_kds_inflated_translation, &bmr_kds_inflated_window,
    // The open question (section 6), and beyond
    &bmr_kds_free_fd1, &bmr_kds_free_fd2, &bmr_kds_free_fdx, &bmr_kds_free_fdxa, &bmr_kds_predict,
    &bmr_kds_predict_adaptive,
    // Rivals (the introduction of section 5)
    &bmr_kds_closest_features, &bmr_kds_inner_tangent, &bmr_kds_separating_edge,
    &bmr_kds_separating_edge_walk, NULL};

size_t bmr_kds_count(void) {
    return sizeof structures / sizeof structures[0] - 1;
}

const bmr_kds_info *bmr_kds_at(size_t index) {
    return index < bmr_kds_count() ? structures[index] : NULL;
}

const bmr_kds_info *bmr_kds_find(const char *name) {
    for (size_t i = 0; name && i < bmr_kds_count(); i++)
        if (strcmp(structures[i]->name, name) == 0)
            return structures[i];
    return NULL;
}
