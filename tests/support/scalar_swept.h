// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_SCALAR_SWEPT_H
#define BMR_TEST_SCALAR_SWEPT_H

#include "boomerang/swept32.h"

/// @file
/// The functions of swept32.h as they are on machines without lanes.

void test_scalar_swept32_make(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count,
                              const bmr_motion32 *motion);
bool test_scalar_swept32_apart_along(const bmr_swept32 *a, const bmr_swept32 *b, float apart,
                                     bmr_vec32 direction);
bmr_swept32_answer test_scalar_swept32_compare(const bmr_swept32 *a, const bmr_swept32 *b, float apart,
                                               float near, bmr_vec32 *direction);
float test_scalar_posed32_gap(const bmr_vec32 *a, int32_t count_a, const bmr_transform32 *at_a,
                              const bmr_vec32 *b, int32_t count_b, const bmr_transform32 *at_b,
                              bmr_vec32 direction, float *reach);
float test_scalar_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                                float *reach);
float test_scalar_points32_reach(const bmr_vec32 *points, int32_t count);

#endif
