// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OWNED_H
#define BMR_TEST_OWNED_H

#include "boomerang/families.h"
#include "boomerang/hierarchy.h"
#include "boomerang/kds.h"
#include "boomerang/motion.h"
#include "boomerang/polygon.h"
#include "boomerang/world.h"
#include "convex32/convex32.h"

/// @file
/// In C: `own_polygon *p = test_polygon(...);` destroys the polygon where the block of `p` ends, after those
/// that were declared later. Likewise for what the other names say. NULL is no harm.

/// The variable's address is handed to `leave` at the end of its block.
#define OWNED(leave) __attribute__((cleanup(leave)))

static inline void leave_polygon(bmr_polygon *const *polygon) {
    bmr_polygon_destroy(*polygon, NULL);
}
static inline void leave_compass(bmr_compass *const *compass) {
    bmr_compass_destroy(*compass, NULL);
}
static inline void leave_hierarchy(bmr_hierarchy *const *hierarchy) {
    bmr_hierarchy_destroy(*hierarchy, NULL);
}
static inline void leave_convex32(bmr_convex32_block *const *block) {
    bmr_convex32_destroy(*block, NULL);
}
static inline void leave_kds(bmr_kds *const *kds) {
    bmr_kds_destroy(*kds, NULL);
}
static inline void leave_motion(bmr_motion *const *motion) {
    bmr_motion_destroy(*motion);
}
static inline void leave_world(bmr_world *const *world) {
    bmr_world_destroy(*world);
}
#define own_polygon OWNED(leave_polygon) bmr_polygon
#define own_compass OWNED(leave_compass) bmr_compass
#define own_hierarchy OWNED(leave_hierarchy) bmr_hierarchy
#define own_convex32 OWNED(leave_convex32) bmr_convex32_block
#define own_kds OWNED(leave_kds) bmr_kds
#define own_motion OWNED(leave_motion) bmr_motion
#define own_family OWNED(bmr_family_destroy) bmr_family_motion
#define own_world OWNED(leave_world) bmr_world

/// What must be made, or the test has failed.
static inline bmr_polygon *made_polygon(const bmr_vec2 *points, size_t count) {
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create(points, count, NULL, &polygon), BMR_OK);
    return polygon;
}
static inline bmr_convex32_block *made_convex32(const bmr_vec32 *points, size_t count) {
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create(points, count, NULL, &block), BMR_OK);
    return block;
}
static inline bmr_kds *made_kds(const bmr_kds_info *info, const bmr_kds_def *def, const bmr_shape *a,
                                const bmr_shape *b) {
    bmr_kds *kds = NULL;
    check_structure = info->name;
    assert_int_equal(bmr_kds_create(info, def, a, b, NULL, &kds), BMR_OK);
    return kds;
}
static inline bmr_motion *made_motion(bmr_motion_piece piece) {
    bmr_motion *motion = NULL;
    assert_int_equal(bmr_motion_create(&piece, NULL, &motion), BMR_OK);
    return motion;
}

#endif
