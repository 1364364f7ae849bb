// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_PLAIN_LANES_H
#define BMR_TEST_PLAIN_LANES_H

#include "convex32/convex32_collide.h"
#include "exact32/exact32.h"
#include "exact32/swept32.h"

/// @file
/// Functions of core that are written in lanes (core/exact32/float4.h), as they are on machines without any.

void test_plain_swept32_make(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count,
                             const bmr_motion32 *motion);
bool test_plain_swept32_apart_along(const bmr_swept32 *a, const bmr_swept32 *b, float apart,
                                    bmr_vec32 direction);
bool test_plain_swept32_find_apart(const bmr_swept32 *a, const bmr_swept32 *b, float apart,
                                   bmr_vec32 *direction);
float test_plain_posed32_gap(const bmr_vec32 *a, int32_t count_a, const bmr_transform32 *at_a,
                             const bmr_vec32 *b, int32_t count_b, const bmr_transform32 *at_b,
                             bmr_vec32 direction, float *reach);
float test_plain_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                               float *reach);
float test_plain_points32_reach(const bmr_vec32 *points, int32_t count);
float test_plain_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                          const bmr_transform32 *reference, const bmr_vec32 *points,
                                          int32_t count, const bmr_transform32 *other);
float test_plain_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                        const bmr_transform32 *frame, int32_t *edge);
int32_t test_plain_exact32_collide(bmr_manifold32 *manifold, const bmr_polygon32 *a,
                                   const bmr_transform32 *pose_a, const bmr_polygon32 *b,
                                   const bmr_transform32 *pose_b, float radius_sum, float tolerance);
bool test_plain_convex32_apart(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                               const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory);
void test_plain_convex32_collide(bmr_manifold32 *manifold, const bmr_convex32 *a,
                                 const bmr_transform32 *pose_a, const bmr_convex32 *b,
                                 const bmr_transform32 *pose_b, float radius_sum, float tolerance,
                                 bmr_convex32_memory *memory);

#endif
