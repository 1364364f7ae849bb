// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_MASS_H
#define BOOMERANG_MASS_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The mass of a polygon of density 1.
typedef struct bmr_mass {
    double area;
    bmr_vec2 centroid;
    double inertia; ///< second moment of area about the centroid
} bmr_mass;

/// Area, centroid and inertia, by a fan of triangles around vertex 0 (it is bmr_outline_mass of one ring). A
/// polygon far from its frame's origin is as exact as one at it. O(n). Errors: NULL_ARGUMENT; OUT_OF_RANGE (a
/// point, a segment, or a polygon so thin that its area or inertia is not a positive number); then *mass is
/// untouched.
bmr_error bmr_polygon_mass(const bmr_polygon *polygon, bmr_mass *mass);

#ifdef __cplusplus
}
#endif
#endif
