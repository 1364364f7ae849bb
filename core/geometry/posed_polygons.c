// SPDX-License-Identifier: MIT
#include "geometry/posed_polygons.h"

#include <math.h>

/// The pose with a rotation of unit length; NULL is the identity.
static bmr_error unit_pose(const bmr_pose *pose, bmr_pose *unit) {
    *unit = pose ? *pose : bmr_pose_identity();
    const double x = unit->position.x, y = unit->position.y, c = unit->c, s = unit->s;
    if (!isfinite(x) || !isfinite(y) || !isfinite(c) || !isfinite(s))
        return BMR_ERROR_NOT_FINITE;
    const double square = c * c + s * s;
    if (!(fabs(square - 1.0) <= BMR_DISTANCE_UNIT) || !(fmax(fabs(x), fabs(y)) <= BMR_MAX_COORDINATE))
        return BMR_ERROR_OUT_OF_RANGE;
    const double length = sqrt(square);
    unit->c /= length;
    unit->s /= length;
    return BMR_OK;
}

bmr_error bmr_posed_polygons_make(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                                  const bmr_pose *pose_b, const void *answer, bmr_posed_polygons *posed) {
    if (!a || !b || !answer)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_pose unit_a, unit_b;
    bmr_error error = unit_pose(pose_a, &unit_a);
    if (error == BMR_OK)
        error = unit_pose(pose_b, &unit_b);
    if (error != BMR_OK)
        return error;
    const bmr_posed_polygons made = {a, b, unit_a, bmr_pose_relative(&unit_a, &unit_b)};
    *posed = made;
    return BMR_OK;
}
