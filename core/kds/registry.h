// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_REGISTRY_H
#define BMR_KDS_REGISTRY_H

#include "boomerang/kds.h"

/// Defines bmr_kds_NAME, from the members of bmr_kds_info in their order.
#define BMR_KDS_INFO(name, ...) const bmr_kds_info bmr_kds_##name = {__VA_ARGS__}

// Each is defined in the file of this folder that implements it.

// inflated_pair.c; the last is not in the table: tests show that its windowless hysteresis fails
extern const bmr_kds_info bmr_kds_inflated_translation, bmr_kds_inflated_window, bmr_kds_inflated_nowindow;
// active_cell.c
extern const bmr_kds_info bmr_kds_active_cell_compass, bmr_kds_active_cell_dudley, bmr_kds_tiling_dudley;

// predict.c
extern const bmr_kds_info bmr_kds_predict_adaptive;
// two_lines.c
extern const bmr_kds_info bmr_kds_hybrid, bmr_kds_two_lines, bmr_kds_free_fd2, bmr_kds_coarse;

// point_lazy.c
extern const bmr_kds_info bmr_kds_point_lazy_dudley;

// point_triangle.c
extern const bmr_kds_info bmr_kds_triangle_levels_compass, bmr_kds_triangle_levels_dudley;
extern const bmr_kds_info bmr_kds_triangle_binary_dudley;

// features.c, inner_tangent.c, separating_edge.c
extern const bmr_kds_info bmr_kds_closest_features, bmr_kds_inner_tangent, bmr_kds_separating_edge_walk;

// point_inflated.c
extern const bmr_kds_info bmr_kds_point_inflated_compass, bmr_kds_point_inflated_dudley,
    bmr_kds_point_complex;

// lazy.c
extern const bmr_kds_info bmr_kds_lazy_compass, bmr_kds_lazy_dudley;

// sum.c
extern const bmr_kds_info bmr_kds_sum_triangle_dudley;

#endif
