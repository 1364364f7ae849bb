// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_POSED_POLYGONS_H
#define BMR_GEOMETRY_POSED_POLYGONS_H

#include "boomerang/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What the two queries of boomerang/distance.h work on: B as A sees it. All computing is done in A's frame;
/// the answers go to the world at the end.
typedef struct bmr_posed_polygons {
    const bmr_polygon *a, *b;
    bmr_pose pose_a; ///< with (c, s) of unit length
    bmr_pose b_in_a;
} bmr_posed_polygons;

/// Checks the arguments of both functions, of the pointer to the answer only that there is one. An error
/// leaves *posed untouched.
bmr_error bmr_posed_polygons_make(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                                  const bmr_pose *pose_b, const void *answer, bmr_posed_polygons *posed);

/// The closest points. False: the polygons overlap or touch, and *closest is untouched. *steps grows by the
/// elementary steps taken (geometry/distance.h).
bool bmr_posed_polygons_closest(const bmr_posed_polygons *posed, unsigned *steps,
                                bmr_closest_points *closest);

#ifdef __cplusplus
}
#endif
#endif
