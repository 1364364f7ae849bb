// SPDX-License-Identifier: MIT
#ifndef BMR_EXACT32_SWEPT32_H
#define BMR_EXACT32_SWEPT32_H

#include <stdbool.h>
#include <stdint.h>

#include "exact32/exact32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Two small convex shapes in motion, and one direction that keeps them apart from beginning to end: the
/// paper's certificate of a direction and two supports, for a motion instead of a pose. In float, for the
/// tests that a game's step makes by the thousand; the caller adds what float arithmetic may be off by
/// (bmr_swept32 has what that takes).

enum { BMR_SWEPT32_MOST = 8 };

/// A motion from beginning to end: the centre goes straight, the shape turns about it, both evenly.
typedef struct bmr_motion32 {
    bmr_vec32 center; ///< the centre, in the frame of the points
    bmr_vec32 start, end;
    float s, c; ///< sine and cosine of the angle at the end
    float turn; ///< angle at the end less angle at the start, radians
} bmr_motion32;

/// The convex hull of up to 8 points, moving.
typedef struct bmr_swept32 {
    float x[BMR_SWEPT32_MOST], y[BMR_SWEPT32_MOST]; ///< at the end, seen from the centre; lanes past the
                                                    ///< count repeat the first point
    bmr_vec32 end;                                  ///< centre at the end
    bmr_vec32 back;                                 ///< from there to the centre at the start
    float turn;                                     ///< as in the motion
    float radius;   ///< no point is farther from the centre; infinite where a coordinate is not finite
    float width;    ///< no two points are farther apart
    float edge;     ///< length of the shortest side; FLT_MAX of a single point
    float least[4]; ///< of x, -x, y and -y of the points
} bmr_swept32;

/// `points` in convex position and in order, 1 to 8 of them; from 3 on they must lie in an array of 8 (what
/// is past `count` is read and not used).
void bmr_swept32_make(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count, const bmr_motion32 *motion);

/// Finds a fixed direction along which the two are farther apart than `apart` during all of the motion. True
/// up to rounding; false: none was found. `direction`, from a to b, of unit length or zero, is tried first
/// and replaced by the one that keeps them apart, if one is found. About 50 instructions where the first
/// holds, and as many where one of the axes does; else a search of at most 8 more, each a step of Gilbert,
/// Johnson and Keerthi's.
/// Anything that is not a number: false. Nothing of finite numbers raises FE_INVALID or FE_DIVBYZERO.
bool bmr_swept32_find_apart(const bmr_swept32 *a, const bmr_swept32 *b, float apart, bmr_vec32 *direction);

/// Are the two farther apart than `apart` along this very direction, of unit length or zero, during all of
/// the motion? True up to rounding; no search, some 50 instructions. Anything that is not a number: no.
bool bmr_swept32_apart_along(const bmr_swept32 *a, const bmr_swept32 *b, float apart, bmr_vec32 direction);

/// How far apart the hulls of the points `a` and `b` are along one direction, at two poses; negative where
/// they overlap along it. `direction` is in the world, from a to b. `reach` becomes the largest coordinate of
/// all points in their own frames. Points as in bmr_swept32_make. A coordinate that is no number does not
/// show in the answer: `reach` is infinite then, and the caller is to look at it.
float bmr_posed32_gap(const bmr_vec32 *a, int32_t count_a, const bmr_transform32 *at_a, const bmr_vec32 *b,
                      int32_t count_b, const bmr_transform32 *at_b, bmr_vec32 direction, float *reach);

/// How deep a point of the world lies inside a posed polygon: its least distance from a side's line, negative
/// outside. Of the vertices alone, normals may be anything; whatever their order is, a point
/// that has a depth lies so deep inside their convex hull. A side without length has no inside. `reach` as
/// above; NaN where a number is not finite.
float bmr_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                        float *reach);

/// The largest coordinate of 3 to 8 points, in an array of 8; infinite where one is not finite.
float bmr_points32_reach(const bmr_vec32 *points, int32_t count);

#ifdef __cplusplus
}
#endif
#endif
